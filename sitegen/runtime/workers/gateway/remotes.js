// @ts-check
// Endpoints in the page's graph that stand for remote ones, under the names of their nodes.

import { isType } from "../../gateway/wire.js";

/** @import { Participant } from "../../participant/participant.js" */
/** @import { Endpoint, Qos } from "../../protocol.js" */
/** @import { Scope } from "../../gateway/names.js" */
/** @import { RemoteEndpoint } from "../../gateway/wire.js" */
/** @import { Owns, Ways } from "./owns.js" */

/** @typedef {{id: number, endpoint: RemoteEndpoint, local: number, open: boolean}} Remote `local` stands for it */

// What a page keeps of a topic, and takes from its own nodes at once: native nodes do not tell their depths.
const LATCHED = 100;
const DEPTH = 1000;
// Types in one question.
const ASKED = 200;
// Remote endpoints; no robot has as many.
const MOST = 50_000;
// Calls that wait for an answer.
const CALLS = 10_000;

export class Remotes {
  #graph;
  #scope;
  #hashes;
  #owns;
  #ways;
  /** @type {Map<number, Remote>} */
  #all = new Map();
  /** The worker's id. @type {number | undefined} */
  #self;
  /** Clients at the gateway for private ones of the page, by service. @type {Map<number, number>} */
  #hired = new Map();
  /** Calls by their number at the gateway. @type {Map<number, {local: number, client: number, sequence: number}>} */
  #calls = new Map();
  #numbers = 0;
  /** Endpoints of types that the page cannot read yet, by id. @type {Map<number, RemoteEndpoint>} */
  #awaiting = new Map();
  /** The types of each question that the gateway has not answered; it answers in order. @type {string[][]} */
  #questions = [];
  /** Types that the gateway was asked for. @type {Set<string>} */
  #asked = new Set();
  /** Types for which it has answered, with a definition or without. @type {Set<string>} */
  #answered = new Set();
  /** Types that differ, which are told once. @type {Set<string>} */
  #different = new Set();

  /**
   * @param {Participant} graph @param {Scope} scope @param {Record<string, string>} hashes @param {Owns} owns
   * @param {Ways} ways
   */
  constructor(graph, scope, hashes, owns, ways) {
    this.#graph = graph;
    this.#scope = scope;
    this.#hashes = hashes;
    this.#owns = owns;
    this.#ways = ways;
    this.#self = Math.floor(graph.gid(0) / 2 ** 32);
  }

  /** Whether a worker of the page is this one. @param {number} peer */
  has(peer) {
    return peer === this.#self;
  }

  /** @param {RemoteEndpoint[]} come @param {number[]} gone */
  change(come, gone) {
    for (const id of gone) this.#remove(id);
    for (const endpoint of come) {
      if (!this.#admits(endpoint)) continue;
      // Whoever sees an endpoint may use it at once, so its type is known before.
      if (this.#isReadable(endpoint.type)) this.#add(endpoint);
      else this.#awaiting.set(endpoint.id, endpoint);
    }
    this.#ask([...this.#awaiting.values()].map(({ type }) => type));
    const nodes = [...this.#all.values()].filter(({ endpoint }) => endpoint.kind === "node");
    this.#ways.tell({ op: "nodes", nodes: nodes.map(({ endpoint }) => this.#scope.inside(endpoint.node)).sort() });
  }

  /** The gateway has answered the oldest question for types. */
  learn() {
    for (const type of this.#questions.shift() ?? []) this.#answered.add(type);
    for (const endpoint of [...this.#awaiting.values()]) {
      if (!this.#isReadable(endpoint.type)) continue;
      this.#awaiting.delete(endpoint.id);
      this.#add(endpoint);
    }
  }

  /** Ask for the messages of publishers that somebody in the page looks at, and of no others. */
  look() {
    for (const remote of this.#all.values()) {
      if (remote.endpoint.kind !== "publisher") continue;
      const open = this.#graph.matched(remote.local) > 0;
      if (open === remote.open) continue;
      remote.open = open;
      const rate = this.#scope.rate(this.#scope.inside(remote.endpoint.name));
      this.#ways.say(open ? { op: "open", id: remote.id, ...(rate ? { rate } : {}) } : { op: "close", id: remote.id });
    }
  }

  /** Whether a remote endpoint is a service. @param {number} id */
  serves(id) {
    return this.#all.get(id)?.endpoint.kind === "service";
  }

  /**
   * Publish a message of a remote publisher, which may have gone while it was on its way.
   * @param {number} id @param {Uint8Array} message @param {boolean} latched
   */
  publish(id, message, latched) {
    const remote = this.#all.get(id);
    if (remote?.endpoint.kind === "publisher") this.#graph.publish(remote.local, message, latched);
  }

  /** Send what the page has for remote subscriptions and services. */
  take() {
    for (const { id, local, endpoint } of this.#all.values()) {
      if (endpoint.kind === "subscription") {
        this.#owns.drain(local);
      } else if (endpoint.kind === "service") {
        for (let sample; (sample = this.#graph.take(local));) this.#call(id, local, endpoint, sample);
      }
    }
    this.#graph.flush();
  }

  /** A service has answered. @param {number} number of the call @param {Uint8Array} message */
  respond(number, message) {
    const call = this.#calls.get(number);
    if (!call) return;
    this.#calls.delete(number);
    this.#graph.respond(call.local, call.client, call.sequence, message);
  }

  close() {
    for (const id of [...this.#all.keys()]) this.#remove(id);
  }

  /** @param {RemoteEndpoint} endpoint */
  #admits({ id, kind, name }) {
    if (this.#all.has(id) || this.#awaiting.has(id)) return false;
    if (this.#all.size + this.#awaiting.size >= MOST) return false;
    return this.#scope.admits({ kind, name: this.#scope.inside(name) });
  }

  /** Whether the page has a definition of a type, or there is none to be had. @param {string} type */
  #isReadable(type) {
    return Boolean(this.#hashes[type]) || this.#answered.has(type) || !isType(type);
  }

  /** @param {RemoteEndpoint} endpoint */
  #add(endpoint) {
    const { id, kind, node, type, hash } = endpoint;
    const own = this.#hashes[type];
    if (hash && own && hash !== own) {
      if (!this.#different.has(type)) this.#ways.tell({ op: "differs", type, name: endpoint.name });
      this.#different.add(type);
      return;
    }
    const [name, from] = [this.#scope.inside(endpoint.name), this.#scope.inside(node)];
    const local = this.#graph.create(kind, from, kind === "node" ? from : name, type, standing(kind, endpoint.qos));
    this.#all.set(id, { id, endpoint, local, open: false });
  }

  /** Ask for the definitions of types, once for each. @param {string[]} types */
  #ask(types) {
    const unknown = [...new Set(types)].filter((type) => !this.#asked.has(type));
    for (const type of unknown) this.#asked.add(type);
    for (let at = 0; at < unknown.length; at += ASKED) {
      const question = unknown.slice(at, at + ASKED);
      this.#questions.push(question);
      this.#ways.say({ op: "describe", types: question });
    }
  }

  /** @param {number} id */
  #remove(id) {
    this.#awaiting.delete(id);
    const remote = this.#all.get(id);
    if (!remote) return;
    this.#all.delete(id);
    this.#hired.delete(id);
    this.#graph.destroy(remote.local);
  }

  /**
   * @param {number} id of the service @param {number} local @param {Endpoint} service
   * @param {import("../../participant/queue.js").Received} request
   */
  #call(id, local, service, { writer, sequence, timestamp, message }) {
    let client = this.#owns.idOf(writer) ?? this.#hired.get(id);
    if (!client) {
      client = this.#owns.hire({ ...service, name: this.#scope.inside(service.name) });
      this.#hired.set(id, client);
    }
    this.#numbers += 1;
    this.#calls.set(this.#numbers, { local, client: writer, sequence });
    if (this.#calls.size > CALLS) this.#calls.delete(/** @type {number} */ (this.#calls.keys().next().value));
    this.#ways.send({ reader: id, writer: client, sequence: this.#numbers, timestamp }, message);
  }
}

/** The quality of service of what stands for a remote endpoint. @param {Endpoint["kind"]} kind @param {Qos} qos */
function standing(kind, qos) {
  if (kind === "subscription") return { ...qos, keepAll: false, depth: DEPTH };
  if (kind === "publisher" && qos.transientLocal) return { ...qos, depth: Math.max(qos.depth, LATCHED) };
  return qos;
}
