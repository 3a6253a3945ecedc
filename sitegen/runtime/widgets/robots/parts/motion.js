// @ts-check
// The motion of a robot on wheels.

import { say } from "../../../ui/words.js";

/** @typedef {{x: number, y: number, heading: number}} Pose metres, and radians counter-clockwise from x */

/**
 * Return the pose after driving along an arc, at a constant speed (m/s) and turning rate (rad/s).
 * @param {Pose} pose @param {number} speed @param {number} turn @param {number} seconds
 * @returns {Pose}
 */
export function drive({ x, y, heading }, speed, turn, seconds) {
  const angle = turn * seconds;
  // The chord of the arc; for very small angles its length is that of the arc.
  const chord = speed * seconds * (Math.abs(angle) < 1e-6 ? 1 : Math.sin(angle / 2) / (angle / 2));
  return {
    x: x + chord * Math.cos(heading + angle / 2),
    y: y + chord * Math.sin(heading + angle / 2),
    heading: heading + angle,
  };
}

/** Return a pose as readings. @param {Pose} pose */
export function describe({ x, y, heading }) {
  const turn = Math.atan2(Math.sin(heading), Math.cos(heading));
  return [
    { name: say("Position"), text: `${plain(x, 2)}, ${plain(y, 2)} m` },
    { name: say("Heading"), text: `${plain((turn * 180) / Math.PI, 0)}°` },
  ];
}

/** Format a number, without negative zero. @param {number} value @param {number} digits */
export function plain(value, digits) {
  const text = value.toFixed(digits);
  return Number(text) === 0 ? text.replace("-", "") : text;
}
