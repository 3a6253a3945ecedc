// @ts-check
// A bag that is read: what is in it, and its messages by time.

import { McapIndexedReader } from "../vendor/mcap.js";
import { ChunkMessages, contentOf, Damage, damaged } from "./chunk.js";
import { decompressors } from "./compression.js";
import { readDefinitions } from "./definition.js";
import { Fault, said, saidOf } from "./orders.js";
import { readProfiles } from "./qos.js";
import { salvaged } from "./salvage.js";

/** @import { MessageType, Qos } from "../protocol.js" */
/** @import { Handlers, Message } from "./chunk.js" */
/** @import { Said, Summary, Track } from "./orders.js" */
/** @import { Readable } from "./source.js" */
/** @import { ChunkIndex } from "./writer.js" */

const MOST_CHANNELS = 5000;
const MOST_CHUNKS = 1_000_000;
const MAGIC = [0x89, 0x4d, 0x43, 0x41, 0x50, 0x30, 0x0d, 0x0a];
// How many latched messages of a topic are looked for.
const MOST_LATCHED = 100;
// The longest names and types, in characters.
const LONGEST = 1000;
const LONGEST_QOS = 100_000;

export class Bag {
  #reader;
  #readable;
  #handlers;
  /** In bytes. */
  size;
  /** @type {Said[]} */
  #notes;
  #tell;
  /** Whether it was told that something of it cannot be read. */
  #told = false;

  /**
   * @param {McapIndexedReader} reader @param {Readable} readable @param {Handlers} handlers @param {number} size
   * @param {Said[]} notes @param {(said: Said) => void} tell
   */
  constructor(reader, readable, handlers, size, notes, tell) {
    this.#reader = reader;
    this.#readable = readable;
    this.#handlers = handlers;
    this.size = size;
    this.#notes = notes;
    this.#tell = tell;
    /** The times of the first and the last message, in ns. */
    this.start = 0n;
    this.end = 0n;
    for (const [index, { messageStartTime: from, messageEndTime: to }] of reader.chunkIndexes.entries()) {
      if (index === 0 || from < this.start) this.start = from;
      if (index === 0 || to > this.end) this.end = to;
    }
    /** @type {Map<number, Qos>} by channel */
    this.qos = new Map([...reader.channelsById.values()].map(({ id, metadata }) =>
      [id, readProfiles(metadata.get("offered_qos_profiles") ?? "")]));
  }

  /**
   * Open a bag; one that was cut off is read as far as it goes.
   * @param {Readable} readable @param {(said: Said) => void} tell called once if a part turns out to be damaged later
   */
  static async open(readable, tell) {
    const size = await readable.size();
    const head = size < 8n ? new Uint8Array() : await readable.read(0n, 8n);
    if (!MAGIC.every((byte, index) => head[index] === byte)) {
      throw new Fault("This is not an MCAP file. Bags of other formats are converted by sitegen when a site is built.");
    }
    const handlers = await decompressors();
    let whole = readable;
    /** @type {Said[]} */
    const notes = [];
    let reader = await McapIndexedReader.Initialize({ readable }).catch(() => undefined);
    if (!reader || !isIndexed(reader)) {
      const found = await salvaged(readable, handlers);
      whole = found.readable;
      if (found.cut) notes.push(said("This bag is cut off or damaged; only its first part is played."));
      reader = await McapIndexedReader.Initialize({ readable: whole });
    }
    if (reader.channelsById.size > MOST_CHANNELS || reader.chunkIndexes.length > MOST_CHUNKS) {
      throw new Fault("This bag has more than {} topics or {} chunks.", MOST_CHANNELS, MOST_CHUNKS);
    }
    return new Bag(reader, whole, handlers, Number(size), notes, tell);
  }

  /** Return what is in it. @returns {Summary} */
  summary() {
    const { channelsById, chunkIndexes, header, statistics } = this.#reader;
    /** @type {Record<string, MessageType>} */
    const types = {};
    const notes = [...this.#notes];
    const tracks = [...channelsById.values()].map((channel) => this.#track(channel, types, notes));
    if (tracks.length === 0) notes.push(said("This bag is empty."));
    return {
      from: this.start,
      to: this.end,
      start: Number(this.start / 1000n) / 1000,
      duration: Number(this.end - this.start) / 1e9,
      count: Number(statistics?.messageCount ?? 0n),
      size: this.size,
      library: header.library.slice(0, LONGEST),
      compression: [...new Set(chunkIndexes.map(({ compression }) => compression))].filter(Boolean).join(", "),
      tracks: tracks.sort((a, b) => (a.topic < b.topic ? -1 : 1)),
      types,
      notes,
    };
  }

  /**
   * @param {{id: number, schemaId: number, topic: string, messageEncoding: string, metadata: Map<string, string>}} channel
   * @param {Record<string, MessageType>} types gets the definitions of its schema @param {Said[]} notes
   * @returns {Track}
   */
  #track({ id, schemaId, topic, messageEncoding, metadata }, types, notes) {
    const schema = this.#reader.schemasById.get(schemaId);
    const type = schema?.name ?? "";
    const count = Number(this.#reader.statistics?.channelMessageCounts.get(id) ?? 0n);
    const qos = (metadata.get("offered_qos_profiles") ?? "").slice(0, LONGEST_QOS);
    /** @type {Track} */
    const track = { id, topic: topic.slice(0, LONGEST), type: type.slice(0, LONGEST), count, qos };
    if (messageEncoding !== "cdr") {
      track.why = said("its messages are not CDR but {}", messageEncoding.slice(0, 40) || "?");
    } else if (!/^(\/[A-Za-z_]\w*)+$/.test(topic) || topic.length > LONGEST) {
      track.why = said("its name is not valid in ROS 2");
    } else if (!/^[A-Za-z]\w*\/\w+\/\w+$/.test(type) || type.length > LONGEST) {
      track.why = said("its type is not valid in ROS 2");
    }
    if (track.why || !schema || schema.encoding !== "ros2msg" || types[type]) return track;
    try {
      // Recorders without the definition of a type write an empty one, too.
      if (schema.data.length > 0 || type.endsWith("/Empty")) {
        Object.assign(types, readDefinitions(type, new TextDecoder().decode(schema.data)), types);
      }
    } catch (error) {
      // It can be played without.
      notes.push(saidOf(error));
    }
    return track;
  }

  /**
   * Yield the messages of some topics from a time to another, in the order of their times. Damaged chunks are left out.
   * @param {bigint} from in ns @param {Set<number>} channels @param {bigint} [to] in ns, the end if it is missing
   * @returns {AsyncGenerator<Message>}
   */
  async *messages(from, channels, to = this.end) {
    const chunks = this.#chunksOf(channels, from, to).sort(by((chunk) => chunk.messageStartTime));
    /** Chunks of which messages are left. @type {ChunkMessages[]} */
    const open = [];
    for (const chunk of chunks) {
      // A chunk is read when one of its messages may be the next one.
      yield* taken(open, chunk.messageStartTime - 1n);
      const messages = await this.#messagesOf(chunk, channels, from, to);
      if (messages) open.push(messages);
    }
    yield* taken(open, to);
  }

  /**
   * Return the messages that a latecomer would have got from a latched topic before a time, the oldest first.
   * @param {number} channel @param {bigint} before in ns
   */
  async latched(channel, before) {
    const depth = Math.min(this.qos.get(channel)?.depth ?? 1, MOST_LATCHED);
    const channels = new Set([channel]);
    const chunks = this.#chunksOf(channels, this.start, before - 1n).sort(by((chunk) => -chunk.messageEndTime));
    /** @type {Message[]} */
    let found = [];
    for (const chunk of chunks) {
      const [oldest] = found;
      if (oldest && found.length >= depth && oldest.logTime >= chunk.messageEndTime) break;
      const messages = await this.#messagesOf(chunk, channels, this.start, before - 1n);
      const more = [];
      for (let one; (one = messages?.shift());) more.push(one);
      found = [...more, ...found].sort(by(({ logTime }) => logTime)).slice(-depth);
    }
    return found;
  }

  /**
   * The chunks that may have messages of some channels between two times.
   * @param {Set<number>} channels @param {bigint} from @param {bigint} to
   */
  #chunksOf(channels, from, to) {
    return this.chunks.filter(({ messageStartTime, messageEndTime, messageIndexOffsets }) =>
      messageStartTime <= to && messageEndTime >= from && [...messageIndexOffsets.keys()].some((id) => channels.has(id)));
  }

  /**
   * Return messages of a chunk; undefined if it is damaged, which is told once.
   * @param {ChunkIndex} chunk @param {Set<number>} channels @param {bigint} from @param {bigint} to
   */
  async #messagesOf(chunk, channels, from, to) {
    try {
      const content = await contentOf(this.#readable, this.#handlers, chunk);
      const messages = new ChunkMessages(content, chunk, channels, from, to);
      if (messages.odd) this.#complain(damaged());
      return messages;
    } catch (error) {
      if (!(error instanceof Damage)) throw error;
      this.#complain(error);
      return undefined;
    }
  }

  /** @param {Damage} damage */
  #complain(damage) {
    if (!this.#told) this.#tell(damage.said);
    this.#told = true;
  }

  /** Return the channels with their schemas, as they are in the file. */
  channels() {
    const { channelsById, schemasById } = this.#reader;
    return [...channelsById.values()].map((channel) => ({ ...channel, schema: schemasById.get(channel.schemaId) }));
  }

  /** Return a time of the bag in ns. @param {number} seconds from its start, which may be outside of it */
  timeAt(seconds) {
    const time = this.start + BigInt(Math.round(seconds * 1e9));
    return time < this.start ? this.start : time > this.end ? this.end : time;
  }

  /** Where the parts of the file are that have messages, and how many bytes its index of them has. */
  get chunks() {
    return this.#reader.chunkIndexes;
  }

  /**
   * Call `found` for each message of a chunk, without reading the messages.
   * @param {typeof McapIndexedReader.prototype.chunkIndexes[number]} chunk
   * @param {(channel: number, time: bigint) => void} found
   */
  async times({ messageIndexOffsets, messageIndexLength }, found) {
    const offsets = [...messageIndexOffsets.values()];
    if (offsets.length === 0) return;
    const first = offsets.reduce((least, offset) => (offset < least ? offset : least));
    const bytes = await this.#readable.read(first, messageIndexLength);
    const view = new DataView(bytes.buffer, bytes.byteOffset, bytes.byteLength);
    for (let at = 0; at + 15 <= bytes.length;) {
      const length = Number(view.getBigUint64(at + 1, true));
      const channel = view.getUint16(at + 9, true);
      const end = Math.min(at + 15 + view.getUint32(at + 11, true), at + 9 + length, bytes.length);
      for (let entry = at + 15; entry + 16 <= end; entry += 16) found(channel, view.getBigUint64(entry, true));
      at += 9 + length;
    }
  }
}

/** Whether all messages can be found. @param {McapIndexedReader} reader */
function isIndexed({ channelsById, chunkIndexes, statistics }) {
  const { messageCount = 1n, channelCount = 1 } = statistics ?? {};
  if (chunkIndexes.length === 0) return messageCount === 0n;
  return channelsById.size >= channelCount && chunkIndexes.every(({ messageIndexOffsets }) => messageIndexOffsets.size > 0);
}

/**
 * Take the messages up to a time out of some chunks, in the order of their times.
 * @param {ChunkMessages[]} open those that have no more are removed @param {bigint} to in ns, included
 */
function* taken(open, to) {
  for (;;) {
    let [next] = open;
    for (const one of open) if (next && timeOf(one) < timeOf(next)) next = one;
    if (!next || timeOf(next) > to) return;
    const message = next.shift();
    if (message) yield message;
    else open.splice(open.indexOf(next), 1);
  }
}

/** @param {ChunkMessages} messages a chunk without messages is the first to be removed */
function timeOf({ time }) {
  return time ?? -1n;
}

/**
 * Return what sorts by a time.
 * @template T
 * @param {(one: T) => bigint} time
 * @returns {(a: T, b: T) => number}
 */
function by(time) {
  return (a, b) => (time(a) < time(b) ? -1 : time(a) > time(b) ? 1 : 0);
}
