// @ts-check
// The parameters of a node, as scripts use them.

import { set } from "../messages/parameters/node.js";
import { BOOL, DOUBLE, fieldOf, INTEGER, listOf, plainOf, STRING } from "../messages/parameters/value.js";
import { say } from "../ui/words.js";
import { Stream } from "./stream.js";

/** @import { PageNode, Ros } from "../protocol.js" */
/** @import { Surroundings } from "./surroundings.js" */

const SRV = "rcl_interfaces/srv";
/** The limits of integers. */
export const [SMALLEST, LARGEST] = [-(2n ** 63n), 2n ** 63n - 1n];
/** @typedef {{timeout?: number, signal?: AbortSignal}} WaitOptions `timeout` in ms, for the node and for its answer */

export class Parameters {
  #raw;
  #surroundings;

  /** @param {PageNode} raw @param {Surroundings} surroundings @param {string} node its full name */
  constructor(raw, surroundings, node) {
    this.#raw = raw;
    this.#surroundings = surroundings;
    this.node = node;
  }

  /** Return the names of all parameters. @param {WaitOptions} [options] @returns {Promise<string[]>} */
  async names(options) {
    const { result } = await this.#call("list_parameters", "ListParameters", { prefixes: [], depth: 0n }, options);
    return result.names;
  }

  /**
   * Return the value of a parameter, undefined if it is not set.
   * @param {string} name @param {WaitOptions} [options] @returns {Promise<any>}
   */
  async get(name, options) {
    const [value] = await this.#values([name], options);
    return value && plainParameter(value);
  }

  /** Return all parameters by name. @param {WaitOptions} [options] @returns {Promise<Record<string, any>>} */
  async all(options) {
    const names = await this.names(options);
    const values = await this.#values(names, options);
    return Object.fromEntries(names.map((name, index) => [name, plainParameter(values[index])]));
  }

  /**
   * Set a parameter, `set("speed", 2, options)`, or several together, `set({ speed: 2, name: "a" }, options)`. A number
   * becomes an integer or a double as the parameter is. Reject with the reason if the node refuses.
   * @param {string | Record<string, any>} name @param {any} [value] @param {WaitOptions} [last]
   */
  async set(name, value, last) {
    const [wanted, options] = typeof name === "string" ? [{ [name]: value }, last] : [name, value];
    const names = Object.keys(wanted);
    const now = await this.#values(names, options);
    const parameters = names.map((one, index) => ({ name: one, value: parameterOf(wanted[one], now[index]?.type) }));
    const call = (/** @type {string} */ service, /** @type {string} */ type, /** @type {any} */ request) =>
      this.#ask(service, type, request, options);
    const fault = await set(/** @type {Ros} */ (/** @type {unknown} */ ({ call })), this.node, parameters);
    if (fault) throw new Error(say("{} refused: {}", this.node, fault));
  }

  /**
   * Return the rcl_interfaces/msg/ParameterDescriptor of a parameter.
   * @param {string} name @param {WaitOptions} [options] @returns {Promise<any>}
   */
  async describe(name, options) {
    const { descriptors } = await this.#call("describe_parameters", "DescribeParameters", { names: [name] }, options);
    return descriptors[0];
  }

  /**
   * Iterate over changes: `{name, value}`, with an undefined value for a parameter that was removed.
   * @param {{most?: number, signal?: AbortSignal}} [options]
   */
  changes(options) {
    return new Stream((push) => this.#raw.subscribe("/parameter_events", "rcl_interfaces/msg/ParameterEvent", (event) => {
      if (event.node !== this.node) return;
      for (const { name, value } of [...event.new_parameters, ...event.changed_parameters]) {
        push({ name, value: plainParameter(value) });
      }
      for (const { name } of event.deleted_parameters) push({ name, value: undefined });
    }, { reliable: true, depth: 1000 }), options, this.#surroundings.closed);
  }

  /** @param {string[]} names @param {WaitOptions} [options] @returns {Promise<any[]>} */
  async #values(names, options) {
    return (await this.#call("get_parameters", "GetParameters", { names }, options)).values;
  }

  /** @param {string} service @param {string} type @param {any} request @param {WaitOptions} [options] */
  async #call(service, type, request, options) {
    const name = `${this.node}/${service}`;
    const { timeout = 5000, signal } = options ?? {};
    await this.#surroundings.when(() => (this.#surroundings.serversOf(name).length ? true : undefined), timeout,
      say("{} has no parameters, or is not running", this.node), signal);
    return this.#ask(name, `${SRV}/${type}`, request, options);
  }

  /** @param {string} name @param {string} type @param {any} request @param {WaitOptions} [options] */
  #ask(name, type, request, { timeout = 5000, signal } = {}) {
    const { closed } = this.#surroundings;
    return this.#raw.call(name, type, request, timeout, signal ? AbortSignal.any([signal, closed]) : closed);
  }
}

/** Return a ParameterValue as JavaScript has it; integers are numbers if these are exact. @param {any} value */
export function plainParameter(value) {
  const plain = plainOf(value);
  if (typeof plain === "bigint") return exact(plain);
  if (plain instanceof BigInt64Array) return Array.from(plain, exact);
  return plain instanceof Float64Array ? Array.from(plain) : plain;
}

/** Return a ParameterValue. @param {any} plain @param {number} [type] the parameter's so far */
export function parameterOf(plain, type = 0) {
  if (plain === null || plain === undefined) return { type: 0 };
  if (plain instanceof Uint8Array) return { type: 5, byte_array_value: plain };
  const list = Array.isArray(plain) || ArrayBuffer.isView(plain);
  const items = list ? Array.from(/** @type {any} */ (plain)) : [plain];
  const kind = items.length ? kindOf(items, type) : Math.max(type, 6) - 5;
  const scalar = items.length ? kind : [1, 2, 3, 4][kind - 1] ?? STRING;
  const values = scalar === INTEGER ? items.map((item) => BigInt(item)) : items;
  const large = values.find((one) => typeof one === "bigint" && (one < SMALLEST || one > LARGEST));
  if (large !== undefined) throw new RangeError(say("{} does not fit into 64 bits", String(large)));
  const found = list ? listOf(scalar) : scalar;
  return { type: found, [fieldOf(found)]: list ? values : values[0] };
}

/** @param {any[]} items not empty @param {number} type the parameter's so far */
function kindOf(items, type) {
  const kinds = new Set(items.map((item) => typeof item));
  if (kinds.size === 1 && kinds.has("boolean")) return BOOL;
  if (kinds.size === 1 && kinds.has("string")) return STRING;
  if ([...kinds].every((kind) => kind === "bigint")) return INTEGER;
  if (![...kinds].every((kind) => kind === "number")) {
    throw new Error(say("a parameter is a boolean, a number, a text, or a list of one of these"));
  }
  const double = type === DOUBLE || type === listOf(DOUBLE);
  return !double && items.every(Number.isSafeInteger) ? INTEGER : DOUBLE;
}

/** @param {bigint} value */
function exact(value) {
  const number = Number(value);
  return Number.isSafeInteger(number) ? number : value;
}
