// @ts-check
// Drive a robot with a stick, keys or a gamepad.

import { RosClock } from "../messages/rosClock.js";
import { create, setNote, setText } from "../ui/elements.js";
import { whileSeen } from "../ui/looking.js";
import { say } from "../ui/words.js";
import { Keys, NOTHING, Stick, readGamepad } from "./teleop/inputs.js";

/** @import { Publisher, Ros } from "../protocol.js" */
/** @import { Drive } from "./teleop/inputs.js" */

const TWIST = "geometry_msgs/msg/Twist";
const STAMPED = "geometry_msgs/msg/TwistStamped";
const JOY = "sensor_msgs/msg/Joy";
// Milliseconds between two messages; robots stop if none comes for a while.
const PERIOD = 100;

/**
 * @typedef {{topic?: string, stamped?: boolean, linear?: string, angular?: string, joy?: string | null,
 *   deadman?: boolean}} Options the topic, whether its messages have a header, the largest speeds (m/s and rad/s), a
 *   topic for the gamepad itself, and whether a second key or button must be held
 */

/**
 * Show a stick.
 * @param {HTMLElement} element
 * @param {Ros} ros
 * @param {Options} options
 * @returns {() => void} unmount
 */
export function mount(element, ros, options) {
  const teleop = new Teleop(ros, options);
  element.replaceChildren(...teleop.elements);
  ros.keep(element, { linear: "string", angular: "string" }, () => teleop.kept(), (state, odd) => teleop.restore(state, odd));
  const unlook = whileSeen(element, () => teleop.begin());
  return () => {
    unlook();
    element.replaceChildren();
  };
}

class Teleop {
  #ros;
  #clock;
  #topic;
  #type;
  #joy;
  #guarded;
  #keys;
  #stick;
  #linear;
  #angular;
  #readout = create("output", "ros-teleop-now");
  #note = create("p", "ros-note");
  /** @type {Publisher | undefined} */
  #publisher;
  /** @type {Publisher | undefined} */
  #joyPublisher;
  #driving = false;
  #seen = false;
  elements;

  /** @param {Ros} ros @param {Options} options */
  constructor(ros, { topic = "/cmd_vel", stamped = false, linear = "0.5", angular = "1.0", joy, deadman = false }) {
    this.#ros = ros;
    this.#clock = new RosClock(ros);
    this.#topic = topic;
    this.#type = stamped ? STAMPED : TWIST;
    this.#joy = joy ?? "";
    this.#guarded = deadman;
    this.#linear = speed(say("Speed"), "m/s", linear);
    this.#angular = speed(say("Turn"), "rad/s", angular);
    const knob = create("span", "ros-knob");
    const base = create("div", "ros-stick", knob);
    base.tabIndex = 0;
    base.setAttribute("role", "application");
    base.setAttribute("aria-label", deadman
      ? say("Stick; hold Shift and the arrow keys to drive") : say("Stick; hold the arrow keys to drive"));
    this.#stick = new Stick(base, knob, () => this.#send());
    this.#keys = new Keys(base, () => this.#send());
    base.addEventListener("pointerdown", () => base.focus({ preventScroll: true }));
    const heading = create("div", "ros-node", create("span", "ros-title", say("Drive")), create("span", "ros-type", topic));
    const hint = create("p", "ros-teleop-help", help(deadman));
    const side = create("div", "ros-teleop-side", this.#linear.element, this.#angular.element, this.#readout, hint, this.#note);
    this.elements = [create("div", "ros-bar", heading), create("div", "ros-teleop-body", base, side)];
    this.#tell(NOTHING);
  }

  /** @returns {() => void} stop the robot and end it */
  begin() {
    this.#seen = true;
    const missing = [this.#type, ...(this.#joy ? [JOY] : [])].find((type) => !this.#ros.types[type]);
    setNote(this.#note, missing ? say("no node on this page uses {}", missing) : "", true);
    if (missing) return () => {};
    this.#publisher = this.#ros.advertise(this.#topic, this.#type);
    if (this.#joy) this.#joyPublisher = this.#ros.advertise(this.#joy, JOY);
    const timer = setInterval(() => this.#send(), PERIOD);
    // A Twist has no stamp.
    const unfollow = this.#type === STAMPED || this.#joy ? this.#clock.follow(this.#ros.graph) : () => {};
    return () => {
      this.#seen = false;
      clearInterval(timer);
      unfollow();
      this.#keys.clear();
      this.#stick.clear();
      this.#send();
      this.#publisher?.close();
      this.#joyPublisher?.close();
      this.#publisher = undefined;
      this.#joyPublisher = undefined;
    };
  }

  kept() {
    return { linear: this.#linear.changed(), angular: this.#angular.changed() };
  }

  /** @param {Record<string, string>} state @param {() => void} odd */
  restore({ linear, angular }, odd) {
    if (linear && !this.#linear.restore(linear)) odd();
    if (angular && !this.#angular.restore(angular)) odd();
  }

  /** Publish where to drive, and zero once after that. */
  #send() {
    if (!this.#publisher) return;
    const pad = this.#seen ? readGamepad(this.#guarded) : undefined;
    const inputs = this.#seen ? [this.#stick.read(), this.#keys.read(this.#guarded), pad?.drive ?? NOTHING] : [];
    const drive = inputs.find(({ forward, left }) => forward || left) ?? NOTHING;
    // What moves or stops the robot comes first, whatever happens to the rest.
    const faults = [this.#publishDrive(drive), pad ? this.#publishJoy(pad) : ""].filter(Boolean);
    setNote(this.#note, faults[0] ?? "", faults.length > 0);
  }

  /** Return what is wrong. @param {Drive} drive */
  #publishDrive(drive) {
    const drives = drive !== NOTHING;
    if (!drives && !this.#driving) return "";
    const twist = {
      linear: { x: drive.forward * this.#linear.value(), y: 0, z: 0 },
      angular: { x: 0, y: 0, z: drive.left * this.#angular.value() },
    };
    this.#tell(drive);
    const fault = attempt(() => this.#publisher?.publish(this.#type === STAMPED ? { header: this.#header(), twist } : twist));
    // The queue of a robot that reads too slowly: the command to stop must not be lost.
    this.#driving = drives || Boolean(fault);
    return fault;
  }

  /** Return what is wrong. @param {{axes: number[], buttons: number[]}} pad */
  #publishJoy({ axes, buttons }) {
    const message = { header: this.#header(), axes: Float32Array.from(axes), buttons: Int32Array.from(buttons) };
    return attempt(() => this.#joyPublisher?.publish(message));
  }

  #header() {
    return { stamp: this.#clock.now(), frame_id: "" };
  }

  /** @param {Drive} drive */
  #tell({ forward, left }) {
    const x = (forward * this.#linear.value()).toFixed(2);
    const z = (left * this.#angular.value()).toFixed(2);
    setText(this.#readout, say("{} m/s, {} rad/s", x, z));
  }
}

/** Do something, and return what is wrong. @param {() => void} act */
function attempt(act) {
  try {
    act();
    return "";
  } catch (error) {
    return error instanceof Error ? error.message : String(error);
  }
}

/** A slider for the largest speed, up to twice the given one. @param {string} text @param {string} unit @param {string} given */
function speed(text, unit, given) {
  const most = Math.abs(Number(given)) || 1;
  const slider = create("input", "");
  Object.assign(slider, { type: "range", min: "0", max: String(2 * most), step: String(most / 20), value: String(most) });
  const shown = create("span", "ros-quiet");
  const show = () => setText(shown, `${Number(slider.value).toFixed(2)} ${unit}`);
  slider.addEventListener("input", show);
  show();
  return {
    element: create("label", "ros-speed", text, slider, shown),
    value: () => Number(slider.value),
    changed: () => (Number(slider.value) === most ? "" : slider.value),
    /** @param {string} value */
    restore(value) {
      const number = Number(value);
      if (!(number >= 0 && number <= 2 * most)) return false;
      slider.value = value;
      show();
      return true;
    },
  };
}

/** How to drive. @param {boolean} deadman */
function help(deadman) {
  // Phones have no keys.
  if (matchMedia("(hover: none) and (pointer: coarse)").matches) {
    return deadman
      ? say("Drag the stick to drive. A gamepad works, too, while a shoulder button is held.")
      : say("Drag the stick to drive. A gamepad works, too.");
  }
  return deadman
    ? say("Drag the stick. Or click it and hold Shift with the arrow keys or W, A, S, D; a gamepad needs a shoulder button.")
    : say("Drag the stick. Or click it and hold the arrow keys or W, A, S, D. A gamepad works, too.");
}
