// @ts-check
// A service, as scripts use it.

import { say } from "../ui/words.js";
import { endingWith } from "./ending.js";

/** @import { PageNode } from "../protocol.js" */
/** @import { Surroundings } from "./surroundings.js" */

export class Service {
  #raw;
  #surroundings;
  #type;
  #end = () => {};

  /** @param {PageNode} raw @param {Surroundings} surroundings @param {string} name @param {string} type */
  constructor(raw, surroundings, name, type) {
    this.#raw = raw;
    this.#surroundings = surroundings;
    this.name = name;
    this.#type = type;
  }

  /** The type, as given or as the graph has it; "" if neither. */
  get type() {
    return this.#type || this.#surroundings.typeOf("services", this.name);
  }

  /** Whether a node serves it now. */
  get available() {
    return this.#surroundings.serversOf(this.name).length > 0;
  }

  /**
   * Call the service and resolve with the response. It waits for a server at first.
   * @param {any} [request] @param {{timeout?: number, signal?: AbortSignal}} [options] `timeout` in ms, 5000 by default,
   *   for the server and then for its response; it may be infinite
   * @returns {Promise<any>}
   */
  async call(request = {}, { timeout = 5000, signal } = {}) {
    // A mistake is told at once if the type is known: there may be no server.
    const checked = this.type && this.#read("_Request", request);
    await this.wait({ timeout, signal });
    const { closed } = this.#surroundings;
    const ended = signal ? AbortSignal.any([signal, closed]) : closed;
    return this.#raw.call(this.name, this.type, checked || this.#read("_Request", request), timeout, ended);
  }

  /** Resolve when a node serves it. @param {{timeout?: number, signal?: AbortSignal}} [options] */
  async wait({ timeout = Infinity, signal } = {}) {
    const fault = say("no server for {} within {} s", this.name, timeout / 1000);
    await this.#surroundings.when(() => (this.available ? true : undefined), timeout, fault, signal);
  }

  /**
   * Serve it: `answer` returns the response to a request, or a promise of it. If it throws, or what it returns does not
   * fit the type, the client gets no response.
   * @param {(request: any) => any} answer @param {{signal?: AbortSignal}} [options] `signal` ends it, too
   * @returns {() => void} end
   */
  serve(answer, { signal } = {}) {
    this.#surroundings.closed.throwIfAborted();
    const { type } = this;
    if (!type) throw new Error(say("give {} a type: the graph has no such service", this.name));
    this.#surroundings.check(this.name, type, "_Request");
    this.#end();
    if (signal?.aborted) return () => {};
    const { checker } = this.#surroundings;
    this.#end = endingWith([signal], this.#raw.serve(this.name, type, async (request) =>
      checker.read(`${type}_Response`, (await answer(request)) ?? {}, this.name)));
    return this.#end;
  }

  /** @param {string} part of the type @param {any} given */
  #read(part, given) {
    const { type } = this;
    this.#surroundings.check(this.name, type, part);
    return this.#surroundings.checker.read(type + part, given, this.name);
  }
}
