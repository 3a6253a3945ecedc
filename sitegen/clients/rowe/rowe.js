// @ts-check
// JSON objects over WebSocket, for programs without ROS: messages that expire, and remote calls. Runs in browsers and,
// with a WebSocket class, in Node. docs/rowe.md describes it.

import { CAPACITY, ExpiringQueue } from "./expiringQueue.js";
import { decode, encode } from "./message.js";

/** @import { Message } from "./message.js" */

/**
 * A message that waits to be sent. `settle` tells whether it was.
 * @typedef {{body: Record<string, any>, fields: Record<string, string>, settle: (sent: boolean) => void}} Outgoing
 */

// Seconds between attempts to connect, the last repeated.
const PAUSES = [0.1, 0.2, 0.5, 1, 2, 5];
// Timers of browsers are at most this long (ms).
const LONGEST_TIMER = 2 ** 31 - 1;

/** A program at the other end of a connection. */
class Peer {
  /** @type {ExpiringQueue<Outgoing>} */
  queue = new ExpiringQueue(({ settle }) => settle(false));
  /** @type {WebSocket | undefined} */
  socket;

  /** @param {string} name */
  constructor(name) {
    this.name = name;
  }

  get connected() {
    return this.socket?.readyState === 1;
  }

  /** Send all messages that wait, if there is a connection. */
  flush() {
    while (this.socket && this.connected) {
      const taken = this.queue.take();
      if (!taken) return;
      this.socket.send(encode(taken.item.body, taken.item.fields, taken.left));
      taken.item.settle(true);
    }
  }
}

export class Endpoint {
  /** @type {Map<string, Peer>} */
  #peers = new Map();
  /** Messages to "the" peer, before there is one. @type {ExpiringQueue<Outgoing>} */
  #unaddressed = new ExpiringQueue(({ settle }) => settle(false));
  /** @type {ExpiringQueue<Message>} */
  #incoming = new ExpiringQueue();
  /** Calls of `receive` that wait. @type {Set<() => void>} */
  #waiting = new Set();
  /** @type {Map<string, (message: Message) => void>} */
  #replies = new Map();
  /** @type {Map<string, ReturnType<typeof setTimeout>>} */
  #attempts = new Map();
  #WebSocket;
  #closed = false;

  /** @param {{WebSocket?: any}} [options] the class of sockets, where there is no global one */
  constructor({ WebSocket = globalThis.WebSocket } = {}) {
    this.#WebSocket = WebSocket;
  }

  /** The names of the peers that are connected now. */
  get peers() {
    return [...this.#peers.values()].filter(({ connected }) => connected).map(({ name }) => name);
  }

  /**
   * Connect to a server, and again after a lost connection. Return the name of the peer.
   * @param {string} url @param {string} [name]
   */
  connect(url, name = url) {
    this.#connect(url, this.#add(name), 0);
    return name;
  }

  /**
   * Serve a socket that a server has accepted, such as one of the package ws.
   * @param {WebSocket} socket @param {string} name
   */
  accept(socket, name) {
    const peer = this.#add(name);
    peer.socket = socket;
    socket.addEventListener("message", ({ data }) => this.#receive(data, name));
    socket.addEventListener("close", () => {
      this.#peers.delete(name);
      peer.queue.clear();
    });
    peer.flush();
  }

  /**
   * Send a message. Resolve with true when it was handed to the connection, and with false when it was discarded,
   * because its time to live (seconds) is over or its peer is gone. Reject if the message is invalid, the queue is
   * full, or `to` does not name a peer.
   * @param {Record<string, any>} body @param {{to?: string, timeToLive?: number}} [options]
   */
  async send(body, options = {}) {
    return this.#send(body, {}, options);
  }

  /**
   * Queue a message to be sent. Throws what `send` rejects with.
   * @param {Record<string, any>} body @param {{to?: string, timeToLive?: number}} [options]
   */
  asyncSend(body, options = {}) {
    this.#send(body, {}, options);
  }

  /**
   * Resolve with the oldest message, or with undefined after `timeout` seconds.
   * @param {number} [timeout] @returns {Promise<Message | undefined>}
   */
  async receive(timeout = Infinity) {
    const end = performance.now() + timeout * 1000;
    for (;;) {
      const taken = this.#incoming.take();
      if (taken) return taken.item;
      const left = end - performance.now();
      if (left <= 0 || this.#closed) return undefined;
      await new Promise((/** @type {(value?: any) => void} */ resolve) => {
        const wake = () => {
          clearTimeout(timer);
          this.#waiting.delete(wake);
          resolve();
        };
        const timer = left < LONGEST_TIMER ? setTimeout(wake, left) : undefined;
        this.#waiting.add(wake);
      });
    }
  }

  /** All messages, until the endpoint is closed. */
  async *[Symbol.asyncIterator]() {
    for (let message; (message = await this.receive());) yield message;
  }

  /**
   * Send a request and resolve with the reply. Reject if there is none within `timeToLive` seconds.
   * @param {Record<string, any>} body @param {{to?: string, timeToLive?: number}} [options]
   * @returns {Promise<Message>}
   */
  async invoke(body, { to, timeToLive = 5 } = {}) {
    const id = randomId();
    /** @type {ReturnType<typeof setTimeout> | undefined} */
    let timer;
    try {
      return await new Promise((resolve, reject) => {
        this.#replies.set(id, resolve);
        timer = setTimeout(() => reject(new Error(`no reply within ${timeToLive} s`)), timeToLive * 1000);
        this.#send(body, { message_id: id }, { to, timeToLive });
      });
    } finally {
      clearTimeout(timer);
      this.#replies.delete(id);
    }
  }

  /**
   * Reply to a request, as `send` does.
   * @param {Message} request @param {Record<string, any>} body @param {{timeToLive?: number}} [options]
   */
  async reply(request, body, { timeToLive } = {}) {
    return this.#send(body, replyTo(request), { to: request.peer, timeToLive });
  }

  /**
   * Queue a reply to a request. Throws what `reply` rejects with.
   * @param {Message} request @param {Record<string, any>} body @param {{timeToLive?: number}} [options]
   */
  asyncReply(request, body, { timeToLive } = {}) {
    this.#send(body, replyTo(request), { to: request.peer, timeToLive });
  }

  /** Close all connections. What waits to be sent is discarded. */
  close() {
    this.#closed = true;
    for (const timer of this.#attempts.values()) clearTimeout(timer);
    for (const { socket, queue } of this.#peers.values()) {
      queue.clear();
      socket?.close();
    }
    this.#unaddressed.clear();
    for (const wake of [...this.#waiting]) wake();
  }

  /** @param {string} name */
  #add(name) {
    if (this.#peers.has(name)) throw new Error(`there is a peer named '${name}' already`);
    const peer = new Peer(name);
    this.#peers.set(name, peer);
    for (let taken; (taken = this.#unaddressed.take());) peer.queue.put(taken.item, taken.left);
    return peer;
  }

  /** @param {string} url @param {Peer} peer @param {number} attempt */
  #connect(url, peer, attempt) {
    /** @type {WebSocket} */
    const socket = new this.#WebSocket(url);
    peer.socket = socket;
    let next = attempt + 1;
    socket.addEventListener("open", () => {
      next = 0;
      peer.flush();
    });
    socket.addEventListener("message", ({ data }) => this.#receive(data, peer.name));
    // Node's package ws ends the program for an error that nobody listens to; "close" follows.
    socket.addEventListener("error", () => {});
    socket.addEventListener("close", () => {
      if (this.#closed) return;
      const pause = PAUSES[Math.min(attempt, PAUSES.length - 1)] ?? 5;
      this.#attempts.set(peer.name, setTimeout(() => this.#connect(url, peer, next), pause * 1000));
    });
  }

  /**
   * @param {Record<string, any>} body @param {Record<string, string>} fields
   * @param {{to?: string | undefined, timeToLive?: number | undefined}} options @returns {Promise<boolean>}
   */
  #send(body, fields, { to = "", timeToLive = Infinity }) {
    encode(body, fields, Infinity);
    if (!(timeToLive >= 0)) throw new Error("timeToLive: must be a number of seconds, 0 or more");
    const names = [...this.#peers.keys()];
    if (!to && names.length > 1) throw new Error(`name the peer: one of ${names.join(", ")}`);
    if (to && !this.#peers.has(to)) throw new Error(`there is no peer named '${to}'`);
    const peer = this.#peers.get(to || (names[0] ?? ""));
    const queue = peer?.queue ?? this.#unaddressed;
    return new Promise((resolve) => {
      /** @type {ReturnType<typeof setTimeout> | undefined} */
      let timer;
      const settle = (/** @type {boolean} */ sent) => {
        clearTimeout(timer);
        resolve(sent);
      };
      queue.put({ body, fields, settle }, timeToLive);
      peer?.flush();
      // The queue itself drops what has expired when it is used again, which may be much later.
      if (timeToLive * 1000 < LONGEST_TIMER) timer = setTimeout(() => settle(false), timeToLive * 1000 + 1);
    });
  }

  /** @param {any} data @param {string} peer */
  #receive(data, peer) {
    const message = decode(data, peer);
    if (typeof message === "string") {
      console.warn(`rowe: ${peer} sent an invalid message: ${message}`);
      return;
    }
    if (message.inReplyTo !== undefined) {
      // Nobody waits any more for a reply that comes too late.
      this.#replies.get(message.inReplyTo)?.(message);
      return;
    }
    if (this.#incoming.length >= CAPACITY) this.#incoming.take();
    this.#incoming.put(message, message.timeToLive);
    for (const wake of [...this.#waiting]) wake();
  }
}

/** @param {Message} request */
function replyTo({ messageId }) {
  if (messageId === undefined) throw new Error("the request has no message_id, so it expects no reply");
  return { in_reply_to: messageId };
}

/** A random id. `crypto.randomUUID` exists on secure origins only. */
function randomId() {
  return [...crypto.getRandomValues(new Uint8Array(16))].map((byte) => byte.toString(16).padStart(2, "0")).join("");
}
