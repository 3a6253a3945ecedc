// @ts-check
// A service, as scripts use it.

import { say } from "../ui/words.js";

/** @import { PageNode } from "../protocol.js" */
/** @import { Surroundings } from "./surroundings.js" */

export class Service {
  #raw;
  #surroundings;
  #type;
  /** @type {(() => void) | undefined} */
  #end;

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
    await this.wait({ timeout, signal });
    const { type } = this;
    this.#surroundings.check(`${type}_Request`);
    return this.#raw.call(this.name, type, request, timeout, signal);
  }

  /** Resolve when a node serves it. @param {{timeout?: number, signal?: AbortSignal}} [options] */
  async wait({ timeout = Infinity, signal } = {}) {
    const fault = say("no server for {} within {} s", this.name, timeout / 1000);
    await this.#surroundings.when(() => (this.available ? true : undefined), timeout, fault, signal);
  }

  /**
   * Serve it: `answer` returns the response to a request, or a promise of it. If it throws, the client gets no response.
   * @param {(request: any) => any} answer @returns {() => void} end
   */
  serve(answer) {
    const { type } = this;
    if (!type) throw new Error(say("give {} a type: the graph has no such service", this.name));
    this.#surroundings.check(`${type}_Request`);
    this.#end?.();
    this.#end = this.#raw.serve(this.name, type, answer);
    return this.#end;
  }
}
