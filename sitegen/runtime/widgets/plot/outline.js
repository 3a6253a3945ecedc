// @ts-check
// The points of a curve against the time that make a difference at the width of a chart.

/** @import { Trace } from "./trace.js" */

/**
 * @typedef {{xs: Float64Array, ys: Float64Array, count: number, low: number, high: number}} Outline points to join by
 *   lines; a y that is not a number is a gap. `low` and `high` are the smallest and the largest y, Infinity and
 *   -Infinity if there are none
 */

// Larger values cannot be drawn: the axes would have no room for their numbers.
const LARGEST = 1e30;

/** Whether a value is drawn; others are gaps. @param {number} value */
export function isDrawn(value) {
  return value > -LARGEST && value < LARGEST;
}

/** @param {number} columns the width of a chart in pixels @returns {Outline} with room for a curve */
export function emptyOutline(columns) {
  // Two neighbours, and up to five points in a column: the first, the smallest, the largest, the last, a gap.
  const room = 5 * columns + 7;
  return { xs: new Float64Array(room), ys: new Float64Array(room), count: 0, low: Infinity, high: -Infinity };
}

/**
 * Outline the samples between two times. Each column of pixels has at most four points, between which the curve has
 * the same extent as with all its samples.
 * @param {Trace} trace @param {number} from @param {number} to @param {number} columns @param {Outline} outline
 */
export function outlineTime(trace, from, to, columns, outline) {
  outline.count = 0;
  outline.low = Infinity;
  outline.high = -Infinity;
  // The neighbours of the samples in view: lines lead to them.
  const begin = Math.max(trace.find(from) - 1, 0);
  const end = Math.min(trace.find(to) + 1, trace.size);
  if (end - begin <= 4 * columns) {
    for (let index = begin; index < end; index++) add(outline, trace.time(index), trace.value(index));
    return;
  }
  const width = (to - from) / columns;
  let index = begin;
  while (index < end) {
    // Columns begin at multiples of their width, so that a curve keeps its shape while it moves.
    const column = Math.floor(trace.time(index) / width);
    index = outlineColumn(trace, index, end, (column + 1) * width, outline);
  }
}

/**
 * Outline the samples from `index` to a time, and return the index of the next one.
 * @param {Trace} trace @param {number} index @param {number} end @param {number} until @param {Outline} outline
 */
function outlineColumn(trace, index, end, until, outline) {
  const first = index;
  let [low, high, gap] = [-1, -1, false];
  let [least, most] = [Infinity, -Infinity];
  do {
    const value = trace.value(index);
    if (!isDrawn(value)) {
      gap = true;
    } else {
      if (value < least) [low, least] = [index, value];
      if (value > most) [high, most] = [index, value];
    }
    index++;
  } while (index < end && trace.time(index) < until);
  const last = index - 1;
  let before = -1;
  for (const at of [first, Math.min(low, high), Math.max(low, high), last]) {
    if (at > before) add(outline, trace.time(at), trace.value(at));
    before = Math.max(at, before);
  }
  const shown = isDrawn(trace.value(first)) && isDrawn(trace.value(last));
  if (gap && shown) add(outline, trace.time(last), NaN);
  return index;
}

/** @param {Outline} outline @param {number} time @param {number} value */
function add(outline, time, value) {
  if (outline.count === outline.xs.length) enlarge(outline);
  const finite = isDrawn(value);
  outline.xs[outline.count] = time;
  outline.ys[outline.count++] = finite ? value : NaN;
  if (!finite) return;
  if (value < outline.low) outline.low = value;
  if (value > outline.high) outline.high = value;
}

/** @param {Outline} outline */
function enlarge(outline) {
  for (const name of /** @type {const} */ (["xs", "ys"])) {
    const larger = new Float64Array(2 * outline[name].length);
    larger.set(outline[name]);
    outline[name] = larger;
  }
}
