// @ts-check
// Obey Twist messages, and stop when they end.

import { say } from "../../../ui/words.js";

/** @import { Ros } from "../../../protocol.js" */

export const TWIST = "geometry_msgs/msg/Twist";
// A robot stops after this time (ms) without a command, like the controllers of ROS.
const PATIENCE = 1000;

/**
 * Call `drive` with the speed (linear.x) and the turning rate (angular.z) of each command. Call `halt` with the reason
 * when a second has passed without a command, the topic has no publisher, or the page is hidden or closed. Return a
 * function that ends this, with a last `halt`.
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
    // Ignore messages that were in transit when the publisher ended or the page was hidden.
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
