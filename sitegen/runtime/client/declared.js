// @ts-check
// A parameter that a node of a script has declared, as the script uses it.

import { plainParameter } from "./parameters.js";
import { Stream } from "./stream.js";

/** @import { Options } from "./descriptor.js" */
/** @import { OwnParameters } from "./ownParameters.js" */

/** Emits `change` when it has another value. */
export class Declared extends EventTarget {
  #own;

  /**
   * @param {OwnParameters} own @param {any} value rcl_interfaces/msg/ParameterValue
   * @param {any} descriptor rcl_interfaces/msg/ParameterDescriptor @param {Options["accept"]} [accept]
   */
  constructor(own, value, descriptor, accept) {
    super();
    this.#own = own;
    this.raw = value;
    this.descriptor = descriptor;
    this.accept = accept;
  }

  get name() {
    return this.descriptor.name;
  }

  get value() {
    return plainParameter(this.raw);
  }

  /** It throws if the parameter does not take the value. */
  set value(value) {
    this.#own.set(this.name, value);
  }

  /** Iterate over the values that it gets. @param {{most?: number, signal?: AbortSignal}} [options] */
  changes(options) {
    return new Stream((push) => {
      const changed = () => push(this.value);
      this.addEventListener("change", changed);
      return () => this.removeEventListener("change", changed);
    }, options, this.#own.closed);
  }

  /** Remove it from the node. */
  undeclare() {
    this.#own.undeclare(this.name);
  }
}
