// @ts-check
// What a program has thrown, as text with lines of the program.

import { inspect } from "../../vendor/inspect.js";

/**
 * Return what was thrown, and where: "at line 3", for each call in the program.
 * @param {unknown} thrown @param {string} address of the program, "" if it has none yet
 */
export function textOf(thrown, address) {
  if (!(thrown instanceof Error)) return `uncaught: ${typeof thrown === "string" ? thrown : inspect(thrown)}`;
  const calls = (thrown.stack ?? "").split("\n").filter((line) => address && line.includes(`${address}:`));
  const lines = calls.map((line) => line.slice(line.lastIndexOf(`${address}:`) + address.length + 1).split(":")[0]);
  const cause = thrown.cause === undefined ? "" : `\n  cause: ${thrown.cause instanceof Error ? thrown.cause : inspect(thrown.cause)}`;
  return `${thrown}${cause}${lines.map((line) => `\n    at line ${line}`).join("")}`;
}
