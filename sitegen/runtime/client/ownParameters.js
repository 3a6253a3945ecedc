// @ts-check
// The parameters of a script's own node, which others ask for and set by its services.

import { BOOL, NOT_SET } from "../messages/parameters/value.js";
import { say } from "../ui/words.js";
import { Declared } from "./declared.js";
import { described, misfit } from "./descriptor.js";
import { parameterOf, plainParameter } from "./parameters.js";

/** @import { PageNode, Publisher } from "../protocol.js" */
/** @import { Clock } from "./clock.js" */
/** @import { Options } from "./descriptor.js" */
/** @import { Surroundings } from "./surroundings.js" */
/** @typedef {{name: string, value: any}} Wanted with a rcl_interfaces/msg/ParameterValue */

const EVENT = "rcl_interfaces/msg/ParameterEvent";
const SRV = "rcl_interfaces/srv";
const SIM_TIME = "use_sim_time";
/** As rclcpp says it of parameters that are set together. */
const UNDECLARED = "One or more parameters were not declared before setting";
/** The kinds of events. */
const [NEW, CHANGED, DELETED] = /** @type {const} */ (["new_parameters", "changed_parameters", "deleted_parameters"]);

export class OwnParameters {
  #node;
  #clock;
  #closed;
  #overrides;
  /** @type {Map<string, Declared>} */
  declared = new Map();
  /** @type {Publisher} */
  #events;

  /**
   * @param {PageNode} raw @param {Surroundings} surroundings @param {Clock} clock @param {string} node its name
   * @param {Record<string, any>} overrides values of parameters that are declared later, instead of their defaults
   */
  constructor(raw, surroundings, clock, node, overrides) {
    this.#node = node;
    this.#clock = clock;
    this.#closed = surroundings.closed;
    this.#overrides = overrides;
    surroundings.check(node, EVENT);
    surroundings.check(node, `${SRV}/SetParametersAtomically`, "_Request");
    this.#events = raw.advertise("/parameter_events", EVENT, { depth: 1000, reliable: true });
    for (const [name, answer] of Object.entries(this.#services)) {
      const type = name.replace(/(?:^|_)(\w)/g, (_, letter) => letter.toUpperCase());
      raw.serve(`${node}/${name}`, `${SRV}/${type}`, answer);
    }
    this.declare(SIM_TIME, false, { type: "bool" });
  }

  /** Aborted when the node is closed. */
  get closed() {
    return this.#closed;
  }

  /** @param {string} name @param {any} given @param {Options} [options] */
  declare(name, given, options = {}) {
    this.#closed.throwIfAborted();
    if (typeof name !== "string" || !name) throw new Error(say("a parameter needs a name, which is a text"));
    if (this.declared.has(name)) throw new Error(say("parameter '{}' has already been declared", name));
    const { value: usual, descriptor } = described(name, given, options);
    const override = Object.hasOwn(this.#overrides, name) ? this.#overrides[name] : undefined;
    const value = override === undefined ? usual : parameterOf(override, descriptor.type);
    const one = new Declared(this, value, descriptor, options.accept);
    const fault = given === undefined && override === undefined ? "" : refusal(one, value);
    if (fault) throw new Error(say("{} refused: {}", this.#node, fault));
    this.declared.set(name, one);
    // It is new to others when it has a value.
    if (value.type !== NOT_SET) this.#changed([{ name, value }], NEW);
    return one;
  }

  /** Throws if the parameter does not take the value. @param {string} name @param {any} given */
  set(name, given) {
    this.#closed.throwIfAborted();
    const fault = this.#set([{ name, value: parameterOf(given, this.declared.get(name)?.descriptor.type) }]);
    if (fault) throw new Error(say("{} refused: {}", this.#node, fault));
  }

  /** @param {string} name */
  undeclare(name) {
    const one = this.declared.get(name);
    if (!one || !this.declared.delete(name)) return;
    this.#publish([{ name, value: one.raw }], DELETED);
  }

  /** Set parameters together and return "", or set none and return why. @param {Wanted[]} wanted */
  #set(wanted) {
    for (const { name, value } of wanted) {
      const one = this.declared.get(name);
      const fault = one ? refusal(one, value, true) : `parameter '${name}' cannot be set because it was not declared`;
      if (fault) return fault;
    }
    const gone = wanted.filter(({ value }) => value.type === NOT_SET);
    const fresh = wanted.filter(({ name, value }) => value.type !== NOT_SET && !this.declared.get(name)?.raw.type);
    const changed = wanted.filter((one) => !gone.includes(one) && !fresh.includes(one));
    for (const { name } of gone) this.undeclare(name);
    if (fresh.length) this.#changed(fresh, NEW);
    if (changed.length) this.#changed(changed, CHANGED);
    return "";
  }

  /** @param {Wanted[]} wanted @param {typeof NEW | typeof CHANGED} kind */
  #changed(wanted, kind) {
    for (const { name, value } of wanted) {
      const one = /** @type {Declared} */ (this.declared.get(name));
      one.raw = value;
      if (one.descriptor.dynamic_typing) one.descriptor.type = value.type;
      if (name === SIM_TIME) this.#clock.isSimulated = value.type === BOOL && value.bool_value;
    }
    this.#publish(wanted, kind);
    for (const { name } of wanted) this.declared.get(name)?.dispatchEvent(new Event("change"));
  }

  /** @param {Wanted[]} parameters @param {typeof NEW | typeof CHANGED | typeof DELETED} kind */
  #publish(parameters, kind) {
    this.#events.publish({ stamp: this.#clock.now(), node: this.#node, [kind]: parameters });
  }

  /** The parameters of these names, if all are declared. @param {string[]} names @returns {Declared[]} */
  #all(names) {
    const found = names.flatMap((name) => this.declared.get(name) ?? []);
    return found.length === names.length ? found : [];
  }

  /** By name. As in rclcpp, one name that is not declared leaves the whole answer empty. @type {Record<string, (request: any) => any>} */
  #services = {
    get_parameters: ({ names }) => ({ values: this.#all(names).map(({ raw }) => raw) }),
    get_parameter_types: ({ names }) => ({ types: Uint8Array.from(this.#all(names), ({ raw }) => raw.type) }),
    describe_parameters: ({ names }) => ({ descriptors: this.#all(names).map(({ descriptor }) => descriptor) }),
    list_parameters: ({ prefixes, depth }) => ({ result: listed([...this.declared.keys()], prefixes, Number(depth)) }),
    set_parameters: ({ parameters }) => ({
      results: parameters.map((/** @type {Wanted} */ one) => resultOf(this.#set([one]))),
    }),
    set_parameters_atomically: ({ parameters }) => {
      const known = parameters.every((/** @type {Wanted} */ { name }) => this.declared.has(name));
      return { result: resultOf(known ? this.#set(parameters) : UNDECLARED) };
    },
  };
}

/**
 * Return why a parameter does not take a value, in words of ROS, or "".
 * @param {Declared} one @param {any} value rcl_interfaces/msg/ParameterValue @param {boolean} [again] not declared just now
 */
function refusal({ name, descriptor, accept }, value, again = false) {
  if (again && descriptor.read_only) return `parameter '${name}' cannot be set because it is read-only`;
  const fault = misfit(value, descriptor);
  if (fault || value.type === NOT_SET) return fault;
  const verdict = accept?.(plainParameter(value)) ?? true;
  return verdict === true ? "" : verdict || `parameter '${name}' does not take this value`;
}

/** @param {string} reason */
function resultOf(reason) {
  return { successful: !reason, reason };
}

/**
 * Return what rcl_interfaces/srv/ListParameters answers.
 * @param {string[]} names @param {string[]} prefixes all if there is none @param {number} depth 0 for all
 */
function listed(names, prefixes, depth) {
  const isNear = (/** @type {string} */ rest) => depth === 0 || rest.split(".").length <= depth;
  const found = names.filter((name) => (prefixes.length
    ? prefixes.some((prefix) => name === prefix || (name.startsWith(`${prefix}.`) && isNear(name.slice(prefix.length + 1))))
    : isNear(name)));
  const above = found.filter((name) => name.includes(".")).map((name) => name.slice(0, name.lastIndexOf(".")));
  return { names: found.sort(), prefixes: [...new Set(above)] };
}
