// @ts-check
// A connection to a gateway, which is opened again when it is lost.

import { now } from "../../protocol.js";
import { PROTOCOL, parse } from "../../gateway/wire.js";
import { Clock } from "./clock.js";
import { Exchange } from "./exchange.js";

/** @import { Participant } from "../../participant/participant.js" */
/** @import { FromGateway, ToGateway } from "../../gateway/orders.js" */

// The time until the next try (ms): doubled each time, and a little random, so that a class does not return at once.
const FIRST = 500;
const LONGEST = 30_000;
// The gateway is asked for its time this often, and is lost if it is silent for so long (ms).
const PING = 3000;
const SILENCE = 9000;
// A server that does not say welcome in this time is no gateway (ms).
const WELCOME = 10_000;

export class Connection {
  #graph;
  #order;
  #tell;
  /** The gateway replaces the lost connection of the same page. */
  #page = crypto.randomUUID();
  /** @type {WebSocket | undefined} */
  #socket;
  /** @type {Exchange | undefined} */
  #exchange;
  #clock;
  #wait = FIRST;
  #heard = 0;
  #closed = false;
  /** @type {ReturnType<typeof setTimeout> | undefined} */
  #timer;

  /**
   * @param {Participant} graph @param {ToGateway & {op: "connect"}} order
   * @param {(message: FromGateway) => void} tell the page
   */
  constructor(graph, order, tell) {
    this.#graph = graph;
    this.#order = order;
    this.#tell = tell;
    this.#clock = new Clock((offset) => tell({ op: "clock", offset }));
    this.#open();
  }

  /** Exchange what has come, after the graph has woken up. */
  turn() {
    this.#exchange?.turn();
  }

  /** Leave for good. */
  close() {
    this.#closed = true;
    clearTimeout(this.#timer);
    this.#drop();
  }

  #open() {
    this.#tell({ op: "state", state: "connecting" });
    const socket = new WebSocket(this.#order.address, PROTOCOL);
    socket.binaryType = "arraybuffer";
    this.#socket = socket;
    this.#heard = now();
    socket.onmessage = ({ data }) => {
      this.#heard = now();
      if (typeof data === "string") this.#receive(parse(data));
      else this.#exchange?.deliver(data);
    };
    socket.onclose = ({ reason }) => this.#lose(reason);
    this.#timer = setTimeout(() => this.#lose(""), WELCOME);
  }

  /** @param {any} message */
  #receive(message) {
    switch (message?.op) {
      case "challenge":
        this.#introduce(message.keys === true);
        break;
      case "welcome":
        this.#welcome(message);
        break;
      case "refused":
        this.#exchange?.refuse(message.id, String(message.reason));
        break;
      case "ended":
        this.#end(this.#exchange ? "ended" : "refused", String(message.reason));
        break;
      case "pong":
        this.#clock.hear(Number(message.sent), Number(message.time));
        break;
      case "turn":
        this.#tell({
          op: "turn", now: String(message.now ?? ""), nowLeft: seconds(message.nowLeft), mineIn: seconds(message.mineIn),
          mineLeft: seconds(message.mineLeft),
        });
        break;
      case "until":
        this.#tell({ op: "until", seconds: Number(message.seconds) });
        break;
      default:
        this.#exchange?.receive(message ?? {});
    }
  }

  /** @param {boolean} keys whether the gateway asks for a key */
  #introduce(keys) {
    const { key } = this.#order;
    if (keys && !key) this.#end("key", "");
    else this.#send({ op: "hello", version: 1, page: this.#page, ...(keys ? { key } : {}) });
  }

  /** @param {any} message */
  #welcome(message) {
    if (this.#exchange) return;
    clearTimeout(this.#timer);
    this.#wait = FIRST;
    const { connect, hashes } = this.#order;
    this.#exchange = new Exchange(this.#graph, /** @type {WebSocket} */ (this.#socket), connect, hashes, this.#tell);
    this.#tell({
      op: "joined", rmw: String(message.rmw), domain: Number(message.domain),
      distribution: String(message.distribution ?? ""),
    });
    this.#tell({ op: "until", seconds: typeof message.until === "number" ? message.until : null });
    this.#tell({ op: "state", state: "connected" });
    this.#ping();
    this.#exchange.turn();
  }

  #ping() {
    if (now() - this.#heard > SILENCE) {
      this.#lose("");
      return;
    }
    this.#send({ op: "ping", id: 1, sent: now() });
    this.#timer = setTimeout(() => this.#ping(), PING);
  }

  /** The gateway lets the page go, and has said why. @param {"key" | "refused" | "ended"} state @param {string} reason */
  #end(state, reason) {
    this.close();
    this.#tell({ op: "state", state, reason });
  }

  /** @param {string} reason that the server gave, or nothing */
  #lose(reason) {
    if (this.#closed) return;
    this.#drop();
    const retry = this.#wait * (0.75 + Math.random() / 2);
    this.#wait = Math.min(this.#wait * 2, LONGEST);
    this.#tell({ op: "state", state: "lost", retry, reason });
    this.#timer = setTimeout(() => this.#open(), retry);
  }

  /** Remote nodes go with the connection. */
  #drop() {
    clearTimeout(this.#timer);
    const socket = this.#socket;
    this.#socket = undefined;
    if (socket) {
      socket.onclose = socket.onmessage = socket.onopen = null;
      socket.close();
    }
    this.#exchange?.close();
    this.#exchange = undefined;
    this.#tell({ op: "nodes", nodes: [] });
  }

  /** @param {object} message */
  #send(message) {
    if (this.#socket?.readyState === WebSocket.OPEN) this.#socket.send(JSON.stringify(message));
  }
}

/** @param {unknown} value */
function seconds(value) {
  return typeof value === "number" ? value : null;
}
