// @ts-check
// Drive a turtle with the arrow keys or with buttons.

import { create } from "../../../ui/elements.js";
import { tool } from "../../../ui/toolbar.js";
import { say } from "../../../ui/words.js";
import { ArrowDown, ArrowUp, RotateCcw, RotateCw } from "../../../vendor/icons.js";

/** @import { Publisher, Ros } from "../../../protocol.js" */

const TWIST = "geometry_msgs/msg/Twist";
// The speed (m/s) and the turning rate (rad/s) of one key press, as in turtle_teleop_key.
const SPEED = 2;

/** Publishes commands for the chosen turtle. Publishers are created when they are first used. */
export class Driver {
  #ros;
  #topic;
  #missed;
  /** @type {Map<string, Publisher>} */
  #publishers = new Map();

  /**
   * @param {Ros} ros @param {() => string | undefined} topic of the chosen turtle
   * @param {() => void} missed called for a command while there is no turtle
   */
  constructor(ros, topic, missed) {
    this.#ros = ros;
    this.#topic = topic;
    this.#missed = missed;
  }

  /** @param {number} linear @param {number} angular */
  drive(linear, angular) {
    const topic = this.#topic();
    if (!topic) {
      this.#missed();
      return;
    }
    const publisher = this.#publishers.get(topic) ?? this.#ros.advertise(topic, TWIST);
    this.#publishers.set(topic, publisher);
    publisher.publish({ linear: { x: linear, y: 0, z: 0 }, angular: { x: 0, y: 0, z: angular } });
  }

  close() {
    for (const publisher of this.#publishers.values()) publisher.close();
  }
}

/**
 * Create the buttons, and handle the arrow keys while the drawing has the keyboard focus.
 * @param {Element} drawing @param {Driver} driver
 */
export function createPad(drawing, driver) {
  const ways = [
    { key: "ArrowLeft", icon: RotateCcw, name: say("Turn left"), linear: 0, angular: SPEED },
    { key: "ArrowUp", icon: ArrowUp, name: say("Forward"), linear: SPEED, angular: 0 },
    { key: "ArrowDown", icon: ArrowDown, name: say("Backward"), linear: -SPEED, angular: 0 },
    { key: "ArrowRight", icon: RotateCw, name: say("Turn right"), linear: 0, angular: -SPEED },
  ];
  drawing.addEventListener("keydown", (event) => {
    const { key, ctrlKey, metaKey, altKey } = /** @type {KeyboardEvent} */ (event);
    const way = ways.find((one) => one.key === key);
    if (!way || ctrlKey || metaKey || altKey) return;
    event.preventDefault();
    driver.drive(way.linear, way.angular);
  });
  const pad = create("div", "ros-pad", ...ways.map(({ icon, name, linear, angular }) =>
    tool(name, icon, () => driver.drive(linear, angular))));
  pad.setAttribute("role", "group");
  pad.setAttribute("aria-label", say("Drive"));
  return pad;
}
