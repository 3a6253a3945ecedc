// @ts-check
// One session with a gateway: what each side is told of the other, and the messages between them.

import { recordSize, splitGid } from "../../protocol.js";
import { Scope } from "../../gateway/names.js";
import { deliverFrame, endpointsOf, Frames, idsOf, LATCHED, typesOf } from "../../gateway/wire.js";
import { Owns } from "./owns.js";
import { Remotes } from "./remotes.js";

/** @import { Participant } from "../../participant/participant.js" */
/** @import { Head } from "../../protocol.js" */
/** @import { Connect, FromGateway, Socket } from "../../gateway/orders.js" */

// While more than this waits to be sent (bytes), the page's nodes wait, as for any slow subscription.
const FULL = 4 * 1024 * 1024;
// The gateway hears what was taken after this much, or this time (ms).
const CREDIT = { records: 500, bytes: 1024 * 1024, pause: 20 };

export class Exchange {
  #socket;
  #owns;
  #remotes;
  #frames;
  #taken = { records: 0, bytes: 0 };
  /** @type {ReturnType<typeof setTimeout> | undefined} */
  #credit;
  /** @type {ReturnType<typeof setTimeout> | undefined} */
  #later;
  #closed = false;
  #tell;

  /**
   * @param {Participant} graph @param {Socket} socket @param {Connect} connect
   * @param {Record<string, string>} hashes of the page's types @param {(message: FromGateway) => void} tell
   */
  constructor(graph, socket, connect, hashes, tell) {
    this.#socket = socket;
    this.#tell = tell;
    const say = (/** @type {object} */ message) => socket.send(JSON.stringify(message));
    this.#frames = new Frames((frame) => socket.send(frame));
    const send = (/** @type {Head} */ head, /** @type {Uint8Array} */ message) => this.#frames.add(head, message);
    const scope = new Scope(connect);
    const ways = { say, send, tell, flush: () => this.#frames.flush() };
    this.#owns = new Owns(graph, scope, hashes, ways);
    this.#remotes = new Remotes(graph, scope, hashes, this.#owns, ways);
  }

  /** Exchange what has come, after the graph has woken up. */
  turn() {
    if (this.#closed || this.#socket.readyState !== WebSocket.OPEN) return;
    this.#owns.announce((gid) => this.#remotes.has(splitGid(gid).peer));
    this.#remotes.look();
    if (this.#owns.late) return;
    if (this.#socket.bufferedAmount > FULL) {
      this.#later ??= setTimeout(() => {
        this.#later = undefined;
        this.turn();
      }, CREDIT.pause);
      return;
    }
    this.#take();
  }

  /** The gateway does not answer: messages wait. */
  hold() {
    this.#owns.late = true;
  }

  /** It answers again. */
  release() {
    this.#take();
    this.#owns.late = false;
  }

  #take() {
    this.#owns.take();
    this.#remotes.take();
    this.#frames.flush();
  }

  /** Handle a message of the gateway. @param {any} message */
  receive(message) {
    if (message.op === "graph") {
      this.#remotes.change(endpointsOf(message.come), idsOf(message.gone));
    } else if (message.op === "types") {
      this.#tell({ op: "types", types: typesOf(message.types) });
      this.#remotes.learn();
    } else if (message.op === "open" || message.op === "close") {
      this.#owns.collect(message.id, message.op === "open");
    }
    this.turn();
  }

  /** The gateway does not take an endpoint. @param {number} id @param {string} reason */
  refuse(id, reason) {
    this.#owns.refuse(id, reason);
  }

  /** Handle a frame of the gateway. @param {ArrayBuffer} frame */
  deliver(frame) {
    deliverFrame(frame, (head, message) => {
      if (head.writer === 0) {
        this.#owns.ask(head.reader, head.sequence, message);
      } else if (this.#remotes.serves(head.writer)) {
        this.#remotes.respond(head.sequence, message);
      } else {
        this.#remotes.publish(head.writer, message, head.reader === LATCHED);
        this.#taken.records += 1;
        this.#taken.bytes += recordSize(message.length);
      }
    });
    this.#give();
    this.turn();
  }

  close() {
    this.#closed = true;
    clearTimeout(this.#credit);
    clearTimeout(this.#later);
    this.#owns.close();
    this.#remotes.close();
  }

  /** Tell the gateway what was taken, many messages at once. */
  #give() {
    const { records, bytes } = this.#taken;
    if (records === 0) return;
    if (records < CREDIT.records && bytes < CREDIT.bytes) {
      this.#credit ??= setTimeout(() => {
        this.#credit = undefined;
        this.#pay();
      }, CREDIT.pause);
      return;
    }
    this.#pay();
  }

  #pay() {
    const { records, bytes } = this.#taken;
    this.#taken = { records: 0, bytes: 0 };
    if (records === 0 || this.#socket.readyState !== WebSocket.OPEN) return;
    this.#socket.send(JSON.stringify({ op: "credit", records, bytes }));
  }
}
