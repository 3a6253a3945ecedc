// @ts-check
// Why Python cannot wait in shared memory here, for the consoles of nodes that need it.

/** Why the page is not isolated; undefined if the site does not request isolation. @type {string | undefined} */
let reason;

/** Note that the site requests isolation. @param {string} why the page is not isolated, or "" */
export function noteIsolation(why) {
  reason = why;
}

/** Return why Python cannot wait here, as the end of a sentence; empty if the site does not request isolation. */
export function obstacle() {
  if (reason === undefined) return "";
  if (globalThis.crossOriginIsolated) return "; it does not support shared memory either";
  return `; shared memory would do instead, but ${reason}`;
}
