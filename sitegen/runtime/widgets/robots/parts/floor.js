// @ts-check
// A floor seen from above, with a robot that leaves a trace. The view follows the robot.

import { shape } from "../../../ui/drawing.js";

/** @import { Pose } from "./motion.js" */

// So much of the floor is always seen (m), more of it where the drawing is wide or high, and the robot
// may go this far from the middle of the view. There is ground for every shape that a page has.
const SEEN = 0.9;
const REACH = 0.25;
const GROUND = 12;
const TILE = 0.1;
// The trace is this fine (m) and this long (points).
const STEP = 0.01;
const LENGTH = 1500;

let floors = 0;

/**
 * @param {string} label what is drawn, for those who do not see it
 * @param {Element} body of the robot, in metres, its front to the right
 */
export function createFloor(label, body) {
  const id = `ros-tiles-${++floors}`;
  const tile = shape("pattern", { id, width: TILE, height: TILE, patternUnits: "userSpaceOnUse" },
    shape("path", { class: "ros-tile", d: `M ${TILE} 0 H 0 V ${TILE}` }));
  const ground = shape("rect", { width: GROUND, height: GROUND, fill: `url(#${id})` });
  const trace = shape("polyline", { class: "ros-trace" });
  const robot = shape("g", {}, body);
  const start = shape("path", { class: "ros-origin", d: "M -0.05 0 H 0.05 M 0 -0.05 V 0.05" });
  // y goes up in the world of ROS, and down in that of drawings.
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
