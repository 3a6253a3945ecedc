// @ts-check
// Texts on the wire. The serializer writes texts beyond ASCII wrongly and wide ones not at all, so it
// gets them as what they are in CDR: sequences of bytes with a zero at the end, or of wide characters.

/** @import { Field } from "./codec.js" */

const TEXT = "text";
const WIDE = "wide text";
const UNITS = { string: "uint8", wstring: "uint32" };

/** An array of texts is one of these. */
export const WIRE_TYPES = [
  { name: TEXT, definitions: [{ name: "units", type: UNITS.string, isArray: true }] },
  { name: WIDE, definitions: [{ name: "units", type: UNITS.wstring, isArray: true }] },
];

/** How a field of texts is defined for the serializer; null for other fields. @param {Field} field */
export function wireField({ name, base, isArray, length }) {
  if (base !== "string" && base !== "wstring") return null;
  if (!isArray) return { name, type: UNITS[base], isArray: true };
  const type = base === "string" ? TEXT : WIDE;
  return { name, type, isComplex: true, isArray: true, arrayLength: length ?? undefined };
}

/**
 * A value for the serializer; texts that are not there are empty.
 * @param {string} base @param {Field} field @param {any} value
 */
export function toWire(base, { isArray, length }, value) {
  const encode = ENCODERS[base];
  if (!encode) return value;
  if (!isArray) return encode(value ?? "");
  const all = value ?? Array.from({ length: length ?? 0 }, () => "");
  return all.map((/** @type {string} */ one) => ({ units: encode(one) }));
}

/** A value from the serializer. @param {string} base @param {Field} field @param {any} value */
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
