// @ts-check
// Definitions of messages as the schemas of bags have them: the text of a .msg file, followed by those of the types
// nested in it.

import { isInteger, isMessage, parseFieldType } from "../messages/fieldType.js";
import { Fault } from "./orders.js";

/** @import { MessageType } from "../protocol.js" */
/** @typedef {Record<string, MessageType>} Types */

const RULE = "=".repeat(80);
const SEPARATOR = /^={20,}[ \t]*\r?$/m;
const HEAD = /^\s*MSG:\s*(\S+)[ \t]*\r?\n?/;
const NAME = /^[A-Za-z]\w*$/;
const CONSTANT = /^(\S+)\s+([A-Z]\w*)\s*=\s*(.*)$/;
const FIELD = /^(\S+)\s+([A-Za-z]\w*)(?:\s+(.+))?$/;
const NUMBERS = /^(?:u?int(?:8|16|32|64)|float(?:32|64)|bool)$/;
const ESCAPE = /\\([0-7]{1,3}|x[\da-f]{2}|u[\da-f]{4}|[abfnrtv"'\\])/gi;
/** @type {Record<string, string>} */
const LETTERS = { a: "\x07", b: "\b", f: "\f", n: "\n", r: "\r", t: "\t", v: "\v" };
/** Other names of types. @type {Record<string, string>} */
const ALIASES = { byte: "uint8", char: "uint8", octet: "uint8" };
/** Types that need no package. @type {Record<string, string>} */
const SHORT = {
  Header: "std_msgs/msg/Header", time: "builtin_interfaces/msg/Time", duration: "builtin_interfaces/msg/Duration",
};

// The limits of a schema: characters, types, and values that a message has at least.
const LONGEST = 1_000_000;
const MOST_TYPES = 500;
const MOST_VALUES = 1_000_000;

/**
 * Return the schema of a type, or undefined if a definition is missing.
 * @param {Types} types @param {string} root
 */
export function definitionText(types, root) {
  const names = new Set([root]);
  for (const name of names) { // the set grows during the loop
    const known = definitionOf(types, name);
    if (!known) return undefined;
    for (const { type } of known.fields) {
      const { base } = parseFieldType(type);
      if (isMessage(base)) names.add(base);
    }
  }
  const [first, ...nested] = [...names].map((name) => linesOf(definitionOf(types, name)));
  return [first, ...nested.map((text, index) => `${RULE}\nMSG: ${short([...names][index + 1] ?? "")}\n${text}`)].join("");
}

/** Of the events of services, only the parts are known. @param {Types} types @param {string} name */
function definitionOf(types, name) {
  if (types[name] || !name.endsWith("_Event")) return types[name];
  const service = name.slice(0, -"_Event".length);
  if (!types[`${service}_Request`] || !types[`${service}_Response`]) return undefined;
  return {
    fields: [
      { name: "info", type: "service_msgs/msg/ServiceEventInfo" },
      { name: "request", type: `${service}_Request[<=1]` },
      { name: "response", type: `${service}_Response[<=1]` },
    ],
    constants: [],
  };
}

/** @param {MessageType | undefined} type */
function linesOf(type) {
  const constants = type?.constants.map(({ type: kind, name, value }) => `${kind} ${name}=${literal(value, kind)}\n`) ?? [];
  const fields = type?.fields.map(({ type: kind, name, default: value }) => {
    const { base } = parseFieldType(kind);
    const written = isMessage(base) ? kind.replace(base, short(base)) : kind;
    return `${written} ${name}${value === undefined || value === null ? "" : ` ${literal(value, base)}`}\n`;
  }) ?? [];
  return [...constants, ...fields].join("");
}

/** @param {any} value @param {string} base its type @returns {string} */
function literal(value, base) {
  if (Array.isArray(value) || ArrayBuffer.isView(value)) {
    return `[${Array.from(/** @type {any[]} */ (value), (one) => literal(one, base)).join(", ")}]`;
  }
  return typeof value === "string" && !isInteger(base) ? quoted(value) : String(value);
}

/** Return a text as .msg files have it: rosidl decodes escapes twice. @param {string} text */
export function quoted(text) {
  return JSON.stringify(text).replace(/\\([^"t])/g, (_, what) => (what === "\\" ? "\\\\\\\\" : `\\\\${what}`));
}

/** Decode the escapes of a text once. @param {string} text */
function decoded(text) {
  return text.replace(ESCAPE, (_, code) => {
    if (/^[0-7]/.test(code)) return String.fromCharCode(parseInt(code, 8));
    return /^[xu]./.test(code) ? String.fromCharCode(parseInt(code.slice(1), 16)) : LETTERS[code] ?? code;
  });
}

/** In these texts, types have no "msg" in the middle. @param {string} name */
function short(name) {
  const [where, , own] = name.split("/");
  return own ? `${where}/${own}` : name;
}

/**
 * Return the definitions that a schema has. Throws a Fault if it is invalid or beyond the limits.
 * @param {string} root the name of its type @param {string} text @returns {Types}
 */
export function readDefinitions(root, text) {
  if (text.length > LONGEST) throw new Fault("The schema of {} is too long.", root);
  const [first = "", ...others] = text.split(SEPARATOR);
  if (others.length >= MOST_TYPES) throw new Fault("The schema of {} has too many types.", root);
  /** @type {Map<string, string>} */
  const texts = new Map([[root, first]]);
  for (const other of others) {
    const name = HEAD.exec(other)?.[1] ?? "";
    texts.set(full(name, ""), other.replace(HEAD, ""));
  }
  /** @type {Types} */
  const types = Object.create(null);
  for (const [name, one] of texts) types[name] = parse(one, name, root);
  check(types, root);
  return types;
}

/** @param {string} text @param {string} name @param {string} root @returns {MessageType} */
function parse(text, name, root) {
  const [where = ""] = name.split("/");
  /** @type {MessageType} */
  const type = { fields: [], constants: [] };
  for (const line of text.split("\n")) {
    const plain = withoutComment(line).trim();
    if (!plain) continue;
    const constant = CONSTANT.exec(plain);
    const field = FIELD.exec(plain);
    if (constant) {
      const [, kind = "", own = "", value = ""] = constant;
      type.constants.push({ name: own, type: kind, value: valueOf(kind, value) });
    } else if (field) {
      const [, kind = "", own = ""] = field;
      type.fields.push({ name: own, type: typeOf(kind, where) });
    } else {
      throw new Fault("The schema of {} has an invalid line: {}", root, plain.slice(0, 60));
    }
  }
  return type;
}

/** @param {string} line */
function withoutComment(line) {
  const quoted = /^((?:[^#"']|"(?:[^"\\]|\\.)*"|'(?:[^'\\]|\\.)*')*)#/.exec(line);
  return quoted?.[1] ?? (/["']/.test(line) ? line : line.replace(/#.*/, ""));
}

/** @param {string} kind @param {string} value */
function valueOf(kind, value) {
  if (kind === "bool") return /^(true|1)$/i.test(value);
  if (/^u?int64$/.test(kind)) return value;
  if (NUMBERS.test(kind) || kind in ALIASES) return Number(value);
  const [, quote, inner = value] = /^(["'])(.*)\1$/.exec(value) ?? [];
  return decoded(decoded(quote ? inner.replaceAll(`\\${quote}`, quote) : inner));
}

/** The full name of the type of a field, with its array. @param {string} kind @param {string} where its package */
function typeOf(kind, where) {
  const { base } = parseFieldType(kind);
  if (NUMBERS.test(base) || base === "string" || base === "wstring") return kind;
  return kind.replace(base, ALIASES[base] ?? full(base, where));
}

/** @param {string} name @param {string} where the package of the type that names it */
function full(name, where) {
  const parts = name.split("/");
  if (!parts.every((part) => NAME.test(part)) || parts.length > 3) {
    throw new Fault("The schemas have an invalid type: {}", name.slice(0, 60));
  }
  if (parts.length === 3) return name;
  return parts.length === 2 ? `${parts[0]}/msg/${parts[1]}` : SHORT[name] ?? `${where}/msg/${name}`;
}

/**
 * Refuse types that contain themselves, and those whose smallest message has too many values: reading one would take
 * forever.
 * @param {Types} types @param {string} root
 */
function check(types, root) {
  /** @type {Map<string, number>} */
  const sizes = new Map();
  const sizeOf = (/** @type {string} */ name) => {
    const known = sizes.get(name);
    if (known !== undefined) return known;
    const type = types[name];
    if (!type) throw new Fault("The schema of {} has no definition of {}.", root, name);
    sizes.set(name, Infinity); // which it has as long as it is inside itself
    let size = 1;
    for (const { type: kind } of type.fields) {
      const { base, array, size: length } = parseFieldType(kind);
      const one = isMessage(base) ? sizeOf(base) : 1;
      if (one > MOST_VALUES) throw new Fault("The schema of {} is nested too deep.", root);
      size += array === "fixed" ? one * length : one;
    }
    if (size > MOST_VALUES) throw new Fault("The schema of {} is too large.", root);
    sizes.set(name, size);
    return size;
  };
  sizeOf(root);
}

/**
 * Whether two sets of definitions mean the same bytes by a type.
 * @param {Types} some @param {Types} others @param {string} name
 */
export function isSame(some, others, name) {
  return shape(some, name) === shape(others, name);
}

/** @param {Types} types @param {string} name @returns {string} */
function shape(types, name) {
  return (types[name]?.fields ?? []).map(({ name: own, type }) => {
    const { base } = parseFieldType(type);
    const kind = isMessage(base) ? type.replace(base, `(${shape(types, base)})`) : type.replace(base, ALIASES[base] ?? base);
    return `${kind} ${own}`;
  }).join();
}
