// @ts-check
// Where a robot on wheels comes to.

import { say } from "../../../ui/words.js";

/** @typedef {{x: number, y: number, heading: number}} Pose metres, and radians counter-clockwise from x */

/**
 * Drive for some time, at a speed (m/s) and a turning rate (rad/s) that stay the same: along an arc.
 * @param {Pose} pose @param {number} speed @param {number} turn @param {number} seconds
 * @returns {Pose}
 */
export function drive({ x, y, heading }, speed, turn, seconds) {
  const angle = turn * seconds;
  // The chord of the arc; for small angles it is the arc itself.
  const chord = speed * seconds * (Math.abs(angle) < 1e-6 ? 1 : Math.sin(angle / 2) / (angle / 2));
  return {
    x: x + chord * Math.cos(heading + angle / 2),
    y: y + chord * Math.sin(heading + angle / 2),
    heading: heading + angle,
  };
}

/** A pose to be read. @param {Pose} pose */
export function describe({ x, y, heading }) {
  const turn = Math.atan2(Math.sin(heading), Math.cos(heading));
  return [
    { name: say("Position"), text: `${plain(x, 2)}, ${plain(y, 2)} m` },
    { name: say("Heading"), text: `${plain((turn * 180) / Math.PI, 0)}°` },
  ];
}

/** A number without a negative zero. @param {number} value @param {number} digits */
export function plain(value, digits) {
  const text = value.toFixed(digits);
  return Number(text) === 0 ? text.replace("-", "") : text;
}
