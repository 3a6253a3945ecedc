// @ts-check
// A node of a program in JavaScript: one of several in its worker.

import { NodeClient } from "../../participant/nodeClient.js";
import { DEFAULT_QOS } from "../../protocol.js";

/** @import { Endpoint, MessageType, Qos } from "../../protocol.js" */
/** @import { Participant } from "../../participant/participant.js" */

export class OwnNode extends NodeClient {
  /** Its endpoints: others of the program may have the same name. @type {Set<number>} */
  #ids = new Set();

  /** @param {Participant} participant @param {string} name @param {Record<string, MessageType>} types */
  constructor(participant, name, types) {
    super(participant, name, types);
    this.create("node", "", "", DEFAULT_QOS);
  }

  /** @param {Endpoint["kind"]} kind @param {string} name @param {string} type @param {Qos} qos */
  create(kind, name, type, qos) {
    const id = super.create(kind, name, type, qos);
    this.#ids.add(id);
    return id;
  }

  /** @param {number} id of an endpoint */
  destroy(id) {
    super.destroy(id);
    this.#ids.delete(id);
  }

  /** Leave the graph, with all that the node has there. */
  leave() {
    super.leave();
    for (const id of this.#ids) this.destroy(id);
  }
}
