// @ts-check
// JSON objects over WebSocket, for programs without ROS: messages that expire, and remote calls. Runs in browsers and,
// with a WebSocket class, in Node. docs/rowe.md describes it.

import { ExpiringQueue, TICK } from "./expiringQueue.js";
import { decode, encode } from "./message.js";
import { Peer } from "./peer.js";

/** @import { Message } from "./message.js" */
/** @import { Outgoing } from "./peer.js" */

// Seconds between attempts to connect, the last repeated.
const PAUSES = [0.1, 0.2, 0.5, 1, 2, 5];
// Timers of browsers are at most this long (ms).
const LONGEST_TIMER = 2 ** 31 - 1;

export class Endpoint {
  /** @type {Map<string, Peer>} */
  #peers = new Map();
  /** Messages to "the" peer, before there is one. @type {ExpiringQueue<Outgoing>} */
  #unaddressed = new ExpiringQueue(({ settle }) => settle(false));
  /** @type {ExpiringQueue<Message>} */
  #incoming = new ExpiringQueue();
  /** Calls of `receive` that wait. @type {Set<() => void>} */
  #waiting = new Set();
  /** @type {Map<string, {peer: string, resolve: (message: Message) => void, reject: (error: Error) => void}>} */
  #replies = new Map();
  /** @type {Map<string, ReturnType<typeof setTimeout>>} */
  #attempts = new Map();
  #WebSocket;
  #closed = false;
  /** Called at the end of `close`. */
  closing = () => {};

  /** @param {{WebSocket?: any}} [options] the class of sockets, where there is no global one */
  constructor({ WebSocket = globalThis.WebSocket } = {}) {
    this.#WebSocket = WebSocket;
  }

  /** The names of the peers that are connected now. */
  peers() {
    return [...this.#peers.values()].filter(({ connected }) => connected).map(({ name }) => name);
  }

  /**
   * Connect to a server, and again after a lost connection. Return the name of the peer.
   * @param {string} url @param {string} [name]
   */
  connect(url, name = url) {
    if (!/^wss?:\/\/[^/]/.test(url)) throw new Error(`'${url}' is not the URL of a WebSocket; write it like 'ws://robot:9090/'`);
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
    socket.addEventListener("message", ({ data }) => this.#receive(data, peer));
    // Node's package ws ends the program for an error that nobody listens to; "close" follows.
    socket.addEventListener("error", () => {});
    socket.addEventListener("close", () => {
      this.#peers.delete(name);
      peer.close();
      this.#fail(name, `'${name}' left before it replied`);
    });
    peer.opened();
  }

  /**
   * Send a message. Resolve with true when it was handed to the connection, and with false when it was discarded,
   * because its time to live (seconds) is over or its peer is gone. Reject if the message is invalid, the queue is
   * full, or `to` does not name a peer.
   * @param {Record<string, any>} body @param {number} [ttl] @param {{to?: string}} [options]
   */
  async send(body, ttl, { to } = {}) {
    return this.#send(body, {}, ttl, to);
  }

  /**
   * Queue a message to be sent. Throws what `send` rejects with.
   * @param {Record<string, any>} body @param {number} [ttl] @param {{to?: string}} [options]
   */
  asyncSend(body, ttl, { to } = {}) {
    this.#send(body, {}, ttl, to);
  }

  /**
   * Queue a message for each connected peer, and return their names. A peer whose queue is full does not get it.
   * @param {Record<string, any>} body @param {number} [ttl]
   */
  broadcast(body, ttl) {
    encode(body, {});
    return this.peers().filter((name) => {
      try {
        this.#send(body, {}, ttl, name);
      } catch {
        this.#peers.get(name)?.note("does not read, so it misses broadcasts");
        return false;
      }
      return true;
    });
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
   * Send a request and resolve with the reply. Reject if there is none within `timeout` seconds, or if the peer, which
   * had connected to this endpoint, left.
   * @param {Record<string, any>} body @param {number} [timeout] @param {{to?: string}} [options]
   * @returns {Promise<Message>}
   */
  async invoke(body, timeout = 5, { to } = {}) {
    const id = randomId();
    /** @type {ReturnType<typeof setTimeout> | undefined} */
    let timer;
    try {
      return await new Promise((resolve, reject) => {
        const peer = to ?? [...this.#peers.keys()][0] ?? "";
        this.#replies.set(id, { peer, resolve, reject });
        if (timeout * 1000 < LONGEST_TIMER) {
          timer = setTimeout(() => reject(new Error(`no reply within ${timeout} s`)), timeout * 1000);
        }
        this.#send(body, { message_id: id }, timeout, to);
      });
    } finally {
      clearTimeout(timer);
      this.#replies.delete(id);
    }
  }

  /**
   * Reply to a request. Resolve as `send` does, with false if the peer is gone.
   * @param {Message} request @param {Record<string, any>} body @param {number} [ttl]
   */
  async reply(request, body, ttl) {
    const fields = replyTo(request);
    return this.#peers.has(request.peer) && this.#send(body, fields, ttl, request.peer);
  }

  /**
   * Queue a reply to a request. Throws what `reply` rejects with.
   * @param {Message} request @param {Record<string, any>} body @param {number} [ttl]
   */
  asyncReply(request, body, ttl) {
    const fields = replyTo(request);
    if (this.#peers.has(request.peer)) this.#send(body, fields, ttl, request.peer);
  }

  /** Close all connections. What waits to be sent is discarded. */
  close() {
    this.#closed = true;
    for (const timer of this.#attempts.values()) clearTimeout(timer);
    for (const peer of this.#peers.values()) {
      peer.close();
      peer.socket?.close();
    }
    this.#unaddressed.clear();
    this.#fail(undefined, "the endpoint was closed");
    for (const wake of [...this.#waiting]) wake();
    this.closing();
  }

  /** Whether there is a peer of this name, connected or not. @param {string} name */
  knows(name) {
    return this.#peers.has(name);
  }

  /** @param {string} name */
  #add(name) {
    if (this.#peers.has(name)) throw new Error(`there is a peer named '${name}' already`);
    const peer = new Peer(name);
    this.#peers.set(name, peer);
    for (let taken; (taken = this.#unaddressed.take());) peer.queue.put(taken.item, taken.left, taken.item.text.length);
    return peer;
  }

  /** @param {string} url @param {Peer} peer @param {number} attempt */
  #connect(url, peer, attempt) {
    /** @type {WebSocket} */
    const socket = new this.#WebSocket(url);
    peer.socket = socket;
    let begun = Infinity;
    const longest = PAUSES[Math.min(attempt, PAUSES.length - 1)] ?? 5;
    socket.addEventListener("open", () => {
      begun = performance.now();
      peer.opened();
    });
    socket.addEventListener("message", ({ data }) => this.#receive(data, peer));
    // Node's package ws ends the program for an error that nobody listens to; "close" follows.
    socket.addEventListener("error", () => {});
    socket.addEventListener("close", () => {
      if (this.#closed) return;
      if (begun === Infinity) peer.note("no connection, trying again");
      // A server that accepts and leaves at once is asked less and less often, too.
      const next = performance.now() - begun > longest * 1000 ? 0 : attempt;
      const pause = PAUSES[Math.min(next, PAUSES.length - 1)] ?? 5;
      // Programs that lost the same server do not all come back in the same instant.
      const wait = pause * 1000 * (0.75 + Math.random() / 4);
      this.#attempts.set(peer.name, setTimeout(() => this.#connect(url, peer, next + 1), wait));
    });
  }

  /**
   * @param {Record<string, any>} body @param {Record<string, string>} fields
   * @param {number} ttl @param {string} to @returns {Promise<boolean>}
   */
  #send(body, fields, ttl = Infinity, to = "") {
    const text = encode(body, fields);
    if (this.#closed) throw new Error("the endpoint is closed");
    if (!(ttl >= 0)) throw new Error("ttl: must be a number of seconds, 0 or more");
    if (!to && this.#peers.size > 1) throw new Error(`name the peer: one of ${[...this.#peers.keys()].join(", ")}`);
    const peer = to ? this.#peers.get(to) : [...this.#peers.values()][0];
    if (to && !peer) throw new Error(`there is no peer named '${to}'`);
    const queue = peer?.queue ?? this.#unaddressed;
    queue.check(text.length);
    return new Promise((resolve) => {
      /** @type {ReturnType<typeof setTimeout> | undefined} */
      let timer;
      const settle = (/** @type {boolean} */ sent) => {
        clearTimeout(timer);
        resolve(sent);
      };
      queue.put({ text, settle }, ttl, text.length);
      // Only the queue knows whether it was sent: it drops what has expired whenever it is used.
      if (ttl * 1000 < LONGEST_TIMER) timer = setTimeout(() => this.#expire(), ttl * 1000 + TICK);
      peer?.flush();
    });
  }

  /** Let queues drop what has expired. */
  #expire() {
    for (const queue of [this.#unaddressed, ...[...this.#peers.values()].map((peer) => peer.queue)]) void queue.length;
  }

  /** End the calls that wait for a peer, or for all of them. @param {string | undefined} name @param {string} reason */
  #fail(name, reason) {
    for (const { peer, reject } of this.#replies.values()) {
      if (name === undefined || peer === name) reject(new Error(reason));
    }
  }

  /** @param {any} data @param {Peer} peer */
  #receive(data, peer) {
    const message = decode(data, peer.name);
    if (typeof message === "string") {
      peer.refuse(message);
    } else if (message.inReplyTo !== undefined) {
      const waiting = this.#replies.get(message.inReplyTo);
      if (waiting) waiting.resolve(message);
      else peer.note("sent a reply that nobody waits for, or that came too late");
    } else {
      while (!this.#incoming.hasRoom(data.length) && this.#incoming.take()) {
        peer.note("messages come faster than they are received, so the oldest are discarded");
      }
      this.#incoming.put(message, message.timeToLive, data.length);
      for (const wake of [...this.#waiting]) wake();
    }
  }
}

/**
 * Return an endpoint that connects to a server, and again after a lost connection.
 * @param {string} host @param {number} port @param {{WebSocket?: any}} [options]
 */
export function openRemoteEndpoint(host, port, options) {
  const endpoint = new Endpoint(options);
  endpoint.connect(`ws://${host.includes(":") ? `[${host}]` : host}:${port}/`);
  return endpoint;
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
