// @ts-check
// The ROS graph of the page: all endpoints, which of them match, and which workers are linked. Messages do not pass
// through here; they travel through the ports that the graph gives to workers.

import { BUDGETS } from "../budgets.js";
import { servicesOf, topicsOf } from "../participant/summary.js";
import { gidOf, incompatibility, sends } from "../protocol.js";
import { Names } from "./names.js";
import { REFUSALS, isEndpoint } from "./reports.js";

/** @import { Endpoint, FromWorker, Refusal, ToWorker } from "../protocol.js" */

/**
 * @typedef {(message: ToWorker, transfer?: Transferable[]) => void} Post
 * @typedef {(text: string) => void} Complain
 * @typedef {{id: number, program: string, origin: string | undefined, post: Post, complain: Complain,
 *   endpoints: Map<number, Member>, nodes: Map<string, number>, alike: Map<string, number>,
 *   missed: Map<number, number>, links: Set<number>, told: Set<string>, refused: number,
 *   looking: boolean}} Participant a worker, or the page; `nodes` counts its nodes by name and `alike` its endpoints of
 *   one kind and name; `told` is what its console knows, `refused` how much others refused of it, and `looking` if
 *   it is told of the others' endpoints
 * @typedef {{owner: Participant, endpoint: Endpoint}} Member
 * @typedef {{senders: Set<Member>, receivers: Set<Member>}} Channel a topic with its publishers and
 *   subscriptions, or a service with its clients and servers
 */

// Those who listen to changes get at most this share of the time of the page, whatever workers announce.
const SHARE = 0.2;
// (ms)
const FRAME = 16;

/** Emits `change` after changes. */
export class Graph extends EventTarget {
  /** @type {Map<number, Participant>} */
  #participants = new Map();
  /** @type {Map<string, Channel>} */
  #topics = new Map();
  /** @type {Map<string, Channel>} */
  #services = new Map();
  #names = new Names();
  #nextId = 1;
  #changing = false;
  /** How long to wait before the next change is told (ms). */
  #pause = 0;
  /** What messages have cost so far: the number of messages to workers. */
  #spent = 0;

  /**
   * Add a worker and return its id.
   * @param {Post} post to the worker @param {string} program the name of its node, empty for the page itself
   * @param {Complain} complain called with errors of the worker
   * @param {string} [origin] of the program that it runs; without, it is part of the page and may use any name
   */
  join(post, program, complain, origin) {
    const id = this.#nextId++;
    if (origin !== undefined) this.#names.reserve(`/${program}`, id, origin);
    this.#participants.set(id, {
      id, program, origin, complain, endpoints: new Map(), nodes: new Map(), alike: new Map(), missed: new Map(),
      links: new Set(), told: new Set(), refused: 0, looking: false,
      post: (message, transfer) => {
        this.#spent += 1;
        post(message, transfer);
      },
    });
    return id;
  }

  /**
   * Handle a message of a worker that concerns the graph. Return what it cost: the number of messages to workers.
   * @param {number} id of the worker @param {FromWorker} message
   */
  receive(id, message) {
    const before = this.#spent;
    this.#handle(id, message);
    return this.#spent - before;
  }

  /** @param {number} id of the worker @param {FromWorker} message */
  #handle(id, message) {
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
        this.#complain(id, message.peer, message.what, message.count);
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
    const left = [...gone.endpoints.keys()].map((endpoint) => ({ peer: id, id: endpoint }));
    for (const member of [...gone.endpoints.values()]) this.#remove(member);
    this.#participants.delete(id);
    this.#names.release(`/${gone.program}`, id);
    if (left.length) this.#tell(gone, { op: "graph", come: [], gone: left });
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
    const fault = this.#fault(owner, endpoint);
    if (fault) {
      tell(owner, fault);
      return;
    }
    const member = { owner, endpoint };
    owner.endpoints.set(endpoint.id, member);
    count(owner.alike, likeness(endpoint), 1);
    this.#tell(owner, { op: "graph", come: [{ peer: id, endpoint }], gone: [] });
    if (endpoint.kind === "node") {
      count(owner.nodes, endpoint.node, 1);
    } else {
      const { mine, others } = this.#sides(endpoint);
      mine.add(member);
      for (const other of others) this.#meet(member, other);
    }
    this.#changed();
  }

  /** Return why an endpoint is not accepted, or "". @param {Participant} owner @param {Endpoint} endpoint */
  #fault(owner, endpoint) {
    if (!isEndpoint(endpoint) || owner.endpoints.has(endpoint.id)) return "announced an invalid endpoint; it was dropped";
    const wrong = this.#names.fault(endpoint, owner.origin, owner.nodes);
    if (wrong) return `announced a ${endpoint.kind} ${wrong}; it was dropped`;
    if (owner.origin === undefined) return ""; // the page itself, and the nodes that it stands for
    if (owner.endpoints.size >= BUDGETS.endpoints) {
      return `announced more than ${BUDGETS.endpoints} endpoints; further ones were dropped`;
    }
    const alike = endpoint.kind !== "node" && (owner.alike.get(likeness(endpoint)) ?? 0) >= BUDGETS.alike;
    return alike ? `announced more than ${BUDGETS.alike} endpoints of one kind and name; further ones were dropped` : "";
  }

  /** @param {number} id of the worker @param {number} endpointId */
  #destroy(id, endpointId) {
    const owner = this.#participants.get(id);
    const member = owner?.endpoints.get(endpointId);
    if (!owner || !member) return;
    this.#remove(member);
    this.#tell(owner, { op: "graph", come: [], gone: [{ peer: id, id: endpointId }] });
    this.#changed();
  }

  /** @param {Member} member */
  #remove(member) {
    const { owner, endpoint } = member;
    owner.endpoints.delete(endpoint.id);
    owner.missed.delete(endpoint.id);
    count(owner.alike, likeness(endpoint), -1);
    if (endpoint.kind === "node") {
      count(owner.nodes, endpoint.node, -1);
      return;
    }
    const { mine, others } = this.#sides(endpoint);
    mine.delete(member);
    for (const other of others) this.#part(member, other);
    if (mine.size + others.size === 0) this.#channels(endpoint).delete(endpoint.name);
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
   * A worker has refused what another one, linked to it, sent. The console of that one says so once, in words of the
   * page: nobody writes in the console of another.
   * @param {number} id of the one that refused @param {number} peer @param {Refusal} what @param {number} times
   */
  #complain(id, peer, what, times) {
    const [owner, accused] = [this.#participants.get(id), this.#participants.get(peer)];
    if (!accused || !owner?.links.has(peer)) return;
    accused.refused += times;
    tell(accused, `${owner.program || "the page"} refused what it sent: ${REFUSALS[what]}`);
  }

  /** How much others refused of what a worker sent. @param {number} id */
  refused(id) {
    return this.#participants.get(id)?.refused ?? 0;
  }

  /** Tell a worker all endpoints of the others, and from now on their changes. @param {number} id */
  #look(id) {
    const owner = this.#participants.get(id);
    if (!owner || owner.looking) return;
    owner.looking = true;
    const others = [...this.#participants.values()].filter((other) => other !== owner);
    const come = others.flatMap(({ id: peer, endpoints }) =>
      [...endpoints.values()].map(({ endpoint }) => ({ peer, endpoint })));
    owner.post({ op: "graph", come, gone: [] });
  }

  /** All endpoints, in the order of their creation. */
  endpoints() {
    return [...this.#participants.values()].flatMap(({ id, program, endpoints, missed }) =>
      [...endpoints.values()].map(({ endpoint }) => ({
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
    return topicsOf(this.#topics, missed);
  }

  /** All services, sorted by name, with their types and nodes. */
  services() {
    return servicesOf(this.#services);
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
      const begun = performance.now();
      this.dispatchEvent(new Event("change"));
      const took = performance.now() - begun;
      // What takes less than a frame needs no pause.
      this.#pause = took < FRAME ? 0 : took / SHARE;
    }, this.#pause);
  }
}

/** Return the endpoints, the sender first. @param {Member} a @param {Member} b @returns {[Endpoint, Endpoint]} */
function inOrder(a, b) {
  return sends(a.endpoint) ? [a.endpoint, b.endpoint] : [b.endpoint, a.endpoint];
}

/** @param {Member} a @param {Member} b @returns {[to: Member, about: Member][]} */
function bothWays(a, b) {
  return [[a, b], [b, a]];
}

/** The number of messages that a subscription missed, 0 for the page's own. @param {Member} member */
function missed({ owner, endpoint }) {
  return owner.program ? owner.missed.get(endpoint.id) ?? 0 : 0;
}

/** What endpoints have in common that match the same ones. @param {Endpoint} endpoint */
function likeness({ kind, name }) {
  return `${kind} ${name}`;
}

/** @param {Map<string, number>} counts @param {string} key @param {number} more */
function count(counts, key, more) {
  const number = (counts.get(key) ?? 0) + more;
  if (number > 0) counts.set(key, number);
  else counts.delete(key);
}

/** Tell the console of a worker something, once. @param {Participant} owner @param {string} text */
function tell(owner, text) {
  if (owner.told.has(text)) return;
  owner.told.add(text);
  owner.complain(text);
}
