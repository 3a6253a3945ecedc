// @ts-check
// The pose of a frame in another one, in the notations of tf2_echo.

import { create, setNote, setText } from "../../ui/elements.js";
import { say } from "../../ui/words.js";
import { rollPitchYaw } from "./pose.js";

/** @import { Transforms } from "./transforms.js" */

const DEGREES = 180 / Math.PI;

export class FrameEcho {
  #reference = create("select", "");
  #frame = create("select", "");
  #note = create("p", "ros-note");
  #rows = new Map([
    ["translation", say("Translation")], ["quaternion", say("Quaternion")], ["radians", say("Roll, pitch, yaw")],
    ["degrees", say("in degrees")],
  ].map(([key = "", text = ""]) => [key, { title: create("dt", "", text), value: create("dd", "") }]));
  #list = create("dl", "ros-pose", ...[...this.#rows.values()].flatMap(({ title, value }) => [title, value]));
  element;
  #given;

  /** @param {string} reference @param {string} frame what the page's author chose, or "" */
  constructor(reference, frame) {
    this.#given = { reference, frame };
    this.#frame.setAttribute("aria-label", say("Pose of frame"));
    this.#reference.setAttribute("aria-label", say("in frame"));
    for (const select of [this.#reference, this.#frame]) select.addEventListener("change", () => this.#again?.());
    const choices = create("div", "ros-frame-choice",
      create("label", "", say("Pose of"), this.#frame), create("label", "", say("in"), this.#reference));
    this.element = create("section", "ros-frame-echo", choices, this.#note, this.#list);
    this.element.setAttribute("aria-label", say("transform between two frames"));
    this.offer([]);
  }

  /** Shows the present choice. @type {(() => void) | undefined} */
  #again;

  /** Let the visitor choose among these. @param {string[]} frames */
  offer(frames) {
    /** @type {[HTMLSelectElement, string][]} */
    const both = [[this.#reference, this.#given.reference], [this.#frame, this.#given.frame]];
    for (const [select, given] of both) {
      const chosen = select.value || given;
      const names = chosen && !frames.includes(chosen) ? [chosen, ...frames] : frames;
      select.replaceChildren(new Option(say("choose a frame"), ""), ...names.map((name) => new Option(name)));
      select.value = chosen;
    }
  }

  /** Show the latest transform. @param {Transforms} transforms */
  show(transforms) {
    this.#again = () => this.show(transforms);
    const [reference, frame] = [this.#reference.value, this.#frame.value];
    const { pose, fault } = reference && frame ? transforms.lookup(reference, frame) : { pose: undefined, fault: "" };
    setNote(this.#note, fault, true);
    this.#list.hidden = !pose;
    if (!pose) return;
    const angles = rollPitchYaw(pose.rotation);
    this.#set("translation", pose.position, 3, "m");
    this.#set("quaternion", pose.rotation, 4, "");
    this.#set("radians", angles, 3, "rad");
    this.#set("degrees", angles.map((angle) => angle * DEGREES), 1, "°");
  }

  /** What a link keeps, if the visitor chose something else. */
  kept() {
    const { reference, frame } = this.#given;
    const differs = (/** @type {string} */ now, /** @type {string} */ before) => (now === before ? "" : now);
    return {
      reference: differs(this.#reference.value, reference), frame: differs(this.#frame.value, frame),
    };
  }

  /** @param {Record<string, any>} state as `kept` returned it */
  restore({ reference, frame }) {
    for (const select of [this.#reference, this.#frame]) select.replaceChildren();
    this.#given = { reference: reference || this.#given.reference, frame: frame || this.#given.frame };
    this.offer([]);
  }

  /** @param {string} key @param {readonly number[]} numbers @param {number} decimals @param {string} unit */
  #set(key, numbers, decimals, unit) {
    // Without "-0.000".
    const texts = numbers.map((number) => (Number(number.toFixed(decimals)) || 0).toFixed(decimals));
    const value = this.#rows.get(key)?.value;
    if (value) setText(value, `${texts.join(", ")} ${unit}`.trim());
  }
}
