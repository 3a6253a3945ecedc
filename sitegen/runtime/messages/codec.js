// @ts-check
// Convert messages between CDR and plain objects, for types that the page has definitions of.

import { MessageReader, MessageWriter } from "../vendor/cdr.js";
import { fromWire, toWire, WIRE_TYPES, wireField } from "./text.js";

/** @import { MessageType } from "../protocol.js" */

// For example "geometry_msgs/msg/Point[<=5]" or "string<=10[3]": the type, its bound, and the bound of the array.
const TYPE = /^([^[<]+)(?:<=(\d+))?(?:\[(<=)?(\d*)\])?$/;

/**
 * The type of a field, parsed. `length` is that of a fixed-size array, else null.
 * @typedef {{name: string, base: string, isArray: boolean, length: number | null}} Field
 */

export class Codec {
  #types;
  /** @type {Map<string, MessageReader>} */
  #readers = new Map();
  /** @type {Map<string, MessageWriter>} */
  #writers = new Map();
  /** @type {Map<string, Field[]>} */
  #fields = new Map();

  /** @param {Record<string, MessageType>} types */
  constructor(types) {
    this.#types = types;
  }

  /** @param {string} type @param {Uint8Array} bytes @returns {any} */
  read(type, bytes) {
    let reader = this.#readers.get(type);
    if (!reader) {
      reader = new MessageReader(this.#definitions(type));
      this.#readers.set(type, reader);
    }
    return this.#convert(type, reader.readMessage(bytes), fromWire);
  }

  /**
   * Missing fields of `message` are zero.
   * @param {string} type @param {any} message @returns {Uint8Array}
   */
  write(type, message) {
    let writer = this.#writers.get(type);
    if (!writer) {
      writer = new MessageWriter(this.#definitions(type));
      this.#writers.set(type, writer);
    }
    return writer.writeMessage(this.#convert(type, message, toWire));
  }

  /** The fields of a type. @param {string} type */
  #fieldsOf(type) {
    let fields = this.#fields.get(type);
    if (!fields) {
      const known = this.#types[type];
      if (!known) throw new Error(`this page has no definition of ${type}`);
      fields = known.fields.map((field) => parse(field.name, field.type));
      this.#fields.set(type, fields);
    }
    return fields;
  }

  /** Return the definitions of a type and of all types nested in it, for the serializer. @param {string} root */
  #definitions(root) {
    const names = new Set([root]);
    const definitions = [];
    for (const name of names) { // the set grows during the loop
      const fields = this.#fieldsOf(name);
      for (const { base } of fields) if (isMessage(base)) names.add(base);
      definitions.push({ name, definitions: fields.map(definition) });
    }
    return [...definitions, ...WIRE_TYPES];
  }

  /**
   * Return a copy of `message` with all texts converted.
   * @param {string} type @param {any} message @param {(base: string, field: Field, value: any) => any} convert
   * @returns {any}
   */
  #convert(type, message, convert) {
    /** @type {Record<string, any>} */
    const copy = {};
    for (const field of this.#fieldsOf(type)) {
      const { name, base, isArray, length } = field;
      const value = message[name];
      if (!isMessage(base)) {
        copy[name] = convert(base, field, value);
      } else if (isArray) {
        const all = value ?? Array.from({ length: length ?? 0 }, () => ({}));
        copy[name] = all.map((/** @type {any} */ one) => this.#convert(base, one, convert));
      } else {
        copy[name] = this.#convert(base, value ?? {}, convert);
      }
    }
    return copy;
  }
}

/** @param {string} base */
function isMessage(base) {
  return base.includes("/");
}

/** @param {string} name @param {string} type @returns {Field} */
function parse(name, type) {
  const [, base = "", , upTo, count] = TYPE.exec(type) ?? [];
  const isArray = count !== undefined;
  return { name, base, isArray, length: isArray && count && !upTo ? Number(count) : null };
}

/** Return the definition of a field for the serializer. @param {Field} field */
function definition(field) {
  const { name, base, isArray, length } = field;
  return wireField(field) ??
    { name, type: base, isComplex: isMessage(base), isArray, arrayLength: length ?? undefined };
}
