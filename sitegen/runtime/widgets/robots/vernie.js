// @ts-check
// Vernie, a LEGO BOOST robot with two tracks and a light: drawn from above, or connected over Bluetooth.

import { shape, toggle } from "../../ui/elements.js";
import { say } from "../../ui/words.js";
import { obstacle } from "./parts/bluetooth.js";
import { obey, TWIST } from "./parts/commands.js";
import { createFloor } from "./parts/floor.js";
import { describe, drive } from "./parts/motion.js";
import { createSenses } from "./parts/senses.js";
import { Connection } from "./vernie/connection.js";
import { Light, STRING } from "./vernie/light.js";

/** @import { Ros } from "../../protocol.js" */
/** @import { Robot } from "./parts/robot.js" */
/** @import { Pose } from "./parts/motion.js" */

/** @typedef {{color: string, twist: string, sensors: string}} Options topics, and the prefix of the sensors' topics */

// The speed of a track at full power (m/s), and the distance between the tracks (m).
const FULL_SPEED = 0.3;
const APART = 0.16;
const START = { x: 0, y: 0, heading: Math.PI / 2 };

/**
 * Return the power (%) of the motors for a command. 1 m/s and 1 rad/s are both full power; a command that is too
 * much for one motor slows both in proportion.
 * @param {number} speed in m/s @param {number} turn in rad/s
 * @returns {[a: number, b: number]} of the left and the right motor
 */
export function motorPower(speed, turn) {
  const [a, b] = [speed - turn, speed + turn];
  const largest = Math.max(1, Math.abs(a), Math.abs(b));
  const percent = (/** @type {number} */ share) => Math.round((100 * share) / largest) || 0;
  return [percent(a), percent(b)];
}

/**
 * @param {Ros} ros
 * @param {Options} options
 * @param {() => void} changed
 * @returns {Robot}
 */
export function create(ros, options, changed) {
  return new Vernie(ros, options, changed);
}

class Vernie {
  #changed;
  #light;
  #senses;
  #connection;
  #floor;
  #hand = toggle(say("Hand in front of it"), (held) => this.#senses.hold(held));
  #stopObeying;
  /** @type {Pose} */
  #pose = START;
  /** Of the left and the right motor, in percent. @type {[number, number]} */
  #power = [0, 0];
  /** Why it stopped, or "". */
  #reason = "";
  title = "Vernie";
  inputs;
  drawing;
  waits;
  controls;

  /** @param {Ros} ros @param {Options} options @param {() => void} changed */
  constructor(ros, { color, twist, sensors }, changed) {
    this.#changed = changed;
    this.inputs = [{ topic: color, type: STRING }, { topic: twist, type: TWIST }];
    this.waits = twist;
    this.#light = new Light(ros, color, () => {
      if (!this.#light.unknown) this.#connection.hub?.light(this.#light.index);
      changed();
    });
    this.#senses = createSenses(ros, sensors, changed);
    this.#connection = new Connection(this.#senses.listener, () => this.#connectionChanged());
    this.#hand.hidden = !this.#senses.seen;
    this.controls = [this.#hand, this.#connection.button];
    this.#floor = createFloor(say("Vernie, seen from above"), body(this.#light.glow, this.#light.bulb));
    this.drawing = this.#floor.element;
    this.#stopObeying = obey(ros, twist, (speed, turn) => this.#drive(speed, turn), (why) => this.#halt(why));
  }

  /** @param {number} seconds */
  advance(seconds) {
    const [a, b] = this.#power;
    const [left, right] = [(a / 100) * FULL_SPEED, (b / 100) * FULL_SPEED];
    const moving = a !== 0 || b !== 0;
    if (moving) this.#pose = drive(this.#pose, (left + right) / 2, (right - left) / APART, seconds);
    this.#floor.place(this.#pose);
    return moving;
  }

  readings() {
    const { hub } = this.#connection;
    const [a, b] = this.#power;
    return [
      { name: say("Robot"), text: hub?.name ?? say("simulated") },
      ...(hub ? this.#senses.readings() : []),
      { name: say("Light"), text: this.#light.color, color: this.#light.look },
      { name: say("Motor {}", "A"), text: `${a} %`, level: a / 100 },
      { name: say("Motor {}", "B"), text: `${b} %`, level: b / 100 },
      ...describe(this.#pose),
    ];
  }

  note() {
    const { unknown, names } = this.#light;
    if (this.#connection.trouble) return { text: this.#connection.trouble, wrong: true };
    if (unknown) {
      return { text: say("The light has no colour '{}'; choose one of {}", unknown, names.join(", ")), wrong: true };
    }
    return { text: this.#reason ? say("Stopped: {}", this.#reason) : obstacle(), wrong: false };
  }

  reset() {
    this.#pose = START;
    this.#floor.clear();
    this.#changed();
  }

  close() {
    this.#stopObeying();
    this.#light.close();
    this.#connection.close();
    this.#senses.close();
  }

  /** @param {number} speed in m/s @param {number} turn in rad/s */
  #drive(speed, turn) {
    this.#power = motorPower(speed, turn);
    this.#reason = "";
    this.#connection.hub?.drive(...this.#power);
    this.#changed();
  }

  /** @param {string} reason */
  #halt(reason) {
    this.#power = [0, 0];
    this.#reason = reason;
    this.#connection.hub?.halt();
    this.#changed();
  }

  #connectionChanged() {
    const { hub, connecting } = this.#connection;
    this.#hand.hidden = !this.#senses.seen || hub !== undefined;
    if (hub) {
      hub.light(this.#light.index);
      hub.drive(...this.#power);
    } else if (connecting) {
      // From now on the real robot publishes what it sees.
      if (this.#hand.querySelector("input")?.checked) this.#hand.click();
    } else {
      this.#senses.clear();
    }
    this.#changed();
  }
}

/** Two tracks, a body, arms and a head with eyes. @param {Element} glow @param {Element} light */
function body(glow, light) {
  const track = (/** @type {number} */ y) =>
    shape("rect", { class: "ros-wheel", x: -0.085, y, width: 0.17, height: 0.042, rx: 0.018 });
  const arm = (/** @type {number} */ y) =>
    shape("rect", { class: "ros-arm", x: 0.02, y, width: 0.085, height: 0.026, rx: 0.013 });
  const eye = (/** @type {number} */ y) => shape("circle", { class: "ros-eye", cx: 0.062, cy: y, r: 0.011 });
  return shape("g", {},
    glow,
    track(0.053), track(-0.095),
    arm(0.05), arm(-0.076),
    shape("rect", { class: "ros-hull", x: -0.075, y: -0.06, width: 0.135, height: 0.12, rx: 0.03 }),
    shape("rect", { class: "ros-head", x: -0.012, y: -0.044, width: 0.088, height: 0.088, rx: 0.03 }),
    eye(0.023), eye(-0.023),
    light);
}
