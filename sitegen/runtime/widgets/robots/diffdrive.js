// @ts-check
// A robot with two driven wheels: it obeys Twist commands, or shows the odometry of another robot.

import { shape } from "../../ui/elements.js";
import { obey, TWIST } from "./parts/commands.js";
import { createFloor } from "./parts/floor.js";
import { describe, drive, plain } from "./parts/motion.js";
import { say } from "../../ui/words.js";

/** @import { Ros } from "../../protocol.js" */
/** @import { Robot } from "./parts/robot.js" */
/** @import { Pose } from "./parts/motion.js" */

const ODOMETRY = "nav_msgs/msg/Odometry";
const START = { x: 0, y: 0, heading: 0 };

/**
 * Show the pose that `odometry` publishes, or without that a robot that obeys `twist`.
 * @param {Ros} ros
 * @param {{twist: string, odometry?: string | null}} options
 * @param {() => void} changed
 * @returns {Robot}
 */
export function create(ros, { twist, odometry }, changed) {
  /** @type {Pose} */
  let pose = START;
  let [speed, turn] = [0, 0];
  let reason = "";
  const floor = createFloor(say("A robot with two wheels, seen from above"), body());

  const close = odometry
    ? follow(ros, odometry, (place, itsSpeed, itsTurn) => {
        [pose, speed, turn] = [place, itsSpeed, itsTurn];
        changed();
      })
    : obey(ros, twist, (itsSpeed, itsTurn) => {
        [speed, turn, reason] = [itsSpeed, itsTurn, ""];
        changed();
      }, (why) => {
        [speed, turn, reason] = [0, 0, why];
        changed();
      });

  return {
    title: say("Differential drive"),
    inputs: [odometry ? { topic: odometry, type: ODOMETRY } : { topic: twist, type: TWIST }],
    drawing: floor.element,
    waits: odometry || twist,
    controls: [],
    advance(seconds) {
      const moving = !odometry && (speed !== 0 || turn !== 0);
      if (moving) pose = drive(pose, speed, turn, seconds);
      floor.place(pose);
      return moving;
    },
    readings: () => [
      ...describe(pose),
      { name: say("Speed"), text: `${plain(speed, 2)} m/s` },
      { name: say("Turn"), text: `${plain(turn, 2)} rad/s` },
    ],
    note: () => ({ text: reason && say("Stopped: {}", reason), wrong: false }),
    reset() {
      if (!odometry) pose = START;
      floor.clear();
      changed();
    },
    close,
  };
}

/**
 * @param {Ros} ros @param {string} topic
 * @param {(pose: Pose, speed: number, turn: number) => void} moved
 */
function follow(ros, topic, moved) {
  if (!ros.types[ODOMETRY]) return () => {};
  return ros.subscribe(topic, ODOMETRY, ({ pose, twist }) => {
    const { position, orientation: q } = pose.pose;
    const heading = Math.atan2(2 * (q.w * q.z + q.x * q.y), 1 - 2 * (q.y * q.y + q.z * q.z));
    if (![position.x, position.y, heading].every(Number.isFinite)) return;
    moved({ x: position.x, y: position.y, heading }, twist.twist.linear.x, twist.twist.angular.z);
  });
}

function body() {
  const wheel = (/** @type {number} */ y) =>
    shape("rect", { class: "ros-wheel", x: -0.035, y, width: 0.07, height: 0.024, rx: 0.008 });
  return shape("g", {},
    wheel(0.068), wheel(-0.092),
    shape("circle", { class: "ros-hull", r: 0.085 }),
    shape("path", { class: "ros-front", d: "M 0.055 0 L 0 0.032 L 0 -0.032 Z" }));
}
