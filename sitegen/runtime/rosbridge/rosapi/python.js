// @ts-check
// Types and values as rclpy writes them, from whose classes rosapi reads its descriptions.

/** How rclpy names the types of fields. @type {Record<string, string>} */
export const NAMES = { bool: "boolean", byte: "octet", float32: "float", float64: "double" };
/** @type {Record<string, any>} */
const ZEROS = { bool: false, string: "", wstring: "" };

/** Return a scalar as `str` does. @param {string} type @param {any} [value] the zero of the type if undefined */
export function pythonText(type, value = ZEROS[type] ?? 0) {
  if (type === "bool") return value ? "True" : "False";
  if (type === "byte") return `b'${byteText(Number(value))}'`;
  const text = String(value);
  if (!type.startsWith("float")) return text;
  return /^-?\d+$/.test(text) ? `${text}.0` : text.replace(/e([-+])(\d)$/, "e$10$2");
}

/** @param {number} byte */
function byteText(byte) {
  const text = String.fromCharCode(byte);
  return /[ -&(-[\]-~]/.test(text) ? text : `\\x${byte.toString(16).padStart(2, "0")}`;
}
