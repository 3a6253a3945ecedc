// @ts-check
// An action, as scripts use it.

import { ActionClient } from "../messages/actionClient.js";
import { say } from "../ui/words.js";
import { endingWith } from "./ending.js";
import { ActionServer, STATUS } from "./actionServer.js";
import { Goal } from "./goal.js";

/** @import { PageNode, Ros } from "../protocol.js" */
/** @import { ServedGoal } from "./actionServer.js" */
/** @import { Surroundings } from "./surroundings.js" */
/**
 * @typedef {{id: string, request: any, signal: AbortSignal, publish(feedback: any): void}} Task a goal that a client
 *   sent; `signal` is aborted when it is to be canceled
 */

const SEND = "/_action/send_goal";

export class Action {
  #raw;
  #graph;
  #surroundings;
  #type;
  /** @type {ActionClient | undefined} */
  #client;

  /**
   * @param {PageNode} raw @param {Ros["graph"]} graph @param {Surroundings} surroundings @param {string} name
   * @param {string} type
   */
  constructor(raw, graph, surroundings, name, type) {
    this.#raw = raw;
    this.#graph = graph;
    this.#surroundings = surroundings;
    this.name = name;
    this.#type = type;
  }

  /** The type, as given or as the graph has it; "" if neither. */
  get type() {
    return this.#type || this.#surroundings.typeOf("services", this.name + SEND).replace(/_SendGoal$/, "");
  }

  /** Whether a node serves it now. */
  get available() {
    return this.#surroundings.serversOf(this.name + SEND).length > 0;
  }

  /** Resolve when a node serves it. @param {{timeout?: number, signal?: AbortSignal}} [options] */
  async wait({ timeout = Infinity, signal } = {}) {
    const fault = say("no server for {} within {} s", this.name, timeout / 1000);
    await this.#surroundings.when(() => (this.available ? true : undefined), timeout, fault, signal);
  }

  /**
   * Send a goal, when there is a server. Aborting `signal` later cancels the goal.
   * @param {any} [request] @param {{timeout?: number, signal?: AbortSignal}} [options]
   */
  async send(request = {}, { timeout = 5000, signal } = {}) {
    // A mistake is told at once if the type is known: there may be no server.
    const checked = this.type && this.#read(this.type, "Goal", request);
    await this.wait({ timeout, signal });
    const client = this.#connected();
    const goal = new Goal(client, client.send(checked || this.#read(this.type, "Goal", request)));
    goal.cancelWith(signal);
    return goal;
  }

  /**
   * Serve it. `execute` gets each goal, and returns its result or a promise of it, or is an async generator that yields
   * feedback and returns the result. A goal whose `signal` was aborted by then is canceled; one that throws, or whose
   * feedback or result does not fit the type, is aborted.
   * @param {(task: Task) => any} execute @param {{accept?: (request: any) => boolean,
   *   cancel?: (task: Task) => boolean, signal?: AbortSignal}} [options] the first two may refuse; `signal` ends it
   * @returns {() => void} end
   */
  serve(execute, { accept = () => true, cancel = () => true, signal: ending } = {}) {
    this.#surroundings.closed.throwIfAborted();
    const { type } = this;
    if (!type) throw new Error(say("give {} a type: the graph has no such action", this.name));
    this.#surroundings.check(this.name, type, "_SendGoal_Request");
    if (ending?.aborted) return () => {};
    /** @type {Map<ServedGoal, {task: Task, abort: AbortController}>} */
    const running = new Map();
    const server = new ActionServer(this.#raw, this.name, type, {
      accepted: (goal) => {
        const { id, request } = goal;
        if (!accept(request)) return false;
        const abort = new AbortController();
        const publish = (/** @type {any} */ feedback) => goal.publish(this.#read(type, "Feedback", feedback ?? {}));
        running.set(goal, { task: { id, request, signal: abort.signal, publish }, abort });
        return true;
      },
      cancel: (goal) => {
        const one = running.get(goal);
        if (!one || !cancel(one.task)) return false;
        one.abort.abort(new Error(say("the goal was canceled")));
        return true;
      },
      execute: async (goal) => {
        const { task } = /** @type {{task: Task}} */ (running.get(goal));
        const { signal } = task;
        try {
          // It may be canceled before it begins.
          const result = signal.aborted ? {} : await resultOf(execute(task), task.publish);
          const checked = this.#read(type, "Result", result ?? {});
          goal.finish(signal.aborted ? STATUS.canceled : STATUS.succeeded, checked);
        } catch (error) {
          if (!signal.aborted) console.error(error);
          goal.finish(signal.aborted ? STATUS.canceled : STATUS.aborted, {});
        }
        running.delete(goal);
      },
    });
    return endingWith([ending, this.#surroundings.closed], () => {
      for (const { abort } of running.values()) abort.abort(new Error(say("closed")));
      server.close();
    });
  }

  /** @param {string} type @param {"Goal" | "Feedback" | "Result"} part @param {any} given */
  #read(type, part, given) {
    this.#surroundings.check(this.name, type, `_${part}`);
    return this.#surroundings.checker.read(`${type}_${part}`, given, this.name);
  }

  #connected() {
    if (this.#client) return this.#client;
    const ros = /** @type {Ros} */ (/** @type {unknown} */ ({
      graph: this.#graph, types: this.#raw.types, subscribe: this.#raw.subscribe.bind(this.#raw),
      call: this.#raw.call.bind(this.#raw),
    }));
    const client = new ActionClient(ros, this.name, this.type);
    if (client.missing) throw new Error(`${this.name}: ${say("this page has no definition of {}", client.missing)}`);
    client.watch();
    // Goals are lost when the node is closed, and their feedback ends.
    this.#surroundings.closed.addEventListener("abort", () => client.close());
    this.#client = client;
    return client;
  }
}

/** Return what `work` returns, and publish what it yields. @param {any} work @param {(feedback: any) => void} publish */
async function resultOf(work, publish) {
  if (typeof work?.next !== "function") return work;
  let step = await work.next();
  while (!step.done) {
    try {
      publish(step.value);
    } catch (error) {
      if (!work.throw) throw error;
      // It is the `yield` that fails, so that the generator can end what it has begun.
      step = await work.throw(error);
      continue;
    }
    step = await work.next();
  }
  return step.value;
}
