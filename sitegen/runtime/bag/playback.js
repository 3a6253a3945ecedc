// @ts-check
// A bag that is played on this page, by a worker that takes part in the graph.

import { say } from "../ui/words.js";
import { definitionText } from "./definition.js";

/** @import { Companion, MessageType, Ros } from "../protocol.js" */
/** @import { FromPlayer, Part, Playing, Said, Source, Summary, ToPlayer } from "./orders.js" */

// Types that a player publishes itself.
const CLOCK = {
  "rosgraph_msgs/msg/Clock": { fields: [{ name: "clock", type: "builtin_interfaces/msg/Time" }], constants: [] },
  "builtin_interfaces/msg/Time": {
    fields: [{ name: "sec", type: "int32" }, { name: "nanosec", type: "uint32" }], constants: [],
  },
};

/**
 * Emits `open` when it is known what is in the bag and its topics are in the graph, `state` when it plays, pauses, or
 * is elsewhere, `marks` when there is more to draw, `note` when there is something to say, and `fail`.
 */
export class Playback extends EventTarget {
  #ros;
  #playing;
  #advertised;
  /** @type {Companion} */
  #worker;
  /** @type {Summary | undefined} */
  summary;
  /** Why topics are not played, by channel. @type {Map<number, string>} */
  refused = new Map();
  /** Both definitions of types that differ, by channel. @type {Map<number, {bag: string, page: string}>} */
  differing = new Map();
  /** What is to be said of the bag. */
  note = "";
  /** How many messages there are at each place of the timeline, by channel. @type {Map<number, Uint32Array>} */
  marks = new Map();
  state = { time: 0, playing: false, waiting: false, ended: false };
  /** The types of the page when the bag was opened. @type {Record<string, MessageType>} */
  #known = {};
  /** Why it has failed, or "". */
  failure = "";

  /**
   * @param {Ros} ros @param {Source} source @param {Playing} [playing]
   * @param {boolean} [advertised] whether its topics get into the graph, or it is only read what is in the bag
   */
  constructor(ros, source, playing = {}, advertised = true) {
    super();
    this.#ros = ros;
    this.#playing = playing;
    this.#advertised = advertised;
    this.#worker = ros.join("bag/bagNode", (message) => this.#told(message), (error) => this.#fail(error));
    this.#order({ op: "open", source });
  }

  play() {
    this.#order({ op: "play" });
  }

  pause() {
    this.#order({ op: "pause" });
  }

  /** Publish the next message only. */
  step() {
    this.#order({ op: "step" });
  }

  /** @param {number} time in seconds from the start */
  seek(time) {
    this.#order({ op: "seek", time });
  }

  /** @param {number} rate 1 is the pace of the recording */
  setRate(rate) {
    this.#order({ op: "rate", rate });
  }

  /** @param {boolean} on */
  setLoop(on) {
    this.#order({ op: "loop", on });
  }

  /** Play only a part of the bag. @param {Part} part */
  setPart(part) {
    this.#order({ op: "part", part });
  }

  /** Play a topic or leave it out. @param {number} id its channel @param {boolean} on */
  choose(id, on) {
    this.#order({ op: "choose", id, on });
  }

  /** Take its topics out of the graph. */
  close() {
    this.#worker.leave();
  }

  /** @param {ToPlayer} order */
  #order(order) {
    this.#worker.tell(order);
  }

  /** @param {FromPlayer} message */
  #told(message) {
    if (message.op === "opened") {
      this.#advertise(message.summary);
    } else if (message.op === "advertised") {
      for (const { id, why, differs } of message.refused) {
        this.refused.set(id, translated(why));
        if (differs) this.#compare(id);
      }
      this.dispatchEvent(new Event("open"));
    } else if (message.op === "noted") {
      this.note = translated(message.said);
      this.dispatchEvent(new Event("note"));
    } else if (message.op === "marks") {
      this.marks = new Map(message.rows.map(({ id, counts }) => [id, counts]));
      this.dispatchEvent(new Event("marks"));
    } else if (message.op === "state") {
      const { time, playing, waiting, ended } = message;
      this.state = { time, playing, waiting, ended };
      this.dispatchEvent(new Event("state"));
    } else {
      this.#fail(translated(message.said));
    }
  }

  /** Let the page know the types of the bag, so that panels can show its topics. @param {Summary} summary */
  #advertise(summary) {
    this.summary = summary;
    if (!this.#advertised) {
      this.dispatchEvent(new Event("open"));
      return;
    }
    const { types } = this.#ros;
    /** @type {Record<string, MessageType>} */
    const known = {};
    for (const { type } of summary.tracks) for (const name of namesIn(type, types)) known[name] = types[name] ?? NONE;
    this.#known = known;
    this.#order({ op: "advertise", playing: this.#playing, known });
    const found = { ...summary.types, ...(this.#playing.clock ? CLOCK : {}) };
    for (const [name, type] of Object.entries(found)) types[name] ??= type;
  }

  /** @param {number} id a channel whose type differs from that of the page */
  #compare(id) {
    const { tracks, types } = this.summary ?? { tracks: [], types: {} };
    const type = tracks.find((track) => track.id === id)?.type ?? "";
    const [bag, page] = [definitionText(types, type), definitionText(this.#known, type)];
    if (bag !== undefined && page !== undefined) this.differing.set(id, { bag, page });
  }

  /** @param {string} text */
  #fail(text) {
    this.failure = text;
    this.state = { ...this.state, playing: false };
    this.dispatchEvent(new Event("fail"));
  }
}

/** @type {MessageType} */
const NONE = { fields: [], constants: [] };

/** Return the names of a known type and of those nested in it. @param {string} root @param {Record<string, MessageType>} types */
function namesIn(root, types) {
  const names = new Set(types[root] ? [root] : []);
  for (const name of names) { // the set grows during the loop
    for (const { type } of types[name]?.fields ?? []) {
      const base = type.replace(/[<[].*/, "");
      if (types[base]) names.add(base);
    }
  }
  return names;
}

/** @param {Said} said */
export function translated({ text, values }) {
  return say(text, ...values);
}
