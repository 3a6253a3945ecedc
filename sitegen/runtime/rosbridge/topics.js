// @ts-check
// Operations about topics: advertise, unadvertise, publish, subscribe, unsubscribe.

import { adapted } from "../client/adapted.js";
import { fullName, fullType } from "../client/names.js";
import { stamp } from "../messages/time.js";
import { checkFields, Mistake } from "./mistake.js";
import { MOST_NAMES, MOST_QUEUE } from "./limits.js";
import { qosOf } from "./qos.js";
import { Throttle } from "./throttle.js";

/** @import { Publisher } from "../protocol.js" */
/** @import { Session } from "./session.js" */
/** @typedef {{type: string, publisher: Publisher, ids: Set<unknown>}} Advertised */
/** @typedef {{rate: number, queue: number, fragment: number, compression: string}} Wish */
/**
 * @typedef {{type: string, wishes: Map<unknown, Wish>, wish: Wish, throttle: Throttle<Uint8Array>, end: () => void}}
 *   Subscribed
 */

const COMPRESSIONS = ["none", "png", "cbor", "cbor-raw"];

export class Topics {
  #session;
  /** @type {Map<string, Advertised>} */
  #advertised = new Map();
  /** @type {Map<string, Subscribed>} */
  #subscribed = new Map();

  /** @param {Session} session */
  constructor(session) {
    this.#session = session;
  }

  /** @type {Record<string, (message: any) => void>} */
  operations = {
    advertise: (message) => this.#advertise(message),
    unadvertise: (message) => this.#unadvertise(message),
    publish: (message) => this.#publish(message),
    subscribe: (message) => this.#subscribe(message),
    unsubscribe: (message) => this.#unsubscribe(message),
  };

  close() {
    for (const { throttle } of this.#subscribed.values()) throttle.close();
  }

  /** @param {any} message */
  #advertise(message) {
    checkFields(message, {
      topic: "string", type: "string", "latch?": "boolean", "queue_size?": "number", "qos?": "object",
    });
    if (this.#session.actionlib.advertise(message)) return;
    const { topic, id = "", latch = false, queue_size: size } = message;
    const name = fullName(topic);
    const type = this.#typed(name, message.type);
    let known = this.#advertised.get(name);
    if (known && known.type !== type) throw new Mistake(`advertise: ${name} is advertised as ${known.type} already`);
    if (!known) {
      if (this.#advertised.size >= MOST_NAMES) throw new Mistake("advertise: too many topics");
      const depth = latch ? 1 : Math.min(MOST_QUEUE, Math.max(1, Math.round(size ?? 100)));
      const qos = { depth, transientLocal: latch, ...qosOf(message.qos) };
      known = { type, publisher: this.#session.raw.advertise(name, type, qos), ids: new Set() };
      this.#advertised.set(name, known);
    }
    if (known.ids.size < MOST_NAMES) known.ids.add(id);
  }

  /** @param {any} message */
  #unadvertise(message) {
    checkFields(message, { topic: "string" });
    const name = fullName(message.topic);
    if (this.#session.actionlib.unadvertise(name)) return;
    const known = this.#advertised.get(name);
    if (!known) throw new Mistake(`unadvertise: this client does not advertise ${name}`);
    if (message.id !== undefined) known.ids.delete(message.id);
    if (message.id !== undefined && known.ids.size) return;
    known.publisher.close();
    this.#advertised.delete(name);
  }

  /** @param {any} message */
  #publish(message) {
    checkFields(message, { topic: "string", "msg?": "object" });
    if (this.#session.actionlib.publish(message)) return;
    const name = fullName(message.topic);
    const known = this.#advertised.get(name);
    if (!known) {
      const type = this.#session.surroundings.typeOf("topics", name);
      if (!type) throw new Mistake(`publish: ${name} has no type; advertise it first`);
      this.#advertise({ op: "publish", topic: name, type });
    }
    const { type, publisher } = /** @type {Advertised} */ (this.#advertised.get(name));
    publisher.publish(this.#session.values.read(type, message.msg));
  }

  /** @param {any} message */
  #subscribe(message) {
    checkFields(message, {
      topic: "string", "type?": "string", "throttle_rate?": "number", "queue_length?": "number",
      "fragment_size?": "number", "compression?": "string", "qos?": "object",
    });
    if (this.#session.actionlib.subscribe(message)) return;
    const name = fullName(message.topic);
    const compression = message.compression ?? "none";
    if (!COMPRESSIONS.includes(compression)) {
      const known = COMPRESSIONS.join(", ");
      throw new Mistake(`subscribe: unknown compression '${compression.slice(0, 50)}'; it is one of ${known}`);
    }
    const wish = {
      rate: Math.max(0, message.throttle_rate ?? 0), compression,
      queue: Math.min(MOST_QUEUE, Math.max(0, message.queue_length ?? 0)),
      fragment: message.fragment_size > 0 ? message.fragment_size : Infinity,
    };
    const known = this.#subscribed.get(name);
    const type = this.#typed(name, message.type ?? known?.type ?? "");
    if (known && known.type !== type) throw new Mistake(`subscribe: ${name} is subscribed to as ${known.type} already`);
    const one = known ?? this.#begin(name, type, wish, message.qos);
    if (one.wishes.size >= MOST_NAMES) throw new Mistake(`subscribe: too many subscriptions to ${name}`);
    one.wishes.set(message.id ?? "", wish);
    this.#settle(one);
  }

  /** @param {string} name @param {string} type @param {Wish} wish @param {any} qos @returns {Subscribed} */
  #begin(name, type, wish, qos) {
    if (this.#subscribed.size >= MOST_NAMES) throw new Mistake("subscribe: too many topics");
    const { raw, surroundings } = this.#session;
    /** @type {Throttle<Uint8Array>} */
    const throttle = new Throttle((bytes) => this.#forward(name, one, bytes));
    const end = adapted(surroundings, name, { depth: 100, ...qosOf(qos) }, (best, isNew) =>
      raw.subscribeBytes(name, type, (bytes, info) => {
        if (isNew(info)) throttle.push(bytes);
      }, best));
    /** @type {Subscribed} */
    const one = { type, wishes: new Map(), wish, throttle, end };
    this.#subscribed.set(name, one);
    return one;
  }

  /** @param {any} message */
  #unsubscribe(message) {
    checkFields(message, { topic: "string" });
    const name = fullName(message.topic);
    if (this.#session.actionlib.unsubscribe(name)) return;
    const one = this.#subscribed.get(name);
    if (!one) throw new Mistake(`unsubscribe: this client does not subscribe to ${name}`);
    if (message.id === undefined) one.wishes.clear();
    else one.wishes.delete(message.id);
    if (one.wishes.size) {
      this.#settle(one);
      return;
    }
    one.end();
    one.throttle.close();
    this.#subscribed.delete(name);
  }

  /** Serve all subscriptions to a topic by one: a client gets each message once. @param {Subscribed} one */
  #settle(one) {
    const wishes = [...one.wishes.values()];
    const strongest = Math.max(...wishes.map(({ compression }) => COMPRESSIONS.indexOf(compression)));
    one.wish = {
      rate: Math.min(...wishes.map(({ rate }) => rate)),
      queue: Math.max(...wishes.map(({ queue }) => queue)),
      fragment: Math.min(...wishes.map(({ fragment }) => fragment)),
      compression: COMPRESSIONS[strongest] ?? "none",
    };
    one.throttle.set(one.wish.rate, one.wish.queue);
  }

  /** @param {string} topic @param {Subscribed} one @param {Uint8Array} bytes */
  #forward(topic, { type, wish: { compression, fragment } }, bytes) {
    const { raw, values } = this.#session;
    let msg;
    if (compression === "cbor-raw") {
      const { sec: secs, nanosec: nsecs } = stamp();
      // The bytes are a part of a larger frame.
      msg = { secs, nsecs, bytes: bytes.slice() };
    } else {
      const message = raw.read(type, bytes);
      msg = compression === "cbor" ? values.toCbor(type, message) : values.toJson(type, message);
    }
    this.#session.send({ op: "publish", topic, msg }, compression, fragment);
  }

  /**
   * Return the full name of a type that the page has, and the topic too, if there is one.
   * @param {string} name @param {string} given
   */
  #typed(name, given) {
    const { surroundings, values } = this.#session;
    const there = surroundings.typeOf("topics", name);
    if (!given && !there) throw new Mistake(`${name} has no type; give one, or publish it first`);
    const type = given ? fullType(given, "msg") : there;
    if (there && there !== type) throw new Mistake(`${name} has the type ${there}, not ${type}`);
    if (!values.knows(type)) throw new Mistake(`this page has no definition of ${type}`);
    return type;
  }
}
