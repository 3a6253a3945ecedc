// @ts-check
// Tools for the lines of a console: fold, find, copy, save, and show as they were written.

import { download } from "./download.js";
import { button, create, setText } from "./elements.js";
import { fullScreenButton } from "./fullScreen.js";
import { tool } from "./toolbar.js";
import { say } from "./words.js";
import { X } from "../vendor/icons.js";

// How long a button says what it did (ms).
const SAID = 2000;

/**
 * What the tools work with. `changed` is called after they have changed what is shown.
 * @typedef {{log: HTMLElement, name: string, changed: () => void}} Shown
 */

export class LineTools {
  #shown;
  #find = create("input", "");
  #count = create("span", "ros-found");
  #copy;
  #raw;
  #fold;
  element;

  /** @param {Shown} shown @param {() => void} close called when the visitor closes the tools */
  constructor(shown, close) {
    this.#shown = shown;
    this.#find.type = "search";
    this.#find.placeholder = say("Find text");
    this.#find.setAttribute("aria-label", say("Find in the lines of {}", shown.name));
    this.#find.addEventListener("input", () => this.look());
    this.#find.addEventListener("keydown", ({ key }) => {
      if (key !== "Escape") return;
      if (this.#find.value) this.find("");
      else close();
    });
    this.#count.setAttribute("role", "status");
    this.#fold = button("", "ros-fold-lines", () => this.fold(!shown.log.hidden));
    this.#copy = button(say("Copy"), "", () => this.#copyLines());
    const save = button(say("Save"), "", () => this.#save());
    this.#raw = button(say("Raw"), "", () => {
      const raw = shown.log.classList.toggle("ros-unformatted");
      this.#raw.setAttribute("aria-pressed", String(raw));
      shown.changed();
    });
    this.#copy.title = say("Copy these lines");
    save.title = say("Save these lines as a file");
    this.#raw.title = say("Show lines as the program wrote them");
    this.#raw.setAttribute("aria-pressed", "false");
    const ends = tool(say("Close"), X, close);
    this.element = create("div", "ros-line-tools", this.#fold, this.#find, this.#count, this.#copy, save, this.#raw,
      fullScreenButton(shown.log), ends);
    this.element.setAttribute("role", "group");
    this.element.setAttribute("aria-label", say("Tools for the lines of {}", shown.name));
    this.fold(false);
  }

  /** What links carry. */
  get state() {
    return { find: this.#find.value, folded: Boolean(this.#shown.log.hidden) };
  }

  focus() {
    this.#find.focus();
  }

  /** @param {string} text */
  find(text) {
    this.#find.value = text;
    this.look();
  }

  /** @param {boolean} on */
  fold(on) {
    const { log, changed } = this.#shown;
    log.hidden = on;
    this.#fold.setAttribute("aria-expanded", String(!on));
    this.#fold.setAttribute("aria-label", on ? say("Show lines") : say("Hide lines"));
    this.look();
    changed();
  }

  /** Show the rows that match, also after rows have come. */
  look() {
    const wanted = this.#find.value.trim().toLowerCase();
    const { log } = this.#shown;
    let found = 0;
    for (const row of /** @type {Iterable<HTMLElement>} */ (log.children)) {
      row.hidden = Boolean(wanted) && !(row.textContent ?? "").toLowerCase().includes(wanted);
      if (!row.hidden) found += 1;
    }
    const all = log.childElementCount;
    setText(this.#count, wanted ? say("{} of {}", found, all) : log.hidden ? say("{} lines", all) : "");
  }

  /** Undo what hides lines. */
  close() {
    this.#find.value = "";
    this.fold(false);
    this.element.remove();
  }

  /** The lines that are shown or folded, as the program wrote them. */
  #text() {
    const rows = /** @type {HTMLElement[]} */ ([...this.#shown.log.children]).filter(({ hidden }) => !hidden);
    return rows.map(({ textContent }) => `${textContent}\n`).join("");
  }

  async #copyLines() {
    let done = true;
    try {
      await navigator.clipboard.writeText(this.#text());
    } catch {
      // Without the permission, or on pages from plain http.
      done = this.#copySelection();
    }
    setText(this.#copy, done ? say("Copied") : say("Not copied"));
    setTimeout(() => setText(this.#copy, say("Copy")), SAID);
  }

  /** Copy by way of the selection, as browsers always allow after a click. */
  #copySelection() {
    const area = create("textarea", "");
    area.value = this.#text();
    this.element.append(area);
    area.select();
    const done = document.execCommand("copy");
    area.remove();
    return done;
  }

  #save() {
    const time = new Date().toISOString().slice(0, 19).replace(/[T:]/g, "-");
    const name = this.#shown.name.replace(/[^\w-]+/g, "-");
    download(new Blob([this.#text()], { type: "text/plain" }), `${name}-${time}.txt`);
  }
}
