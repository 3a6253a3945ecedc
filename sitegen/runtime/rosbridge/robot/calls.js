// @ts-check
// Calls of the robot's services. rosbridge_server handles what a connection sends in order, and waits for each answer:
// so calls have connections of their own, on which nothing else waits.

import { Mistake } from "../mistake.js";
import { parseJson, writeJson } from "./numbers.js";

/** @typedef {{socket: WebSocket, ready: Promise<void>}} Line a connection that carries one call at a time */

// Connections at once; further calls wait.
const MOST = 24;
// Calls that wait for a connection.
const WAITING = 1000;

const SILENT = "there was no answer";
export const RESPONSE = "service_response";

/** Return the operation that calls a service. @param {string} service @param {object} [args] */
export function callOf(service, args = {}) {
  return { op: "call_service", service, args };
}

/** Return why a call failed. @param {unknown} values */
export function reasonOf(values) {
  return typeof values === "string" && values ? values.slice(0, 500) : "the robot does not say why it failed";
}

export class Calls {
  #address;
  #heard;
  #timeout;
  #patience;
  /** @type {Line[]} */
  #idle = [];
  /** All connections, and since when each is used, those with the oldest calls first. @type {Map<WebSocket, number>} */
  #open = new Map();
  /** @type {((line: Line) => void)[]} */
  #waiting = [];
  /** By the id of an operation that has no answer yet. @type {Map<string, WebSocket>} */
  #under = new Map();
  #closed = false;
  /** @type {ReturnType<typeof setTimeout> | undefined} */
  #timer;

  /**
   * @param {string} address @param {() => void} heard called when the server has sent something
   * @param {{timeout?: number, patience?: number}} [limits] `timeout` of each call (ms), and `patience` with a call that
   *   has no answer while others wait for its connection (ms)
   */
  constructor(address, heard, { timeout = Infinity, patience = Infinity } = {}) {
    this.#address = address;
    this.#heard = heard;
    this.#timeout = timeout;
    this.#patience = patience;
  }

  /**
   * Call a service and return its response, as JSON has it. Rejects with a Mistake if there is no answer.
   * @param {string} service @param {object} [args] @returns {Promise<any>}
   */
  async call(service, args = {}) {
    const { result, values } = await this.exchange(callOf(service, args), RESPONSE);
    if (result !== true) throw new Mistake(reasonOf(values));
    return values ?? {};
  }

  /**
   * Send an operation that has one answer, and return this. Rejects with a Mistake if the connection is lost, or too
   * much time has passed.
   * @param {{op: string, id?: string}} operation @param {string} answer its `op`
   * @param {(message: any) => void} [between] for the messages that come before @returns {Promise<any>}
   */
  async exchange(operation, answer, between) {
    const line = await this.#line();
    // An answer that comes later must not be taken for that of another call.
    const timer = this.#timeout < Infinity ? setTimeout(() => line.socket.close(), this.#timeout) : undefined;
    this.#open.delete(line.socket);
    this.#open.set(line.socket, performance.now());
    try {
      await line.ready;
      if (operation.id) this.#under.set(operation.id, line.socket);
      return await this.#answer(line.socket, operation, answer, between);
    } finally {
      clearTimeout(timer);
      if (operation.id) this.#under.delete(operation.id);
      this.#release(line);
    }
  }

  /** Send something on the connection of an operation that has no answer yet. @param {string} id @param {object} message */
  tell(id, message) {
    this.#under.get(id)?.send(writeJson(message));
  }

  close() {
    this.#closed = true;
    clearTimeout(this.#timer);
    for (const socket of this.#open.keys()) socket.close();
  }

  /** @returns {Promise<Line>} */
  async #line() {
    if (this.#closed) throw new Mistake("the connection has ended");
    for (let idle; (idle = this.#idle.pop());) {
      if (idle.socket.readyState === WebSocket.OPEN) return idle;
      this.#open.delete(idle.socket);
    }
    if (this.#open.size >= MOST) {
      if (this.#waiting.length >= WAITING) throw new Mistake("too many calls wait for an answer");
      return new Promise((resolve) => {
        this.#waiting.push(resolve);
        this.#hurry();
      });
    }
    return this.#opened();
  }

  /** Give up the oldest calls that have taken too long, while others wait for their connections. */
  #hurry() {
    clearTimeout(this.#timer);
    for (const [socket, since] of this.#open) {
      if (this.#waiting.length === 0) return;
      const left = since + this.#patience - performance.now();
      if (left > 0) {
        if (left < Infinity) this.#timer = setTimeout(() => this.#hurry(), left);
        return;
      }
      this.#open.delete(socket);
      socket.close();
      this.#waiting.shift()?.(this.#opened());
    }
  }

  /** @returns {Line} */
  #opened() {
    const socket = new WebSocket(this.#address);
    this.#open.set(socket, performance.now());
    return { socket, ready: new Promise((resolve, reject) => {
      socket.onopen = () => resolve();
      socket.onclose = () => reject(new Mistake(SILENT));
    }) };
  }

  /** @param {Line} line */
  #release(line) {
    const { socket } = line;
    socket.onmessage = socket.onclose = null;
    // The place of a call that was given up has been taken.
    if (this.#closed || !this.#open.has(socket)) return;
    const next = this.#waiting.shift();
    if (socket.readyState === WebSocket.OPEN) {
      if (next) next(line);
      else this.#idle.push(line);
      return;
    }
    this.#open.delete(socket);
    next?.(this.#opened());
  }

  /**
   * @param {WebSocket} socket @param {object} operation @param {string} answer
   * @param {((message: any) => void)} [between] @returns {Promise<any>}
   */
  #answer(socket, operation, answer, between) {
    return new Promise((resolve, reject) => {
      socket.onclose = () => reject(new Mistake(SILENT));
      socket.onmessage = ({ data }) => {
        this.#heard();
        const message = typeof data === "string" ? parseJson(data) : undefined;
        if (message?.op === answer) resolve(message);
        else if (message) between?.(message);
      };
      socket.send(writeJson(operation));
    });
  }
}
