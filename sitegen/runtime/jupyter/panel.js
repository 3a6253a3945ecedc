// @ts-check
// A panel in an output of JupyterLab: the document of a frame, with the styles and on the graph of the page around.

import { place } from "../place.js";

/** @import { Ros } from "../protocol.js" */
/** @import { Around, Described } from "../widgets/cell/panel.js" */

/**
 * What the page around JupyterLab lends to panels.
 * @typedef {{ros: Ros, around: Around, document: Document}} Lent
 */

// Without a page around them, panels have no graph.
const frame = /** @type {HTMLIFrameElement & {rosPanel: {described: Described, lent: Lent}}} */ (window.frameElement);
const { described, lent } = frame.rosPanel;

const root = document.documentElement;
const theirs = lent.document.documentElement;
// Before the first text: widgets speak the language of the page.
root.lang = theirs.lang;
for (const { name, value } of theirs.attributes) if (name.startsWith("data-")) root.setAttribute(name, value);
const sheets = [...lent.document.querySelectorAll("link[rel=stylesheet]")].map((link) => {
  const own = document.createElement("link");
  own.rel = "stylesheet";
  own.href = /** @type {HTMLLinkElement} */ (link).href;
  document.head.append(own);
  return new Promise((resolve) => own.addEventListener("load", resolve, { once: true }));
});
await Promise.all(sheets);

const element = document.createElement("section");
document.body.append(element);
new ResizeObserver(() => {
  frame.style.blockSize = `${Math.ceil(element.getBoundingClientRect().height) + 1}px`;
}).observe(element);

/** @type {typeof import("../widgets/cell/panel.js")} */
const { mountPanel } = await import(place("widgets/cell/panel.js"));
try {
  const unmount = await mountPanel(element, lent.ros, described, lent.around);
  addEventListener("pagehide", unmount);
} catch (error) {
  element.textContent = error instanceof Error ? error.message : String(error);
}
