// @ts-check
// Check the messages that a program makes, before they are written: their fields, types and ranges.

import { FLOATS, INTEGERS, isFloat, isInteger, isMessage, parseFieldType, range } from "./fieldType.js";

/** @import { MessageType } from "../protocol.js" */
/** @import { FieldType } from "./fieldType.js" */
/**
 * @typedef {"message" | "text" | "bool" | "float" | "integer" | "long"} Kind `long` has 64 bits
 * @typedef {{name: string, written: string, type: FieldType, kind: Kind, least: any, most: any, List: any}} Field `List`
 *   is the class of arrays of numbers
 */

const WHOLE = "a whole number";
/** @type {Record<string, string>} */
const WANTED = { text: "a text", bool: "true or false", float: "a number", integer: WHOLE, long: WHOLE };
const LISTS = /** @type {Record<string, any>} */ ({ ...INTEGERS, ...FLOATS });

/** What it accepts and how it tells mistakes is for JavaScript; classes that extend it are for other clients. */
export class Checker {
  #types;
  /** Of each type, by name. @type {Map<string, Map<string, Field>>} */
  #fields = new Map();
  // Of the message that is read: whose it is, its type, and the way to the present value by fields and places in lists.
  #about = "";
  #root = "";
  /** @type {(string | number)[]} */
  #path = [];

  /** @param {Record<string, MessageType>} types */
  constructor(types) {
    this.#types = types;
  }

  /** Whether the page has the definition of a type. @param {string} type */
  knows(type) {
    return Object.hasOwn(this.#types, type);
  }

  /** The fields of a type, by name. @param {string} type */
  fieldsOf(type) {
    let fields = this.#fields.get(type);
    if (!fields) {
      const known = this.knows(type) ? this.#types[type] : undefined;
      if (!known) throw this.errorOf(`this page has no definition of ${this.nameOf(type)}`, Error);
      fields = new Map(known.fields.map(({ name, type: written }) => [name, fieldOf(name, written)]));
      this.#fields.set(type, fields);
    }
    return fields;
  }

  /**
   * Return a message as the codec has it. Throw an Error that says what is wrong, and where. Fields may be missing.
   * @param {string} type @param {any} given @param {string} [about] the topic, service or action @returns {any}
   */
  read(type, given, about = "") {
    this.#about = about;
    this.#root = type;
    this.#path = [];
    return this.#message(type, given);
  }

  /** Return the Error of the present value. @param {string} text @param {new (text: string) => Error} Kind */
  fault(text, Kind = TypeError) {
    const path = pathOf(this.#path);
    return this.errorOf(`${this.nameOf(this.#root)}${path && `.${path}`}: ${text}`, Kind);
  }

  /** @param {string} text @param {new (text: string) => Error} Kind @returns {Error} */
  errorOf(text, Kind) {
    return new Kind(this.#about ? `${this.#about}: ${text}` : text);
  }

  /** The name of a type in messages. @param {string} type */
  nameOf(type) {
    return type;
  }

  /**
   * Return what a value of another type means; undefined if nothing.
   * @param {string} _type of the value, "uint8[]" for a list @param {any} _given @returns {any}
   */
  meant(_type, _given) {
    return undefined;
  }

  /** Return the field that another name means. @param {string} _type @param {string} _name */
  renamed(_type, _name) {
    return "";
  }

  /** Add what is missing. @param {string} _type @param {any} _message @param {boolean} _whole not a part of another */
  complete(_type, _message, _whole) {}

  /** Say what there is in place of an unknown field. @param {string} type */
  advice(type) {
    const names = [...this.fieldsOf(type).keys()];
    const whose = this.#path.length ? `the fields of ${this.nameOf(type)}` : "its fields";
    return names.length ? `; ${whose} are ${names.join(", ")}` : `; ${this.nameOf(type)} has no fields`;
  }

  /** Count the items of lists and the letters of texts. @param {number} _items */
  spend(_items) {}

  /** Whether a number may stand for an integer of 64 bits. @param {number} number */
  isExact(number) {
    return Number.isSafeInteger(number);
  }

  /** @param {string} type @param {any} given @returns {any} */
  #message(type, given) {
    const fields = this.fieldsOf(type);
    const keys = keysOf(given, fields);
    if (!keys) return this.#otherwise(type, `an object for ${this.nameOf(type)}`, given);
    /** @type {Record<string, any>} */
    const message = {};
    const path = this.#path;
    for (const key of keys) {
      const field = fields.get(key) ?? fields.get(this.renamed(type, key));
      if (!field) {
        const wrong = pathOf([...path, key]);
        throw this.errorOf(`${this.nameOf(this.#root)} has no field '${wrong}'${this.advice(type)}`, TypeError);
      }
      const value = given[key];
      if (value === undefined) continue;
      path.push(field.name);
      message[field.name] = field.type.array ? this.#list(field, value) : this.#value(field, value);
      path.pop();
    }
    this.complete(type, message, path.length === 0);
    return message;
  }

  /** @param {Field} field @param {any} given @returns {any} */
  #list(field, given) {
    const { written, type: { base, array, size }, List } = field;
    const items = isList(given) ? given : this.#otherwise(`${base}[]`, `a list for ${written}`, given);
    const { length } = items;
    this.spend(length);
    if (array === "fixed" ? length !== size : length > size) {
      throw this.fault(`${written} cannot have ${length} items`, RangeError);
    }
    if (List && items instanceof List) return items;
    if (List === Uint8Array && items instanceof Uint8ClampedArray) {
      return new Uint8Array(items.buffer, items.byteOffset, length);
    }
    const read = List ? new List(length) : new Array(length);
    const path = this.#path;
    const depth = path.push(0) - 1;
    for (let index = 0; index < length; index++) {
      path[depth] = index;
      read[index] = this.#value(field, items[index]);
    }
    path.pop();
    return read;
  }

  /** @param {Field} field @param {any} given @returns {any} */
  #value(field, given) {
    const { kind, type: { base } } = field;
    const number = typeof given === "number";
    switch (kind) {
      case "message":
        return this.#message(base, given);
      case "float":
        if (number || typeof given === "bigint") return this.#float(base, given);
        break;
      case "text":
        if (typeof given === "string") return this.#text(field, given);
        break;
      case "bool":
        if (typeof given === "boolean") return given;
        break;
      default:
        if (number ? Number.isInteger(given) : typeof given === "bigint") return this.#integer(field, given);
    }
    return this.#otherwise(base, `${WANTED[kind]} for ${base}`, given);
  }

  /** @param {Field} field @param {string} given */
  #text({ type: { base, capacity } }, given) {
    this.spend(given.length);
    const length = capacity === Infinity ? 0 : base === "wstring" ? given.length : new TextEncoder().encode(given).length;
    if (length > capacity) throw this.fault(`holds at most ${capacity} bytes, not ${length}`, RangeError);
    return given;
  }

  /** @param {string} base @param {number | bigint} given */
  #float(base, given) {
    if (base === "float64" && typeof given === "number") return given;
    const value = Number(given);
    const fits = Number.isFinite(base === "float32" ? Math.fround(value) : value);
    if (fits || (typeof given === "number" && !Number.isFinite(given))) return value;
    throw this.fault(`${base} cannot be ${given}`, RangeError);
  }

  /** @param {Field} field @param {number | bigint} given */
  #integer({ kind, least, most, type: { base } }, given) {
    if (given < least || given > most) throw this.fault(`${base} cannot be ${given}`, RangeError);
    if (kind === "integer") return Number(given);
    if (typeof given === "number" && !this.isExact(given)) {
      throw this.fault(`${given} is not exact as a number; write it as a BigInt, like ${BigInt(given)}n`, RangeError);
    }
    return BigInt(given);
  }

  /** Return what a value means that is not of its type. @param {string} type @param {string} wanted @param {any} given */
  #otherwise(type, wanted, given) {
    const meant = this.meant(type, given);
    if (meant === undefined) throw this.fault(`expected ${wanted}, found ${found(given)}`);
    return meant;
  }
}

/** @param {string} name @param {string} written @returns {Field} */
function fieldOf(name, written) {
  const type = parseFieldType(written);
  const { base } = type;
  const field = { name, written, type, least: 0, most: 0, List: LISTS[base] };
  if (!isInteger(base)) {
    const kind = isMessage(base) ? "message" : isFloat(base) ? "float" : base === "bool" ? "bool" : "text";
    return { ...field, kind };
  }
  const { least, most } = range(base);
  if (base.endsWith("64")) return { ...field, kind: "long", least, most };
  return { ...field, kind: "integer", least: Number(least), most: Number(most) };
}

/**
 * The names of what is given for a message; undefined if it is none. Objects of classes, such as DOMPoint, may have more
 * than a message has, but at least one of its fields: a promise or a Map is a mistake.
 * @param {any} given @param {Map<string, Field>} fields
 */
function keysOf(given, fields) {
  if (typeof given !== "object" || given === null || Array.isArray(given) || ArrayBuffer.isView(given)) return undefined;
  if (isPlain(given)) return Object.keys(given);
  const names = [...fields.keys()].filter((name) => name in given);
  return names.length ? names : undefined;
}

/** Whether an object is a literal, of this window or of another. @param {object} given */
function isPlain(given) {
  const above = Object.getPrototypeOf(given);
  return above === null || Object.getPrototypeOf(above) === null;
}

/** @param {any} given */
function isList(given) {
  return Array.isArray(given) || (ArrayBuffer.isView(given) && !(given instanceof DataView));
}

/** @param {(string | number)[]} path */
function pathOf(path) {
  const text = path.map((step) => (typeof step === "number" ? `[${step}]` : `.${step}`)).join("").slice(1);
  return text.slice(0, 200);
}

/** @param {unknown} value */
function found(value) {
  if (value === null || value === undefined) return String(value);
  if (isList(value)) return "a list";
  if (typeof value !== "object") return `the ${typeof value} ${JSON.stringify(String(value)).slice(0, 60)}`;
  return isPlain(value) ? "an object" : `an object of the class ${value.constructor?.name}`;
}
