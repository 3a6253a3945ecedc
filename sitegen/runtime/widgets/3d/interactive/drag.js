// @ts-check
// How a pointer that moves a control moves its marker.

import { Plane, Quaternion, Vector3 } from "../../../vendor/three.js";
import { MODES, modeOf } from "./modes.js";

/** @import { Control, Handle } from "./handle.js" */

// Radians for each pixel, where the marker is turned freely.
const TURN = 0.01;
const { moveAxis, rotateAxis, move3d, rotate3d, moveRotate3d } = MODES;

/** Whether a control moves its marker. @param {Control} control */
export function isMoving({ mode }) {
  return mode >= moveAxis && mode <= moveRotate3d;
}

export class Drag {
  #handle;
  #camera;
  /** @type {number} */
  #mode;
  #axis;
  /** Where the marker was, and how it was turned, in the scene. */
  #position = new Vector3();
  #rotation = new Quaternion();
  #grabbed;
  /** @type {any} */
  #plane;
  /** Where the pointer was. */
  /** @type {number} */
  #x;
  /** @type {number} */
  #y;

  /**
   * @param {Handle} handle @param {Control} control @param {any} point where it was grabbed @param {any} camera
   * @param {{offsetX: number, offsetY: number, shiftKey: boolean}} event
   */
  constructor(handle, control, point, camera, { offsetX, offsetY, shiftKey }) {
    this.#handle = handle;
    this.#camera = camera;
    this.#axis = handle.axis(control);
    this.#grabbed = point.clone();
    [this.#x, this.#y] = [offsetX, offsetY];
    this.#mode = modeOf(control, shiftKey);
    handle.body.getWorldPosition(this.#position);
    handle.body.getWorldQuaternion(this.#rotation);
    const towards = camera.getWorldDirection(new Vector3());
    if (this.#mode === rotateAxis) this.#plane = new Plane().setFromNormalAndCoplanarPoint(this.#axis, this.#position);
    else if (this.#mode === move3d) this.#plane = new Plane().setFromNormalAndCoplanarPoint(towards, point);
    else this.#plane = new Plane().setFromNormalAndCoplanarPoint(this.#axis, point);
    if (this.#mode === rotateAxis) this.#grabbed = this.#plane.projectPoint(point, new Vector3());
  }

  /** Move the marker to where the pointer is. @param {any} ray @param {{offsetX: number, offsetY: number}} event */
  to(ray, { offsetX, offsetY }) {
    const position = this.#position.clone();
    const rotation = this.#rotation.clone();
    if (this.#mode === moveAxis) {
      position.addScaledVector(this.#axis, this.#along(ray));
    } else if (this.#mode === rotate3d) {
      const turn = (/** @type {number} */ column, /** @type {number} */ angle) => new Quaternion().setFromAxisAngle(
        new Vector3().setFromMatrixColumn(this.#camera.matrixWorld, column).normalize(), angle);
      rotation.premultiply(turn(1, (offsetX - this.#x) * TURN)).premultiply(turn(0, (offsetY - this.#y) * TURN));
    } else {
      const hit = ray.intersectPlane(this.#plane, new Vector3());
      // The pointer is beyond the horizon of the plane.
      if (!hit) return;
      if (this.#mode === rotateAxis) rotation.premultiply(this.#turned(hit));
      else position.add(hit).sub(this.#grabbed);
    }
    if (![...position.toArray(), ...rotation.toArray()].every(Number.isFinite)) return;
    this.#handle.put(position, rotation);
  }

  /** How far the point of the axis that is nearest to a ray is from where it was grabbed. @param {any} ray */
  #along(ray) {
    const between = ray.origin.clone().sub(this.#grabbed);
    const cosine = this.#axis.dot(ray.direction);
    const square = 1 - cosine * cosine;
    // The visitor looks along the axis.
    if (square < 1e-4) return 0;
    return (between.dot(this.#axis) - between.dot(ray.direction) * cosine) / square;
  }

  /** @param {any} hit */
  #turned(hit) {
    const from = this.#grabbed.clone().sub(this.#position).normalize();
    const to = hit.clone().sub(this.#position).normalize();
    const angle = Math.atan2(from.clone().cross(to).dot(this.#axis), from.dot(to));
    return new Quaternion().setFromAxisAngle(this.#axis, Number.isFinite(angle) ? angle : 0);
  }
}
