// @ts-check
// How a control looks that has no markers of its own: arrows along its axis, or a ring around it.

import { Color, DoubleSide, Mesh, MeshLambertMaterial, RingGeometry, SphereGeometry, Vector3 } from "../../../vendor/three.js";
import { Arrows } from "../shapes.js";
import { MODES } from "./modes.js";

/** @import { Control } from "./handle.js" */

const X = new Vector3(1, 0, 0);
const Z = new Vector3(0, 0, 1);
// In the scale of the marker.
const [INNER, OUTER, TIP] = [0.5, 0.65, 1];
const ALPHA = 0.6;

/** @param {any} group @param {Control} control @param {number} scale */
export function drawControl(group, { mode, turn }, scale) {
  const axis = X.clone().applyQuaternion(turn);
  // Red, green and blue for x, y and z.
  const color = new Color(...axis.toArray().map((part) => 0.25 + 0.75 * Math.abs(part)));
  if (mode === MODES.moveAxis) {
    const arrows = new Arrows(group);
    arrows.begin();
    for (const sign of [1, -1]) {
      const from = axis.clone().multiplyScalar(sign * INNER * scale);
      const along = axis.clone().multiplyScalar(sign * (TIP - INNER) * scale);
      arrows.add(from, along, { shaft: 0.1 * scale, head: 0.22 * scale, length: 0.25 * scale }, color);
    }
    arrows.end(ALPHA);
    return;
  }
  const shape = { color, transparent: true, opacity: ALPHA, side: DoubleSide };
  if (mode === MODES.movePlane || mode === MODES.rotateAxis || mode === MODES.moveRotate) {
    const ring = new Mesh(new RingGeometry(INNER * scale, OUTER * scale, 48), new MeshLambertMaterial(shape));
    ring.quaternion.setFromUnitVectors(Z, axis);
    group.add(ring);
    return;
  }
  if (mode === MODES.none) return;
  group.add(new Mesh(new SphereGeometry(0.2 * scale, 24, 12), new MeshLambertMaterial({ ...shape, color: 0xb8c4e0 })));
}
