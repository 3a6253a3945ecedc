// @ts-check
// The prefix of a line that ROS logged: `[INFO] [1795413035.366799805] [talker]: `.

import { create } from "./elements.js";

const PREFIX = /^\[(DEBUG|INFO|WARN|ERROR|FATAL)\] \[(\d+)\.(\d{9})\] \[([^\]\s]+)\]: /;
// Times before this (s) are those of a simulation, not of a calendar.
const CALENDAR = 1e8;

/**
 * A row for a line of output. A prefix of ROS stays in the text, for copying, and is shown as the time, the level
 * unless it is INFO, and the node's name where it is another than in the row before.
 * @param {string} text
 * @param {string} before the name of the node in the row before, or ""
 * @returns {{row: HTMLElement, name: string}} the row, and the name of its node
 */
export function createRow(text, before) {
  const found = PREFIX.exec(text);
  if (!found) return { row: create("div", "", text), name: "" };
  const [prefix, level = "", seconds = "", nanoseconds = "", name = ""] = found;
  const element = create("span", "ros-prefix", prefix);
  element.dataset.time = clock(Number(seconds), nanoseconds.slice(0, 3));
  const rest = `${level === "INFO" ? "" : `${level} `}${name === before ? "" : `${name}: `}`;
  if (rest) element.dataset.rest = rest;
  return { row: create("div", "", element, text.slice(prefix.length)), name };
}

/** @param {number} seconds @param {string} milliseconds */
function clock(seconds, milliseconds) {
  if (seconds < CALENDAR) return `${seconds}.${milliseconds}`;
  return `${new Date(seconds * 1000).toTimeString().slice(0, 8)}.${milliseconds}`;
}
