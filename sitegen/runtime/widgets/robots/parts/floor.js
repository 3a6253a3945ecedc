// @ts-check
// A floor seen from above, with a robot and its trace. The view follows the robot.

import { shape } from "../../../ui/elements.js";

/** @import { Pose } from "./motion.js" */

// In metres: the side of the square that is always visible, the largest distance of the robot from the centre of the
// view, and the size of the ground, which fills wide and high views, too.
const SEEN = 0.9;
const REACH = 0.25;
const GROUND = 12;
const TILE = 0.1;
// The distance between points of the trace (m), and their largest number.
const STEP = 0.01;
const LENGTH = 1500;

let floors = 0;

/**
 * @param {string} label for screen readers
 * @param {Element} body of the robot, in metres, facing right
 */
export function createFloor(label, body) {
  const id = `ros-tiles-${++floors}`;
  const tile = shape("pattern", { id, width: TILE, height: TILE, patternUnits: "userSpaceOnUse" },
    shape("path", { class: "ros-tile", d: `M ${TILE} 0 H 0 V ${TILE}` }));
  const ground = shape("rect", { width: GROUND, height: GROUND, fill: `url(#${id})` });
  const trace = shape("polyline", { class: "ros-trace" });
  const robot = shape("g", {}, body);
  const start = shape("path", { class: "ros-origin", d: "M -0.05 0 H 0.05 M 0 -0.05 V 0.05" });
  // The y axis points up in ROS and down in SVG.
  const world = shape("g", {}, ground, start, trace, robot);
  const element = shape("svg", {
    class: "ros-floor", role: "img", "aria-label": label,
    viewBox: `${-SEEN / 2} ${-SEEN / 2} ${SEEN} ${SEEN}`,
  }, shape("defs", {}, tile), world);

  /** @type {[number, number][]} */
  let path = [];
  let [seenX, seenY] = [0, 0];

  return {
    element,
    /** @param {Pose} pose */
    place({ x, y, heading }) {
      seenX = within(seenX, x);
      seenY = within(seenY, y);
      world.setAttribute("transform", `scale(1 -1) translate(${-seenX} ${-seenY})`);
      ground.setAttribute("x", String(tiled(seenX) - GROUND / 2));
      ground.setAttribute("y", String(tiled(seenY) - GROUND / 2));
      robot.setAttribute("transform", `translate(${x} ${y}) rotate(${(heading * 180) / Math.PI})`);
      const [lastX, lastY] = path.at(-1) ?? [Infinity, 0];
      if (Math.hypot(x - lastX, y - lastY) < STEP) return;
      path.push([x, y]);
      if (path.length > LENGTH) path = path.slice(-LENGTH);
      trace.setAttribute("points", path.map(([a, b]) => `${a.toFixed(3)},${b.toFixed(3)}`).join(" "));
    },
    clear() {
      path = [];
      [seenX, seenY] = [0, 0];
      trace.setAttribute("points", "");
    },
  };
}

/** @param {number} seen @param {number} at */
function within(seen, at) {
  return Math.min(Math.max(seen, at - REACH), at + REACH);
}

/** @param {number} value */
function tiled(value) {
  return Math.round(value / TILE) * TILE;
}
