// @ts-check
// The input line on the screen: drawn again after each key, over several rows if it is long.

import { Editing, keysOf } from "./editing.js";
import { harmless } from "../shell/style.js";

/**
 * What keys do beyond the line. `older` and `newer` return another line; `find` the latest one with a
 * text, before `skipped` others.
 * @typedef {{enter(text: string): void, interrupt(): void, older(text: string): string | undefined,
 *   newer(text: string): string | undefined, find(text: string, skipped: number): string | undefined, complete(before: string): void,
 *   clear(): void}} Actions
 */

// Characters that take two cells.
const WIDE = /[\u1100-\u115f\u2e80-\ua4cf\uac00-\ud7a3\uf900-\ufaff\ufe30-\ufe6f\uff00-\uff60\uffe0-\uffe6]|[\ud83c-\ud83e][\udc00-\udfff]/g;
const COMBINING = /[\u0300-\u036f\u200b-\u200f\ufe00-\ufe0f]/g;

export class InputLine {
  #put;
  #columns;
  #editing = new Editing();
  #prompt = "";
  /** The row of the cursor, below that of the prompt. */
  #row = 0;
  #shown = false;
  /** What is searched for, while it is. @type {string | undefined} */
  #search;
  /** How many found lines were skipped, by Ctrl-R again. */
  #skipped = 0;

  /** @param {(text: string) => void} put on the screen @param {() => number} columns of the screen */
  constructor(put, columns) {
    this.#put = put;
    this.#columns = columns;
  }

  /** The text before the cursor. */
  get before() {
    return this.#editing.text.slice(0, this.#editing.at);
  }

  /** Show an empty line. @param {string} prompt */
  begin(prompt) {
    this.#prompt = prompt;
    this.#editing.set("");
    this.#row = 0;
    this.#shown = true;
    this.#draw();
  }

  /** @param {string} text */
  insert(text) {
    this.#editing.insert(text);
    this.redraw();
  }

  /** Draw the line again. */
  redraw() {
    if (this.#shown) this.#draw();
  }

  /** Print something above the line. @param {string} data @param {(data: string) => void} put */
  aside(data, put) {
    if (this.#shown) this.#erase();
    put(data);
    this.#row = 0;
    this.redraw();
  }

  /**
   * Handle keys, up to one that runs a command; return the rest.
   * @param {string} data @param {Actions} actions @returns {string}
   */
  type(data, actions) {
    const keys = keysOf(data);
    for (const [index, { action, text }] of keys.entries()) {
      if (this.#search !== undefined && this.#searching(action, text, actions)) continue;
      if (action === "enter" || action === "interrupt") {
        this.#leave(actions, action);
        return keys.slice(index + 1).map((key) => key.text).join("");
      }
      this.#press(action, text, actions);
    }
    this.redraw();
    return "";
  }

  /** @param {Actions} actions @param {"enter" | "interrupt"} action */
  #leave(actions, action) {
    this.#editing.at = this.#editing.text.length;
    this.redraw();
    this.#shown = false;
    if (action === "enter") actions.enter(this.#editing.text);
    else actions.interrupt();
  }

  /** @param {string} action @param {string} text @param {Actions} actions */
  #press(action, text, actions) {
    const editing = this.#editing;
    if (action === "insert") {
      editing.insert(text);
    } else if (action === "older" || action === "newer") {
      const line = actions[action](editing.text);
      if (line !== undefined) editing.set(line);
    } else if (action === "complete") {
      actions.complete(this.before);
    } else if (action === "end") {
      // There is no way out of the page; as elsewhere, Ctrl-D deletes in a line.
      editing.apply("delete");
    } else if (action === "clear") {
      this.#row = 0;
      actions.clear();
    } else if (action === "search") {
      [this.#search, this.#skipped] = ["", 0];
    } else {
      editing.apply(action);
    }
  }

  /** Ctrl-R: search in earlier lines. @param {string} action @param {string} text @param {Actions} actions */
  #searching(action, text, actions) {
    if (action === "search") {
      this.#skipped++;
    } else if (action === "insert") {
      this.#search += text;
      this.#skipped = 0;
    } else if (action === "rubOut") {
      this.#search = (this.#search ?? "").slice(0, -1);
      this.#skipped = 0;
    } else {
      this.#search = undefined;
      return action === "interrupt" ? (this.#editing.set(""), true) : false;
    }
    const found = actions.find(this.#search ?? "", this.#skipped);
    if (found !== undefined) this.#editing.set(found);
    // There is no earlier one.
    else if (action === "search") this.#skipped--;
    return true;
  }

  #erase() {
    this.#put(`${this.#row ? `\x1b[${this.#row}A` : ""}\r\x1b[J`);
  }

  #draw() {
    const columns = this.#columns();
    const { text, at } = this.#editing;
    const prompt = this.#search === undefined ? this.#prompt : `(search)\`${this.#search}': `;
    const shown = (/** @type {string} */ part) => harmless(part).replaceAll("\n", "^J").replaceAll("\t", " ");
    const whole = shown(text);
    const end = width(prompt) + width(whole);
    const cursor = width(prompt) + width(shown(text.slice(0, at)));
    this.#erase();
    const colour = `\x1b[1;32m${shown(prompt)}\x1b[0m`;
    // In a full row, the cursor would wait at its end.
    this.#put(colour + whole + (end % columns === 0 ? " \r" : ""));
    const up = Math.floor(end / columns) - Math.floor(cursor / columns);
    const column = cursor % columns;
    this.#put(`${up ? `\x1b[${up}A` : ""}\r${column ? `\x1b[${column}C` : ""}`);
    this.#row = Math.floor(cursor / columns);
  }
}

/** The number of cells that a text takes. @param {string} text */
function width(text) {
  return [...text.replace(COMBINING, "")].length + (text.match(WIDE)?.length ?? 0);
}
