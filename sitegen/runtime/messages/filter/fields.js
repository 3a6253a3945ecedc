// @ts-check
// Read single fields of messages in CDR.

/**
 * A field. `kind` is a number of type_description_interfaces: a scalar, plus 48 for an array, 96 for a bounded sequence
 * or 144 for an unbounded one. `nested` is the name of a nested message, `capacity` the length of an array.
 * @typedef {{name: string, kind: number, nested: string, capacity: number}} Field
 */
/** Values of the same sort can be compared. @typedef {"number" | "text" | "bool"} Sort */
/** @typedef {number | bigint | string | boolean} Value */

const NESTED = 1;
const SCALARS = 48;
const BOOL = 15;
const TEXTS = new Set([17, 19, 21]);
const WIDE = new Set([18, 20, 22]);
/** @type {Record<number, number>} */
const SIZES = { 2: 1, 3: 1, 4: 2, 5: 2, 6: 4, 7: 4, 8: 8, 9: 8, 10: 4, 11: 8, 12: 16, 13: 1, 14: 2, 15: 1, 16: 1 };
/** @type {Record<number, (view: DataView, at: number) => Value>} */
const READ = {
  2: (view, at) => view.getInt8(at),
  3: (view, at) => view.getUint8(at),
  4: (view, at) => view.getInt16(at, true),
  5: (view, at) => view.getUint16(at, true),
  6: (view, at) => view.getInt32(at, true),
  7: (view, at) => view.getUint32(at, true),
  8: (view, at) => view.getBigInt64(at, true),
  9: (view, at) => view.getBigUint64(at, true),
  10: (view, at) => view.getFloat32(at, true),
  11: (view, at) => view.getFloat64(at, true),
  13: (view, at) => view.getUint8(at),
  15: (view, at) => view.getUint8(at) !== 0,
  16: (view, at) => view.getUint8(at),
};

export class Fields {
  /** By the name of the message type, empty for that of the message itself. @type {Map<string, Field[]>} */
  #types = new Map();
  /** The index of each value, by path. @type {Map<string, number>} */
  #slots = new Map();
  /** The paths of all values and of the messages and arrays around them. @type {Set<string>} */
  #ways = new Set();

  /**
   * @param {string} definition a field per line: its name, kind, nested message or "-", and the length of an array. A
   *   line that begins with "=" has the name of a nested message, whose fields follow.
   */
  constructor(definition) {
    let name = "";
    for (const line of definition.split("\n")) {
      if (line.startsWith("=")) name = line.slice(1);
      const fields = this.#types.get(name) ?? [];
      this.#types.set(name, fields);
      const [field = "", kind, nested = "", capacity] = line.split(" ");
      if (kind) fields.push({ name: field, kind: Number(kind), nested, capacity: Number(capacity) });
    }
  }

  /**
   * Return the index in `values` of the field at `path`, such as pose.position.x or ranges[0], and its sort. Throws an
   * Error if there is no such field.
   * @param {string} path @returns {{slot: number, sort: Sort}}
   */
  find(path) {
    let type = "";
    let way = "";
    const parts = path.split(".");
    for (const [step, part] of parts.entries()) {
      const [, name, index] = /^(\w+)(?:\[(\d+)\])?$/.exec(part) ?? [];
      const field = this.#types.get(type)?.find((one) => one.name === name);
      if (!field) throw new Error(`the message has no field '${path}'`);
      if ((field.kind >= SCALARS) !== (index !== undefined)) {
        throw new Error(index === undefined ? `'${path}' is an array` : `'${path}' is not an array`);
      }
      way = way ? `${way}.${name}` : `${name}`;
      this.#ways.add(way);
      if (index !== undefined) this.#ways.add(way += `[${Number(index)}]`);
      const scalar = field.kind % SCALARS;
      type = field.nested;
      if (step === parts.length - 1) {
        if (scalar === NESTED) throw new Error(`'${path}' is a message: name one of its fields`);
        if (!this.#slots.has(way)) this.#slots.set(way, this.#slots.size);
        const sort = scalar === BOOL ? "bool" : TEXTS.has(scalar) || WIDE.has(scalar) ? "text" : "number";
        return { slot: this.#slots.get(way) ?? 0, sort };
      }
      if (scalar !== NESTED) throw new Error(`the message has no field '${path}'`);
    }
    throw new Error("a field without a name");
  }

  /**
   * Return the values of all fields that were found; undefined beyond the end of a sequence.
   * @param {Uint8Array} message @returns {(Value | undefined)[]}
   */
  values(message) {
    const view = new DataView(message.buffer, message.byteOffset + 4, message.byteLength - 4);
    /** @type {(Value | undefined)[]} */
    const values = Array(this.#slots.size).fill(undefined);
    this.#walk(view, 0, "", "", values);
    return values;
  }

  /**
   * @param {DataView} view @param {number} at @param {string} type
   * @param {string} way its path, "?" if none of its fields is needed
   * @param {(Value | undefined)[]} values
   * @returns {number} the offset of its end
   */
  #walk(view, at, type, way, values) {
    for (const { name, kind, nested, capacity } of this.#types.get(type) ?? []) {
      const scalar = kind % SCALARS;
      const path = way === "?" ? way : way ? `${way}.${name}` : name;
      const here = this.#ways.has(path) ? path : "?";
      if (kind < SCALARS) {
        at = this.#one(view, at, scalar, nested, here, values);
        continue;
      }
      let count = capacity;
      if (kind >= 2 * SCALARS) {
        at = aligned(at, 4);
        count = view.getUint32(at, true);
        at += 4;
      }
      const size = SIZES[scalar];
      if (size && here === "?") {
        at = count ? aligned(at, Math.min(size, 8)) + size * count : at;
        continue;
      }
      for (let index = 0; index < count; index++) {
        const element = `${here}[${index}]`;
        at = this.#one(view, at, scalar, nested, this.#ways.has(element) ? element : "?", values);
      }
    }
    return at;
  }

  /**
   * @param {DataView} view @param {number} at @param {number} scalar @param {string} nested
   * @param {string} way @param {(Value | undefined)[]} values
   */
  #one(view, at, scalar, nested, way, values) {
    if (scalar === NESTED) return this.#walk(view, at, nested, way, values);
    const slot = this.#slots.get(way);
    const size = SIZES[scalar];
    if (size) {
      const start = aligned(at, Math.min(size, 8));
      if (slot !== undefined) values[slot] = READ[scalar]?.(view, start);
      return start + size;
    }
    const start = aligned(at, 4) + 4;
    const length = view.getUint32(start - 4, true);
    if (WIDE.has(scalar)) {
      const unit = (/** @type {unknown} */ _, /** @type {number} */ i) => view.getUint32(start + 4 * i, true);
      if (slot !== undefined) values[slot] = String.fromCharCode(...Array.from({ length }, unit));
      return start + 4 * length;
    }
    if (slot !== undefined) {
      const text = new Uint8Array(view.buffer, view.byteOffset + start, Math.max(length - 1, 0));
      values[slot] = new TextDecoder().decode(text);
    }
    return start + length;
  }
}

/** @param {number} at @param {number} size */
function aligned(at, size) {
  return Math.ceil(at / size) * size;
}
