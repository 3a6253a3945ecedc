// @ts-check
// The types of what the page and the worker of bags tell each other, inside `tell` messages; see protocol.js.

/** @import { MessageType } from "../protocol.js" */
/** @import { Choice } from "./choice.js" */

/**
 * A text with {} for values, which the page translates.
 * @typedef {{text: string, values: unknown[]}} Said
 *
 * A topic of a bag: one channel of the file. `type` is "" if there is no schema, `qos` is the
 * quality of service as it was recorded, `why` says why it cannot be played.
 * @typedef {{id: number, topic: string, type: string, count: number, qos: string, why?: Said}} Track
 *
 * What is in a bag. `from` and `to` are the times of the first and the last message in ns, `start` is in ms since 1970, `duration` in seconds, `size` in bytes; `types` are the definitions
 * that its schemas have, by name; `notes` are for the visitor.
 * @typedef {{from: bigint, to: bigint, start: number, duration: number, count: number, size: number, library: string, compression: string,
 *   tracks: Track[], types: Record<string, MessageType>, notes: Said[]}} Summary
 *
 * The part of a bag that is played, in seconds from its start; to its end if `to` is missing.
 * @typedef {{from: number, to?: number}} Part
 *
 * How a bag is played: which of its topics, names by which they are replaced, whether /clock is published (or how
 * often, in Hz), and whether it starts again at its end.
 * @typedef {Choice & {remap?: Record<string, string>, clock?: boolean | number, loop?: boolean,
 *   rate?: number}} Playing
 *
 * @typedef {{url: string} | {blob: Blob} | {stored: string, folder: string}} Source
 *   an address, a file of the visitor, or a recording in the browser's storage
 *
 * To the player, and from it. Times are seconds from the start of the bag.
 * @typedef {{op: "open", source: Source}
 *   | {op: "advertise", playing: Playing, known: Record<string, MessageType>}
 *   | {op: "play"} | {op: "pause"} | {op: "step"}
 *   | {op: "seek", time: number} | {op: "rate", rate: number} | {op: "loop", on: boolean} | {op: "part", part: Part}
 *   | {op: "choose", id: number, on: boolean}} ToPlayer
 * @typedef {{op: "opened", summary: Summary}
 *   | {op: "advertised", refused: {id: number, why: Said, differs?: boolean}[]} | {op: "noted", said: Said}
 *   | {op: "marks", columns: number, rows: {id: number, counts: Uint32Array}[]}
 *   | {op: "state", time: number, playing: boolean, waiting: boolean, ended: boolean}
 *   | {op: "failed", said: Said}} FromPlayer
 *
 * What is recorded: the chosen topics, hidden ones only if they are named or `hidden` is set; the largest size in bytes.
 * @typedef {Choice & {hidden?: boolean, limit: number, compress: boolean}} Wanted
 *
 * To the recorder, and from it. `kept` says whether the recording is in the browser's storage, or only in memory.
 * @typedef {{op: "record", folder: string, name: string, wanted: Wanted, types: Record<string, MessageType>}
 *   | {op: "types", types: Record<string, MessageType>} | {op: "flush"}
 *   | {op: "end"}} ToRecorder
 * @typedef {{op: "began", kept: boolean, limit: number}
 *   | {op: "subscribed", topic: string}
 *   | {op: "grown", size: number, count: number, topics: number}
 *   | {op: "ended", size: number, count: number, topics: number, blob?: Blob, reason?: Said}
 *   | {op: "failed", said: Said}} FromRecorder
 *
 * To a keeper of recordings, and from it: what is in the browser's storage, mended if the page ended while it was
 * recorded.
 * @typedef {{op: "mend", folder: string}} ToKeeper
 * @typedef {{op: "mended", names: string[]}} FromKeeper
 *
 * To what cuts a part out of a bag, and from it. `left` are the channels that are left out; `notes` are for the visitor.
 * @typedef {{op: "cut", source: Source, part: Part, left: number[]}} ToCutter
 * @typedef {{op: "cut", content: Blob, notes: Said[]} | {op: "failed", said: Said}} FromCutter
 */

/** @param {string} text @param {unknown[]} values @returns {Said} */
export function said(text, ...values) {
  return { text, values };
}

/** What the visitor is told instead of a result. */
export class Fault extends Error {
  said;

  /** @param {string} text @param {unknown[]} values */
  constructor(text, ...values) {
    let next = 0;
    super(text.replaceAll("{}", () => String(values[next++])));
    this.said = said(text, ...values);
  }
}

/** What is said about an error. @param {unknown} error @returns {Said} */
export function saidOf(error) {
  if (error instanceof Fault) return error.said;
  const text = error instanceof Error ? error.message : String(error);
  return said("This bag cannot be read: {}", text.replace(/ \[library=[^]*\]$/, "").replace(/[^ -~]+/g, " ").slice(0, 200));
}
