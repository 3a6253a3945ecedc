// @ts-check
// Encode texts for the serializer, which supports neither non-ASCII strings nor wide strings. It gets them as they are
// in CDR: sequences of bytes that end with a zero, or sequences of wide characters.

/** @import { Field } from "./codec.js" */

const TEXT = "text";
const WIDE = "wide text";
const UNITS = { string: "uint8", wstring: "uint32" };

/** The element types of arrays of texts. */
export const WIRE_TYPES = [
  { name: TEXT, definitions: [{ name: "units", type: UNITS.string, isArray: true }] },
  { name: WIDE, definitions: [{ name: "units", type: UNITS.wstring, isArray: true }] },
];

/** Return the definition of a field of texts for the serializer; null for other fields. @param {Field} field */
export function wireField({ name, base, isArray, length }) {
  if (base !== "string" && base !== "wstring") return null;
  if (!isArray) return { name, type: UNITS[base], isArray: true };
  const type = base === "string" ? TEXT : WIDE;
  return { name, type, isComplex: true, isArray: true, arrayLength: length ?? undefined };
}

/**
 * Convert a value for the serializer; missing texts become empty.
 * @param {string} base @param {Field} field @param {any} value
 */
export function toWire(base, { isArray, length }, value) {
  const encode = ENCODERS[base];
  if (!encode) return value;
  if (!isArray) return encode(value ?? "");
  const all = value ?? Array.from({ length: length ?? 0 }, () => "");
  return all.map((/** @type {string} */ one) => ({ units: encode(one) }));
}

/** Convert a value from the serializer. @param {string} base @param {Field} field @param {any} value */
export function fromWire(base, field, value) {
  const decode = DECODERS[base];
  if (!decode) return value;
  return field.isArray ? value.map((/** @type {any} */ one) => decode(one.units)) : decode(value);
}

/** @type {Record<string, ((text: string) => Uint8Array | Uint32Array) | undefined>} */
const ENCODERS = {
  string: (text) => new TextEncoder().encode(`${text}\0`),
  wstring: (text) => Uint32Array.from({ length: text.length }, (_, i) => text.charCodeAt(i)),
};

/** @type {Record<string, ((units: any) => string) | undefined>} */
const DECODERS = {
  string: (units) => new TextDecoder().decode(units.subarray(0, -1)),
  wstring: (units) => Array.from(units, (/** @type {number} */ unit) => String.fromCharCode(unit)).join(""),
};
