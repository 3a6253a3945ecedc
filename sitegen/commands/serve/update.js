// @ts-check
// Change an open page into what it is after an edit: its text, its widgets and its nodes, while all that stays the
// same goes on running and keeps what it shows.

import { Idiomorph } from "./idiomorph.js";

/** @import { NodeEntry, PageEntry } from "../../runtime/protocol.js" */
/** @typedef {typeof import("../../runtime/rosMain.js")} RosMain */

// What scripts of a page add to its text, or change of it.
const ADDED = ".copy, [data-ros-widget] *, .ros-word, .sitegen-problems";
const CHANGED = ["checked", "open", "data-current"];
// Beside the text, what an edit of one page changes in it.
const AROUND = "title, nav, aside, footer";

/** Return the parsed HTML of the open page as the server has it now. */
export async function served() {
  const text = await (await fetch(location.pathname, { cache: "no-store" })).text();
  return new DOMParser().parseFromString(text, "text/html");
}

/** Return the number of builds before a page was served. @param {Document} page */
export function buildsOf(page) {
  return page.querySelector('meta[name="sitegen-builds"]')?.getAttribute("content") ?? "";
}

/** Return page.json, if the page has one. @returns {Promise<PageEntry | undefined>} */
export async function entryOf() {
  const link = /** @type {HTMLLinkElement | null} */ (document.getElementById("ros-page"));
  return link ? (await fetch(link.href, { cache: "no-store" })).json() : undefined;
}

/** Return the page's ROS, if it has nodes. @returns {Promise<RosMain | undefined>} */
export async function rosMain() {
  const script = /** @type {HTMLScriptElement | null} */ (document.querySelector('script[src*="rosMain"]'));
  return script ? import(script.src) : undefined;
}

/**
 * Change the page's text from what was served to what is served now.
 * @param {Document} old @param {Document} fresh
 * @returns {boolean} false if it has to be loaded anew: more than text is different
 */
export function updateText(old, fresh) {
  const [main, before, after] = [document, old, fresh].map((page) => page.querySelector("main"));
  if (!main || !before || !after || !arrangedAlike(main, before)) return false;
  const [around, fore, aft] = [document, old, fresh].map((page) => [...page.querySelectorAll(AROUND)].filter(outside));
  if (!around || !fore || !aft || around.length !== aft.length || fore.length !== aft.length) return false;
  if (shell(old) !== shell(fresh)) return false;
  for (const [index, element] of aft.entries()) {
    if (!fore[index]?.isEqualNode(element)) around[index]?.replaceWith(document.importNode(element, true));
  }
  if (!before.isEqualNode(after)) {
    Idiomorph.morph(main, document.importNode(after, true), {
      callbacks: {
        beforeNodeMorphed: (/** @type {Node} */ node) => !isWidget(node),
        beforeNodeRemoved: (/** @type {Node} */ node) => !(node instanceof Element && node.matches(ADDED)),
        beforeAttributeUpdated: (/** @type {string} */ name) => !CHANGED.includes(name),
      },
    });
  }
  // Themes look after what they added to the text.
  document.dispatchEvent(new Event("sitegen:edited"));
  return true;
}

/**
 * Change the nodes and remove the widgets that are no more; `updateText` comes next, then the function that is
 * returned.
 * @param {PageEntry} old @param {PageEntry} fresh @param {RosMain} main
 * @returns {(() => Promise<unknown>) | undefined} undefined if the page has to be loaded anew
 */
export function updateNodes(old, fresh, { ros, editing }) {
  const types = Object.entries(old.types ?? {}).filter(([name, type]) => name in (fresh.types ?? {}) &&
    different(type, fresh.types?.[name]));
  // A script has run, and cannot be undone.
  const given = /** @type {const} */ (["scripts", "interfaces", "messagesFrom"]);
  if (given.some((key) => different(old[key], fresh[key]))) return undefined;
  // What a launch file does has begun, too.
  const acting = (/** @type {PageEntry} */ { launch }) => launch?.handlers && launch;
  if (different(acting(old), acting(fresh))) return undefined;
  if (types.length || Boolean(old.types) !== Boolean(fresh.types) || old.isolate !== fresh.isolate) return undefined;
  // Widgets heed what nodes need when they are mounted.
  const same = (/** @type {[string, NodeEntry]} */ [name, { needs }]) => !(name in old.nodes) || !different(needs, old.nodes[name]?.needs);
  if (!Object.entries(fresh.nodes).every(same)) return undefined;
  Object.assign(ros.types, fresh.types);

  for (const [name, entry] of Object.entries(fresh.nodes)) {
    const node = ros.nodes.get(name);
    if (!node) {
      const added = editing.add(name, entry);
      if (entry.autostart) added.start();
    } else if (different(program(entry), program(old.nodes[name]))) {
      const lacked = Object.keys(entry.builds ?? {}).length > Object.keys(old.nodes[name]?.builds ?? {}).length;
      node.replace(entry);
      // It was made for another browser, and is there for this one now.
      if (lacked && node.state === "failed") node.start();
    }
  }
  const kept = new Map(old.widgets.map((widget) => [widget.element, widget]));
  const mounted = fresh.widgets.filter((widget) => different(widget, kept.get(widget.element)));
  const elements = new Set(fresh.widgets.map(({ element }) => element));
  for (const element of kept.keys()) if (!elements.has(element)) ros.unmount(element);
  return () => {
    editing.rename(fresh);
    // Those that visitors have started besides, and cells, go on.
    for (const name of Object.keys(old.nodes).filter((name) => !(name in fresh.nodes))) {
      ros.nodes.get(name)?.stop();
      ros.nodes.delete(name);
    }
    return Promise.all(mounted.map((widget) => editing.mount(widget)));
  };
}

/** @param {unknown} one @param {unknown} other */
function different(one, other) {
  return JSON.stringify(one) !== JSON.stringify(other);
}

/** What a node runs: whether it starts by itself matters only when a page opens. @param {NodeEntry | undefined} entry */
function program(entry) {
  return entry && { ...entry, autostart: false };
}

/** @param {Node} node */
function isWidget(node) {
  return node instanceof Element && node.matches("[data-ros-widget]");
}

/** @param {Element} element */
function outside(element) {
  return !element.closest("main");
}

/** Whether no script has moved the parts of the text, as slides do. @param {Element} live @param {Element} served */
function arrangedAlike(live, served) {
  const [one, other] = [live, served].map((main) => [...main.children].map(({ localName, className }) => [localName, className]));
  return !different(one, other);
}

/** Return what no edit of text changes. @param {Document} page */
function shell(page) {
  const copy = /** @type {Document} */ (page.cloneNode(true));
  for (const element of copy.querySelectorAll(`${AROUND}, main, meta:not([http-equiv]), link[rel=preload], link[rel=modulepreload], template[data-engine]`)) {
    element.remove();
  }
  return copy.documentElement.outerHTML.replace(/\s+/g, " ");
}
