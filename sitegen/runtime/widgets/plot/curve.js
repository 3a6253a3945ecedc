// @ts-check
// The series of a plot, each a message path, and their curves: one, or one for each element of a slice.

import { Derivative } from "../../messages/derivative.js";
import { checkNumeric, nameOf, parsePath, readPath, toNumber } from "../../messages/path.js";
import { say } from "../../ui/words.js";
import { Trace } from "./trace.js";

/** @import { Path, Types } from "../../messages/path.js" */

// The number of curves in a plot: more cannot be told apart.
export const MOST_CURVES = 40;

export class Curve {
  trace;
  name;
  /** A number for the colour; those of removed curves are used again. */
  number;
  shown = true;
  /** The last value, also if it cannot be drawn. @type {number | undefined} */
  latest;
  #derivative;

  /** @param {string} name @param {number} number @param {boolean} derivative @param {boolean} against */
  constructor(name, number, derivative, against) {
    this.name = name;
    this.number = number;
    this.#derivative = derivative ? new Derivative() : undefined;
    this.trace = new Trace(against);
  }

  /** @param {number} time (s) @param {number} value @param {number} x */
  push(time, value, x) {
    const found = this.#derivative ? this.#derivative.of(time, value) : value;
    if (found === undefined) return;
    this.latest = found;
    this.trace.push(time, found, x);
  }

  /** End the line: what follows is not connected with it. */
  interrupt() {
    this.#derivative?.clear();
    const last = this.trace.size - 1;
    if (last >= 0 && !Number.isNaN(this.trace.value(last))) this.trace.push(this.trace.time(last), NaN, NaN);
  }

  clear() {
    this.#derivative?.clear();
    this.trace.clear();
    this.latest = undefined;
  }
}

export class Series {
  text;
  /** @type {Path | undefined} */
  path;
  /** Why there are no curves, or "". */
  error = "";
  /** By the label of the element. @type {Map<string, Curve>} */
  curves = new Map();
  #create;
  #checked = "";
  #time = 0;
  #x = 0;

  /** @param {string} text a path @param {(name: string, derivative: boolean) => Curve | undefined} create a curve */
  constructor(text, create) {
    this.text = text;
    this.#create = create;
    try {
      this.path = parsePath(text);
    } catch (error) {
      this.error = error instanceof Error ? error.message : String(error);
    }
  }

  /**
   * Read `/odom/twist/x`, as rqt_plot writes it, as `/odom.twist.x` if there is only such a topic. Return whether the
   * topic has changed.
   * @param {string[]} topics
   */
  resolve(topics) {
    if (!this.path || this.path.steps.length || topics.includes(this.path.topic)) return false;
    const { topic: whole } = this.path;
    const [topic] = topics.filter((name) => whole.startsWith(`${name}/`)).sort((one, two) => two.length - one.length);
    if (!topic) return false;
    this.path = parsePath(topic + whole.slice(topic.length).replaceAll("/", "."));
    return true;
  }

  /** Check the path when the type of its topic is known. @param {string} type @param {Types} types */
  check(type, types) {
    if (!this.path || !types[type] || type === this.#checked) return;
    this.#checked = type;
    this.error = "";
    try {
      checkNumeric(this.path, type, types);
    } catch (error) {
      this.error = error instanceof Error ? error.message : String(error);
    }
  }

  /** Take the values of a message. @param {any} message @param {number} time @param {number} x */
  read(message, time, x) {
    if (!this.path || (this.error && this.curves.size === 0)) return;
    [this.#time, this.#x] = [time, x];
    readPath(this.path, message, this.#take);
  }

  #take = (/** @type {string} */ label, /** @type {any} */ value) => {
    const number = toNumber(value);
    if (number === undefined) return true;
    let curve = this.curves.get(label);
    if (!curve) {
      const path = /** @type {Path} */ (this.path);
      curve = this.#create(nameOf(path, label), path.derivative);
      if (!curve) {
        this.error = say("Only {} curves are drawn; choose fewer elements with a slice such as [0:5]", MOST_CURVES);
        return false;
      }
      this.curves.set(label, curve);
    }
    curve.push(this.#time, number, this.#x);
    return true;
  };
}
