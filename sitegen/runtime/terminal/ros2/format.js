// @ts-check
// Messages as `ros2 topic echo` prints them: message_to_yaml and message_to_csv of rosidl_runtime_py.

import { isFloat, isMessage, parseFieldType } from "../../messages/fieldType.js";
import { toYaml } from "../../messages/yaml.js";
import { arraySummary, float, quoted } from "./python.js";

/** @import { Types } from "./python.js" */
/**
 * @typedef {{limit: number, noArrays?: boolean, noTexts?: boolean, flow?: boolean}} Form `limit` is the length to
 *   which arrays and texts are truncated
 */

/** @param {any} message @param {string} type @param {Types} types @param {Form} form @returns {string} with a line end */
export function yaml(message, type, types, form) {
  if (form.flow) return `${flow(message, type, types, form)}\n`;
  if (!form.noArrays && !form.noTexts) return `${toYaml(message, type, types, form.limit)}\n`;
  return `${summarized(message, type, types, form).join("\n")}\n`;
}

/** @param {any} message @param {string} name @param {Types} types @param {Form} form @returns {string[]} */
function summarized(message, name, types, form) {
  const fields = types[name]?.fields ?? [];
  if (!fields.length) return ["{}"];
  return fields.flatMap((field) => {
    const { base, array } = parseFieldType(field.type);
    const value = message[field.name];
    if (array && form.noArrays) return [`${field.name}: '${arraySummary(field.type, value.length)}'`];
    if (!array && form.noTexts && /^w?string$/.test(base)) return [`${field.name}: '<string length: <${value.length}>>'`];
    if (!array && isMessage(base)) {
      const inner = summarized(value, base, types, form);
      return inner[0] === "{}" ? [`${field.name}: {}`] : [`${field.name}:`, ...inner.map((line) => `  ${line}`)];
    }
    return toYaml({ [field.name]: value }, "", { ...types, "": { fields: [field], constants: [] } }, form.limit).split("\n");
  });
}

/** @param {any} value @param {string} name @param {Types} types @param {Form} form @returns {string} */
function flow(value, name, types, form) {
  const fields = (types[name]?.fields ?? []).map((field) => {
    const { base, array } = parseFieldType(field.type);
    const one = value[field.name];
    if (array && form.noArrays) return `${field.name}: '${arraySummary(field.type, one.length)}'`;
    if (!array) return `${field.name}: ${flowItem(one, base, types, form)}`;
    const items = Array.from(one.slice(0, form.limit), (item) => flowItem(item, base, types, form));
    if (one.length > form.limit) items.push("'...'");
    return `${field.name}: [${items.join(", ")}]`;
  });
  return `{${fields.join(", ")}}`;
}

/** @param {any} value @param {string} base @param {Types} types @param {Form} form */
function flowItem(value, base, types, form) {
  if (isMessage(base)) return flow(value, base, types, form);
  const line = toYaml({ x: value }, "", { "": { fields: [{ name: "x", type: base }], constants: [] } }, form.limit);
  // In a list, a comma ends a plain text.
  const text = line.slice("x: ".length);
  return typeof value === "string" && /^[^'"].*[,[\]{}]/.test(text) ? quoted(text) : text;
}

/** @param {any} message @param {string} name @param {Types} types @param {Form} form @returns {string} without a line end */
export function csv(message, name, types, form) {
  return (types[name]?.fields ?? []).map((field) => {
    const { base, array } = parseFieldType(field.type);
    const value = message[field.name];
    if (!array) return csvItem(value, base, types, form, true);
    if (form.noArrays) return arraySummary(field.type, value.length);
    const items = Array.from(value.slice(0, form.limit), (item) => csvItem(item, base, types, form, false));
    return [...items, ...(value.length > form.limit ? ["..."] : [])].join(",");
  }).join(",");
}

/** @param {any} value @param {string} base @param {Types} types @param {Form} form @param {boolean} alone */
function csvItem(value, base, types, form, alone) {
  if (isMessage(base)) return csv(value, base, types, form);
  if (isFloat(base)) return float(value);
  if (typeof value === "boolean") return value ? "True" : "False";
  if (typeof value !== "string") return String(value);
  if (form.noTexts && alone) return `<string length: <${value.length}>>`;
  return value.length > form.limit ? `${value.slice(0, form.limit)}...` : value;
}
