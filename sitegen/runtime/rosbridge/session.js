// @ts-check
// One client of rosbridge: the messages that it sends, and those for it.

import { Surroundings } from "../client/surroundings.js";
import { Actionlib } from "./actionlib.js";
import { Actions } from "./actions.js";
import { ActionServers } from "./actionServers.js";
import { Mistake, textOf } from "./mistake.js";
import { Fragments } from "./fragments.js";
import { LONGEST_ID, LONGEST_NAME, MOST_TEXT } from "./limits.js";
import { Republisher } from "./republisher.js";
import { Rosapi } from "./rosapi/rosapi.js";
import { Services } from "./services.js";
import { Topics } from "./topics.js";
import { Values } from "./values.js";

/** @import { Ros } from "../protocol.js" */
/**
 * @typedef {{message: any, compression: string, fragment: number}} Sent a message for the client; `compression` and
 *   `fragment`, the size of fragments, are as it asked
 */

const NODE = "/rosbridge";
const LEVELS = ["none", "error", "warning", "info"];

export class Session {
  #deliver;
  #closing = new AbortController();
  #fragments = new Fragments();
  #level = 1;
  /** @type {Record<string, (message: any) => void>} */
  #operations;
  signal = this.#closing.signal;

  /** @param {Ros} ros @param {(sent: Sent) => void} deliver */
  constructor(ros, deliver) {
    this.#deliver = deliver;
    this.graph = ros.graph;
    this.raw = ros.node(NODE);
    this.surroundings = new Surroundings(ros);
    this.values = new Values(this.raw.types);
    this.republisher = new Republisher(this.raw, this.surroundings);
    this.actionlib = new Actionlib(this);
    this.rosapi = new Rosapi(this);
    this.topics = new Topics(this);
    this.actions = new Actions(this);
    this.#operations = {
      ...this.topics.operations, ...new Services(this).operations, ...this.actions.operations,
      ...new ActionServers(this).operations,
      set_level: (message) => this.#setLevel(message),
      fragment: (message) => {
        const whole = this.#fragments.add(message);
        if (whole !== undefined) this.#take(whole, "fragment: ", message.id);
      },
      // There is nobody to convince.
      auth: () => {},
    };
  }

  /** Handle a message of the client: an object, or JSON. @param {unknown} message */
  receive(message) {
    if (!this.signal.aborted) this.#take(message);
  }

  /** @param {any} message @param {string} [compression] @param {unknown} [fragment] */
  send(message, compression = "none", fragment) {
    if (this.signal.aborted) return;
    const size = typeof fragment === "number" && fragment > 0 ? fragment : Infinity;
    this.#deliver({ message, compression, fragment: size });
  }

  /**
   * Tell the client something, if it wants to know.
   * @param {"error" | "warning" | "info"} level @param {string} msg @param {unknown} [id]
   */
  status(level, msg, id) {
    if (LEVELS.indexOf(level) > this.#level) return;
    this.send({ op: "status", level, msg, ...(isId(id) && id !== undefined && { id }) });
  }

  /** Forget the client: everything that it has in the graph is gone. */
  close() {
    if (this.signal.aborted) return;
    this.#closing.abort(new Error("the client is gone"));
    this.topics.close();
    this.actions.close();
    this.republisher.close();
    this.surroundings.close();
    this.raw.leave();
  }

  /** @param {unknown} given @param {string} [about] what it came in, if it came in parts @param {unknown} [id] of these */
  #take(given, about = "", id) {
    /** @type {any} */
    let message = { id };
    try {
      message = typeof given === "string" ? parsed(given) : given;
      this.#handle(message, about !== "");
    } catch (error) {
      const known = error instanceof Mistake || typeof message?.op === "string";
      const text = known ? textOf(error) : `the message could not be handled: ${textOf(error)}`;
      this.status("error", about + text, message?.id);
    }
  }

  /** @param {any} message @param {boolean} inside whether it came in fragments */
  #handle(message, inside) {
    if (typeof message !== "object" || message === null || typeof message.op !== "string") {
      throw new Mistake("a message is an object with a text 'op'");
    }
    const { op, id } = message;
    if (!isId(id)) {
      throw new Mistake(`${op.slice(0, 50)}: 'id' is a text of at most ${LONGEST_ID} characters, or a number`);
    }
    for (const key of ["topic", "service", "action", "type", "action_type"]) {
      if (message[key]?.length > LONGEST_NAME) throw new Mistake(`${op.slice(0, 50)}: '${key}' is too long`);
    }
    const handle = Object.hasOwn(this.#operations, op) ? this.#operations[op] : undefined;
    if (!handle || (inside && op === "fragment")) throw new Mistake(`unknown operation '${op.slice(0, 50)}'`);
    try {
      handle(message);
    } catch (error) {
      this.status("error", textOf(error).startsWith(op) ? textOf(error) : `${op}: ${textOf(error)}`, id);
    }
  }

  /** @param {any} message */
  #setLevel({ level }) {
    const found = LEVELS.indexOf(level);
    if (found < 0) throw new Mistake(`set_level: 'level' is one of ${LEVELS.join(", ")}`);
    this.#level = found;
  }
}

/** @param {string} text */
function parsed(text) {
  if (text.length > MOST_TEXT) throw new Mistake(`a message has at most ${MOST_TEXT} characters`);
  try {
    return JSON.parse(text);
  } catch {
    throw new Mistake("the message is not valid JSON");
  }
}

/** @param {unknown} id */
function isId(id) {
  return id === undefined || id === null || typeof id === "number" || (typeof id === "string" && id.length <= LONGEST_ID);
}
