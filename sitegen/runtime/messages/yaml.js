// @ts-check
// Turn messages into YAML, as `ros2 topic echo` prints them.

import { isFloat, isMessage, parseFieldType } from "./fieldType.js";

/** @import { MessageType } from "../protocol.js" */

/** `ros2 topic echo` truncates longer arrays and strings. */
const LIMIT = 128;

/**
 * Return a message as YAML, without a line end. Arrays and strings longer than `limit` are truncated and end with
 * "...".
 * @param {any} message
 * @param {string} type
 * @param {Record<string, MessageType>} types
 * @param {number} [limit]
 * @param {(text: string) => string} [quote] formats a text
 */
export function toYaml(message, type, types, limit = LIMIT, quote = quoteText) {
  return lines(message, type, types, limit, quote).join("\n");
}

/** Whether a text needs no quotes in YAML. @param {string} text */
export function isPlain(text) {
  return quoteText(text) === text;
}

/**
 * @param {any} message @param {string} name @param {Record<string, MessageType>} types
 * @param {number} limit @param {(text: string) => string} quote @returns {string[]}
 */
function lines(message, name, types, limit, quote) {
  const type = types[name];
  if (!type) throw new Error(`this page has no definition of ${name}`);
  const found = type.fields.flatMap((field) => {
    const { base, array } = parseFieldType(field.type);
    const value = message[field.name];
    if (!array) {
      if (!isMessage(base)) return [`${field.name}: ${scalar(value, base, limit, quote)}`];
      const inner = lines(value, base, types, limit, quote);
      if (inner[0] === "{}") return [`${field.name}: {}`];
      return [`${field.name}:`, ...inner.map(indent)];
    }
    if (!value.length) return [`${field.name}: []`];
    const shown = Array.from(value.slice(0, limit), (item) =>
      isMessage(base) ? lines(item, base, types, limit, quote) : [scalar(item, base, limit, quote)],
    );
    if (value.length > limit) shown.push(["'...'"]);
    const items = shown.map(([first, ...rest]) => [`- ${first}`, ...rest.map(indent)]);
    return [`${field.name}:`, ...items.flat()];
  });
  // Split texts of several lines, so that they are indented, too.
  return found.length ? found.flatMap((line) => line.split("\n")) : ["{}"];
}

/** @param {string} line */
function indent(line) {
  return line && `  ${line}`;
}

/** @param {any} value @param {string} base @param {number} limit @param {(text: string) => string} quote */
function scalar(value, base, limit, quote) {
  if (isFloat(base)) return floatText(value);
  if (typeof value !== "string") return String(value);
  return quote(value.length > limit ? `${value.slice(0, limit)}...` : value);
}

/** Format a number as Python does, which uses exponents sooner than JavaScript. @param {number} value */
export function floatText(value) {
  if (Number.isNaN(value)) return ".nan";
  if (!Number.isFinite(value)) return value < 0 ? "-.inf" : ".inf";
  if (value === 0) return Object.is(value, -0) ? "-0.0" : "0.0";
  const [digits = "", exponent = "0"] = value.toExponential().split("e");
  const power = Number(exponent);
  if (power >= -4 && power < 16) return Number.isInteger(value) ? `${value}.0` : String(value);
  const sign = power < 0 ? "-" : "+";
  return `${digits.includes(".") ? digits : `${digits}.0`}e${sign}${String(Math.abs(power)).padStart(2, "0")}`;
}

// Texts that YAML 1.1, as in PyYAML, would read as other types.
const OTHER = new RegExp(
  [
    /yes|Yes|YES|no|No|NO|true|True|TRUE|false|False|FALSE|on|On|ON|off|Off|OFF/,
    /[-+]?\d[\d_]*\.[\d_]*(?:[eE][-+]\d+)?|\.\d[\d_]*(?:[eE][-+]\d+)?/,
    /[-+]?\d[\d_]*(?::[0-5]?\d)+\.[\d_]*|[-+]?\.(?:inf|Inf|INF)|\.(?:nan|NaN|NAN)/,
    /[-+]?0b[01_]+|[-+]?0[0-7_]+|[-+]?(?:0|[1-9][\d_]*)|[-+]?0x[\da-fA-F_]+/,
    /[-+]?[1-9][\d_]*(?::[0-5]?\d)+|<<|=|~|null|Null|NULL|/,
    /\d{4}-\d\d-\d\d/,
    /\d{4}-\d\d?-\d\d?(?:[Tt]|[ \t]+)\d\d?:\d\d:\d\d(?:\.\d*)?(?:[ \t]*(?:Z|[-+]\d\d?(?::\d\d)?))?/,
  ].map(({ source }) => `^(?:${source})$`).join("|"),
);
const INDICATORS = /^[#,[\]{}&*!|>'"%@`]|^[-?:](?=\s|$)|:(?=\s|$)|\s#|^---|^\.\.\./;
const SPECIAL = /[^\n\x20-\x7e\x85\xa0-\ud7ff\ue000-\ufefe\uff00-\ufffd\u{10000}-\u{10ffff}]/u;
const ESCAPED = /["\\\x85\u2028\u2029]|[^\x20-\x7e\xa0-\ud7ff\ue000-\ufefe\uff00-\ufffd]/gu;
/** @type {Record<string, string>} */
const SHORT = {
  "\0": "0", "\x07": "a", "\b": "b", "\t": "t", "\n": "n", "\v": "v", "\f": "f", "\r": "r",
  "\x1b": "e", '"': '"', "\\": "\\", "\x85": "N", "\u2028": "L", "\u2029": "P",
};

/** Format a text: plain if that is safe, else in quotes. @param {string} text */
function quoteText(text) {
  const breaks = /[\n\x85\u2028\u2029]/;
  if (SPECIAL.test(text) || / [\n\x85\u2028\u2029]|[\n\x85\u2028\u2029] /.test(text)) {
    return `"${text.replace(ESCAPED, escape)}"`;
  }
  const plain = !OTHER.test(text) && !INDICATORS.test(text) && !/^ | $/.test(text);
  if (plain && !breaks.test(text)) return text;
  // In single quotes a line break is written as an empty line.
  const broken = text.replaceAll("'", "''").replace(/[\n\x85\u2028\u2029]+/g, (all) =>
    `${all.startsWith("\n") ? "\n" : ""}${all}  `);
  return `'${broken}'`;
}

/** @param {string} letter */
function escape(letter) {
  const code = letter.codePointAt(0) ?? 0;
  const short = SHORT[letter];
  if (short) return `\\${short}`;
  const hex = code.toString(16).toUpperCase();
  if (code < 0x100) return `\\x${hex.padStart(2, "0")}`;
  return code < 0x10000 ? `\\u${hex.padStart(4, "0")}` : `\\U${hex.padStart(8, "0")}`;
}
