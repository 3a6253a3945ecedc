// @ts-check
// A node of a program in JavaScript: one of several in its worker.

import { NodeClient } from "../../participant/nodeClient.js";
import { DEFAULT_QOS } from "../../protocol.js";

/** @import { MessageType } from "../../protocol.js" */
/** @import { Participant } from "../../participant/participant.js" */

export class OwnNode extends NodeClient {
  #participant;
  #name;

  /** @param {Participant} participant @param {string} name @param {Record<string, MessageType>} types */
  constructor(participant, name, types) {
    super(participant, name, types);
    this.#participant = participant;
    this.#name = name;
    participant.create("node", name, "", "", DEFAULT_QOS);
  }

  /** Leave the graph, with all that the node has there. */
  leave() {
    super.leave();
    for (const { gid, endpoint } of this.#participant.look() ?? []) {
      if (endpoint.node === this.#name && this.#participant.gid(endpoint.id) === gid) this.#participant.destroy(endpoint.id);
    }
  }
}
