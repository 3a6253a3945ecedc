// @ts-check
// What a launch file does while its nodes run: it starts some later, reacts when others start or end, changes the
// states of managed nodes, and stops all.

import { changeStates, followStates } from "./managed.js";
import { delay, delayRosTime } from "./timers.js";

/** @import { Launch, LaunchEffect, LaunchEvent, LaunchHandler, NodeHandle, Ros } from "../protocol.js" */

/**
 * Whoever runs a launch file: a panel, with the nodes of the page, or a terminal, with processes of its own.
 * @typedef {{
 *   start(name: string): void, stop(name: string): void,
 *   log(level: string, text: string): void, ends(node: string, reason: string): void,
 * }} Host `start` passes the node to `watch`; `ends` is called when the launch file stops all nodes, because `node` has
 *   ended or for another reason
 * @typedef {Record<string, string | number | undefined>} Facts what an event says, by its name in launch
 */

// What stands around the name of a fact in a line of the log; written by launch/describe_events.py.
const FACT = /\ue000(?:event\.)?(.*?)\ue001/g;

export class LaunchRun extends EventTarget {
  #host;
  #ros;
  /** The nodes that start at once. */
  first;
  /** The handlers of the launch file that act when it is launched. @type {LaunchHandler[]} */
  #first;
  /** Those that wait for an event, with the number of times that they have acted. @type {Map<LaunchHandler, number>} */
  #waiting = new Map();
  /** Those of the launch file, which wait anew when it is launched again. @type {LaunchHandler[]} */
  #always;
  /** @type {Map<string, {node: NodeHandle, listening: AbortController}>} */
  #watched = new Map();
  /** Ends the timers of this launch. */
  #launched = new AbortController();
  /** Ends the changes of state that wait for a node, by its name. @type {Map<string, AbortController>} */
  #changing = new Map();
  /** Which of the nodes start without an event of another one. @type {(name: string) => boolean} */
  #starts = () => true;
  #timers = 0;
  #ending = false;
  #unfollow;

  /** @param {Launch} launch @param {Host} host @param {Ros} ros */
  constructor({ nodes, first = nodes, handlers = [] }, host, ros) {
    super();
    this.#host = host;
    this.#ros = ros;
    this.first = first;
    const isFirst = (/** @type {LaunchHandler} */ { on }) => on.kind === "launched" || on.kind === "time";
    this.#first = handlers.filter(isFirst);
    this.#always = handlers.filter((handler) => !isFirst(handler));
    for (const handler of this.#always) this.#waiting.set(handler, 0);
    this.#unfollow = followStates(ros, handlers, (node, facts) => this.#happened("state", node, facts));
  }

  /** Whether a node runs, or a timer will act. */
  get active() {
    return this.#timers > 0 || this.#ending || [...this.#watched.values()].some(({ node }) => !isOver(node));
  }

  /** Follow a node of the launch file, from its start on. @param {string} name @param {NodeHandle} node */
  watch(name, node) {
    this.#watched.get(name)?.listening.abort();
    const listening = new AbortController();
    this.#watched.set(name, { node, listening });
    let before = node.state;
    let ran = false;
    const look = () => {
      const was = before;
      before = node.state;
      if (before === "running" && was !== "running") {
        ran = true;
        this.#happened("started", name, { process_name: name });
      }
      if (!isOver(node)) {
        this.dispatchEvent(new Event("change"));
        return;
      }
      // A node that restarts is on its way again by then.
      queueMicrotask(() => {
        if (isOver(node)) {
          if (ran) this.#exited(name, node, was === "running");
          ran = false;
          this.#rest();
        }
        this.dispatchEvent(new Event("change"));
      });
    };
    node.addEventListener("state", look, { signal: listening.signal });
    if (node.state === "running") this.#happened("started", name, { process_name: name });
    ran = node.state === "running" || node.state === "stopping";
  }

  /**
   * Do what the launch file does when it is launched, as soon as its first nodes run.
   * @param {(name: string) => boolean} [starts] which of the nodes start without an event of another one
   */
  async launch(starts = () => true) {
    this.#forget();
    const { signal } = this.#launched;
    this.#waiting = new Map(this.#always.map((handler) => [handler, 0]));
    this.#starts = starts;
    this.#timers++;
    await this.#haveStarted(signal);
    this.#timers--;
    if (signal.aborted) return;
    for (const handler of this.#first) this.#handle(handler, {}, "");
    this.dispatchEvent(new Event("change"));
  }

  /** Stop all nodes, and what waits. @param {string} [reason] */
  shutdown(reason = "") {
    if (this.#ending) return;
    this.#ending = true;
    this.#forget();
    this.#happened("shutdown", "", { reason });
    for (const [name, { node }] of this.#watched) if (!isOver(node)) this.#host.stop(name);
    this.#rest();
    this.dispatchEvent(new Event("change"));
  }

  /** Act no more. */
  close() {
    this.#forget();
    this.#unfollow();
    for (const { listening } of this.#watched.values()) listening.abort();
    this.#waiting.clear();
  }

  /** End the timers, and the changes of state that wait. */
  #forget() {
    this.#launched.abort();
    this.#launched = new AbortController();
    for (const changing of this.#changing.values()) changing.abort();
  }

  /** The shutdown is over when no node runs. */
  #rest() {
    if (![...this.#watched.values()].some(({ node }) => !isOver(node))) this.#ending = false;
  }

  /** @param {string} name @param {NodeHandle} node @param {boolean} byItself whether nobody stopped it */
  #exited(name, node, byItself) {
    const facts = { process_name: name, returncode: node.code };
    this.#changing.get(name)?.abort();
    if (byItself) this.#happened("ended", name, facts);
    this.#happened("exited", name, facts);
  }

  /** @param {LaunchEvent["kind"]} kind @param {string} node it is about @param {Facts} facts */
  #happened(kind, node, facts) {
    if (this.#ending && kind !== "shutdown") return;
    for (const [handler, times] of [...this.#waiting]) {
      const { on, most = -1 } = handler;
      if (times === most || !isAbout(on, kind, node, facts)) continue;
      this.#waiting.set(handler, times + 1);
      if (on.after) this.#later(on, () => this.#act(handler, facts, node));
      else this.#act(handler, facts, node);
    }
  }

  /** @param {LaunchHandler} handler @param {Facts} facts @param {string} node */
  #handle(handler, facts, node) {
    if (handler.on.kind === "launched") this.#act(handler, facts, node);
    else if (handler.on.kind === "time") this.#later(handler.on, () => this.#act(handler, facts, node));
    else this.#waiting.set(handler, 0);
  }

  /** @param {LaunchEvent} on @param {() => void} act */
  async #later({ after = 0, ros_time: rosTime }, act) {
    const { signal } = this.#launched;
    this.#timers++;
    this.dispatchEvent(new Event("change"));
    await (rosTime ? delayRosTime(this.#ros, after, signal, (text) => this.#host.log("warning", text)) : delay(after, signal));
    this.#timers--;
    if (!signal.aborted) act();
    this.dispatchEvent(new Event("change"));
  }

  /** @param {LaunchHandler} handler @param {Facts} facts @param {string} about the node of the event */
  #act({ effects }, facts, about) {
    for (const effect of effects) this.#do(effect, facts, about);
  }

  /** @param {LaunchEffect} effect @param {Facts} facts @param {string} about */
  #do({ kind, nodes = [], text = "", level = "info", ids = [], handler }, facts, about) {
    const { log } = this.#host;
    if (kind === "log") log(level, text.replace(FACT, (_, name) => String(facts[name] ?? "")));
    else if (this.#ending) return;
    else if (kind === "start") nodes.filter((name) => about || this.#starts(name)).forEach((name) => this.#host.start(name));
    else if (kind === "stop") nodes.forEach((name) => this.#host.stop(name));
    else if (kind === "shutdown") {
      this.#host.ends(about, text);
      this.shutdown(text);
    }
    else if (kind === "handle" && handler) this.#handle(handler, facts, about);
    else if (kind === "transition") {
      for (const node of nodes) changeStates(this.#ros, node, ids, (error) => log("error", error), this.#whileUp(about));
    }
  }

  /** A signal that aborts when a node ends. @param {string} name */
  #whileUp(name) {
    let changing = this.#changing.get(name);
    if (!changing || changing.signal.aborted) this.#changing.set(name, changing = new AbortController());
    return changing.signal;
  }

  /** Resolve when no node of the launch file is starting. @param {AbortSignal} signal */
  #haveStarted(signal) {
    return new Promise((/** @type {(value?: void) => void} */ resolve) => {
      const look = () => {
        if (![...this.#watched.values()].some(({ node }) => node.state === "starting")) resolve();
      };
      this.addEventListener("change", look, { signal });
      signal.addEventListener("abort", () => resolve());
      look();
    });
  }
}

/** Whether an event is the one that a handler waits for. @param {LaunchEvent} on @param {LaunchEvent["kind"]} kind @param {string} node @param {Facts} facts */
function isAbout(on, kind, node, { transition, start_state: start, goal_state: goal }) {
  return on.kind === kind && (!on.nodes || on.nodes.includes(node)) && (!on.transition || on.transition === transition) &&
    (!on.start_state || on.start_state === start) && (!on.goal_state || on.goal_state === goal);
}

/** Whether a node does not run. @param {NodeHandle} node */
export function isOver({ state }) {
  return state === "stopped" || state === "failed";
}
