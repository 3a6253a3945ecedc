// @ts-check
// Shared links restore the state of a page: running nodes, panels, tabs and the reading position. The state is the
// fragment of the address, which is not sent to the server; docs/formats.md describes its format.

import { place } from "../place.js";
import { say, together } from "../ui/words.js";

/** @import { NodeHandle, PageEntry, Shared } from "../protocol.js" */

const VERSION = 1;
// Widgets that start nodes. A prompt is not among them, because Python is a large download.
const STARTING = ["buttons", "editor"];
const SIGN = "#share=";
// The length of the longest link. Longer ones are ignored, because anyone can write a link.
const LONGEST = 32_768;
// A page that `sitegen serve` loads anew notes its own link here, where no other site can write. As in follow.js.
const OWN = "sitegen:own";
// A notice names up to this many nodes.
const NAMED = 5;

export class Sharing {
  #page;
  /** The names of widgets in links, such as "topics-1", by element. @type {Map<string, string>} */
  #names = new Map();
  /** Functions that return the state of widgets, by the id of the element. @type {Map<string, () => Shared>} */
  #readers = new Map();
  /** @type {{run?: string[], show: Record<string, Shared>, tabs: string[], at: string}} */
  #given = { show: {}, tabs: [], at: "" };
  #odd = false;
  #told = false;
  /** The nodes that start if the visitor agrees. @type {Set<string>} */
  #asked = new Set();
  /** The nodes that start when their widgets have restored their options. @type {Set<string>} */
  #later = new Set();
  /** The widgets that restore their state. @type {(void | Promise<void>)[]} */
  #restoring = [];
  /** Whether it is the link of this tab itself, while its page is edited. */
  #own;

  /** @param {PageEntry} page @param {string} fragment of the page's address */
  constructor(page, fragment) {
    this.#page = page;
    this.#own = fragment === own();
    this.rename(page);
    if (fragment.startsWith(SIGN)) this.#read(fragment.slice(SIGN.length));
  }

  /** Select the tabs and go to the heading of the link. */
  restore() {
    for (const id of this.#given.tabs) {
      const tab = document.getElementById(id);
      if (tab instanceof HTMLInputElement && tab.type === "radio") {
        tab.checked = true;
        tab.dispatchEvent(new Event("change", { bubbles: true }));
      } else this.#odd = true;
    }
    // Restore the fragment that the address had: a heading, or a slide.
    if (this.#given.at) location.replace(`#${this.#given.at}`);
    addEventListener("hashchange", () => {
      if (location.hash.startsWith(SIGN)) location.reload();
    });
  }

  /** Name the widgets as links do, after `page` has changed. @param {PageEntry} page */
  rename(page) {
    this.#page = page;
    this.#names.clear();
    /** @type {Record<string, number>} */
    const counts = {};
    for (const { kind, element } of page.widgets) {
      counts[kind] = (counts[kind] ?? 0) + 1;
      this.#names.set(element, `${kind}-${counts[kind]}`);
    }
    for (const element of this.#readers.keys()) {
      if (!this.#names.has(element)) this.#readers.delete(element);
    }
  }

  /**
   * Whether a node starts with the page. Only a node with buttons or an editor obeys the link; if it would not start
   * without the link, the visitor is asked, because anyone can write a link.
   * @param {string} name
   */
  starts(name) {
    const entry = this.#page.nodes[name];
    const chosen = this.#page.widgets.some(({ kind, target }) => STARTING.includes(kind) && target === name);
    if (!this.#given.run || !chosen) return Boolean(entry?.autostart);
    if (!this.#given.run.includes(name)) return false;
    const trusted = this.#own || this.#page.startFromLinks?.includes(name);
    const changed = this.#hasOptions(name);
    if (!changed && (trusted || entry?.autostart || entry?.later)) return true;
    (trusted ? this.#later : this.#asked).add(name);
    return false;
  }

  /** Whether the link starts a node with other arguments, which its buttons show. @param {string} name */
  #hasOptions(name) {
    return this.#page.widgets.some(({ kind, target, element }) =>
      kind === "buttons" && target === name && this.#given.show[this.#names.get(element) ?? ""]?.options);
  }

  /** Start the nodes that had to wait for their widgets. @param {Map<string, NodeHandle>} nodes */
  async begin(nodes) {
    await Promise.all(this.#restoring);
    for (const name of this.#later) nodes.get(name)?.start();
  }

  /** Ask the visitor whether to start the nodes of the link that wait. @param {Map<string, NodeHandle>} nodes */
  async ask(nodes) {
    const names = [...this.#asked];
    if (!names.length) return;
    const what = names.length > NAMED ? say("{} nodes", names.length) : together(names);
    const press = () => names.forEach((name) => nodes.get(name)?.start());
    const { notify } = await loadNotice();
    const close = notify(say("This link starts {}.", what), { label: say("Start"), press });
    // The visitor may start them by their own buttons.
    for (const name of names) {
      nodes.get(name)?.addEventListener("state", () => {
        this.#asked.delete(name);
        if (!this.#asked.size) close();
      });
    }
  }

  /**
   * Make the state of a widget part of links; see Ros in protocol.js.
   * @param {{id: string}} element @param {Record<string, "string" | "boolean" | "number" | "object">} shape
   * @param {() => Shared} read @param {(state: Shared, odd: () => void) => void | Promise<void>} restore
   */
  keep(element, shape, read, restore) {
    const name = this.#names.get(element.id) ?? "";
    this.#readers.set(element.id, read);
    const given = this.#given.show[name];
    if (!given) return;
    delete this.#given.show[name];
    const known = Object.entries(given).filter(([key, value]) =>
      Object.hasOwn(shape, key) && typeof value === shape[key] && value !== null);
    if (known.length < Object.keys(given).length) this.#odd = true;
    this.#restoring.push(restore(Object.fromEntries(known), () => {
      this.#odd = true;
      this.tell();
    }));
  }

  /**
   * Return the fragment of a link to the present state. If it is too long, keep only the nodes.
   * @param {Iterable<NodeHandle>} nodes
   */
  fragment(nodes) {
    const run = [...nodes].filter(({ state }) => state === "starting" || state === "running");
    /** @type {Record<string, Shared>} */
    const show = {};
    for (const [element, read] of this.#readers) {
      const told = Object.entries(read()).filter(([, value]) => value);
      if (told.length) show[this.#names.get(element) ?? ""] = Object.fromEntries(told);
    }
    const tabs = [...document.querySelectorAll("main input[type=radio][id]")].filter(
      (tab) => tab instanceof HTMLInputElement && tab.checked && !tab.defaultChecked);
    const state = {
      run: run.map(({ name }) => name),
      ...(Object.keys(show).length && { show }),
      ...(tabs.length && { tabs: tabs.map(({ id }) => id) }),
      ...(location.hash.length > 1 && !location.hash.startsWith(SIGN) && { at: location.hash.slice(1) }),
    };
    const whole = `${SIGN}${VERSION}.${encode(JSON.stringify(state))}`;
    return whole.length <= LONGEST ? whole : `${SIGN}${VERSION}.${encode(JSON.stringify({ run: state.run }))}`;
  }

  /** Tell the visitor, once, that parts of the link were ignored. */
  async tell() {
    if (!this.#odd && !Object.keys(this.#given.show).length) return;
    if (this.#told) return;
    this.#told = true;
    const { notify } = await loadNotice();
    notify(say("Parts of this link no longer match this page and were ignored."));
  }

  /** @param {string} text what follows SIGN */
  #read(text) {
    const [version, data = ""] = text.split(".");
    try {
      if (Number(version) !== VERSION || text.length > LONGEST) throw new Error("another version");
      const { run, show = {}, tabs = [], at = "", ...more } = JSON.parse(decode(data));
      if (Object.keys(more).length) this.#odd = true;
      if (isList(run)) {
        this.#given.run = run.filter((name) => Object.hasOwn(this.#page.nodes, name));
        if (this.#given.run.length < run.length) this.#odd = true;
      } else if (run !== undefined) {
        this.#odd = true;
      }
      if (isList(tabs)) this.#given.tabs = tabs;
      else this.#odd = true;
      if (typeof at === "string" && !`#${at}`.startsWith(SIGN)) this.#given.at = at;
      else this.#odd = true;
      for (const [name, state] of Object.entries(show)) {
        if (state && typeof state === "object" && !Array.isArray(state)) this.#given.show[name] = state;
        else this.#odd = true;
      }
    } catch {
      this.#odd = true;
    }
  }
}

/** @type {Promise<typeof import("./notice.js")> | undefined} */
let loading;

/** Few visitors see a notice. There is one promise, so that sentences come in the order in which they were said. */
function loadNotice() {
  return loading ??= /** @type {Promise<typeof import("./notice.js")>} */ (import(place("page/notice.js")));
}

/** Return the link that this tab has noted as its own, if any. */
function own() {
  try {
    return sessionStorage.getItem(OWN);
  } catch {
    return null; // a frame without storage
  }
}

/** @param {unknown} value @returns {value is string[]} */
function isList(value) {
  return Array.isArray(value) && value.every((item) => typeof item === "string");
}

/** Encode a text as base64url. @param {string} text */
function encode(text) {
  const bytes = Array.from(new TextEncoder().encode(text), (byte) => String.fromCharCode(byte));
  return btoa(bytes.join("")).replaceAll("+", "-").replaceAll("/", "_").replace(/=+$/, "");
}

/** @param {string} text */
function decode(text) {
  const bytes = atob(text.replaceAll("-", "+").replaceAll("_", "/"));
  return new TextDecoder("utf-8", { fatal: true }).decode(Uint8Array.from(bytes, (c) => c.charCodeAt(0)));
}
