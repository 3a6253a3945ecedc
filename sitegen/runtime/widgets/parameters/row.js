// @ts-check
// A parameter of a node: its name, a control of its type, and what is known about it.

import { create, setNote, setText } from "../../ui/elements.js";
import { say } from "../../ui/words.js";
import { BOOL, DOUBLE, INTEGER, NOT_SET, nameOf, parse, plainOf, textOf, valueOf } from "../../messages/parameters/value.js";

/** @import { Parameter } from "../../messages/parameters/node.js" */

let lastId = 0;

export class Row {
  #parameter;
  #set;
  /** The text of the value that the field shows. */
  #shown = "";
  #id = `ros-parameter-${++lastId}`;
  #label = create("label", "");
  #about = create("p", "ros-parameter-about");
  #note = create("p", "ros-note");
  #type = create("small", "");
  #box = create("input", "");
  #field = create("input", "");
  #slider = create("input", "");
  element;

  /** @param {Parameter} parameter @param {(value: any) => Promise<string>} set it, and return why it was refused or "" */
  constructor(parameter, set) {
    this.#parameter = parameter;
    this.#set = set;
    const { name } = parameter;
    this.#box.type = "checkbox";
    this.#slider.type = "range";
    Object.assign(this.#field, { spellcheck: false, autocomplete: "off" });
    this.#box.id = `${this.#id}-box`;
    this.#field.id = this.#id;
    this.#slider.setAttribute("aria-label", say("slider of {}", name));
    this.#note.id = `${this.#id}-note`;
    for (const control of this.#controls) control.setAttribute("aria-describedby", this.#note.id);
    this.#box.addEventListener("change", () => this.#send(() => valueOf(this.#box.checked, BOOL)));
    this.#field.addEventListener("change", () => this.#send(() => parse(this.#field.value, this.#parameter.value.type)));
    this.#field.addEventListener("keydown", ({ key }) => {
      if (key === "Escape") this.#field.value = this.#shown;
    });
    this.#slider.addEventListener("input", () => {
      this.#field.value = this.#slider.value;
    });
    this.#slider.addEventListener("change", () =>
      this.#send(() => valueOf(Number(this.#slider.value), this.#parameter.value.type)));
    this.#label.append(name, " ", this.#type);
    const controls = create("div", "ros-parameter-value", ...this.#controls);
    this.element = create("div", "ros-parameter", this.#label, controls, this.#about, this.#note);
    this.describe(parameter);
  }

  get #controls() {
    return [this.#box, this.#slider, this.#field];
  }

  /** Show what was read again. @param {Parameter} parameter */
  describe(parameter) {
    this.#parameter = parameter;
    const { descriptor, value } = parameter;
    const help = [descriptor.description, descriptor.additional_constraints, descriptor.read_only && say("read-only")];
    setText(this.#about, help.filter(Boolean).join(" · "));
    this.#about.hidden = !this.#about.textContent;
    for (const control of this.#controls) control.disabled = Boolean(descriptor.read_only);
    this.show(value);
  }

  /** Whether the visitor has typed something that is not sent yet. */
  get #typed() {
    return document.activeElement === this.#field && this.#field.value !== this.#shown;
  }

  /**
   * Show a value, and forget what was wrong with another. What the visitor types stays until it is sent or given up.
   * @param {any} value a ParameterValue
   */
  show(value) {
    const typed = this.#typed;
    this.#parameter.value = value;
    this.#shown = textOf(value);
    const { type } = value;
    const range = this.#range();
    setText(this.#type, nameOf(type));
    this.#box.hidden = type !== BOOL;
    this.#slider.hidden = !range;
    this.#field.hidden = type === BOOL;
    this.#field.disabled = Boolean(this.#parameter.descriptor.read_only) || type === NOT_SET;
    this.#label.htmlFor = type === BOOL ? this.#box.id : this.#id;
    this.#field.inputMode = type === INTEGER ? "numeric" : type === DOUBLE ? "decimal" : "text";
    this.#box.checked = type === BOOL && plainOf(value);
    if (!typed) this.#field.value = this.#shown;
    if (range) {
      const [least, most, step] = range.map(Number);
      Object.assign(this.#slider, { min: String(least), max: String(most), step: step ? String(step) : type === INTEGER ? "1" : "any" });
      this.#slider.value = String(plainOf(value));
    }
    this.#tell("");
  }

  /** From, to and step of a range, if the parameter has one. */
  #range() {
    const { descriptor, value: { type } } = this.#parameter;
    const [range] = (type === INTEGER ? descriptor.integer_range : type === DOUBLE ? descriptor.floating_point_range : []) ?? [];
    const bounded = range && Number.isFinite(Number(range.from_value)) && Number.isFinite(Number(range.to_value));
    return bounded ? [range.from_value, range.to_value, range.step] : undefined;
  }

  /** Send what `read` returns; if it is refused, show the former value and the reason. @param {() => any} read */
  async #send(read) {
    let value;
    try {
      value = read();
    } catch (error) {
      this.#tell(error instanceof Error ? error.message : String(error));
      return;
    }
    // It is no longer what is being typed.
    this.#shown = this.#field.value;
    const reason = await this.#set(value).catch((error) => (error instanceof Error ? error.message : String(error)));
    this.show(reason ? this.#parameter.value : value);
    this.#tell(reason);
  }

  /** @param {string} text */
  #tell(text) {
    setNote(this.#note, text, Boolean(text));
    this.#note.hidden = !text;
    for (const control of this.#controls) {
      if (text) control.setAttribute("aria-invalid", "true");
      else control.removeAttribute("aria-invalid");
    }
  }
}
