// @ts-check
// A chunk of a bag: its content, checked, and its messages in the order of time. @mcap/core's own reader ends at the
// first damaged chunk, and takes the index at its word.

import { crc32 } from "../vendor/mcap.js";
import { LARGEST_CHUNK } from "./compression.js";
import { Fault } from "./orders.js";

/** @import { Readable } from "./source.js" */
/**
 * @typedef {{channelId: number, sequence: number, logTime: bigint, publishTime: bigint, data: Uint8Array}} Message
 * @typedef {Record<string, (bytes: Uint8Array, size: bigint) => Uint8Array>} Handlers what decompresses, by name
 * @typedef {{chunkStartOffset: bigint, chunkLength: bigint}} Place
 */

const OP = { message: 5, chunk: 6 };
// A record begins with its kind and its length. A message has a channel, a number and two times before its data.
const HEAD = 9;
const MESSAGE_HEAD = HEAD + 22;
// A chunk has two times, its size, its checksum, and two texts with their lengths: the compression and the content.
const SIZE = HEAD + 16;
const CHECKSUM = SIZE + 8;
const COMPRESSION = CHECKSUM + 8;
const LONGEST_NAME = 32;

/** Why a chunk cannot be used: it is damaged, too large, or compressed in an unknown way. */
export class Damage extends Fault {}

/**
 * Read the content of a chunk. Throws a Damage if it cannot be used, and what reading throws.
 * @param {Readable} readable @param {Handlers} handlers @param {Place} place
 */
export async function contentOf(readable, handlers, { chunkStartOffset, chunkLength }) {
  if (chunkLength > LARGEST_CHUNK) {
    throw new Damage("This bag has chunks of more than {} MB, which the page does not read.", LARGEST_CHUNK / 1024 / 1024);
  }
  if (chunkStartOffset + chunkLength > (await readable.size()) || chunkLength < COMPRESSION) throw damaged();
  const record = await readable.read(chunkStartOffset, chunkLength);
  const view = viewOf(record);
  const named = view.getUint32(COMPRESSION - 4, true);
  const at = COMPRESSION + named + 8;
  if (view.getUint8(0) !== OP.chunk || named > LONGEST_NAME || at > record.length) throw damaged();
  const length = view.getBigUint64(at - 8, true);
  if (length > BigInt(record.length - at)) throw damaged();
  const packed = record.subarray(at, at + Number(length));
  const compression = new TextDecoder().decode(record.subarray(COMPRESSION, COMPRESSION + named));
  const content = unpacked(packed, handlers, compression, view.getBigUint64(SIZE, true));
  const checksum = view.getUint32(CHECKSUM, true);
  if (checksum !== 0 && crc32(content) !== checksum) throw damaged();
  return content;
}

/** @param {Uint8Array} packed @param {Handlers} handlers @param {string} compression @param {bigint} size */
function unpacked(packed, handlers, compression, size) {
  if (!compression || packed.length === 0) return packed;
  const handler = handlers[compression];
  if (!handler) throw new Damage("This bag is compressed with '{}', which the page cannot read.", compression);
  try {
    return handler(packed, size);
  } catch (error) {
    throw error instanceof Fault ? new Damage(error.said.text, ...error.said.values) : damaged();
  }
}

export function damaged() {
  return new Damage("A damaged part of this bag is left out.");
}

/** Yield the whole records in the content of a chunk. @param {Uint8Array} content */
export function* recordsIn(content) {
  const view = viewOf(content);
  for (let at = 0; at + HEAD <= content.length;) {
    const length = HEAD + Number(view.getBigUint64(at + 1, true));
    if (at + length > content.length) return;
    yield { op: view.getUint8(at), at, length };
    at += length;
  }
}

/** The messages of some channels of a chunk between two times. */
export class ChunkMessages {
  #content;
  #view;
  /** Where the messages are, in the order of their times. @type {number[]} */
  #places = [];
  #next = 0;
  /** Whether messages are outside of the times that the chunk states: they would be out of order. */
  odd = false;

  /**
   * @param {Uint8Array} content @param {{messageStartTime: bigint, messageEndTime: bigint}} stated
   * @param {Set<number>} channels @param {bigint} from in ns @param {bigint} to in ns, included
   */
  constructor(content, { messageStartTime, messageEndTime }, channels, from, to) {
    this.#content = content;
    this.#view = viewOf(content);
    let last = 0n;
    let ordered = true;
    for (const { op, at, length } of recordsIn(content)) {
      if (op !== OP.message || length < MESSAGE_HEAD || !channels.has(this.#view.getUint16(at + HEAD, true))) continue;
      const time = this.#timeAt(at);
      if (time < messageStartTime || time > messageEndTime) {
        this.odd = true;
        continue;
      }
      if (time < from || time > to) continue;
      this.#places.push(at);
      ordered &&= time >= last;
      last = time;
    }
    if (!ordered) this.#places.sort((a, b) => Number(this.#timeAt(a) - this.#timeAt(b)) || a - b);
  }

  /** The time of the next message in ns, undefined at the end. */
  get time() {
    const place = this.#places[this.#next];
    return place === undefined ? undefined : this.#timeAt(place);
  }

  /** Take the next message; its data is a part of the chunk. @returns {Message | undefined} */
  shift() {
    const place = this.#places[this.#next];
    if (place === undefined) return undefined;
    this.#next += 1;
    return {
      channelId: this.#view.getUint16(place + HEAD, true),
      sequence: this.#view.getUint32(place + HEAD + 2, true),
      logTime: this.#timeAt(place),
      publishTime: this.#view.getBigUint64(place + HEAD + 14, true),
      data: this.#content.subarray(place + MESSAGE_HEAD, place + HEAD + Number(this.#view.getBigUint64(place + 1, true))),
    };
  }

  /** @param {number} place */
  #timeAt(place) {
    return this.#view.getBigUint64(place + HEAD + 6, true);
  }
}

/** @param {Uint8Array} bytes */
export function viewOf(bytes) {
  return new DataView(bytes.buffer, bytes.byteOffset, bytes.byteLength);
}
