// @ts-check
// Write a bag: chunks with an index, the summary and statistics. @mcap/core's own writer cannot end a chunk before it
// is full, so what it would hold back could be lost with the page.

import { crc32, crc32Final, crc32Init, crc32Update, McapChunkBuilder, McapRecordBuilder } from "../vendor/mcap.js";

/**
 * @typedef {{id: number, name: string, encoding: string, data: Uint8Array}} Schema
 * @typedef {{id: number, schemaId: number, topic: string, messageEncoding: string,
 *   metadata: Map<string, string>}} Channel
 * @typedef {{messageStartTime: bigint, messageEndTime: bigint, chunkStartOffset: bigint, chunkLength: bigint,
 *   messageIndexOffsets: Map<number, bigint>, messageIndexLength: bigint, compression: string,
 *   compressedSize: bigint, uncompressedSize: bigint}} ChunkIndex
 * @typedef {(records: Uint8Array) => {compression: string, records: Uint8Array}} Compress
 * @typedef {{schemas: Map<number, Schema>, channels: Map<number, Channel>, chunks: ChunkIndex[],
 *   counts: Map<number, bigint>}} Contents
 */

export const LIBRARY = "sitegen";
const CHUNK = 1024 * 1024;
const SUMMARY = { schema: 3, channel: 4, statistics: 11, chunkIndex: 8 };

export class BagWriter {
  #write;
  #compress;
  #records = new McapRecordBuilder();
  #chunk = new McapChunkBuilder({ useMessageIndex: true });
  #crc = crc32Init();
  #position = 0;
  /** @type {Contents} */
  #contents = { schemas: new Map(), channels: new Map(), chunks: [], counts: new Map() };
  count = 0;

  /** @param {(bytes: Uint8Array) => void} write @param {Compress} [compress] chunks */
  constructor(write, compress) {
    this.#write = write;
    this.#compress = compress;
    this.#records.writeMagic();
    this.#records.writeHeader({ profile: "ros2", library: LIBRARY });
    this.#flush();
  }

  /** The size of the file, with what is not written yet, in bytes. */
  get size() {
    return this.#position + this.#chunk.byteLength;
  }

  /** Add a topic and return its id. @param {string} topic @param {string} type @param {string} text @param {string} qos */
  addTopic(topic, type, text, qos) {
    const { schemas } = this.#contents;
    const known = [...schemas.values()].find(({ name }) => name === type)?.id;
    const schemaId = known ?? this.addSchema({ name: type, encoding: "ros2msg", data: new TextEncoder().encode(text) });
    const metadata = new Map([["offered_qos_profiles", qos]]);
    return this.addChannel({ schemaId, topic, messageEncoding: "cdr", metadata });
  }

  /** Add a schema and return its id. @param {Omit<Schema, "id">} given */
  addSchema({ name, encoding, data }) {
    const { schemas } = this.#contents;
    const schema = { id: schemas.size + 1, name, encoding, data };
    schemas.set(schema.id, schema);
    this.#records.writeSchema(schema);
    return schema.id;
  }

  /** Add a channel and return its id. @param {Omit<Channel, "id">} given `schemaId` is 0 if it has none */
  addChannel({ schemaId, topic, messageEncoding, metadata }) {
    const { channels } = this.#contents;
    const channel = { id: channels.size + 1, schemaId, topic, messageEncoding, metadata };
    channels.set(channel.id, channel);
    // Outside of chunks, whose messages can then be found without decompressing them.
    this.#records.writeChannel(channel);
    this.#flush();
    return channel.id;
  }

  /** @param {number} channelId @param {number} sequence @param {bigint} logTime @param {bigint} publishTime @param {Uint8Array} data */
  add(channelId, sequence, logTime, publishTime, data) {
    this.#chunk.addMessage({ channelId, sequence, logTime, publishTime, data });
    this.#contents.counts.set(channelId, (this.#contents.counts.get(channelId) ?? 0n) + 1n);
    this.count += 1;
    if (this.#chunk.byteLength >= CHUNK) this.endChunk();
  }

  /** Write what is not written yet. */
  endChunk() {
    const chunk = this.#chunk;
    if (chunk.numMessages === 0) return;
    const plain = chunk.buffer;
    const { compression, records } = this.#compress?.(plain) ?? { compression: "", records: plain };
    const { messageStartTime, messageEndTime } = chunk;
    const uncompressedSize = BigInt(plain.length);
    const start = BigInt(this.#position);
    const chunkLength = this.#records.writeChunk({
      messageStartTime, messageEndTime, uncompressedSize, uncompressedCrc: crc32(plain), compression, records,
    });
    const indexStart = start + BigInt(this.#records.length);
    /** @type {Map<number, bigint>} */
    const messageIndexOffsets = new Map();
    for (const index of chunk.indices) {
      if (index.records.length === 0) continue;
      messageIndexOffsets.set(index.channelId, start + BigInt(this.#records.length));
      this.#records.writeMessageIndex(index);
    }
    this.#contents.chunks.push({
      messageStartTime, messageEndTime, chunkStartOffset: start, chunkLength, messageIndexOffsets,
      messageIndexLength: start + BigInt(this.#records.length) - indexStart,
      compression, compressedSize: BigInt(records.length), uncompressedSize,
    });
    chunk.reset();
    this.#flush();
  }

  /** Write the summary; the file is complete then. */
  end() {
    this.endChunk();
    this.#put(tail(this.#contents, this.#position, crc32Final(this.#crc)));
  }

  /** What `ros2 bag info` says of it: the messages of each channel. */
  get channels() {
    const { channels, schemas, counts } = this.#contents;
    return [...channels.values()].map(({ id, topic, schemaId, metadata }) => ({
      topic, type: schemas.get(schemaId)?.name ?? "", count: counts.get(id) ?? 0n,
      qos: metadata.get("offered_qos_profiles") ?? "",
    }));
  }

  #flush() {
    const bytes = this.#records.buffer;
    this.#crc = crc32Update(this.#crc, bytes);
    this.#records.reset();
    this.#put(bytes);
  }

  /** @param {Uint8Array} bytes */
  #put(bytes) {
    this.#write(bytes);
    this.#position += bytes.length;
  }
}

/**
 * Return the end of a file: the summary of its contents.
 * @param {Contents} contents @param {number} position where it begins @param {number} crc of all before, or 0
 */
export function tail(contents, position, crc) {
  const records = new McapRecordBuilder();
  records.writeDataEnd({ dataSectionCrc: crc });
  const prefix = records.length;
  const { schemas, channels, chunks } = contents;
  /** @type {{groupOpcode: number, groupStart: bigint, groupLength: bigint}[]} */
  const groups = [];
  const group = (/** @type {number} */ groupOpcode, /** @type {() => void} */ write) => {
    const before = records.length;
    write();
    if (records.length === before) return;
    groups.push({
      groupOpcode, groupStart: BigInt(position + before), groupLength: BigInt(records.length - before),
    });
  };
  group(SUMMARY.schema, () => schemas.forEach((schema) => records.writeSchema(schema)));
  group(SUMMARY.channel, () => channels.forEach((channel) => records.writeChannel(channel)));
  group(SUMMARY.statistics, () => records.writeStatistics(statistics(contents)));
  group(SUMMARY.chunkIndex, () => chunks.forEach((chunk) => records.writeChunkIndex(chunk)));
  const offsets = records.length;
  for (const one of groups) records.writeSummaryOffset(one);
  const before = records.buffer.length;
  const footer = { summaryStart: BigInt(position + prefix), summaryOffsetStart: BigInt(position + offsets) };
  records.writeFooter({ ...footer, summaryCrc: 0 });
  // The checksum is that of the summary and of the footer up to the checksum itself.
  const summed = records.buffer.subarray(prefix, records.length - 4);
  const summaryCrc = crc32Final(crc32Update(crc32Init(), summed));
  const kept = records.buffer.slice(0, before);
  const last = new McapRecordBuilder();
  last.writeFooter({ ...footer, summaryCrc });
  last.writeMagic();
  const bytes = new Uint8Array(kept.length + last.length);
  bytes.set(kept);
  bytes.set(last.buffer, kept.length);
  return bytes;
}

/** @param {Contents} contents */
function statistics({ schemas, channels, chunks, counts }) {
  const filled = chunks.filter(({ messageIndexOffsets }) => messageIndexOffsets.size > 0);
  const least = (/** @type {bigint | undefined} */ a, /** @type {bigint} */ b) => (a === undefined || b < a ? b : a);
  const most = (/** @type {bigint} */ a, /** @type {bigint} */ b) => (b > a ? b : a);
  return {
    messageCount: [...counts.values()].reduce((sum, count) => sum + count, 0n),
    schemaCount: schemas.size, channelCount: channels.size, attachmentCount: 0, metadataCount: 0,
    chunkCount: chunks.length,
    messageStartTime: filled.reduce((time, one) => least(time, one.messageStartTime),
      /** @type {bigint | undefined} */ (undefined)) ?? 0n,
    messageEndTime: filled.reduce((time, one) => most(time, one.messageEndTime), 0n),
    channelMessageCounts: counts,
  };
}
