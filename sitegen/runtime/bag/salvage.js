// @ts-check
// Make a bag readable that has no index, or that ends too early: all whole chunks of it, with an index of our own.

import { McapRecordBuilder, McapStreamReader } from "../vendor/mcap.js";
import { contentOf, damaged, recordsIn, viewOf } from "./chunk.js";
import { Fault } from "./orders.js";
import { fromBlob } from "./source.js";
import { BagWriter, tail as tailOf } from "./writer.js";

/** @import { Handlers } from "./chunk.js" */
/** @import { Readable } from "./source.js" */
/** @import { ChunkIndex, Contents } from "./writer.js" */

const OP = { schema: 3, channel: 4, message: 5, chunk: 6, index: 7, dataEnd: 15 };
const HEAD = 9;
// Where the parts of a chunk record are, from its beginning.
const CHUNK_HEAD = HEAD + 32;
const BLOCK = 1024 * 1024;
// The largest file whose messages are not in chunks, which is read as a whole, in bytes.
const LARGEST = 512 * 1024 * 1024;
const MOST = { schemas: 5000, channels: 5000, chunks: 1_000_000 };

/**
 * Return a readable bag, `length` and `tail`, by which the file itself can be made valid, and whether something of it
 * was `cut` off or it is `empty`.
 * @param {Readable} readable @param {Handlers} handlers
 */
export async function salvaged(readable, handlers) {
  const scan = new Scan(readable, handlers);
  await scan.run();
  const { cut, end: length, empty } = scan;
  if (scan.loose) return { readable: await rewritten(readable), cut, length: 0, tail: undefined, empty: false };
  const tail = scan.tail();
  return { readable: joined(readable, length, tail), cut, length, tail, empty };
}

class Scan {
  #readable;
  #handlers;
  /** @type {Contents} */
  #contents = { schemas: new Map(), channels: new Map(), chunks: [], counts: new Map() };
  /** Own indexes of chunks that have none. @type {Map<ChunkIndex, Map<number, [bigint, bigint][]>>} */
  #made = new Map();
  /** How many messages of each channel a chunk has. @type {Map<ChunkIndex, Map<number, number>>} */
  #counts = new Map();
  /** The position behind the last whole record. */
  end = 8;
  cut = true;
  /** Whether messages are outside of chunks. */
  loose = false;

  /** @param {Readable} readable @param {Handlers} handlers */
  constructor(readable, handlers) {
    this.#readable = buffered(readable);
    this.#handlers = handlers;
  }

  /** Whether it has no messages. */
  get empty() {
    return this.#contents.chunks.length === 0;
  }

  async run() {
    const size = Number(await this.#readable.size());
    while (this.end + HEAD <= size) {
      const head = viewOf(await this.#readable.read(BigInt(this.end), BigInt(HEAD)));
      const length = HEAD + Number(head.getBigUint64(1, true));
      const op = head.getUint8(0);
      if (!Number.isSafeInteger(length) || this.end + length > size) break;
      if (op === OP.dataEnd) {
        this.cut = false;
        break;
      }
      if (!(await this.#take(op, length).catch(() => false))) break;
      this.end += length;
    }
    const last = this.#contents.chunks.at(-1);
    // Of the last chunk, the index may be incomplete.
    if (last && (this.cut || last.messageIndexOffsets.size === 0)) await this.#walk(last);
  }

  /** Take a record; return whether it is sound. @param {number} op @param {number} length */
  async #take(op, length) {
    const { schemas, channels, chunks } = this.#contents;
    if (op === OP.message) this.loose = true;
    if (op === OP.schema || op === OP.channel) {
      this.#note(await this.#readable.read(BigInt(this.end), BigInt(length)));
    } else if (op === OP.chunk) {
      const before = chunks.at(-1);
      if (before && before.messageIndexOffsets.size === 0) await this.#walk(before);
      chunks.push(await this.#chunk(length));
    } else if (op === OP.index) {
      await this.#index(length);
    }
    return schemas.size <= MOST.schemas && channels.size <= MOST.channels && chunks.length <= MOST.chunks;
  }

  /** Note the schemas and channels among some records. @param {Uint8Array} records */
  #note(records) {
    for (const { op, at, length } of recordsIn(records)) {
      if (op !== OP.schema && op !== OP.channel) continue;
      const reader = new McapStreamReader({ noMagicPrefix: true });
      reader.append(records.subarray(at, at + length));
      const record = reader.nextRecord();
      if (record?.type === "Schema") this.#contents.schemas.set(record.id, record);
      else if (record?.type === "Channel") this.#contents.channels.set(record.id, record);
    }
  }

  /** @param {number} length of the record @returns {Promise<ChunkIndex>} */
  async #chunk(length) {
    const head = viewOf(await this.#readable.read(BigInt(this.end), BigInt(Math.min(length, CHUNK_HEAD + 64))));
    const named = head.getUint32(HEAD + 28, true);
    if (named > 32) throw damaged();
    const name = new Uint8Array(head.buffer, head.byteOffset + CHUNK_HEAD, named);
    return {
      messageStartTime: head.getBigUint64(HEAD, true), messageEndTime: head.getBigUint64(HEAD + 8, true),
      chunkStartOffset: BigInt(this.end), chunkLength: BigInt(length),
      messageIndexOffsets: new Map(), messageIndexLength: 0n, compression: new TextDecoder().decode(name),
      compressedSize: head.getBigUint64(CHUNK_HEAD + named, true), uncompressedSize: head.getBigUint64(HEAD + 16, true),
    };
  }

  /** @param {number} length of the record */
  async #index(length) {
    const chunk = this.#contents.chunks.at(-1);
    const head = viewOf(await this.#readable.read(BigInt(this.end), BigInt(HEAD + 6)));
    const [channel, bytes] = [head.getUint16(HEAD, true), head.getUint32(HEAD + 2, true)];
    if (!chunk || bytes + HEAD + 6 > length) throw damaged();
    if (!this.#contents.channels.has(channel)) {
      // Where the chunk is damaged, its channels may be in another one.
      const records = await contentOf(this.#readable, this.#handlers, chunk).catch(() => undefined);
      if (records) this.#note(records);
    }
    if (bytes > 0) chunk.messageIndexOffsets.set(channel, BigInt(this.end));
    chunk.messageIndexLength += BigInt(length);
    const counts = this.#counts.get(chunk) ?? new Map();
    this.#counts.set(chunk, counts.set(channel, Math.floor(bytes / 16)));
  }

  /** Make an index of a chunk from its records. @param {ChunkIndex} chunk */
  async #walk(chunk) {
    const { channels, chunks } = this.#contents;
    const records = await contentOf(this.#readable, this.#handlers, chunk).catch(() => undefined);
    if (!records) {
      chunks.splice(chunks.indexOf(chunk), 1);
      return;
    }
    this.#note(records);
    /** @type {Map<number, [bigint, bigint][]>} */
    const made = new Map();
    const all = viewOf(records);
    for (const { op, at, length } of recordsIn(records)) {
      if (op !== OP.message || length < HEAD + 14) continue;
      const channel = all.getUint16(at + HEAD, true);
      const entries = made.get(channel) ?? [];
      if (channels.has(channel)) made.set(channel, entries);
      entries.push([all.getBigUint64(at + HEAD + 6, true), BigInt(at)]);
    }
    this.#made.set(chunk, made);
    this.#counts.set(chunk, new Map([...made].map(([channel, entries]) => [channel, entries.length])));
  }

  /** Return what has to stand behind the last whole record. */
  tail() {
    const records = new McapRecordBuilder();
    for (const [chunk, made] of this.#made) {
      const begin = BigInt(this.end + records.length);
      chunk.messageIndexOffsets = new Map([...made].map(([channelId, entries]) => {
        const offset = BigInt(this.end + records.length);
        records.writeMessageIndex({ channelId, records: entries });
        return [channelId, offset];
      }));
      chunk.messageIndexLength = BigInt(this.end + records.length) - begin;
    }
    const { chunks } = this.#contents;
    const filled = chunks.filter((one) => one.messageIndexOffsets.size > 0);
    /** @type {Map<number, bigint>} */
    const counts = new Map();
    for (const [channel, count] of filled.flatMap((chunk) => [...(this.#counts.get(chunk) ?? [])])) {
      counts.set(channel, (counts.get(channel) ?? 0n) + BigInt(count));
    }
    const contents = { ...this.#contents, chunks: filled, counts };
    const end = tailOf(contents, this.end + records.length, 0);
    const bytes = new Uint8Array(records.length + end.length);
    bytes.set(records.buffer);
    bytes.set(end, records.length);
    return bytes;
  }
}

/** Write the messages of a bag without chunks into chunks. @param {Readable} readable @returns {Promise<Readable>} */
async function rewritten(readable) {
  const size = Number(await readable.size());
  if (size > LARGEST) {
    throw new Fault("This bag has no index and more than {} MB; convert it with 'ros2 bag convert'.", LARGEST / BLOCK);
  }
  /** @type {Uint8Array<ArrayBuffer>[]} */
  const parts = [];
  const writer = new BagWriter((bytes) => parts.push(new Uint8Array(bytes)));
  const reader = new McapStreamReader();
  /** The new ids by those in the file. @type {Map<number, number>} */
  const schemas = new Map();
  /** @type {Map<number, number>} */
  const channels = new Map();
  const take = (/** @type {ReturnType<typeof reader.nextRecord>} */ record) => {
    if (record?.type === "Schema" && !schemas.has(record.id) && schemas.size < MOST.schemas) {
      schemas.set(record.id, writer.addSchema(record));
    } else if (record?.type === "Channel" && !channels.has(record.id) && channels.size < MOST.channels) {
      channels.set(record.id, writer.addChannel({ ...record, schemaId: schemas.get(record.schemaId) ?? 0 }));
    } else if (record?.type === "Message") {
      const { channelId, sequence, logTime, publishTime, data } = record;
      const channel = channels.get(channelId);
      if (channel !== undefined) writer.add(channel, sequence, logTime, publishTime, data);
    }
  };
  try {
    for (let at = 0; at < size && !reader.done(); at += BLOCK) {
      reader.append(await readable.read(BigInt(at), BigInt(Math.min(BLOCK, size - at))));
      for (let record; (record = reader.nextRecord());) take(record);
    }
  } catch {
    // What was read so far is what there is.
  }
  writer.end();
  return fromBlob(new Blob(parts));
}

/** Read in blocks, as small parts follow each other. @param {Readable} readable @returns {Readable} */
function buffered(readable) {
  let block = new Uint8Array();
  let start = 0n;
  return {
    size: () => readable.size(),
    async read(offset, length) {
      if (length > BLOCK) return readable.read(offset, length);
      if (offset < start || offset + length > start + BigInt(block.length)) {
        const left = (await readable.size()) - offset;
        block = new Uint8Array(await readable.read(offset, left < BigInt(BLOCK) ? left : BigInt(BLOCK)));
        start = offset;
      }
      const at = Number(offset - start);
      return block.subarray(at, at + Number(length));
    },
  };
}

/** The first `length` bytes of a file, followed by others. @param {Readable} readable @param {number} length @param {Uint8Array<ArrayBuffer>} end @returns {Readable} */
function joined(readable, length, end) {
  const rest = fromBlob(new Blob([end]));
  const at = BigInt(length);
  return {
    size: async () => at + (await rest.size()),
    async read(offset, count) {
      if (offset + count <= at) return readable.read(offset, count);
      if (offset >= at) return rest.read(offset - at, count);
      const [first, second] = [await readable.read(offset, at - offset), await rest.read(0n, offset + count - at)];
      const bytes = new Uint8Array(first.length + second.length);
      bytes.set(first);
      bytes.set(second, first.length);
      return bytes;
    },
  };
}
