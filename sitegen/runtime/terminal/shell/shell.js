// @ts-check
// Runs lines: starts the commands of a pipeline side by side, keeps the jobs, the files and the last status.

import { Broken, Pipe } from "./pipe.js";
import { parse, Unfinished } from "./parse.js";

/** @import { Ros } from "../../protocol.js" */
/** @import { Bags } from "../bags.js" */
/** @import { Interfaces } from "../interfaces.js" */
/** @import { Command, List, Pipeline, Word } from "./parse.js" */
/** @import { Style } from "./style.js" */

/**
 * What a command has: its words, where its output goes, and `signal`, which aborts with an Interrupt at Ctrl-C.
 * `columns` is the width for help. `foreground` lets keys go to a program, see Keys; it is undefined in a pipe and in
 * the background.
 * @typedef {{words: string[], ros: Ros, shell: Shell, signal: AbortSignal, columns: number, input: Pipe | undefined,
 *   toScreen: boolean, keys: Keys | undefined,
 *   out(text: string, style?: Style): Promise<void>, err(text: string, style?: Style): Promise<void>}} Io
 * @typedef {(type: (data: string) => void) => () => void} Keys give keys to a program, until the returned function is
 *   called
 * @typedef {(io: Io) => Promise<number | void>} Run returns the status, 0 if none
 * @typedef {{name: string, about: string, run: Run, words?(before: string[]): string[] | undefined}} Program
 *   `words` returns how to complete the next word
 * @typedef {{columns(): number, rows(): number, write(text: string, style?: Style): Promise<void>, clear(): void,
 *   eraseLine(): void, keys: Keys}} Screen
 * `suspended` is pending while a job is stopped by Ctrl-Z: what it prints waits for that. `halt` ends the wait for a
 * job in the foreground.
 * @typedef {{id: number, text: string, status: number | undefined, background: boolean, stop: AbortController,
 *   ended: Promise<number>, suspended: Promise<void> | undefined, resume(): void, halt(): void}} Job
 */

/** The status of a command that Ctrl-C or kill has ended, as of shells. */
export const INTERRUPTED = 130;
export const NOT_FOUND = 127;
/** The status of a command that Ctrl-Z has stopped. */
const STOPPED = 148;
// The files of a terminal, all together, in characters.
const MOST = 4_000_000;

/** Ctrl-C, or `kill`. */
export class Interrupt extends Error {}
/** A command failed; it prints the message, and its status is 1, or `status`. */
export class Failure extends Error {
  /** @param {string} text @param {number} [status] */
  constructor(text, status = 1) {
    super(text);
    this.status = status;
  }
}

export class Shell {
  #ros;
  #screen;
  #programs;
  /** The last status: $?. */
  status = 0;
  /** @type {Map<number, Job>} */
  jobs = new Map();
  /** @type {Job | undefined} */
  #foreground;
  /** The lines that were entered. @type {readonly string[]} */
  history = [];

  /**
   * @param {Ros} ros @param {Screen} screen @param {Map<string, Program>} programs
   * @param {Map<string, string>} files that all terminals of the page share @param {Bags} bags of the page
   * @param {Interfaces} interfaces
   */
  constructor(ros, screen, programs, files, bags, interfaces) {
    this.#ros = ros;
    this.#screen = screen;
    this.#programs = programs;
    this.files = files;
    this.bags = bags;
    this.interfaces = interfaces;
  }

  get programs() {
    return this.#programs;
  }

  /** Run a line, and resolve when what it does not leave in the background has ended. @param {string} text */
  async run(text) {
    let lists;
    try {
      lists = parse(text);
    } catch (error) {
      await this.#screen.write(`sh: ${error instanceof Error ? error.message : error}\n`);
      this.status = 2;
      return;
    }
    for (const list of lists) {
      const job = this.#start(list);
      if (list.background) {
        await this.#screen.write(`[${job.id}]\n`);
        this.status = 0;
        continue;
      }
      // As in other shells, Ctrl-C and Ctrl-Z end the whole line.
      if ((await this.bring(job)) === STOPPED || job.stop.signal.aborted) break;
    }
  }

  /** Wait for a job in the foreground, until it ends or is stopped. @param {Job} job @returns {Promise<number>} its status */
  async bring(job) {
    const before = this.#foreground;
    this.#foreground = job;
    job.background = false;
    job.resume();
    const halted = /** @type {Promise<number>} */ (new Promise((resolve) => {
      job.halt = () => resolve(STOPPED);
    }));
    this.status = await Promise.race([job.ended, halted]);
    this.#foreground = before;
    return this.status;
  }

  /** Ctrl-Z: stop the job in the foreground. Return it, if there is one. */
  suspend() {
    const job = this.#foreground;
    if (!job) return undefined;
    job.background = true;
    job.suspended = new Promise((resolve) => {
      job.resume = () => {
        job.suspended = undefined;
        resolve();
      };
    });
    // A stopped job can be killed.
    job.stop.signal.addEventListener("abort", () => job.resume(), { once: true });
    job.halt();
    return job;
  }

  /** Ctrl-C. Return whether there was something to interrupt. */
  interrupt() {
    this.#foreground?.stop.abort(new Interrupt());
    return this.#foreground !== undefined;
  }

  clear() {
    this.#screen.clear();
  }

  /** The rows of the screen. */
  get rows() {
    return this.#screen.rows();
  }

  eraseLine() {
    this.#screen.eraseLine();
  }

  /** End everything. */
  close() {
    for (const { stop } of this.jobs.values()) stop.abort(new Interrupt());
  }

  /** Take the jobs of the background that have ended, to tell about them. */
  takeEnded() {
    const ended = [...this.jobs.values()].filter(({ status }) => status !== undefined);
    for (const { id } of ended) this.jobs.delete(id);
    return ended.filter(({ background }) => background);
  }

  /** @param {string} name @param {string} text @param {boolean} [append] */
  writeFile(name, text, append = false) {
    if (/[\0/]/.test(name) || !name) throw new Failure(`${name}: there are no folders here`);
    const whole = append ? (this.files.get(name) ?? "") + text : text;
    const others = [...this.files].reduce((sum, [other, { length }]) => sum + (other === name ? 0 : length), 0);
    if (others + whole.length > MOST) throw new Failure(`${name}: no space left`);
    this.files.set(name, whole);
  }

  /** Return the text of a file. @param {string} name */
  readFile(name) {
    const text = this.files.get(name);
    if (text === undefined) throw new Failure(`${name}: No such file or directory`);
    return text;
  }

  /** @param {List} list @returns {Job} */
  #start(list) {
    const stop = new AbortController();
    let id = 1;
    while (this.jobs.has(id)) id++;
    /** @type {Job} */
    const job = {
      id, text: list.text, status: undefined, background: list.background, stop, ended: Promise.resolve(0),
      suspended: undefined, resume() {}, halt() {},
    };
    this.jobs.set(id, job);
    job.ended = this.#runSteps(list, job).then((status) => {
      job.status = status;
      if (!job.background) this.jobs.delete(id);
      return status;
    });
    return job;
  }

  /** @param {List} list @param {Job} job */
  async #runSteps({ steps }, job) {
    let status = 0;
    for (const { pipeline, when } of steps) {
      if (when !== "always" && (status === 0) !== (when === "success")) continue;
      await job.suspended;
      if (job.stop.signal.aborted) return INTERRUPTED;
      status = await this.#runPipeline(pipeline, job);
      this.status = status;
    }
    return status;
  }

  /** @param {Pipeline} pipeline @param {Job} job @returns {Promise<number>} the status of the last command */
  async #runPipeline({ commands }, job) {
    const pipes = commands.slice(1).map(() => new Pipe());
    const statuses = await Promise.all(commands.map((command, index) =>
      this.#runCommand(command, pipes[index - 1], pipes[index], job)));
    return statuses.at(-1) ?? 0;
  }

  /** @param {Command} command @param {Pipe | undefined} input @param {Pipe | undefined} output @param {Job} job */
  async #runCommand(command, input, output, job) {
    const words = command.words.map((word) => this.#expand(word));
    const name = words[0] ?? "";
    /** @type {(text: string, style?: Style) => Promise<void>} */
    const write = async (text, style) => {
      while (job.suspended) await job.suspended;
      await this.#screen.write(text, style);
    };
    let err = write;
    try {
      const from = command.from ? whole(this.readFile(this.#expand(command.from))) : input;
      const to = command.to && this.#file(this.#expand(command.to.file), command.to.append);
      const out = to ?? (output ? (/** @type {string} */ text) => output.write(text) : write);
      if (command.merged) err = out;
      // Who writes into a pipe ends with its reader.
      const signal = output ? AbortSignal.any([job.stop.signal, output.closed]) : job.stop.signal;
      const alone = (!input || name === "less") && !output && !job.background;
      const program = this.#programs.get(name);
      if (!program) throw new Failure(`${name}: command not found`, NOT_FOUND);
      const status = await program.run({
        words: words.slice(1), ros: this.#ros, shell: this, signal, columns: this.#screen.columns(), input: from,
        toScreen: !to && !output, keys: alone ? (type) => (job.background ? () => {} : this.#screen.keys(type)) : undefined, out, err,
      });
      return status ?? 0;
    } catch (error) {
      if (error instanceof Interrupt) return INTERRUPTED;
      if (error instanceof Broken) return 141;
      const known = error instanceof Failure;
      const said = error instanceof Error ? error.message : String(error);
      if (said) await err(`${known && error.status !== NOT_FOUND ? "" : known ? "sh: " : `${name}: `}${said}\n`);
      return known ? error.status : 1;
    } finally {
      output?.end();
      input?.close();
    }
  }

  /** @param {string} name @param {boolean} append */
  #file(name, append) {
    this.writeFile(name, "", append);
    return async (/** @type {string} */ text) => this.writeFile(name, text, true);
  }

  /** @param {Word} word */
  #expand(word) {
    return word.map((piece) => {
      if (typeof piece === "string") return piece;
      if (piece.variable === "?") return String(this.status);
      return Object.hasOwn(VARIABLES, piece.variable) ? VARIABLES[piece.variable] : "";
    }).join("");
  }
}

/** @type {Record<string, string>} */
export const VARIABLES = { HOME: "/", PWD: "/", SHELL: "sh", TERM: "xterm-256color", ROS_VERSION: "2", ROS_DISTRO: "kilted" };

/** Return a pipe that has a text. @param {string} text */
function whole(text) {
  const pipe = new Pipe();
  pipe.write(text).catch(() => {}); // waits until it is read
  pipe.end();
  return pipe;
}

/** Wait. @param {number} milliseconds @param {AbortSignal} signal @returns {Promise<void>} */
export function pause(milliseconds, signal) {
  return new Promise((resolve, reject) => {
    if (signal.aborted) {
      reject(signal.reason);
      return;
    }
    const timer = setTimeout(() => {
      signal.removeEventListener("abort", end);
      resolve();
    }, milliseconds);
    const end = () => {
      clearTimeout(timer);
      reject(signal.reason);
    };
    signal.addEventListener("abort", end, { once: true });
  });
}

/** Whether a line needs no further one: its quotes are closed. @param {string} text */
export function isFinished(text) {
  try {
    parse(text);
    return true;
  } catch (error) {
    return !(error instanceof Unfinished);
  }
}
