// @ts-check
// Messages as rosbridge has them in JSON, and as the codec has them.

import { isFloat, isInteger, isMessage, parseFieldType, range } from "../messages/fieldType.js";
import { stamp } from "../client/time.js";
import { Mistake } from "./mistake.js";
import { MOST_TEXT } from "./limits.js";

/** @import { MessageType } from "../protocol.js" */
/** @import { FieldType } from "../messages/fieldType.js" */
/** @typedef {{name: string, written: string, type: FieldType}} Field */

const TIMES = ["builtin_interfaces/msg/Time", "builtin_interfaces/msg/Duration"];
const HEADER = "std_msgs/msg/Header";
/** How ROS 1 names the fields of times. @type {Record<string, string>} */
const OLD = { secs: "sec", nsecs: "nanosec" };

export class Values {
  #types;
  /** @type {Map<string, Field[]>} */
  #fields = new Map();
  /** Of the message that is read: how many more items it may have. */
  #left = 0;

  /** @param {Record<string, MessageType>} types */
  constructor(types) {
    this.#types = types;
  }

  /** Whether the page has the definition of a type. @param {string} type */
  knows(type) {
    return Object.hasOwn(this.#types, type);
  }

  /** @param {string} type @returns {Field[]} */
  fieldsOf(type) {
    let fields = this.#fields.get(type);
    if (!fields) {
      const known = this.knows(type) ? this.#types[type] : undefined;
      if (!known) throw new Mistake(`this page has no definition of ${short(type)}`);
      fields = known.fields.map(({ name, type: written }) => ({ name, written, type: parseFieldType(written) }));
      this.#fields.set(type, fields);
    }
    return fields;
  }

  /**
   * Return a message as JSON has it: 64-bit integers are numbers, bytes are base64, and what is no number is null.
   * @param {string} type @param {any} message @returns {any}
   */
  toJson(type, message) {
    return this.#out(type, message, jsonScalar, jsonArray);
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
   * @param {string} type @param {any} given an object, or a list of the values of the fields in order @returns {any}
   */
  read(type, given) {
    this.#left = MOST_TEXT;
    const fields = this.fieldsOf(type);
    if (!Array.isArray(given)) return this.#read(type, given ?? {}, type, "");
    if (given.length > fields.length) {
      throw new Mistake(`${short(type)} has ${fields.length} fields, not ${given.length}`);
    }
    return this.#read(type, Object.fromEntries(given.map((value, index) => [fields[index]?.name, value])), type, "");
  }

  /**
   * @param {string} type @param {any} message @param {(value: any) => any} scalar @param {(array: any, base: string) => any} list
   * @returns {any}
   */
  #out(type, message, scalar, list) {
    /** @type {Record<string, any>} */
    const copy = {};
    for (const { name, type: { base, array } } of this.fieldsOf(type)) {
      const value = message[name];
      if (!isMessage(base)) copy[name] = array ? list(value, base) : scalar(value);
      else if (!array) copy[name] = this.#out(base, value, scalar, list);
      else copy[name] = value.map((/** @type {any} */ one) => this.#out(base, one, scalar, list));
    }
    return copy;
  }

  /** @param {string} type @param {any} given @param {string} root @param {string} path @returns {any} */
  #read(type, given, root, path) {
    if (given === "now" && type === TIMES[0]) return stamp();
    if (typeof given !== "object" || given === null || Array.isArray(given) || ArrayBuffer.isView(given)) {
      throw new Mistake(`${at(root, path)}: expected an object for ${short(type)}, found ${found(given)}`);
    }
    const fields = this.fieldsOf(type);
    /** @type {Record<string, any>} */
    const message = {};
    const time = TIMES.includes(type);
    const known = new Map(fields.map((field) => [field.name, field]));
    for (const key of Object.keys(given)) {
      const field = known.get(key) ?? (time ? known.get(OLD[key] ?? "") : undefined);
      if (!field) throw new Mistake(`${short(root)} has no field '${joined(path, key).slice(0, 200)}'`);
      if (given[key] !== undefined) message[field.name] = this.#field(field, given[key], root, joined(path, field.name));
    }
    if (type === HEADER) message.stamp ??= stamp();
    const header = known.get("header");
    if (!path && header?.written === HEADER) message.header ??= { stamp: stamp(), frame_id: "" };
    return message;
  }

  /** @param {Field} field @param {any} given @param {string} root @param {string} path @returns {any} */
  #field({ type, written }, given, root, path) {
    const { base, array, size } = type;
    if (!array) return isMessage(base) ? this.#read(base, given, root, path) : this.#scalar(type, given, root, path);
    const items = typeof given === "string" && base === "uint8" ? decoded(given, root, path) : given;
    if (!Array.isArray(items) && !ArrayBuffer.isView(items)) {
      throw new Mistake(`${at(root, path)}: expected a list for ${written}, found ${found(given)}`);
    }
    const all = /** @type {ArrayLike<any> & Iterable<any>} */ (/** @type {unknown} */ (items));
    this.#spend(all.length, root);
    if (array === "fixed" ? all.length !== size : all.length > size) {
      throw new Mistake(`${at(root, path)}: ${written} cannot have ${all.length} items`);
    }
    if (items instanceof Uint8Array && base === "uint8") return items;
    if (isMessage(base)) return Array.from(all, (one, index) => this.#read(base, one, root, `${path}[${index}]`));
    return Array.from(all, (one, index) => this.#scalar(type, one, root, `${path}[${index}]`));
  }

  /** @param {FieldType} type @param {any} given @param {string} root @param {string} path @returns {any} */
  #scalar({ base, capacity }, given, root, path) {
    const wrong = (/** @type {string} */ wanted) =>
      new Mistake(`${at(root, path)}: expected ${wanted} for ${base}, found ${found(given)}`);
    if (isFloat(base)) {
      if (given === null) return NaN;
      if (typeof given === "bigint") return Number(given);
      if (typeof given !== "number") throw wrong("a number");
      return given;
    }
    if (isInteger(base)) {
      if (typeof given === "number" ? !Number.isInteger(given) : typeof given !== "bigint") throw wrong("a whole number");
      const { least, most } = range(base);
      const exact = BigInt(given);
      if (exact < least || exact > most) throw new Mistake(`${at(root, path)}: ${base} cannot be ${given}`);
      return base.endsWith("64") ? BigInt(given) : Number(given);
    }
    if (base === "bool") {
      if (typeof given !== "boolean" && given !== 0 && given !== 1) throw wrong("true or false");
      return Boolean(given);
    }
    if (typeof given !== "string") throw wrong("a text");
    this.#spend(given.length, root);
    const length = capacity === Infinity ? 0 : base === "wstring" ? given.length : new TextEncoder().encode(given).length;
    if (length > capacity) throw new Mistake(`${at(root, path)}: holds at most ${capacity} bytes, not ${length}`);
    return given;
  }

  /** @param {number} items @param {string} root */
  #spend(items, root) {
    this.#left -= items;
    if (this.#left < 0) throw new Mistake(`${short(root)}: the message is too large`);
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

/** @param {Uint8Array} bytes */
export function encoded(bytes) {
  const parts = [];
  for (let at = 0; at < bytes.length; at += 0x8000) parts.push(String.fromCharCode(...bytes.subarray(at, at + 0x8000)));
  return btoa(parts.join(""));
}

/** @param {string} text @param {string} root @param {string} path */
function decoded(text, root, path) {
  try {
    const binary = atob(text);
    return Uint8Array.from(binary, (letter) => letter.charCodeAt(0));
  } catch {
    throw new Mistake(`${at(root, path)}: the text is not base64`);
  }
}

/** @param {string} root @param {string} path */
function at(root, path) {
  return path ? `${short(root)}.${path.slice(0, 200)}` : short(root);
}

/** @param {string} path @param {string} name */
function joined(path, name) {
  return path ? `${path}.${name}` : name;
}

/** @param {unknown} value */
function found(value) {
  if (value === null) return "null";
  if (Array.isArray(value) || ArrayBuffer.isView(value)) return "a list";
  if (typeof value === "object") return "an object";
  return `the ${typeof value} ${JSON.stringify(String(value)).slice(0, 60)}`;
}
