// @ts-check
// The errors of an author's panel, shown in the panel; the rest of the page goes on.

import { create, setText } from "../../ui/elements.js";

export class Faults {
  #file;
  #address;
  #listening = new AbortController();
  #said = "";
  element = create("p", "ros-note ros-wrong");

  /** @param {string} file of the panel @param {string} address of its module */
  constructor(file, address) {
    this.#file = file;
    this.#address = address;
    this.element.setAttribute("role", "alert");
    const { signal } = this.#listening;
    // Handlers of elements and timers are the browser's to call; the stack of an error tells whose it is.
    addEventListener("error", (event) => {
      if (this.#isOwn(event.error)) this.show(event.error);
    }, { signal });
    addEventListener("unhandledrejection", (event) => {
      if (this.#isOwn(event.reason)) this.show(event.reason);
    }, { signal });
  }

  /**
   * Return a function that shows what `work` throws, and what a promise of it is rejected with.
   * @template {(...given: any[]) => any} Work
   * @param {Work} work @returns {(...given: Parameters<Work>) => void}
   */
  guard(work) {
    return (...given) => {
      try {
        Promise.resolve(work(...given)).catch((error) => this.show(error));
      } catch (error) {
        this.show(error);
      }
    };
  }

  /** @param {unknown} error */
  show(error) {
    const text = `${this.#place(error)}: ${error instanceof Error ? error : `Error: ${error}`}`;
    // A callback may fail a thousand times a second.
    if (text === this.#said) return;
    this.#said = text;
    setText(this.element, text.slice(0, 1000));
    console.error(error);
  }

  close() {
    this.#listening.abort();
  }

  /** The file of the panel, with the line if the stack tells. @param {unknown} error */
  #place(error) {
    const stack = error instanceof Error ? error.stack ?? "" : "";
    const at = stack.indexOf(`${this.#address}:`);
    const line = at < 0 ? undefined : /^\d+/.exec(stack.slice(at + this.#address.length + 1))?.[0];
    return line ? `${this.#file}:${line}` : this.#file;
  }

  /** @param {unknown} error */
  #isOwn(error) {
    return error instanceof Error && (error.stack ?? "").includes(this.#address);
  }
}
