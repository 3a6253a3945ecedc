// @ts-check
// Keep a worker within the budgets of what it reports to the page: a worker may run any program.

import { BUDGETS } from "../budgets.js";
import { Allowance } from "./allowance.js";
import { faultOf } from "./reports.js";

/** @import { FromWorker, Line } from "../protocol.js" */

export class Guard {
  #tell;
  #stop;
  #reports = new Allowance(BUDGETS.reports, performance.now());
  #lines = new Allowance(BUDGETS.lines, performance.now());
  /** How many reports were wrong, by what was wrong. @type {Map<string, number>} */
  #faults = new Map();
  #cut = false;
  #dropped = 0;
  #over = false;

  /**
   * @param {(text: string) => void} tell tells the worker's own console what was refused
   * @param {(reason: string) => void} stop called once, when the worker has to be stopped
   */
  constructor(tell, stop) {
    this.#tell = tell;
    this.#stop = stop;
  }

  /** Return what the page handles of a report, if anything. @param {any} message @returns {FromWorker | undefined} */
  admit(message) {
    if (!this.spend(1)) return undefined;
    const fault = faultOf(message);
    if (fault) {
      this.#refuse(fault);
      return undefined;
    }
    return message.op === "lines" ? this.#shorten(message) : message;
  }

  /** What the page did for a report costs more of them. Return whether the worker goes on. @param {number} reports */
  spend(reports) {
    if (!this.#over && this.#reports.spend(reports, performance.now())) return true;
    this.#end(`reported to the page more than ${BUDGETS.reports.rate} times a second and was stopped`);
    return false;
  }

  /** Tell how many reports were wrong, if more than were told when they came. */
  finish() {
    const counts = [...this.#faults].filter(([, count]) => count > 1).map(([fault, count]) => `${count} ${fault}`);
    if (counts.length) this.#tell(`invalid reports: ${counts.join(", ")}`);
    if (this.#dropped) this.#tell(`${this.#dropped} lines were dropped`);
  }

  /** @param {string} fault */
  #refuse(fault) {
    const count = this.#faults.get(fault) ?? 0;
    this.#faults.set(fault, count + 1);
    if (count === 0) this.#tell(`sent an invalid report: ${fault}`);
    this.spend(BUDGETS.invalid);
  }

  /** @param {Extract<FromWorker, {op: "lines"}>} report */
  #shorten({ lines }) {
    const time = performance.now();
    const { width } = BUDGETS.lines;
    /** @type {Line[]} */
    const kept = [];
    for (const { severity, text: whole } of lines) {
      const text = whole.length > BUDGETS.line ? `${whole.slice(0, BUDGETS.line)}…` : whole;
      if (this.#lines.spend(1 + Math.floor(text.length / width), time)) kept.push({ severity, text });
      else this.#drop();
      if (text !== whole) this.#note();
    }
    return kept.length ? /** @type {FromWorker} */ ({ op: "lines", lines: kept }) : undefined;
  }

  #note() {
    if (this.#cut) return;
    this.#cut = true;
    this.#tell(`lines are cut after ${BUDGETS.line} characters`);
  }

  #drop() {
    const often = `more than ${BUDGETS.lines.rate} lines a second`;
    if (this.#dropped === 0) this.#tell(`prints ${often}; some are dropped`);
    this.#dropped += 1;
    if (this.#dropped > BUDGETS.dropped) this.#end(`went on printing ${often} and was stopped`);
  }

  /** @param {string} reason */
  #end(reason) {
    if (this.#over) return;
    this.#over = true;
    this.#stop(reason);
  }
}
