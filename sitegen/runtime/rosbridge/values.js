// @ts-check
// Messages as rosbridge has them in JSON, and as the codec has them.

import { stamp } from "../messages/time.js";
import { Checker } from "../messages/checker.js";
import { isFloat, isMessage } from "../messages/fieldType.js";
import { Mistake } from "./mistake.js";
import { MOST_TEXT } from "./limits.js";

const TIMES = ["builtin_interfaces/msg/Time", "builtin_interfaces/msg/Duration"];
const HEADER = "std_msgs/msg/Header";
// Bytes in a list.
const MOST_LISTED = 1000;
/** How ROS 1 names the fields of times. @type {Record<string, string>} */
const OLD = { secs: "sec", nsecs: "nanosec" };

/** Reads what clients of rosbridge write, too: base64, null for what is no number, "now", and the times of ROS 1. */
export class Values extends Checker {
  /** Of the message that is read: how many more items it may have. */
  #left = 0;
  #whole = "";

  /**
   * Return a message as JSON has it: 64-bit integers are numbers, bytes are base64, and what is no number is null.
   * @param {string} type @param {any} message @returns {any}
   */
  toJson(type, message) {
    return this.#out(type, message, jsonScalar, jsonArray);
  }

  /**
   * Return a message as JSON has it, but with the numbers that JSON lacks as they are.
   * @param {string} type @param {any} message @returns {any}
   */
  toExact(type, message) {
    return this.#out(type, message, (value) => value, exactArray);
  }

  /**
   * Return a message as CBOR has it: arrays of numbers are typed arrays, and bytes are bytes.
   * @param {string} type @param {any} message @returns {any}
   */
  toCbor(type, message) {
    return this.#out(type, message, cborScalar, (array) => array);
  }

  /**
   * Return the message that JSON, or an object with typed arrays, means. Missing fields are zero; a missing time of a
   * header is now.
   * @override
   * @param {string} type @param {any} given an object, or a list of the values of the fields in order @returns {any}
   */
  read(type, given) {
    this.#left = MOST_TEXT;
    this.#whole = type;
    if (!Array.isArray(given)) return super.read(type, given ?? {});
    const names = [...this.fieldsOf(type).keys()];
    if (given.length > names.length) {
      throw new Mistake(`${short(type)} has ${names.length} fields, not ${given.length}`);
    }
    return super.read(type, Object.fromEntries(given.map((value, index) => [names[index], value])));
  }

  /** @override @param {string} text */
  errorOf(text) {
    return new Mistake(text);
  }

  /** @override @param {string} type */
  nameOf(type) {
    return short(type);
  }

  /** @override @param {string} type @param {any} given @returns {any} */
  meant(type, given) {
    if (given === null && isFloat(type)) return NaN;
    if (type === "bool" && (given === 0 || given === 1)) return given === 1;
    if (type === TIMES[0] && given === "now") return stamp();
    if (type !== "uint8[]" || typeof given !== "string") return undefined;
    try {
      return Uint8Array.from(atob(given), (letter) => letter.charCodeAt(0));
    } catch {
      throw this.fault("the text is not base64");
    }
  }

  /** @override @param {string} type @param {string} name */
  renamed(type, name) {
    return (TIMES.includes(type) && OLD[name]) || "";
  }

  /** @override @param {string} type @param {any} message @param {boolean} whole */
  complete(type, message, whole) {
    if (type === HEADER) message.stamp ??= stamp();
    else if (whole && this.fieldsOf(type).get("header")?.written === HEADER) {
      message.header ??= { stamp: stamp(), frame_id: "" };
    }
  }

  /** @override */
  advice() {
    return "";
  }

  /** @override @param {number} items */
  spend(items) {
    this.#left -= items;
    if (this.#left < 0) throw new Mistake(`${short(this.#whole)}: the message is too large`);
  }

  /** JSON has no other integers. @override */
  isExact() {
    return true;
  }

  /**
   * @param {string} type @param {any} message @param {(value: any) => any} scalar @param {(array: any, base: string) => any} list
   * @returns {any}
   */
  #out(type, message, scalar, list) {
    /** @type {Record<string, any>} */
    const copy = {};
    for (const { name, type: { base, array } } of this.fieldsOf(type).values()) {
      const value = message[name];
      if (!isMessage(base)) copy[name] = array ? list(value, base) : scalar(value);
      else if (!array) copy[name] = this.#out(base, value, scalar, list);
      else copy[name] = value.map((/** @type {any} */ one) => this.#out(base, one, scalar, list));
    }
    return copy;
  }
}

/** Return the name of a type as ROS 1 has it. @param {string} type */
export function short(type) {
  return type.replace(/\/(msg|srv|action)\//, "/");
}

/** @param {any} value */
function jsonScalar(value) {
  if (typeof value === "bigint") return Number(value);
  return typeof value === "number" && !Number.isFinite(value) ? null : value;
}

/** @param {any} value */
function cborScalar(value) {
  if (typeof value !== "bigint") return value;
  return Number.isSafeInteger(Number(value)) ? Number(value) : value;
}

/** @param {any} array @param {string} base */
function jsonArray(array, base) {
  if (array instanceof Uint8Array && base === "uint8") return encoded(array);
  return Array.from(array, jsonScalar);
}

/** @param {any} array */
function exactArray(array) {
  // Servers want lists of byte[], which the page cannot tell from uint8[]. Long ones are images and the like.
  return array instanceof Uint8Array && array.length > MOST_LISTED ? encoded(array) : Array.from(array);
}

/** @param {Uint8Array} bytes */
export function encoded(bytes) {
  const parts = [];
  for (let at = 0; at < bytes.length; at += 0x8000) parts.push(String.fromCharCode(...bytes.subarray(at, at + 0x8000)));
  return btoa(parts.join(""));
}
