// @ts-check
// What a shared link carries of a page: which nodes run, what panels show, which tabs are chosen, what is being
// read. It is the fragment of the page's address, so no server hears of it; docs/protocol.md describes it.

import { button, create } from "../ui/elements.js";
import { say } from "../ui/words.js";

/** @import { NodeHandle, PageEntry, Shared } from "../protocol.js" */

const VERSION = 1;
const SIGN = "#share=";
// A link is made by anybody: no more of it is read than a page would write.
const LONGEST = 32_768;

export class Sharing {
  #page;
  /** The widgets by their places in the page, as links name them: "topics-1". @type {Map<string, string>} */
  #names = new Map();
  /** What widgets show, by the ids of their elements. @type {Map<string, () => Shared>} */
  #readers = new Map();
  /** @type {{run?: string[], show: Record<string, Shared>, tabs: string[], at: string}} */
  #given = { show: {}, tabs: [], at: "" };
  #odd = false;

  /** @param {PageEntry} page @param {string} fragment of the page's address */
  constructor(page, fragment) {
    this.#page = page;
    this.rename(page);
    if (fragment.startsWith(SIGN)) this.#read(fragment.slice(SIGN.length));
  }

  /** Choose the tabs and go to the heading of the link. */
  restore() {
    for (const id of this.#given.tabs) {
      const tab = document.getElementById(id);
      if (tab instanceof HTMLInputElement && tab.type === "radio") tab.checked = true;
      else this.#odd = true;
    }
    // From here on the address is as if it had been reached by reading: a heading, or a slide.
    if (this.#given.at) location.replace(`#${this.#given.at}`);
    addEventListener("hashchange", () => {
      if (location.hash.startsWith(SIGN)) location.reload();
    });
  }

  /** Name the widgets as links do, which are those of `page` now. @param {PageEntry} page */
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

  /** Whether a node runs when the page opens: as the link says, where a visitor could have chosen. @param {string} name */
  starts(name) {
    const entry = this.#page.nodes[name];
    const chosen = this.#page.widgets.some(({ kind, target }) => kind === "buttons" && target === name);
    if (!this.#given.run || !chosen) return Boolean(entry?.autostart);
    return this.#given.run.includes(name);
  }

  /**
   * Let links carry what a widget shows: see Ros in protocol.js.
   * @param {{id: string}} element @param {Record<string, "string" | "boolean" | "object">} shape
   * @param {() => Shared} read @param {(state: Shared, odd: () => void) => void} restore
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
    restore(Object.fromEntries(known), () => {
      this.#odd = true;
      this.tell();
    });
  }

  /** The fragment of a link to the page as it is now; of very much, what runs. @param {Iterable<NodeHandle>} nodes */
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

  /** Say, once, that not all of the link had a meaning here. */
  tell() {
    if (!this.#odd && !Object.keys(this.#given.show).length) return;
    if (document.querySelector(".ros-word")) return;
    const close = button("×", "", () => word.remove());
    close.setAttribute("aria-label", say("Close"));
    const text = say("Parts of this link no longer match this page and were ignored.");
    const word = create("div", "ros-word", create("span", "", text), close);
    word.setAttribute("role", "status");
    document.body.append(word);
  }

  /** @param {string} text what follows the sign */
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

/** @param {unknown} value @returns {value is string[]} */
function isList(value) {
  return Array.isArray(value) && value.every((item) => typeof item === "string");
}

/** base64url of the text as UTF-8. @param {string} text */
function encode(text) {
  const bytes = Array.from(new TextEncoder().encode(text), (byte) => String.fromCharCode(byte));
  return btoa(bytes.join("")).replaceAll("+", "-").replaceAll("/", "_").replace(/=+$/, "");
}

/** @param {string} text */
function decode(text) {
  const bytes = atob(text.replaceAll("-", "+").replaceAll("_", "/"));
  return new TextDecoder("utf-8", { fatal: true }).decode(Uint8Array.from(bytes, (c) => c.charCodeAt(0)));
}
