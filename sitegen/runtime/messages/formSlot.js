// @ts-check
// The place of a form whose message type may become known, or change, while the page is open.

import { create } from "../ui/elements.js";
import { createForm } from "./form.js";

/** @import { Types } from "./form.js" */

export class FormSlot {
  #types;
  element = create("div", "ros-place");
  /** @type {ReturnType<typeof createForm> | undefined} */
  #form;
  #owner = "";
  /** What a link fills in, until its form exists. @type {{owner: string, values: any, odd: () => void} | undefined} */
  #given;

  /** @param {Types} types */
  constructor(types) {
    this.#types = types;
  }

  /** Whether there is a form now. */
  get filled() {
    return this.#form !== undefined;
  }

  /**
   * Show a new form for `type`, or none if that is empty. Throws an Error if the page does not know the type.
   * @param {string} type @param {string} [owner] the topic or service that it is for
   */
  show(type, owner = "") {
    this.#owner = owner;
    this.#form = undefined;
    this.element.replaceChildren();
    if (!type) return;
    const form = createForm(type, this.#types);
    this.#form = form;
    this.element.replaceChildren(form.element);
    if (this.#given?.owner !== owner) return;
    if (!form.fill(this.#given.values)) this.#given.odd();
    this.#given = undefined;
  }

  /** The message, or undefined after showing what is wrong with it. */
  read() {
    return this.#form?.read() ?? undefined;
  }

  /** What the visitor has changed in the form, for links. */
  typed() {
    return this.#given?.owner === this.#owner ? this.#given.values : this.#form?.typed();
  }

  /**
   * Fill in `values` as soon as the form of `owner` is shown, and call `odd` if they do not fit.
   * @param {any} values as `typed` returned them @param {() => void} odd @param {string} [owner]
   */
  fill(values, odd, owner = "") {
    this.#given = values ? { owner, values, odd } : undefined;
  }
}
