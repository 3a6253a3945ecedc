// @ts-check
// How a key moves the marker of a control.

import { Quaternion, Vector3 } from "../../../vendor/three.js";
import { MODES, modeOf } from "./modes.js";

/** @import { Control, Handle } from "./handle.js" */

// A step is this part of the marker's size, or this angle (radians).
const STEP = 0.05;
const ANGLE = Math.PI / 36;
const { moveAxis, movePlane, rotateAxis, move3d, rotate3d } = MODES;

/** Which axis of a control a key is for, and in which direction. @type {Record<string, [number, number]>} */
const KEYS = {
  ArrowRight: [0, 1], ArrowLeft: [0, -1], ArrowUp: [1, 1], ArrowDown: [1, -1], PageUp: [2, 1], PageDown: [2, -1],
};

/** Whether a key moves the marker of a control. @param {string} key @param {Control} control */
export function isNudge(key, { mode }) {
  const [which] = KEYS[key] ?? [];
  return which !== undefined && (which < 2 || mode >= move3d);
}

/**
 * Move a marker by one step. Along or around an axis, both pairs of arrow keys do the same; in a plane, each pair has
 * a direction of its own; freely, arrow and Page keys stand for the axes of the control. With `shift`, they turn what
 * can be moved and turned.
 * @param {Handle} handle @param {Control} control @param {string} key @param {boolean} shift
 */
export function nudge(handle, control, key, shift) {
  const [which, sign] = /** @type {[number, number]} */ (KEYS[key]);
  const mode = modeOf(control, shift);
  const position = handle.body.getWorldPosition(new Vector3());
  const rotation = handle.body.getWorldQuaternion(new Quaternion());
  const axis = handle.axis(control, axisOf(mode, which));
  if (mode === rotateAxis || mode === rotate3d) rotation.premultiply(new Quaternion().setFromAxisAngle(axis, sign * ANGLE));
  else position.addScaledVector(axis, sign * STEP * handle.scale);
  handle.put(position, rotation);
}

/** Which axis of a control a key stands for. @param {number} mode @param {number} which */
function axisOf(mode, which) {
  if (mode === moveAxis || mode === rotateAxis) return 0;
  // The plane is perpendicular to the first.
  return mode === movePlane ? which + 1 : which;
}
