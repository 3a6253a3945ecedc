// @ts-check
// The samples of a plot: subscribe to the topics of its series, and keep those of the last seconds.

import { checkNumeric, isSliced, parsePath, readPath, toNumber } from "../../messages/path.js";
import { TopicReader } from "../../messages/topicReader.js";
import { say } from "../../ui/words.js";
import { Curve, MOST_CURVES, Series } from "./curve.js";
import { MOST } from "./trace.js";

/** @import { MessageInfo, Ros } from "../../protocol.js" */
/** @import { Path } from "../../messages/path.js" */

// Messages of a topic that may wait while the page is busy.
const DEPTH = 1000;
export const MOST_SERIES = 20;
// Stamps before this (s) are those of a simulation, not of a calendar.
const CALENDAR = 1e8;

export class Samples {
  #ros;
  #changed;
  /** By topic. @type {Map<string, TopicReader>} */
  #readers = new Map();
  /** By topic: what is read from its messages. @type {Map<string, Series[]>} */
  #wanted = new Map();
  /** @type {Series[]} */
  series = [];
  /** The path of the horizontal axis, if that is not the time. @type {Path | undefined} */
  against;
  /** Why there is no horizontal axis, or "". */
  error = "";
  #x = NaN;
  #stamped;
  #working = false;
  /** How many seconds are kept. */
  window;
  /** The time of the last message, by topic. @type {Map<string, number>} */
  #latest = new Map();
  /** The time of the newest sample (s), NaN if there is none. */
  newest = NaN;
  /** The time 0, in seconds since 1970. @type {number | undefined} */
  #zero;

  /**
   * @param {Ros} ros @param {{x?: string | null, time?: string | null, window: number}} options
   * @param {() => void} changed called when samples have arrived
   */
  constructor(ros, { x, time, window }, changed) {
    this.#ros = ros;
    this.#changed = changed;
    this.#stamped = time === "header";
    this.window = window;
    if (!x) return;
    try {
      this.against = parsePath(x);
      if (isSliced(this.against)) throw new Error(say("x must be one value: {}", x));
    } catch (error) {
      this.error = error instanceof Error ? error.message : String(error);
    }
  }

  get zero() {
    return this.#zero ?? performance.timeOrigin / 1000;
  }

  /** All curves. */
  get curves() {
    return this.series.flatMap(({ curves }) => [...curves.values()]);
  }

  /** Plot these paths; those that stay keep their samples. @param {string[]} paths */
  choose(paths) {
    const old = new Map(this.series.map((series) => [series.text, series]));
    this.series = paths.map((text) => old.get(text) ?? new Series(text, (name, derivative) =>
      this.#create(name, derivative)));
    this.#wanted.clear();
    for (const series of this.series) {
      if (series.path) this.#wanted.set(series.path.topic, [...(this.#wanted.get(series.path.topic) ?? []), series]);
    }
    if (this.against && !this.error && !this.#wanted.has(this.against.topic)) this.#wanted.set(this.against.topic, []);
    for (const [topic, reader] of this.#readers) {
      if (this.#wanted.has(topic)) continue;
      reader.close();
      this.#readers.delete(topic);
    }
    for (const topic of this.#wanted.keys()) {
      if (this.#readers.has(topic)) continue;
      this.#readers.set(topic, new TopicReader(this.#ros, topic, (message, info) =>
        this.#receive(topic, message, info), DEPTH));
    }
    this.look();
  }

  /** Subscribe or not. @param {boolean} working */
  work(working) {
    if (!working && this.#working) for (const curve of this.curves) curve.interrupt();
    this.#working = working;
    this.look();
  }

  /** Follow changes of the graph. */
  look() {
    const topics = this.#ros.graph.topics().map(({ name }) => name);
    if (this.series.filter((series) => series.resolve(topics)).length) this.choose(this.series.map(({ text }) => text));
    for (const [topic, reader] of this.#readers) {
      reader.look(this.#working);
      for (const series of this.#wanted.get(topic) ?? []) series.check(reader.type, this.#ros.types);
      if (topic === this.against?.topic && this.#ros.types[reader.type]) this.#checkAgainst(reader.type);
    }
  }

  clear() {
    for (const curve of this.curves) curve.clear();
    this.newest = NaN;
    this.#latest.clear();
  }

  /** Why a series has no values, or not all of the window, in a sentence; else "". @param {Series} series */
  describe(series) {
    if (series.error) return series.error;
    if (series.curves.size) return this.#describeLoss(series);
    return this.#readers.get(series.path?.topic ?? "")?.describeSilence() ?? "";
  }

  /** @param {Series} series */
  #describeLoss({ curves }) {
    for (const { trace } of curves.values()) {
      const kept = trace.size === MOST ? this.newest - trace.time(0) : Infinity;
      if (kept < this.window) return say("only the last {} samples are kept: {} s", MOST, kept.toFixed(1));
    }
    return "";
  }

  /** Forget what is older than the window. */
  trim() {
    for (const curve of this.curves) curve.trace.dropBefore(this.newest - this.window);
  }

  /** @param {string} type */
  #checkAgainst(type) {
    this.error = "";
    try {
      checkNumeric(/** @type {Path} */ (this.against), type, this.#ros.types);
    } catch (error) {
      this.error = error instanceof Error ? error.message : String(error);
    }
  }

  /** @param {string} name @param {boolean} derivative */
  #create(name, derivative) {
    const used = new Set(this.curves.map(({ number }) => number));
    if (used.size >= MOST_CURVES) return undefined;
    let number = 0;
    while (used.has(number)) number++;
    return new Curve(name, number, derivative, Boolean(this.against));
  }

  /** @param {string} topic @param {any} message @param {MessageInfo} info */
  #receive(topic, message, info) {
    const time = this.#timeOf(message, info);
    if (!Number.isFinite(time)) return;
    // A simulation that starts again, or messages of several publishers out of order. Topics may be behind others.
    const before = this.#latest.get(topic) ?? -Infinity;
    if (time < before - 1) this.clear();
    else if (time < before) return;
    if (topic === this.against?.topic) {
      readPath(this.against, message, (_, value) => {
        this.#x = toNumber(value) ?? NaN;
      });
    }
    this.#latest.set(topic, time);
    if (!(time <= this.newest)) this.newest = time;
    for (const series of this.#wanted.get(topic) ?? []) series.read(message, time, this.#x);
    this.#changed();
  }

  /** @param {any} message @param {MessageInfo} info @returns {number} */
  #timeOf(message, { received }) {
    const stamp = this.#stamped ? toNumber(message.header?.stamp) : undefined;
    const time = stamp ?? received / 1000;
    this.#zero ??= time < CALENDAR ? 0 : performance.timeOrigin / 1000;
    return time - this.#zero;
  }
}
