// @ts-check
// Who is at a gateway, as it says. What comes is checked: it may be any server.

/**
 * @typedef {{id: number, name: string, namespace: string, nodes: number, since: number, you: boolean}} Visitor a page
 *   that has joined: `name` is empty if the gateway does not know it, and `namespace` if it has no nodes; `since` is ms
 *   since 1970
 * @typedef {{pages: Visitor[], more: number, others: number}} People `more` pages are not listed; `others` are clients
 *   that are no pages
 */

// Pages that are listed, and characters of a name.
const MOST = 200;
const LONGEST = 255;
// The latest time that a Date can have (ms).
const LATEST = 8.64e15;

/**
 * Return who is there.
 * @param {any} said what the gateway says @param {number} you the id of this page @param {number} ahead the time of the
 *   gateway minus that of the page (ms)
 * @returns {People}
 */
export function peopleOf({ pages, more, others }, you, ahead) {
  const listed = Array.isArray(pages) ? pages : [];
  return {
    pages: listed.slice(0, MOST).filter(isVisitor).map(({ id, name, namespace, nodes, since }) =>
      ({ id, name, namespace, nodes, since: since - ahead, you: id === you })).filter(({ since }) => Math.abs(since) <= LATEST),
    more: count(more) + Math.max(0, listed.length - MOST),
    others: count(others),
  };
}

/** @param {any} given */
function isVisitor(given) {
  const { id, name, namespace, nodes, since } = given ?? {};
  const texts = [name, namespace].every((text) => typeof text === "string" && text.length <= LONGEST);
  return texts && count(id) > 0 && count(nodes) === nodes && typeof since === "number";
}

/** @param {any} given */
function count(given) {
  return Number.isSafeInteger(given) && given >= 0 ? given : 0;
}
