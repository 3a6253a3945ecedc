// @ts-check
// The types of the page, which tells them when it is asked, and those of the robot's topics.

import { isSame, readDefinitions } from "../../bag/definition.js";
import { isMessage, parseFieldType } from "../../messages/fieldType.js";
import { textOf } from "../mistake.js";

/** @import { Types } from "../../bag/definition.js" */
/** @import { Calls } from "./calls.js" */
/** @typedef {{types: Types, hasCbor: boolean}} Known the definition of a type and of those in it */

export class RobotTypes {
  #calls;
  #note;
  /** What the page has told, and what it has learned. @type {Types} */
  all = {};
  #askPage;
  /** Resolves when the page has told a type, or that it has none. @type {Map<string, {told: Promise<void>, resolve(): void}>} */
  #wanted = new Map();
  /** The questions that the page has not answered; it answers in order. @type {string[]} */
  #questions = [];
  /** What the robot has said of types, by name. @type {Map<string, Known | undefined>} */
  #known = new Map();
  /** @type {Promise<void> | undefined} */
  #asking;

  /**
   * @param {(types: string[]) => void} askPage @param {Calls} calls
   * @param {(name: string, reason: string) => void} note
   */
  constructor(askPage, calls, note) {
    this.#askPage = askPage;
    this.#calls = calls;
    this.#note = note;
  }

  /** Whether a type need not be waited for. @param {string} type */
  has(type) {
    return Object.hasOwn(this.all, type);
  }

  /** Wait until the page has told a type, if it has it. @param {string} type @returns {Promise<void>} */
  need(type) {
    if (this.has(type)) return Promise.resolve();
    const known = this.#wanted.get(type);
    if (known) return known.told;
    let resolve = () => {};
    const told = new Promise((/** @type {(value: void) => void} */ done) => (resolve = done));
    this.#wanted.set(type, { told, resolve });
    this.#questions.push(type);
    this.#askPage([type]);
    return told;
  }

  /** The page has answered the oldest question. @param {Types} types */
  learn(types) {
    Object.assign(this.all, types);
    const type = this.#questions.shift() ?? "";
    this.#wanted.get(type)?.resolve();
    // Later, it may have it.
    this.#wanted.delete(type);
  }

  /** Whether the server can send a type as CBOR. @param {string} type */
  async hasCbor(type) {
    return (await this.#robots(type))?.hasCbor ?? false;
  }

  /**
   * Return definitions of types that the page does not have, as far as the robot tells them.
   * @param {string[]} types @returns {Promise<Types>}
   */
  async describe(types) {
    /** @type {Types} */
    const learned = {};
    for (const type of types) {
      for (const [name, one] of Object.entries((await this.#robots(type))?.types ?? {})) {
        if (!Object.hasOwn(this.all, name)) learned[name] = one;
      }
    }
    Object.assign(this.all, learned);
    return learned;
  }

  /** @param {string} type @returns {Promise<Known | undefined>} */
  async #robots(type) {
    await this.need(type);
    // Of services and actions, rosapi tells single types only, and ends at some of them.
    if (!type.includes("/msg/")) return undefined;
    if (!this.#known.has(type)) {
      this.#asking ??= this.#ask().finally(() => (this.#asking = undefined));
      await this.#asking;
    }
    if (!this.#known.has(type)) this.#known.set(type, undefined);
    return this.#known.get(type);
  }

  /** Ask for the types of all topics, which rosapi tells together. */
  async #ask() {
    const { types, typedefs_full_text: texts } =
      await this.#calls.call("/rosapi/topics_and_raw_types").catch(() => ({}));
    if (!Array.isArray(types) || !Array.isArray(texts)) return;
    for (const [index, type] of types.entries()) {
      if (!this.#known.get(type)) this.#known.set(type, this.#read(String(type), texts[index]));
    }
  }

  /** @param {string} type @param {unknown} text @returns {Known | undefined} */
  #read(type, text) {
    // A single comment says why the server has no definition.
    if (typeof text !== "string" || /^#[^\n]*\n?$/.test(text)) return undefined;
    try {
      const types = readDefinitions(type, text);
      if (this.all[type] && !isSame(this.all, types, type)) this.#note(type, "the robot has another definition of this type");
      return { types, hasCbor: hasCbor(types, text) };
    } catch (error) {
      this.#note(type, textOf(error));
      return undefined;
    }
  }
}

/**
 * Whether rosbridge_server can write a type as CBOR. It fails, and sends nothing, for arrays of numbers with a fixed or
 * limited size, for bytes and for wide texts.
 * @param {Types} types @param {string} text of the definitions, which tells byte from uint8
 */
function hasCbor(types, text) {
  return !/^\s*(?:byte|wstring)\b/m.test(text) && Object.values(types).every(({ fields }) => fields.every(({ type }) => {
    const { base, array } = parseFieldType(type);
    return isMessage(base) || array === "" || array === "unbounded";
  }));
}
