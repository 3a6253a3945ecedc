// @ts-check
// Play a bag into the graph: a publisher for each of its topics, and messages at their times.

import { Bag } from "../../bag/bag.js";
import { isChosen } from "../../bag/choice.js";
import { isSame } from "../../bag/definition.js";
import { said, saidOf } from "../../bag/orders.js";
import { DEFAULT_QOS, now } from "../../protocol.js";
import { Ahead } from "./ahead.js";
import { ClockPublisher } from "./clock.js";
import { readableOf } from "./files.js";
import { marksOf } from "./marks.js";

/** @import { MessageType } from "../../protocol.js" */
/** @import { FromPlayer, Part, Playing, Said, Source, Summary, ToPlayer } from "../../bag/orders.js" */
/** @import { Message } from "../../bag/chunk.js" */
/** @import { Participant } from "../../participant/participant.js" */

export const NODE = "/rosbag2_player";

// Timers of browsers are late by about this time (ms); the rest is waited for by turns of the event loop.
const SPIN = 2;
// The page is told the time this often (ms).
const TOLD = 50;
// A player that is late by more than this (ms), because the file was slow, goes on from where it is.
const LATE = 300;
// The widths of the timeline, and how long a bag that starts by itself waits until subscriptions match (ms).
const COLUMNS = 400;
const MATCHED = 300;

export class Player {
  #participant;
  #tell;
  /** @type {Bag | undefined} */
  #bag;
  /** @type {Summary | undefined} */
  #summary;
  /** Publishers by channel. @type {Map<number, number>} */
  #publishers = new Map();
  /** Channels that are played now. @type {Set<number>} */
  #chosen = new Set();
  /** @type {Ahead | undefined} */
  #ahead;
  /** @type {ClockPublisher | undefined} */
  #clock;
  #remote = false;
  #playing = false;
  #loop = false;
  #rate = 1;
  /** The time in the bag (ns) at a time of the wall clock (ms). */
  #at = 0n;
  #since = 0;
  #told = 0;
  #ended = false;
  /** The part that is played, and where playing ends next: at its end, or at that of the bag after a seek beyond it. */
  #from = 0n;
  #to = 0n;
  #goal = 0n;
  /** The number of the last order to go elsewhere, and whether it is being carried out. */
  #seeks = 0;
  #seeking = false;

  /** @param {Participant} participant @param {(message: FromPlayer, transfer?: Transferable[]) => void} tell */
  constructor(participant, tell) {
    this.#participant = participant;
    this.#tell = tell;
  }

  /** Open a bag and tell what is in it. @param {Source} source */
  async open(source) {
    this.#remote = "url" in source;
    this.#bag = await Bag.open(await readableOf(source), (said) => this.#tell({ op: "noted", said }));
    this.#summary = this.#bag.summary();
    this.#at = this.#from = this.#bag.start;
    this.#to = this.#goal = this.#bag.end;
    this.#tell({ op: "opened", summary: this.#summary });
  }

  /** @param {ToPlayer} order */
  async receive(order) {
    const bag = this.#bag;
    if (!bag) return;
    if (order.op === "advertise") this.#advertise(bag, order.playing, order.known);
    else if (order.op === "play") this.#play(bag);
    else if (order.op === "pause") this.#pause();
    else if (order.op === "step") await this.#step(bag);
    else if (order.op === "seek") await this.#seek(bag, bag.timeAt(order.time));
    else if (order.op === "part") await this.#restrict(bag, order.part);
    else if (order.op === "loop") this.#loop = order.on;
    else if (order.op === "rate") {
      this.#rebase(this.#now());
      this.#rate = order.rate;
    } else if (order.op === "choose") {
      if (order.on) this.#chosen.add(order.id);
      else this.#chosen.delete(order.id);
    }
    this.#participant.wake();
  }

  /**
   * Create the publishers of all topics whose type means the same on this page.
   * @param {Bag} bag @param {Playing} playing @param {Record<string, MessageType>} known types of the page
   */
  #advertise(bag, playing, known) {
    const { tracks = [], types = {} } = this.#summary ?? {};
    /** @type {{id: number, why: Said, differs?: boolean}[]} */
    const refused = [];
    for (const { id, topic, type, why } of tracks) {
      const differs = type in known && type in types && !isSame(known, types, type);
      if (why) refused.push({ id, why });
      else if (differs) refused.push({ id, why: said("its type differs from the {} of this page", type), differs });
      else if (isChosen(topic, playing)) {
        const name = playing.remap?.[topic] ?? topic;
        const qos = bag.qos.get(id) ?? DEFAULT_QOS;
        this.#publishers.set(id, this.#participant.create("publisher", NODE, name, type, qos));
        this.#chosen.add(id);
      }
    }
    if (playing.clock) this.#clock = new ClockPublisher(this.#participant, NODE, playing.clock === true ? undefined : playing.clock);
    this.#loop = playing.loop ?? false;
    this.#rate = playing.rate ?? 1;
    this.#tell({ op: "advertised", refused });
    this.#read(bag, bag.start);
    this.#run(bag).catch((error) => this.#fail(error));
    marksOf(bag, COLUMNS, this.#remote, (rows) => this.#tell({ op: "marks", columns: COLUMNS, rows })).catch(() => {});
  }

  /** @param {Bag} bag */
  async #play(bag) {
    if (this.#ended) await this.#seek(bag, this.#from);
    await new Promise((resolve) => this.#participant.whenAnnounced(() => resolve(undefined)));
    const fresh = [...this.#publishers.values()].some((id) => this.#participant.matched(id) === 0);
    if (fresh && this.#at === this.#from) await new Promise((resolve) => setTimeout(resolve, MATCHED));
    this.#since = now();
    this.#playing = true;
    this.#ended = false;
    this.#participant.wake();
    this.#show();
  }

  #pause() {
    this.#rebase(this.#now());
    this.#playing = false;
    this.#show();
  }

  /** Publish the next message. @param {Bag} bag */
  async #step(bag) {
    this.#pause();
    const message = await this.#ahead?.next();
    if (!message) {
      this.#finish();
      return;
    }
    this.#rebase(message.logTime);
    this.#aim(bag);
    this.#publish(message);
    this.#clock?.publish(message.logTime);
    this.#participant.flush();
    this.#show();
  }

  /** Play only a part of the bag, from its start if the time is outside of it. @param {Bag} bag @param {Part} part */
  async #restrict(bag, { from, to }) {
    this.#from = bag.timeAt(from);
    this.#to = to === undefined ? bag.end : bag.timeAt(to);
    const time = this.#now();
    if (time < this.#from || time > this.#to) await this.#seek(bag, this.#from);
    else this.#aim(bag);
  }

  /** Let playing end where the part does, or the bag if the part is over. @param {Bag} bag */
  #aim(bag) {
    this.#goal = this.#at > this.#to ? bag.end : this.#to;
    this.#ended = this.#at >= this.#goal;
  }

  /** Go to a time: what latched topics would have told latecomers comes first. @param {Bag} bag @param {bigint} to */
  async #seek(bag, to) {
    const seek = ++this.#seeks;
    this.#seeking = true;
    this.#rebase(to);
    this.#aim(bag);
    const found = [];
    for (const [id] of this.#publishers) {
      if (!bag.qos.get(id)?.transientLocal) continue;
      found.push(...(await bag.latched(id, to)));
      if (seek !== this.#seeks) return; // a newer order has come
    }
    this.#read(bag, to);
    for (const message of found) this.#publish(message);
    this.#clock?.publish(to);
    this.#participant.flush();
    // Reading may have taken its time.
    this.#rebase(to);
    this.#seeking = false;
    this.#participant.wake();
    this.#show();
  }

  /** Read messages from a time on. @param {Bag} bag @param {bigint} time */
  #read(bag, time) {
    this.#ahead?.close();
    const channels = new Set(this.#publishers.keys());
    this.#ahead = new Ahead(bag.messages(time, channels), () => this.#participant.wake());
  }

  /** @param {Bag} bag */
  async #run(bag) {
    for (;;) {
      if (!this.#playing || this.#seeking) {
        await this.#participant.wait(-1);
        continue;
      }
      const ahead = this.#ahead;
      const message = ahead?.peek();
      if (!message || message.logTime > this.#goal) {
        const last = message || ahead?.ended;
        if (!message && ahead?.failure) this.#fail(ahead.failure);
        else if (last && this.#now() >= this.#goal) await this.#turn(bag);
        else await this.#wait(last ? this.#left(this.#goal) : TOLD);
        continue;
      }
      const left = this.#left(message.logTime);
      if (left > 0) {
        await this.#wait(left);
        continue;
      }
      if (left < -LATE) this.#rebase(message.logTime);
      if (this.#publish(message)) ahead?.shift();
      else await this.#participant.wait(TOLD); // a subscription that must not miss any is behind
      if (now() - this.#told > TOLD) this.#show();
    }
  }

  /** Wait for a message that is due in `left` ms, and tell the time meanwhile. @param {number} left */
  async #wait(left) {
    this.#clock?.tick(this.#now());
    if (now() - this.#told > TOLD) this.#show();
    const longest = Math.min(TOLD, this.#clock?.period ?? TOLD);
    await this.#participant.wait(left > SPIN ? Math.min(left - SPIN, longest) : 0);
  }

  /** At the end: begin again, or stop. @param {Bag} bag */
  async #turn(bag) {
    if (this.#loop && this.#to > this.#from) await this.#seek(bag, this.#from);
    else this.#finish();
  }

  #finish() {
    // Whoever closes the player now gets the last message, too.
    this.#participant.flush();
    this.#rebase(this.#goal);
    this.#playing = false;
    this.#ended = true;
    this.#show();
  }

  /** Return whether the message was published. @param {Message} message */
  #publish({ channelId, logTime, data }) {
    const publisher = this.#publishers.get(channelId);
    if (publisher === undefined || !this.#chosen.has(channelId)) return true;
    this.#clock?.tick(logTime);
    return this.#participant.publish(publisher, data);
  }

  /** The time in the bag now, in ns. */
  #now() {
    if (!this.#playing) return this.#at;
    return this.#at + BigInt(Math.round((now() - this.#since) * this.#rate * 1e6));
  }

  /** How many ms it is until a time of the bag. @param {bigint} time */
  #left(time) {
    return Number(time - this.#at) / 1e6 / this.#rate - (now() - this.#since);
  }

  /** Let it be a time of the bag now. @param {bigint} time */
  #rebase(time) {
    this.#at = time;
    this.#since = now();
  }

  #show() {
    if (!this.#bag) return;
    this.#told = now();
    const time = this.#now();
    const shown = time > this.#bag.end ? this.#bag.end : time;
    const waiting = this.#playing && !this.#ahead?.ended && !this.#ahead?.peek();
    this.#tell({
      op: "state", time: Number(shown - this.#bag.start) / 1e9, playing: this.#playing, waiting, ended: this.#ended,
    });
  }

  /** @param {unknown} error */
  #fail(error) {
    this.#finish();
    this.#tell({ op: "failed", said: saidOf(error) });
  }
}
