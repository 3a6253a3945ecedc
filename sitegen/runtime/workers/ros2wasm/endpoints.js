// @ts-check
// The endpoints of a script in the graph. The script has its messages in YAML, the graph in CDR.

import { Codec } from "../../messages/codec.js";
import { isPlain, toYaml } from "../../messages/yaml.js";
import { fromYaml } from "../../messages/yamlReader.js";
import { DEFAULT_QOS } from "../../protocol.js";
import { topicsOf } from "./names.js";

/** @import { MessageType, Qos } from "../../protocol.js" */
/** @import { Participant } from "../../participant/participant.js" */
/** @import { Complaints } from "./complaints.js" */

/**
 * An endpoint as its script sees it. `send` sends a message that the script published on one of the topics `out`;
 * `take` returns the oldest message for the topics `in`, or undefined. `look` is called after changes of the graph.
 * @typedef {{id: number, out: string[], in: string[], send(yaml: string): void,
 *   take(): string | undefined, look(): void}} Endpoint
 * @typedef {"publisher" | "subscription" | "service" | "client"} Kind
 */

// The protocol of ROS2WASM has no QoS. Offering the default and requesting best effort is compatible with most others.
// The default depth is that of ROS2WASM's queues.
/** @type {Record<Kind, Qos>} */
const QOS = {
  publisher: DEFAULT_QOS,
  subscription: { ...DEFAULT_QOS, reliable: false },
  service: DEFAULT_QOS,
  client: DEFAULT_QOS,
};
const NONE = () => undefined;

export class Endpoints {
  #participant;
  #types;
  #codec;
  #complaints;

  /**
   * @param {Participant} participant @param {Record<string, MessageType>} types
   * @param {Complaints} complaints
   */
  constructor(participant, types, complaints) {
    this.#participant = participant;
    this.#types = types;
    this.#codec = new Codec(types);
    this.#complaints = complaints;
  }

  /** @param {Kind} kind @param {string} node @param {string} name @param {string} type @returns {Endpoint} */
  create(kind, node, name, type) {
    const id = this.#participant.create(kind, node, name, type, QOS[kind]);
    switch (kind) {
      case "publisher":
        return this.#publisher(id, name, type);
      case "subscription": {
        const take = () => this.#toText(name, type, this.#participant.take(id)?.message);
        return { id, out: [], in: [name], send: NONE, take, look: NONE };
      }
      case "service":
        return this.#service(id, name, type);
      case "client":
        return this.#client(id, name, type);
    }
  }

  /** @param {number} id @param {string} name @param {string} type @returns {Endpoint} */
  #publisher(id, name, type) {
    const send = (/** @type {string} */ yaml) => {
      const bytes = this.#toBytes(name, type, yaml);
      if (!bytes) return;
      this.#participant.publish(id, bytes);
      this.#participant.flush();
    };
    return { id, out: [name], in: [], send, take: NONE, look: NONE };
  }

  /**
   * The script does not say which request it answers. So it gets the next request only after it has answered the last
   * one.
   * @param {number} id @param {string} name @param {string} type @returns {Endpoint}
   */
  #service(id, name, type) {
    /** @type {import("../../participant/queue.js").Received | undefined} */
    let asked;
    return {
      id,
      out: topicsOf(name, false),
      in: topicsOf(name, true),
      take: () => {
        if (asked) return undefined;
        asked = this.#participant.take(id);
        const text = this.#toText(name, `${type}_Request`, asked?.message);
        if (text === undefined) asked = undefined;
        return text;
      },
      send: (yaml) => {
        if (!asked) {
          this.#complaints.add(`answer ${name}`, `answered on ${name} without a request`);
          return;
        }
        const { writer, sequence } = asked;
        asked = undefined;
        const bytes = this.#toBytes(name, `${type}_Response`, yaml);
        if (!bytes) return;
        this.#participant.respond(id, writer, sequence, bytes);
        this.#participant.flush();
      },
      look: NONE,
    };
  }

  /**
   * The script does not check for a server, so requests wait for one.
   * @param {number} id @param {string} name @param {string} type @returns {Endpoint}
   */
  #client(id, name, type) {
    /** @type {Uint8Array[]} */
    const waiting = [];
    const look = () => {
      if (waiting.length === 0 || this.#participant.matched(id) === 0) return;
      for (const bytes of waiting.splice(0)) this.#participant.request(id, bytes);
      this.#participant.flush();
    };
    return {
      id,
      out: topicsOf(name, true),
      in: topicsOf(name, false),
      take: () => this.#toText(name, `${type}_Response`, this.#participant.take(id)?.message),
      send: (yaml) => {
        const bytes = this.#toBytes(name, `${type}_Request`, yaml);
        if (!bytes) return;
        waiting.push(bytes);
        if (waiting.length > DEFAULT_QOS.depth) waiting.shift();
        look();
      },
      look,
    };
  }

  /** @param {string} name @param {string} type @param {string} yaml */
  #toBytes(name, type, yaml) {
    try {
      return this.#codec.write(type, read(yaml, type, this.#types));
    } catch (error) {
      const what = error instanceof Error ? error.message : error;
      this.#complaints.add(
        `yaml ${type} ${name}`,
        `sent an invalid ${type} on ${name}: ${what}; check the type that site.yaml gives ${name}`,
      );
      return undefined;
    }
  }

  /** @param {string} name @param {string} type @param {Uint8Array} [bytes] */
  #toText(name, type, bytes) {
    if (!bytes) return undefined;
    try {
      return toYaml(this.#codec.read(type, bytes), type, this.#types, Infinity, quote);
    } catch (error) {
      const what = error instanceof Error ? error.message : error;
      this.#complaints.add(`cdr ${name}`, `cannot read a message on ${name} as ${type}: ${what}`);
      return undefined;
    }
  }
}

/**
 * Parse YAML in which line ends may have been replaced by ", ", as in the pages of ROS2WASM. This misreads texts of
 * such messages that contain ", " themselves.
 * @param {string} yaml @param {string} type @param {Record<string, MessageType>} types
 */
function read(yaml, type, types) {
  try {
    return fromYaml(yaml, type, types);
  } catch (error) {
    if (yaml.includes("\n") || !yaml.includes(", ")) throw error;
    try {
      return fromYaml(yaml.replaceAll(", ", "\n"), type, types);
    } catch {
      throw error;
    }
  }
}

/**
 * Format a text without ", ", which scripts replace by a line end. In double quotes, the space has an escape sequence
 * that is valid in YAML and JSON.
 * @param {string} text
 */
function quote(text) {
  if (isPlain(text) && !text.includes(", ")) return text;
  const valid = text.replace(/\p{Surrogate}/gu, "\ufffd");
  return JSON.stringify(valid).replaceAll(", ", ",\\u0020");
}
