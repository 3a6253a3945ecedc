// @ts-check
// A transport of roslib 2 to the graph of the page: messages are handed over as objects, without a socket.

import { pageRos } from "../client/page.js";
import { Session } from "./session.js";

/** @typedef {"open" | "close" | "error" | "message"} Kind */

class Transport {
  /** @type {Record<Kind, Set<(event: any) => void>>} */
  #listeners = { open: new Set(), close: new Set(), error: new Set(), message: new Set() };
  /** @type {Session | undefined} */
  #session;
  /** @type {"connecting" | "open" | "closed"} */
  #state = "connecting";

  /** @param {Kind} kind @param {(event: any) => void} listener */
  on(kind, listener) {
    this.#listeners[kind]?.add(listener);
    return this;
  }

  /** @param {Kind} kind @param {(event: any) => void} listener */
  off(kind, listener) {
    this.#listeners[kind]?.delete(listener);
    return this;
  }

  open() {
    if (this.#state !== "connecting") return;
    // What the client hears never comes from within its own call, as with a socket.
    this.#session = new Session(pageRos(), ({ message }) => queueMicrotask(() => {
      if (this.#state === "open") this.#emit("message", message);
    }));
    this.#state = "open";
    this.#emit("open", new Event("open"));
  }

  /** @param {any} message */
  send(message) {
    if (this.#state !== "open") throw new Error("the connection is not open");
    this.#session?.receive(message);
  }

  close() {
    if (this.#state === "closed") return;
    this.#state = "closed";
    this.#session?.close();
    setTimeout(() => this.#emit("close", new Event("close")));
  }

  isConnecting() {
    return this.#state === "connecting";
  }

  isOpen() {
    return this.#state === "open";
  }

  isClosing() {
    return false;
  }

  isClosed() {
    return this.#state === "closed";
  }

  /** @param {Kind} kind @param {any} event */
  #emit(kind, event) {
    for (const listener of [...this.#listeners[kind]]) listener(event);
  }
}

/**
 * The `transportFactory` of roslib 2: `new Ros({ transportFactory })`, then `connect("page:")`. The address means nothing.
 * @returns {Promise<Transport>}
 */
export async function transportFactory() {
  const transport = new Transport();
  // roslib listens only after it has got the transport.
  setTimeout(() => transport.open());
  return transport;
}
