// @ts-check
// The ROS graph of the page: all endpoints, which of them match, and which workers are linked. Messages do not pass
// through here; they travel through the ports that the graph gives to workers.

import { gidOf, incompatibility, sends } from "../protocol.js";
import { isEndpoint } from "./reports.js";

/** @import { Endpoint, FromWorker, Mismatch, ToWorker } from "../protocol.js" */

/**
 * @typedef {(message: ToWorker, transfer?: Transferable[]) => void} Post
 * @typedef {(text: string) => void} Complain
 * @typedef {{id: number, program: string, post: Post, complain: Complain,
 *   endpoints: Map<number, Endpoint>, missed: Map<number, number>, links: Set<number>,
 *   accused: Set<number>, looking: boolean}} Participant a worker, or the page; `looking` if it is told of the others'
 *   endpoints, and `accused` are the workers that it has complained about
 * @typedef {{owner: Participant, endpoint: Endpoint}} Member
 * @typedef {{senders: Set<Member>, receivers: Set<Member>}} Channel a topic with its publishers and
 *   subscriptions, or a service with its clients and servers
 */

// The longest complaint of one worker about another, in characters.
const COMPLAINT = 200;

/** Emits `change` after changes. */
export class Graph extends EventTarget {
  /** @type {Map<number, Participant>} */
  #participants = new Map();
  /** @type {Map<string, Channel>} */
  #topics = new Map();
  /** @type {Map<string, Channel>} */
  #services = new Map();
  #nextId = 1;
  #changing = false;

  /**
   * Add a worker and return its id.
   * @param {Post} post to the worker @param {string} program the name of its node, empty for the page itself
   * @param {Complain} complain called with errors of the worker
   */
  join(post, program, complain) {
    const id = this.#nextId++;
    this.#participants.set(id, {
      id, program, post, complain, endpoints: new Map(), missed: new Map(), links: new Set(), accused: new Set(),
      looking: false,
    });
    return id;
  }

  /**
   * Handle a message of a worker that concerns the graph.
   * @param {number} id of the worker @param {FromWorker} message
   */
  receive(id, message) {
    switch (message.op) {
      case "create":
        this.#create(id, message.endpoint);
        break;
      case "destroy":
        this.#destroy(id, message.id);
        break;
      case "missed":
        this.#miss(id, message.id, message.count);
        break;
      case "complain":
        this.#complain(id, message.peer, message.text);
        break;
      case "look":
        this.#look(id);
        break;
      case "settle":
        this.#participants.get(id)?.post({ op: "settled" });
        break;
    }
  }

  /** Remove a worker that has ended, with all its endpoints. @param {number} id */
  leave(id) {
    const gone = this.#participants.get(id);
    if (!gone) return;
    for (const endpoint of [...gone.endpoints.keys()]) this.#destroy(id, endpoint);
    this.#participants.delete(id);
    for (const peer of gone.links) {
      const other = this.#participants.get(peer);
      other?.links.delete(id);
      other?.post({ op: "unlink", peer: id });
    }
    this.#changed();
  }

  /** @param {number} id of the worker @param {Endpoint} endpoint */
  #create(id, endpoint) {
    const owner = this.#participants.get(id);
    if (!owner) return;
    if (!isEndpoint(endpoint) || owner.endpoints.has(endpoint.id)) {
      owner.complain("announced an invalid endpoint; it was dropped");
      return;
    }
    owner.endpoints.set(endpoint.id, endpoint);
    this.#tell(owner, { op: "graph", come: [{ peer: id, endpoint }], gone: [] });
    if (endpoint.kind !== "node") {
      const member = { owner, endpoint };
      const { mine, others } = this.#sides(endpoint);
      mine.add(member);
      for (const other of others) this.#meet(member, other);
    }
    this.#changed();
  }

  /** @param {number} id of the worker @param {number} endpointId */
  #destroy(id, endpointId) {
    const owner = this.#participants.get(id);
    const endpoint = owner?.endpoints.get(endpointId);
    if (!owner || !endpoint) return;
    owner.endpoints.delete(endpointId);
    this.#tell(owner, { op: "graph", come: [], gone: [{ peer: id, id: endpointId }] });
    owner.missed.delete(endpointId);
    if (endpoint.kind !== "node") {
      const { mine, others } = this.#sides(endpoint);
      const member = [...mine].find((m) => m.owner === owner && m.endpoint === endpoint);
      if (member) {
        mine.delete(member);
        for (const other of others) this.#part(member, other);
      }
      if (mine.size + others.size === 0) this.#channels(endpoint).delete(endpoint.name);
    }
    this.#changed();
  }

  /**
   * Note how many messages a subscription has missed.
   * @param {number} id of the worker @param {number} endpoint @param {number} count
   */
  #miss(id, endpoint, count) {
    const owner = this.#participants.get(id);
    if (!owner?.endpoints.has(endpoint)) return;
    owner.missed.set(endpoint, count);
    this.#changed();
  }

  /**
   * Show in the console of a worker what another one, linked to it, says about it, once.
   * @param {number} id of the other one @param {number} peer @param {string} text
   */
  #complain(id, peer, text) {
    const [owner, accused] = [this.#participants.get(id), this.#participants.get(peer)];
    if (!owner?.links.has(peer) || owner.accused.has(peer)) return;
    owner.accused.add(peer);
    const said = text.slice(0, COMPLAINT).replace(/\s+/g, " ");
    accused?.complain(`${owner.program || "the page"} says that it ${said}`);
  }

  /** Tell a worker all endpoints of the others, and from now on their changes. @param {number} id */
  #look(id) {
    const owner = this.#participants.get(id);
    if (!owner || owner.looking) return;
    owner.looking = true;
    const others = [...this.#participants.values()].filter((other) => other !== owner);
    const come = others.flatMap(({ id: peer, endpoints }) =>
      [...endpoints.values()].map((endpoint) => ({ peer, endpoint })));
    owner.post({ op: "graph", come, gone: [] });
  }

  /** All endpoints, in the order of their creation. */
  endpoints() {
    return [...this.#participants.values()].flatMap(({ id, program, endpoints, missed }) =>
      [...endpoints.values()].map((endpoint) => ({
        ...endpoint, gid: gidOf(id, endpoint.id), program, missed: missed.get(endpoint.id) ?? 0,
      })),
    );
  }

  /** The fully qualified names of all nodes, sorted. */
  nodes() {
    return this.endpoints().filter((e) => e.kind === "node").map((e) => e.node).sort();
  }

  /** All topics, sorted by name, with their types and nodes. */
  topics() {
    return [...this.#topics].sort(byName).map(([name, channel]) => ({
      name,
      types: types(channel),
      publishers: nodesOf(channel.senders),
      subscriptions: nodesOf(channel.receivers),
      missed: sum([...channel.receivers].map(missed)),
      mismatches: mismatches(channel),
    }));
  }

  /** All services, sorted by name, with their types and nodes. */
  services() {
    return [...this.#services].sort(byName).map(([name, channel]) => ({
      name,
      types: types(channel),
      servers: nodesOf(channel.receivers),
      clients: nodesOf(channel.senders),
    }));
  }

  /** @param {Endpoint} endpoint */
  #channels({ kind }) {
    return kind === "service" || kind === "client" ? this.#services : this.#topics;
  }

  /** Return the side of the channel that `endpoint` is on, and the other side. @param {Endpoint} endpoint */
  #sides(endpoint) {
    const channels = this.#channels(endpoint);
    let channel = channels.get(endpoint.name);
    if (!channel) {
      channel = { senders: new Set(), receivers: new Set() };
      channels.set(endpoint.name, channel);
    }
    return sends(endpoint)
      ? { mine: channel.senders, others: channel.receivers }
      : { mine: channel.receivers, others: channel.senders };
  }

  /**
   * Match two endpoints, one from each side of a channel, if they are compatible. Endpoints of one worker find each
   * other there.
   * @param {Member} a @param {Member} b
   */
  #meet(a, b) {
    if (a.owner === b.owner) return;
    const policy = incompatibility(...inOrder(a, b));
    if (!policy) this.#link(a.owner, b.owner);
    for (const [to, about] of bothWays(a, b)) {
      const local = to.endpoint.id;
      if (policy) {
        to.owner.post({ op: "incompatible", local, policy });
      } else {
        const { id: remote, qos } = about.endpoint;
        to.owner.post({ op: "match", local, peer: about.owner.id, remote, qos });
      }
    }
  }

  /** @param {Member} a @param {Member} b */
  #part(a, b) {
    if (a.owner === b.owner || incompatibility(...inOrder(a, b))) return;
    for (const [to, about] of bothWays(a, b)) {
      const [local, remote] = [to.endpoint.id, about.endpoint.id];
      to.owner.post({ op: "unmatch", local, peer: about.owner.id, remote });
    }
  }

  /** Give two workers a port to each other, once. @param {Participant} a @param {Participant} b */
  #link(a, b) {
    if (a.links.has(b.id)) return;
    const { port1, port2 } = new MessageChannel();
    a.links.add(b.id);
    b.links.add(a.id);
    a.post({ op: "link", peer: b.id, port: port1 }, [port1]);
    b.post({ op: "link", peer: a.id, port: port2 }, [port2]);
  }

  /** Tell a change of `owner` to all others that are looking. @param {Participant} owner @param {ToWorker} change */
  #tell(owner, change) {
    for (const other of this.#participants.values()) {
      if (other.looking && other !== owner) other.post(change);
    }
  }

  #changed() {
    if (this.#changing) return;
    this.#changing = true;
    // One event for many changes: a node that starts announces a dozen endpoints.
    setTimeout(() => {
      this.#changing = false;
      this.dispatchEvent(new Event("change"));
    });
  }
}

/** Return the endpoints, the sender first. @param {Member} a @param {Member} b @returns {[Endpoint, Endpoint]} */
function inOrder(a, b) {
  return sends(a.endpoint) ? [a.endpoint, b.endpoint] : [b.endpoint, a.endpoint];
}

/** @param {[string, Channel]} a @param {[string, Channel]} b */
function byName([a], [b]) {
  return a < b ? -1 : 1;
}

/** @param {Channel} channel */
function types({ senders, receivers }) {
  return [...new Set([...senders, ...receivers].map((member) => member.endpoint.type))];
}

/** @param {Set<Member>} members */
function nodesOf(members) {
  return [...members].map((member) => member.endpoint.node);
}

/** @param {Member} a @param {Member} b @returns {[to: Member, about: Member][]} */
function bothWays(a, b) {
  return [[a, b], [b, a]];
}

/** Return the incompatible pairs of a topic. @param {Channel} channel @returns {Mismatch[]} */
function mismatches({ senders, receivers }) {
  return [...senders].flatMap(({ endpoint: from }) =>
    [...receivers].flatMap(({ endpoint: to }) => {
      const policy = incompatibility(from, to);
      return policy ? [{ publisher: from.node, subscription: to.node, policy }] : [];
    }),
  );
}

/** The number of messages that a subscription missed, 0 for the page's own. @param {Member} member */
function missed({ owner, endpoint }) {
  return owner.program ? owner.missed.get(endpoint.id) ?? 0 : 0;
}

/** @param {number[]} numbers */
function sum(numbers) {
  return numbers.reduce((total, number) => total + number, 0);
}
