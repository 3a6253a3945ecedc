// @ts-check
// Numbers of nodes in a few characters.

/** A number in at most nine characters or so. @param {number} value */
export function numberText(value) {
  if (Number.isNaN(value)) return "NaN";
  if (!Number.isFinite(value)) return value > 0 ? "∞" : "−∞";
  const size = Math.abs(value);
  const text = size !== 0 && (size >= 1e7 || size < 1e-4) ? value.toExponential(3) : decimals(value, size);
  return text.replace("-", "−");
}

/** @param {number} value @param {number} size */
function decimals(value, size) {
  if (Number.isInteger(value)) return String(value);
  return value.toFixed(size >= 1000 ? 1 : size >= 10 ? 2 : size >= 0.1 ? 4 : 6);
}
