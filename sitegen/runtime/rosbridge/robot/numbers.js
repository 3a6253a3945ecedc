// @ts-check
// JSON with the numbers that JavaScript's JSON lacks: whole ones of 64 bits, and NaN and Infinity, which the JSON of
// Python has.

// Nobody else can write this into a text.
const MARK = `number ${crypto.getRandomValues(new Uint32Array(4)).join("-")} `;
const MARKED = new RegExp(`"${MARK}([^"]+)"`, "g");
const LONG = /\d{16}/;

/** @param {any} value @returns {string} */
export function writeJson(value) {
  let odd = false;
  const text = JSON.stringify(value, (_key, one) => {
    if (typeof one !== "bigint" && (typeof one !== "number" || Number.isFinite(one))) return one;
    odd = true;
    return MARK + one;
  });
  return odd ? text.replace(MARKED, "$1") : text;
}

/** Return what a text means, or undefined if it is not JSON. @param {string} text @returns {any} */
export function parseJson(text) {
  try {
    return JSON.parse(text, LONG.test(text) ? exact : undefined);
  } catch {
    return undefined;
  }
}

/**
 * @param {string} _key @param {any} value @param {{source?: string}} [context] older browsers have none, and round
 * @returns {any}
 */
function exact(_key, value, context) {
  if (typeof value !== "number" || Number.isSafeInteger(value) || !/^-?\d+$/.test(context?.source ?? "")) return value;
  return BigInt(/** @type {string} */ (context?.source));
}
