// @ts-check
// How many messages each topic of a bag has at each place of a timeline.

/** @import { Bag } from "../../bag/bag.js" */

// Of more chunks than these, only the first and the last time are used; so it is with bags of a server that are larger
// (bytes), because each index is a part of the file to load.
const EXACT = { chunks: 5000, remote: 16 * 1024 * 1024 };
// What is found is shown this often (ms).
const SHOWN = 500;

/**
 * Call `show` with the numbers of messages by channel, and again when there are more.
 * @param {Bag} bag @param {number} columns @param {boolean} remote whether the bag is on a server
 * @param {(rows: {id: number, counts: Uint32Array}[]) => void} show
 */
export async function marksOf(bag, columns, remote, show) {
  /** @type {Map<number, Uint32Array>} */
  const rows = new Map();
  const span = Number(bag.end - bag.start) || 1;
  const note = (/** @type {number} */ id, /** @type {bigint} */ time) => {
    const counts = rows.get(id) ?? new Uint32Array(columns);
    rows.set(id, counts);
    const column = Math.floor((Number(time - bag.start) / span) * columns);
    const at = Math.max(0, Math.min(column, columns - 1));
    counts[at] = (counts[at] ?? 0) + 1;
  };
  const exact = bag.chunks.length <= EXACT.chunks && !(remote && bag.size > EXACT.remote);
  let shown = performance.now();
  for (const chunk of bag.chunks) {
    if (exact) {
      await bag.times(chunk, note);
    } else {
      const [from, to] = [chunk.messageStartTime, chunk.messageEndTime];
      for (const id of chunk.messageIndexOffsets.keys()) {
        for (let part = 0n; part <= 8n; part++) note(id, from + ((to - from) * part) / 8n);
      }
    }
    if (performance.now() - shown < SHOWN) continue;
    shown = performance.now();
    show(copies(rows));
  }
  show(copies(rows));
}

/** @param {Map<number, Uint32Array>} rows */
function copies(rows) {
  return [...rows].map(([id, counts]) => ({ id, counts: counts.slice() }));
}
