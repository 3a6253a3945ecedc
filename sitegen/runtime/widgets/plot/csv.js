// @ts-check
// The samples of curves as a table of comma-separated values.

/** @import { Trace } from "./trace.js" */

/**
 * Return a row for each time between `from` and `to`, with an empty cell for a curve that has no sample then.
 * @param {{name: string, trace: Trace}[]} curves @param {number} from @param {number} to (s)
 * @param {number} zero the time 0 in seconds since 1970
 * @param {string} against the path of x, or ""
 */
export function toCsv(curves, from, to, zero, against) {
  const rows = [["time", ...curves.flatMap(({ name }) => (against ? [`${against} of ${name}`, name] : [name]))]
    .map(quoted).join(",")];
  const next = curves.map(({ trace }) => trace.find(from));
  const timeOf = (/** @type {number} */ index) => {
    const { trace } = /** @type {{trace: Trace}} */ (curves[index]);
    const at = /** @type {number} */ (next[index]);
    return at < trace.size ? trace.time(at) : Infinity;
  };
  for (;;) {
    const time = Math.min(...curves.map((_, index) => timeOf(index)));
    if (!(time <= to)) break;
    const cells = curves.flatMap(({ trace }, index) => {
      const there = timeOf(index) === time;
      const at = /** @type {number} */ (next[index]);
      if (there) next[index] = at + 1;
      const value = there ? String(trace.value(at)) : "";
      return against ? [there ? String(trace.x(at)) : "", value] : [value];
    });
    rows.push([(zero + time).toFixed(6), ...cells].join(","));
  }
  return `${rows.join("\r\n")}\r\n`;
}

/** @param {string} text */
function quoted(text) {
  return /[",\r\n]/.test(text) ? `"${text.replaceAll('"', '""')}"` : text;
}
