// @ts-check
// A node of the page itself in the graph: topics and services as JavaScript functions and objects.

import { BUDGETS } from "../budgets.js";
import { PAGE_NODE } from "../graphNames.js";
import { NodeClient } from "../participant/nodeClient.js";
import { Participant } from "../participant/participant.js";
import { DEFAULT_QOS } from "../protocol.js";
import { join } from "./companion.js";

// Only pages with panels need it, too.
export { addFullScreen } from "../ui/fullScreen.js";

/** @import { Graph } from "./graph.js" */
/** @import { Companion, MessageType } from "../protocol.js" */

export class PageClient extends NodeClient {
  #graph;
  #id;

  /**
   * @param {Graph} graph @param {Record<string, MessageType>} types
   * @param {string} [node] its name; without one, it is the page's hidden node
   */
  constructor(graph, types, node = "") {
    /** @type {Participant} */
    let participant;
    const id = graph.join((message) => participant.receive(message), "", (text) => console.warn(`the page ${text}`));
    participant = new Participant(id, (message) => graph.receive(id, message), false, BUDGETS.frame);
    super(participant, node || PAGE_NODE, types);
    if (node) participant.create("node", node, "", "", DEFAULT_QOS);
    this.#graph = graph;
    this.#id = id;
  }

  /** Return another node of the page in the graph. @param {string} name */
  node(name) {
    return new PageClient(this.#graph, this.types, name);
  }

  /** Leave the graph. */
  leave() {
    super.leave();
    this.#graph.leave(this.#id);
  }

  /**
   * Start a worker of the runtime that takes part in the graph, such as the player of a bag.
   * @param {string} file of the worker, below workers/ @param {(message: any) => void} told called with what it tells
   * @param {(error: string) => void} failed called when it has ended by an error @returns {Companion}
   */
  join(file, told, failed) {
    return join(this.#graph, file, told, failed);
  }
}
