// @ts-check
// Obey Twist messages, and stop whenever nobody commands any more.

import { say } from "../../../ui/words.js";

/** @import { Ros } from "../../../protocol.js" */

export const TWIST = "geometry_msgs/msg/Twist";
// A robot without a command for this time (ms) stops, as the controllers of ROS do.
const PATIENCE = 1000;

/**
 * Call `drive` with speed (linear.x) and turning rate (angular.z) of each command, and `halt` with the
 * reason when there is none any more: for a second none came, no publisher is left on the topic, the
 * page is hidden or closed. Returns a function that ends it, with a last `halt`.
 * @param {Ros} ros
 * @param {string} topic
 * @param {(speed: number, turn: number) => void} drive
 * @param {(reason: string) => void} halt
 */
export function obey(ros, topic, drive, halt) {
  if (!ros.types[TWIST]) return () => {};
  let moving = false;
  /** @type {ReturnType<typeof setTimeout> | undefined} */
  let timer;

  const stop = (/** @type {string} */ reason) => {
    clearTimeout(timer);
    if (moving) halt(reason);
    moving = false;
  };
  const commanded = () =>
    ros.graph.topics().some(({ name, publishers }) => name === topic && publishers.length > 0);
  const unsubscribe = ros.subscribe(topic, TWIST, ({ linear, angular }) => {
    // What was on its way when the publisher ended, or the page was hidden, comes too late.
    if (document.visibilityState === "hidden" || !commanded()) return;
    if (!Number.isFinite(linear.x) || !Number.isFinite(angular.z)) {
      stop(say("a command was not a number"));
      return;
    }
    clearTimeout(timer);
    moving = linear.x !== 0 || angular.z !== 0;
    if (moving) timer = setTimeout(() => stop(say("no command for a second")), PATIENCE);
    drive(linear.x, angular.z);
  });

  const ending = new AbortController();
  const { signal } = ending;
  ros.graph.addEventListener("change", () => {
    if (moving && !commanded()) stop(say("no publishers on {} any more", topic));
  }, { signal });
  document.addEventListener("visibilitychange", () => {
    if (document.visibilityState === "hidden") stop(say("the page was hidden"));
  }, { signal });
  window.addEventListener("pagehide", () => stop(say("the page was closed")), { signal });
  return () => {
    ending.abort();
    unsubscribe();
    stop("");
  };
}
