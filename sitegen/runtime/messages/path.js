// @ts-check
// Message paths, which name values in the messages of a topic: /odom.pose.pose.position.x, /scan.ranges[0],
// /joint_states.position[:]{name}.

import { say } from "../ui/words.js";
import { isFloat, isInteger, isMessage, parseFieldType } from "./fieldType.js";

/** @import { MessageType } from "../protocol.js" */
/** @import { FieldType } from "./fieldType.js" */

/**
 * @typedef {{kind: "field", name: string} | {kind: "item", index: number}
 *   | {kind: "slice", from: number | undefined, to: number | undefined, names: string}} Step `names` is the field
 *   beside the array whose texts name its elements, or ""
 * @typedef {{text: string, topic: string, steps: Step[], derivative: boolean}} Path
 * @typedef {Record<string, MessageType>} Types
 */

const TOPIC = /^(?:\/[A-Za-z_]\w*)+/;
const STEP = /\.@(\w+)|\.([A-Za-z]\w*)|\[(-?\d{1,9})\]|\[(-?\d{1,9})?:(-?\d{1,9})?\]|\{(\w+)\}/y;
const DERIVATIVE = "derivative";
/** Messages that count as numbers, in seconds. */
const TIMES = ["builtin_interfaces/msg/Time", "builtin_interfaces/msg/Duration"];
const LONGEST = 500;
/** The names of elements without names; paths of one slice have the same ones in every message. @type {string[]} */
const INDEXES = [];

/** Parse a path. Throws an Error that says what is wrong with the text. @param {string} text @returns {Path} */
export function parsePath(text) {
  text = text.trim();
  const topic = TOPIC.exec(text)?.[0];
  if (!topic || text.length > LONGEST) throw new Error(unreadable(text));
  /** @type {Step[]} */
  const steps = [];
  let derivative = false;
  STEP.lastIndex = topic.length;
  while (STEP.lastIndex < text.length) {
    const found = STEP.exec(text);
    if (!found || derivative) throw new Error(unreadable(text));
    const [, modifier, field, index, from, to, names] = found;
    const last = steps.at(-1);
    if (modifier !== undefined) {
      if (modifier !== DERIVATIVE) throw new Error(say("unknown '.@{}' in {}; there is only .@derivative", modifier, text));
      derivative = true;
    } else if (field !== undefined) {
      steps.push({ kind: "field", name: field });
    } else if (names !== undefined) {
      if (last?.kind !== "slice" || last.names) {
        throw new Error(say("'{}' in {} must stand behind [:], whose elements it names", `{${names}}`, text));
      }
      last.names = names;
    } else if (last?.kind !== "field") {
      throw new Error(unreadable(text));
    } else if (index !== undefined) {
      steps.push({ kind: "item", index: Number(index) });
    } else {
      if (steps.some(({ kind }) => kind === "slice")) throw new Error(say("{} has two slices; keep one", text));
      steps.push({ kind: "slice", from: numberOf(from), to: numberOf(to), names: "" });
    }
  }
  return { text, topic, steps, derivative };
}

/** Whether a path names several values. @param {Path} path */
export function isSliced({ steps }) {
  return steps.some(({ kind }) => kind === "slice");
}

/** The name of one value of a sliced path, by its label; of others, the path. @param {Path} path @param {string} label */
export function nameOf({ text }, label) {
  return label ? text.replace(/\[[^\][]*:[^\][]*\](\{\w+\})?/, () => `[${label}]`) : text;
}

/**
 * Return the type of the values that a path names in messages of `type`. Throws an Error if there are none.
 * @param {Path} path @param {string} type @param {Types} types @returns {FieldType}
 */
export function typeAt(path, type, types) {
  let here = parseFieldType(type);
  let owner = "";
  for (const step of path.steps) {
    if (step.kind === "field") {
      if (here.array) throw new Error(say("{}: '{}' is an array; write {}[0] or {}[:]", path.text, owner, owner, owner));
      here = fieldOf(path, here.base, step.name, types);
      owner = step.name;
      continue;
    }
    if (!here.array) throw new Error(say("{}: '{}' is not an array", path.text, owner));
    if (step.kind === "slice" && step.names) checkNames(path, type, types, step.names);
    here = { ...here, array: "" };
  }
  return here;
}

/**
 * Like `typeAt`, and throw an Error unless the values are numbers.
 * @param {Path} path @param {string} type @param {Types} types
 */
export function checkNumeric(path, type, types) {
  const found = typeAt(path, type, types);
  const name = path.steps.findLast((step) => step.kind === "field")?.name ?? path.topic;
  if (found.array) throw new Error(say("{}: '{}' is an array; write {}[0] or {}[:]", path.text, name, name, name));
  if (isNumeric(found.base)) return;
  if (isMessage(found.base)) {
    const inside = types[found.base]?.fields.map((field) => field.name).join(", ") ?? "";
    throw new Error(say("{} is a whole {}; add one of its fields: {}", path.text, found.base, inside));
  }
  throw new Error(say("{} is text, not a number", path.text));
}

/**
 * Call `visit` with each value that a path names in a message, and its label: "" for a path without a slice. Values
 * that are not there are left out. `visit` may return false to end it.
 * @param {Path} path @param {any} message @param {(label: string, value: any) => boolean | void} visit
 */
export function readPath({ steps }, message, visit) {
  let [value, owner] = [message, message];
  for (let at = 0; at < steps.length; at++) {
    const step = /** @type {Step} */ (steps[at]);
    if (step.kind === "slice") {
      readSlice(step, steps.slice(at + 1), value, owner, visit);
      return;
    }
    owner = value;
    value = follow(step, value);
    if (value === undefined || value === null) return;
  }
  visit("", value);
}

/** Return a value of a message as a number; undefined if it is none. @param {any} value @returns {number | undefined} */
export function toNumber(value) {
  if (typeof value === "number") return value;
  if (typeof value === "bigint" || typeof value === "boolean") return Number(value);
  if (typeof value?.sec === "number" && typeof value.nanosec === "number") return value.sec + value.nanosec / 1e9;
  return undefined;
}

/** Whether values of a type are numbers for us; times are, in seconds. @param {string} base */
export function isNumeric(base) {
  return isInteger(base) || isFloat(base) || ["bool", "byte", "char"].includes(base) || TIMES.includes(base);
}

/**
 * Return paths for the numbers in messages of a type, without the topic, at most `most`.
 * @param {string} type @param {Types} types @param {number} [most]
 */
export function numericFields(type, types, most = 200) {
  /** @type {string[]} */
  const found = [];
  collect("", type, types, found, most);
  return found.slice(0, most);
}

/**
 * @param {string} prefix @param {string} name @param {Types} types @param {string[]} found @param {number} most
 */
function collect(prefix, name, types, found, most) {
  const fields = types[name]?.fields ?? [];
  for (const field of fields) {
    if (found.length >= most) return;
    const { base, array } = parseFieldType(field.type);
    const path = `${prefix}.${field.name}`;
    if (TIMES.includes(base)) continue;
    // Arrays of bytes are data of another kind, such as images.
    if (array && ["uint8", "byte", "char"].includes(base)) continue;
    const sliced = prefix.includes("[:]");
    if (isNumeric(base)) found.push(array ? `${path}${sliced ? "[0]" : elements(fields)}` : path);
    else if (isMessage(base)) collect(array ? `${path}[0]` : path, base, types, found, most);
  }
}

/** How to write the elements of an array beside other fields. @param {{name: string, type: string}[]} fields */
function elements(fields) {
  const names = fields.find(({ name, type }) => /^names?$|_names$/.test(name) && /^string.*\[/.test(type));
  return names ? `[:]{${names.name}}` : "[0]";
}

/** @param {Path} path @param {string} base @param {string} name @param {Types} types */
function fieldOf(path, base, name, types) {
  if (!isMessage(base)) throw new Error(say("{}: {} has no fields, so no '{}'", path.text, base, name));
  const known = types[base];
  if (!known) throw new Error(say("This page has no definition of {}, so it cannot read these messages.", base));
  const field = known.fields.find((one) => one.name === name);
  if (field) return parseFieldType(field.type);
  const names = known.fields.map((one) => one.name).join(", ");
  throw new Error(say("{}: {} has no field '{}'; its fields are {}", path.text, base, name, names));
}

/** @param {Path} path @param {string} type @param {Types} types @param {string} names */
function checkNames(path, type, types, names) {
  const at = path.steps.findIndex(({ kind }) => kind === "slice");
  const beside = [...path.steps.slice(0, at - 1), /** @type {Step} */ ({ kind: "field", name: names })];
  const found = typeAt({ ...path, steps: beside }, type, types);
  if (!found.array || !/^w?string$/.test(found.base)) {
    throw new Error(say("{}: '{}' is not an array of texts, so it cannot name elements", path.text, names));
  }
}

/** @param {Exclude<Step, {kind: "slice"}>} step @param {any} value */
function follow(step, value) {
  if (step.kind === "field") return value[step.name];
  return value[step.index < 0 ? value.length + step.index : step.index];
}

/**
 * @param {Extract<Step, {kind: "slice"}>} step @param {Step[]} rest @param {any} array @param {any} owner
 * @param {(label: string, value: any) => boolean | void} visit
 */
function readSlice({ from = 0, to, names }, rest, array, owner, visit) {
  const size = array?.length ?? 0;
  const within = (/** @type {number} */ index) => Math.min(Math.max(index < 0 ? size + index : index, 0), size);
  const labels = names ? owner?.[names] : undefined;
  for (let index = within(from); index < within(to ?? size); index++) {
    let value = array[index];
    for (const step of rest) {
      if (value === undefined || value === null || step.kind === "slice") break;
      value = follow(step, value);
    }
    if (value === undefined || value === null) continue;
    const label = labels?.[index] || (INDEXES[index] ??= String(index));
    if (visit(label, value) === false) return;
  }
}

/** @param {string | undefined} digits */
function numberOf(digits) {
  return digits === undefined ? undefined : Number(digits);
}

/** @param {string} text */
function unreadable(text) {
  const short = text.length > 60 ? `${text.slice(0, 59)}…` : text;
  return say("'{}' is not a message path; write it like {}", short, "/odom.pose.pose.position.x");
}
