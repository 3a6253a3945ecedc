// @ts-check
// A connection to a gateway, which is opened again when it is lost.

import { now } from "../../protocol.js";
import { peopleOf } from "../../gateway/people.js";
import { PROTOCOL, parse } from "../../gateway/wire.js";
import { place } from "../../place.js";
import { Clock } from "./clock.js";
import { Exchange } from "./exchange.js";

/** @import { Participant } from "../../participant/participant.js" */
/** @import { MessageType } from "../../protocol.js" */
/** @import { FromGateway, Socket, ToGateway } from "../../gateway/orders.js" */

// The time until the next try (ms): doubled each time, and a little random, so that a class does not return at once.
const FIRST = 500;
const LONGEST = 30_000;
// The gateway is asked for its time this often. After LATE without an answer, the visitor is told; after SILENCE, the
// connection is lost (ms). TCP brings a connection back that was cut for 10 s, and nothing of it is lost.
const PING = 500;
const LATE = 1500;
const SILENCE = 15_000;
// A server that does not say welcome in this time is no gateway (ms).
const WELCOME = 10_000;

export class Connection {
  #graph;
  #order;
  #tell;
  /** The gateway replaces the lost connection of the same page. Pages from plain http have no randomUUID. */
  #page = crypto.getRandomValues(new Uint32Array(4)).join("-");
  /** @type {Socket | undefined} */
  #socket;
  /** @type {Exchange | undefined} */
  #exchange;
  #clock;
  #wait = FIRST;
  #heard = 0;
  #asked = 0;
  /** Whether the visitor was told that the gateway does not answer. */
  #late = false;
  #closed = false;
  /** Which of those who are there this page is, and the time of the gateway minus that of the page (ms). */
  #you = 0;
  #ahead = 0;
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

  /** Tell the gateway of types that it has asked for. @param {Record<string, MessageType>} types */
  describe(types) {
    this.#send({ op: "types", types });
  }

  /** Leave for good. */
  close() {
    this.#closed = true;
    clearTimeout(this.#timer);
    this.#drop();
  }

  #open() {
    this.#tell({ op: "state", state: "connecting" });
    this.#heard = now();
    this.#timer = setTimeout(() => this.#lose(""), WELCOME);
    const socket = new WebSocket(this.#order.address, PROTOCOL);
    socket.binaryType = "arraybuffer";
    let isOpen = false;
    // A server that does not know the protocol refuses the connection, or has none.
    socket.onopen = () => {
      isOpen = true;
      if (socket.protocol !== PROTOCOL) this.#translate(socket);
    };
    this.#listen(socket);
    socket.onclose = ({ reason }) => (isOpen ? this.#lose(reason) : this.#openPlain());
  }

  /** The server may speak rosbridge, if there is one. */
  #openPlain() {
    const socket = new WebSocket(this.#order.address);
    socket.onopen = () => this.#translate(socket);
    socket.onclose = ({ reason }) => this.#lose(reason);
    this.#socket = socket;
  }

  /** Let a server that speaks rosbridge be a gateway. @param {WebSocket} socket that is open */
  async #translate(socket) {
    const { Bridge } = await import(place("rosbridge/robot/bridge.js"));
    if (this.#socket !== socket) return;
    const bridge = new Bridge(socket);
    this.#listen(bridge);
    bridge.onclose = (/** @type {{reason: string}} */ { reason }) => this.#lose(reason);
  }

  /** @param {Socket} socket */
  #listen(socket) {
    this.#socket = socket;
    socket.onmessage = ({ data }) => {
      this.#heard = now();
      if (this.#late) this.#recover();
      if (typeof data === "string") this.#receive(parse(data));
      else this.#exchange?.deliver(data);
    };
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
      case "describe":
        this.#tell({ op: "describe", types: textsOf(message.types) });
        break;
      case "note":
        this.#tell({ op: "note", name: String(message.name), reason: String(message.reason) });
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
      case "people":
        this.#tell({ op: "people", people: peopleOf(message, this.#you, this.#ahead) });
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
    this.#you = Number(message.you);
    this.#ahead = Number.isFinite(message.time) ? message.time - now() : 0;
    const { connect, hashes } = this.#order;
    this.#exchange = new Exchange(this.#graph, /** @type {Socket} */ (this.#socket), connect, hashes, this.#tell);
    this.#tell({
      op: "joined", rmw: String(message.rmw), domain: message.domain === null ? null : Number(message.domain),
      distribution: String(message.distribution ?? ""),
    });
    this.#tell({ op: "until", seconds: typeof message.until === "number" ? message.until : null });
    this.#tell({ op: "state", state: "connected" });
    this.#ping();
    this.#exchange.turn();
  }

  #ping() {
    const silent = now() - this.#heard;
    // After a pause of this worker, answers may be there that it has not taken yet.
    const isAwake = now() - this.#asked < LATE;
    if (isAwake && silent > SILENCE) {
      this.#lose("");
      return;
    }
    if (isAwake && silent > LATE && !this.#late) {
      this.#late = true;
      this.#exchange?.hold();
      this.#tell({ op: "state", state: "late" });
    }
    this.#asked = now();
    this.#send({ op: "ping", id: 1, sent: now() });
    this.#timer = setTimeout(() => this.#ping(), PING);
  }

  /** The gateway answers again. */
  #recover() {
    this.#late = false;
    this.#exchange?.release();
    this.#tell({ op: "state", state: "connected" });
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
    this.#late = false;
    const socket = this.#socket;
    this.#socket = undefined;
    if (socket) {
      socket.onclose = socket.onmessage = null;
      if (socket instanceof WebSocket) socket.onopen = null;
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

/** @param {unknown} value @returns {string[]} */
function textsOf(value) {
  return Array.isArray(value) ? value.filter((one) => typeof one === "string") : [];
}

/** @param {unknown} value */
function seconds(value) {
  return typeof value === "number" ? value : null;
}
