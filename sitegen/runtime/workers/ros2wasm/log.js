// @ts-check
// Parse the console output of a script, which is formatted as on a terminal.

/** @import { Line, Severity } from "../../protocol.js" */

// Colours and other control sequences of terminals.
const ESCAPES = /\x1b\[[\d;]*[A-Za-z]|[\x00-\x08\x0b-\x1f\x7f]/g;
const LOGGED = /^\[(DEBUG|INFO|WARN|ERROR|FATAL)\] \[(\d+)\.(\d{1,9})\] \[([^\]]*)\]: ([^]*)$/;
const NAMED = /^\[(DEBUG|INFO|WARN|ERROR|FATAL)\]/;
/** @type {Record<string, number>} */
const LEVELS = { DEBUG: 10, INFO: 20, WARN: 30, ERROR: 40, FATAL: 50 };

/**
 * Return the lines of a text, without control sequences.
 * @param {string} text @returns {Line[]}
 */
export function toLines(text) {
  const plain = text.replace(ESCAPES, "");
  const name = NAMED.exec(plain)?.[1];
  const severity = /** @type {Severity} */ (name ? name.toLowerCase() : "stderr");
  return plain.split("\n").map((line) => ({ severity, text: line }));
}

/** Return the message for /rosout, if the text was logged and not only printed. @param {string} text */
export function toLog(text) {
  const [, severity, sec, fraction, name, msg] = LOGGED.exec(text.replace(ESCAPES, "")) ?? [];
  if (!severity || !fraction) return null;
  const stamp = { sec: Number(sec), nanosec: Number(fraction.padEnd(9, "0")) };
  return { stamp, level: LEVELS[severity], name, msg, file: "", function: "", line: 0 };
}
