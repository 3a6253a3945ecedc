// @ts-check
// Record topics of the graph to a bag: a subscription for each of them, new ones as they appear.

import { isChosen } from "../../bag/choice.js";
import { definitionText } from "../../bag/definition.js";
import { writeProfiles } from "../../bag/qos.js";
import { loadCompressor } from "../../bag/compression.js";
import { said } from "../../bag/orders.js";
import { BagWriter } from "../../bag/writer.js";
import { isHidden } from "../../graphNames.js";
import { DEFAULT_QOS, now } from "../../protocol.js";
import { Target } from "./files.js";

/** @import { Endpoint, MessageType, Qos } from "../../protocol.js" */
/** @import { FromRecorder, Said, ToRecorder, Wanted } from "../../bag/orders.js" */
/** @import { Participant } from "../../participant/participant.js" */

/**
 * @typedef {{id: number, channel: number, name: string, type: string, offered: Qos[]}} Recorded a subscription, the
 *   channel of the bag that it is written to (0 before its first message), and what its publishers offer
 */

export const NODE = "/rosbag2_recorder";

// What is not yet in a file is written this often (ms): so much is lost if the tab crashes.
const WRITTEN = 1000;
// The page is told how far it is this often (ms).
const TOLD = 250;
// Without a file, a recording ends at this size (bytes).
const IN_MEMORY = 256e6;
// How many messages and bytes are taken before others get their turn.
const TURN = { messages: 512, bytes: 8 * 1024 * 1024 };
// The recorder is behind if it works for more than this part of the time, on average over about so many turns.
const BUSY = 0.65;
const AVERAGED = 10;

export class Recorder {
  #participant;
  #tell;
  /** @type {Wanted} */
  #wanted = { limit: 0, compress: false };
  /** @type {Record<string, MessageType>} */
  #types = {};
  /** @type {Target | undefined} */
  #target;
  /** @type {BagWriter | undefined} */
  #writer;
  /** By topic and type. @type {Map<string, Recorded>} */
  #topics = new Map();
  #changes = -1;
  #recording = false;
  /** Whether it was told to end before it had begun. */
  #early = false;
  /** Whether messages come faster than they can be compressed and written. */
  #behind = false;
  /** For which part of the time it has worked lately. */
  #busy = 0;
  #written = 0;
  #told = 0;

  /** @param {Participant} participant @param {(message: FromRecorder) => void} tell */
  constructor(participant, tell) {
    this.#participant = participant;
    this.#tell = tell;
  }

  /** @param {Extract<ToRecorder, {op: "record"}>} order */
  async begin({ folder, name, wanted, types }) {
    // Without it, the recording is larger, and nothing else.
    const compress = wanted.compress ? await loadCompressor().catch(() => undefined) : undefined;
    const target = await Target.open(folder, name);
    this.#wanted = { ...wanted, limit: target.kept ? wanted.limit : Math.min(wanted.limit, IN_MEMORY) };
    this.#types = types;
    this.#target = target;
    // Chunks that come faster than they can be compressed are stored as they are.
    this.#writer = new BagWriter((bytes) => target.write(bytes), (records) =>
      (this.#behind || !compress ? { compression: "", records } : compress(records)));
    this.#recording = true;
    this.#participant.look();
    this.#tell({ op: "began", kept: target.kept, limit: this.#wanted.limit });
    if (this.#early) {
      this.#end();
      return;
    }
    this.#run().catch((error) => this.#end(reasonOf(error)));
  }

  /** @param {ToRecorder} order */
  async receive(order) {
    if (order.op === "types") this.#types = order.types;
    if (order.op === "flush") this.#writer?.endChunk();
    if (order.op === "end") {
      this.#early = true;
      this.#end();
    }
  }

  async #run() {
    while (this.#recording) {
      if (this.#participant.changes !== this.#changes) this.#follow();
      const begun = now();
      const more = this.#take();
      const time = now();
      if (time - this.#written > WRITTEN) {
        this.#written = time;
        this.#writer?.endChunk();
      }
      if (time - this.#told > TOLD) {
        this.#told = time;
        this.#tell({ op: "grown", ...this.#state() });
      }
      if ((this.#writer?.size ?? 0) >= this.#wanted.limit) {
        const megabytes = Math.round(this.#wanted.limit / 1e6);
        this.#end(said("The recording has reached its limit of {} MB.", megabytes));
        return;
      }
      const worked = now();
      await this.#participant.wait(more ? 0 : TOLD);
      // Large messages are few at a time: then it is seen by how little it waits for the next ones.
      this.#busy += ((worked - begun) / Math.max(now() - begun, Number.EPSILON) - this.#busy) / AVERAGED;
      this.#behind = more || this.#busy > BUSY;
    }
  }

  /** Subscribe to topics that have appeared. */
  #follow() {
    this.#changes = this.#participant.changes;
    /** @type {Map<string, Endpoint[]>} */
    const publishers = new Map();
    for (const { endpoint } of this.#participant.look() ?? []) {
      if (endpoint.kind !== "publisher" || !this.#isWanted(endpoint.name)) continue;
      const key = `${endpoint.name} ${endpoint.type}`;
      publishers.set(key, [...(publishers.get(key) ?? []), endpoint]);
    }
    for (const [key, [first, ...others]] of publishers) {
      if (!first || this.#topics.has(key)) continue;
      this.#subscribe(key, first, [first, ...others].map(({ qos }) => qos));
    }
  }

  /** @param {string} topic */
  #isWanted(topic) {
    const { topics, hidden } = this.#wanted;
    return isChosen(topic, this.#wanted) && (hidden || topics?.includes(topic) || !isHidden(topic));
  }

  /** @param {string} key @param {Endpoint} endpoint a publisher @param {Qos[]} offered by all of them */
  #subscribe(key, { name, type }, offered) {
    const every = (/** @type {"reliable" | "transientLocal"} */ policy) => offered.every((qos) => qos[policy]);
    const id = this.#participant.create("subscription", NODE, name, type, {
      ...DEFAULT_QOS, keepAll: true, reliable: every("reliable"), transientLocal: every("transientLocal"),
    });
    this.#topics.set(key, { id, channel: 0, name, type, offered });
    this.#tell({ op: "subscribed", topic: name });
  }

  /** Return the channel of a topic. Its definition may have come after the topic. @param {Recorded} topic */
  #channelOf(topic) {
    const { name, type, offered } = topic;
    const text = definitionText(this.#types, type) ?? "";
    topic.channel ||= this.#writer?.addTopic(name, type, text, writeProfiles(offered)) ?? 0;
    return topic.channel;
  }

  /** Write the messages that have arrived; return whether there may be more. */
  #take() {
    let [taken, bytes] = [0, 0];
    const full = () => taken >= TURN.messages || bytes >= TURN.bytes;
    for (const topic of this.#topics.values()) {
      for (let sample; !full() && (sample = this.#participant.take(topic.id));) {
        const { sequence, received, timestamp, message } = sample;
        const channel = topic.channel || this.#channelOf(topic);
        this.#writer?.add(channel, sequence, nanoseconds(received), nanoseconds(timestamp), message);
        taken += 1;
        bytes += message.length;
      }
    }
    return full();
  }

  /** Complete the bag. @param {Said} [reason] why it ends by itself */
  #end(reason) {
    if (!this.#recording) return;
    this.#recording = false;
    let why = reason;
    try {
      while (this.#take());
      for (const topic of this.#topics.values()) this.#channelOf(topic);
      this.#writer?.end();
    } catch (error) {
      // What is in the file is mended when it is opened.
      why ??= reasonOf(error);
    }
    const state = this.#state();
    for (const { id } of this.#topics.values()) this.#participant.destroy(id);
    this.#tell({ op: "ended", ...state, blob: this.#target?.close(), reason: why });
  }

  #state() {
    const { size = 0, count = 0 } = this.#writer ?? {};
    return { size, count, topics: this.#topics.size };
  }
}

/** @param {number} milliseconds with fractions */
function nanoseconds(milliseconds) {
  return BigInt(Math.round(milliseconds * 1000)) * 1000n;
}

/** @param {unknown} error @returns {Said} */
export function reasonOf(error) {
  if (error instanceof DOMException && error.name === "QuotaExceededError") {
    return said("The browser has no more space for this recording.");
  }
  return said("The recording has ended: {}", error instanceof Error ? error.message : String(error));
}
