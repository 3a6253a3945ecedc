// @ts-check
// A turtle: where it is, how it looks, and the line that it draws.

import { shape } from "../../../ui/elements.js";
import { pixels } from "./paper.js";

/** @import { Ros } from "../../../protocol.js" */
/** @import { Paper } from "./paper.js" */

const SHELLS = ["#6ec25b", "#e8a33d", "#d76fb0", "#5fc4c4", "#c9c14a", "#b78be0"];
// ROS 2 distributions differ in the package.
const POSES = ["turtlesim/msg/Pose", "turtlesim_msgs/msg/Pose"];

export class Turtle {
  /** Its part of the last turtlesim_window/msg/Window. @type {any} */
  look;
  /** The last pose, if any. @type {any} */
  pose;
  /** Where its line continues. @type {any} */
  #end;
  #body;
  #label = shape("text", { class: "ros-turtle-name", y: 36, "text-anchor": "middle" });
  #unsubscribe = () => {};

  /** @param {Ros} ros @param {any} look @param {Paper} paper @param {() => void} changed */
  constructor(ros, look, paper, changed) {
    this.look = look;
    this.#body = createBody(look.number);
    this.#label.textContent = look.name;
    const type = POSES.find((name) => ros.types[name]);
    if (!type) return;
    this.#unsubscribe = ros.subscribe(look.pose, type, (pose) => {
      if (this.#end && this.look.width) paper.line(this.look, this.#end, pose);
      this.pose = this.#end = pose;
      changed();
    });
  }

  /** Do not continue its line, because the paper was cleared. */
  lift() {
    this.#end = undefined;
  }

  /** Draw it in `layer`. @param {Element} layer @param {boolean} named whether its name is shown */
  draw(layer, named) {
    if (!this.pose) return;
    const [x, y] = pixels(this.pose);
    this.#body.setAttribute("transform", `translate(${x} ${y}) rotate(${(-this.pose.theta * 180) / Math.PI})`);
    this.#label.setAttribute("transform", `translate(${x} ${y})`);
    if (!this.#body.isConnected) layer.append(this.#body);
    if (named) layer.append(this.#label);
    else this.#label.remove();
  }

  close() {
    this.#unsubscribe();
    this.#body.remove();
    this.#label.remove();
  }
}

/** A turtle that faces right. @param {number} number */
function createBody(number) {
  const leg = (/** @type {number} */ x, /** @type {number} */ y, /** @type {number} */ turn) =>
    shape("ellipse", { class: "ros-skin", rx: 7, ry: 4, transform: `translate(${x} ${y}) rotate(${turn})` });
  const turtle = shape("g", { class: "ros-turtle" },
    leg(10, -13, -50), leg(10, 13, 50), leg(-11, -12, 40), leg(-11, 12, -40),
    shape("path", { class: "ros-skin", d: "M -15 -3 L -24 0 L -15 3 Z" }),
    shape("ellipse", { class: "ros-skin", cx: 20, rx: 7, ry: 5.5 }),
    shape("circle", { class: "ros-turtle-eye", cx: 22.5, cy: -2.6, r: 1.2 }),
    shape("circle", { class: "ros-turtle-eye", cx: 22.5, cy: 2.6, r: 1.2 }),
    shape("ellipse", { class: "ros-shell", rx: 16, ry: 13 }),
    shape("path", { class: "ros-plates", d: "M -7 0 L -3 -6 H 5 L 9 0 L 5 6 H -3 Z M -7 0 H -16 M 9 0 H 16 M -3 -6 L -7 -12 M -3 6 L -7 12 M 5 -6 L 8 -11 M 5 6 L 8 11" }));
  turtle.style.setProperty("--shell", SHELLS[(number - 1) % SHELLS.length] ?? "");
  return turtle;
}
