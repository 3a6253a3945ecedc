// @ts-check
// The part of a bag that is played: its limits in fields, or where the player is, and a file of its own.

import { button, create, enable, setText } from "../../ui/elements.js";
import { say } from "../../ui/words.js";
import { clockText } from "./texts.js";

/** @import { Part } from "../../bag/orders.js" */

export class PartView {
  #change;
  #duration = 0;
  /** Where the player is, in seconds. */
  #time = 0;
  #summary = create("summary", "");
  #from = field(say("From (s)"), () => this.#read());
  #to = field(say("To (s)"), () => this.#read());
  #save;
  element;

  /** @param {(part: Part) => void} change @param {(part: Part) => Promise<void>} save as a file */
  constructor(change, save) {
    this.#change = change;
    this.#save = button(say("Save part"), "ros-save", () => this.#saveNow(save));
    this.element = create("details", "ros-bag-part", this.#summary, create("div", "ros-bag-limits",
      create("div", "ros-controls", this.#from.label, button(say("Start here"), "", () => this.#put(this.#from.input))),
      create("div", "ros-controls", this.#to.label, button(say("End here"), "", () => this.#put(this.#to.input))),
      create("div", "ros-controls", button(say("Whole bag"), "", () => this.show(this.#duration, { from: 0 }, true)), this.#save)));
  }

  /**
   * @param {number} duration of the bag in seconds @param {Part} part
   * @param {boolean} changed whether it is new to the player
   */
  show(duration, { from, to = duration }, changed = false) {
    this.#duration = duration;
    for (const { input } of [this.#from, this.#to]) input.max = String(duration);
    this.#from.input.value = String(from);
    this.#to.input.value = String(to);
    this.#tell(changed);
  }

  /** @param {number} time */
  at(time) {
    this.#time = time;
  }

  /** The part that the fields have; the whole bag has no end. @returns {Part} */
  get part() {
    const [from, to] = [this.#from.input.valueAsNumber || 0, this.#to.input.valueAsNumber];
    return to < this.#duration ? { from, to } : { from };
  }

  /** Let a limit be where the player is; the other one gives way. @param {HTMLInputElement} input */
  #put(input) {
    input.value = String(rounded(this.#time, this.#duration));
    const [from, to] = [this.#from.input, this.#to.input];
    if (from.valueAsNumber >= to.valueAsNumber) {
      if (input === from) to.value = String(this.#duration);
      else from.value = "0";
    }
    this.#read();
  }

  /** Tell what was typed, if it is a part of the bag; otherwise the field says what is wrong. */
  #read() {
    const [from, to] = [this.#from.input, this.#to.input];
    to.setCustomValidity(from.valueAsNumber < to.valueAsNumber ? "" : say("This must be later than the start."));
    const wrong = [from, to].find((input) => !input.checkValidity());
    enable([[this.#save, !wrong]]);
    if (wrong) wrong.reportValidity();
    else this.#tell(true);
  }

  /** @param {boolean} changed */
  #tell(changed) {
    const { from, to = this.#duration } = this.part;
    const all = from === 0 && to === this.#duration;
    setText(this.#summary, all ? say("Play or save a part") : say("Part: {} to {}", clockText(from), clockText(to)));
    if (changed) this.#change(this.part);
  }

  /** @param {(part: Part) => Promise<void>} save */
  async #saveNow(save) {
    enable([[this.#save, false]]);
    await save(this.part);
    enable([[this.#save, true]]);
  }
}

/** Return a time in whole milliseconds, but not after the end. @param {number} time @param {number} duration */
export function rounded(time, duration) {
  return Math.min(Math.round(time * 1000) / 1000, duration);
}

/** Return the part that a link names, such as "2-4.5". @param {string} text @param {number} duration of the bag */
export function partIn(text, duration) {
  const [, from, to] = /^(\d+(?:\.\d+)?)-(\d+(?:\.\d+)?)$/.exec(text) ?? [];
  return within({ from: Number(from), to: Number(to) }, duration);
}

/** Return what a bag has of a part; undefined if that is nothing. @param {Required<Part>} part @param {number} duration */
export function within({ from, to }, duration) {
  const end = Math.min(to, duration);
  return from >= 0 && from < end ? { from, to: end } : undefined;
}

/** A field for a time. @param {string} text @param {() => void} change */
function field(text, change) {
  const input = create("input", "");
  input.type = "number";
  input.min = "0";
  input.step = "any";
  input.required = true;
  input.addEventListener("change", change);
  return { input, label: create("label", "", text, input) };
}
