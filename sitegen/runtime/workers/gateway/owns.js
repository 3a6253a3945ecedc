// @ts-check
// The endpoints of the page's nodes: the gateway is told of them, gets what they send, and asks their services.

import { DEFAULT_QOS, now } from "../../protocol.js";
import { isPrivate } from "../../gateway/names.js";
import { writtenQos } from "../../gateway/wire.js";

/** @import { Participant } from "../../participant/participant.js" */
/** @import { Received } from "../../participant/queue.js" */
/** @import { Endpoint, Head, Neighbour } from "../../protocol.js" */
/** @import { Scope } from "../../gateway/names.js" */
/** @import { FromGateway } from "../../gateway/orders.js" */

/**
 * @typedef {{say(message: object): void, send(head: Head, message: Uint8Array): void,
 *   tell(message: FromGateway): void, flush(): void}} Ways to the gateway, and to the page; records wait for `flush`
 * @typedef {{id: number, endpoint: Endpoint}} Own
 * @typedef {{caller: number, waiting: {sequence: number, message: Uint8Array}[],
 *   asked: Map<number, number>}} Service `asked` are the numbers of requests at the gateway, by those in the page
 */

/** The node of what this worker needs for itself. */
export const NODE = "/_gateway";
// For so long, messages of what is gone are still sent (ms).
const LINGER = 200;
// Of what a service is asked before the page has matched the caller.
const MOST = 1000;

export class Owns {
  /** Whether the gateway does not answer, so that messages wait. */
  late = false;
  #graph;
  #scope;
  #hashes;
  #ways;
  /** By gid. @type {Map<number, Own>} */
  #told = new Map();
  /** By id. @type {Map<number, Own>} */
  #byId = new Map();
  #ids = 0;
  /** Those that have gone, and are soon forgotten. @type {Set<number>} */
  #going = new Set();
  #closed = false;
  #changes = -1;
  /** Subscriptions that collect what others look at, by publisher. @type {Map<number, number>} */
  #collectors = new Map();
  /** The last message that was sent, by the publisher's gid. @type {Map<number, number>} */
  #sent = new Map();
  /** By id of the endpoint. @type {Map<number, Service>} */
  #services = new Map();

  /** @param {Participant} graph @param {Scope} scope @param {Record<string, string>} hashes @param {Ways} ways */
  constructor(graph, scope, hashes, ways) {
    this.#graph = graph;
    this.#scope = scope;
    this.#hashes = hashes;
    this.#ways = ways;
  }

  /** Tell the gateway what has changed. @param {(gid: number) => boolean} foreign whether an endpoint is not the page's */
  announce(foreign) {
    const all = this.#graph.look();
    if (!all || this.#graph.changes === this.#changes) return;
    this.#changes = this.#graph.changes;
    const present = new Map(all.filter((one) => !foreign(one.gid) && this.#isTold(one)).map((one) => [one.gid, one]));
    const gone = [...this.#told.keys()].filter((gid) => !present.has(gid) && !this.#going.has(gid));
    for (const gid of gone) this.#going.add(gid);
    // What a program sends just before it ends arrives after the news of its end.
    if (gone.length > 0) setTimeout(() => this.#dismiss(gone), LINGER);
    const come = [...present].filter(([gid]) => !this.#told.has(gid));
    if (come.length === 0) return;
    const described = come.map(([gid, { endpoint }]) => this.#describe(gid, endpoint));
    this.#ways.say({ op: "graph", gone: [], come: described });
    // Natively, late subscriptions get what a publisher keeps, so everything that it keeps has to be there.
    for (const [gid, { endpoint }] of come) {
      if (endpoint.kind === "publisher" && endpoint.qos.transientLocal) this.#collect(gid, endpoint);
    }
  }

  /** @param {number[]} gone gids */
  #dismiss(gone) {
    if (this.#closed) return;
    this.take();
    this.#ways.flush();
    const ids = gone.flatMap((gid) => this.#told.get(gid)?.id ?? []);
    for (const gid of gone) {
      this.#forget(gid, this.#told.get(gid)?.id ?? 0);
      this.#told.delete(gid);
      this.#going.delete(gid);
    }
    this.#ways.say({ op: "graph", gone: ids, come: [] });
  }

  /** Somebody whom the page does not see looks at a publisher, or no longer does. @param {number} id @param {boolean} yes */
  collect(id, yes) {
    const own = this.#byId.get(id);
    const gid = own && [...this.#told].find(([, one]) => one === own)?.[0];
    if (!own || !gid || own.endpoint.kind !== "publisher") return;
    if (yes) this.#collect(gid, own.endpoint);
    else if (!own.endpoint.qos.transientLocal) this.#stop(gid);
  }

  /** The id of a publisher or client that the gateway knows. @param {number} gid */
  idOf(gid) {
    return this.#told.get(gid)?.id;
  }

  /** An id for a client that the gateway knows only from this worker. @param {Endpoint} service */
  hire({ name, type }) {
    const id = ++this.#ids;
    const endpoint = { kind: "client", name: this.#scope.outside(name), type, node: "" };
    this.#ways.say({ op: "graph", gone: [], come: [{ id, ...endpoint, hash: this.#hashes[type] ?? "" }] });
    return id;
  }

  /**
   * Send what a publisher of the page has sent, once, though several remote subscriptions get it.
   * @param {Received} sample
   */
  pass({ writer, sequence, timestamp, message }) {
    const id = this.idOf(writer);
    if (!id || sequence <= (this.#sent.get(writer) ?? 0)) return;
    this.#sent.set(writer, sequence);
    this.#ways.send({ reader: 0, writer: id, sequence, timestamp }, message);
  }

  /** Send what a subscription of this worker has got. @param {number} local */
  drain(local) {
    if (this.late) {
      for (const sample of this.#kept(local)) this.pass(sample);
      return;
    }
    for (let sample; (sample = this.#graph.take(local));) this.pass(sample);
  }

  /** Send what collectors have got, and the answers of services. */
  take() {
    for (const collector of this.#collectors.values()) this.drain(collector);
    for (const [id, service] of this.#services) {
      if (service.waiting.length > 0 && this.#graph.matched(service.caller) > 0) {
        for (const { sequence, message } of service.waiting.splice(0)) this.#request(service, sequence, message);
      }
      for (let sample; (sample = this.#graph.take(service.caller));) {
        const number = service.asked.get(sample.sequence);
        if (number === undefined) continue;
        service.asked.delete(sample.sequence);
        this.#ways.send({ reader: 0, writer: id, sequence: number, timestamp: now() }, sample.message);
      }
    }
    this.#graph.flush();
  }

  /** Somebody calls a service of the page. @param {number} id @param {number} sequence @param {Uint8Array} message */
  ask(id, sequence, message) {
    const own = this.#byId.get(id);
    if (own?.endpoint.kind !== "service") return;
    let service = this.#services.get(id);
    if (!service) {
      const { name, type } = own.endpoint;
      const caller = this.#graph.create("client", NODE, name, type, DEFAULT_QOS);
      service = { caller, waiting: [], asked: new Map() };
      this.#services.set(id, service);
    }
    // The frame that it is a view of is short-lived.
    if (service.waiting.length < MOST) service.waiting.push({ sequence, message: message.slice() });
  }

  /** The gateway does not take an endpoint. @param {number} id @param {string} reason */
  refuse(id, reason) {
    const own = this.#byId.get(id);
    if (own) this.#ways.tell({ op: "kept", name: own.endpoint.name, reason });
  }

  close() {
    this.#closed = true;
    for (const collector of this.#collectors.values()) this.#graph.destroy(collector);
    for (const { caller } of this.#services.values()) this.#graph.destroy(caller);
    this.#collectors.clear();
    this.#services.clear();
  }

  /**
   * What waited for a silent gateway. Natively, a publisher keeps no more than its history for those who cannot be
   * reached: a robot must not drive by the commands of a minute ago.
   * @param {number} local a subscription of this worker
   */
  #kept(local) {
    /** @type {Received[]} */
    const held = [];
    for (let sample; (sample = this.#graph.take(local));) held.push(sample);
    /** @type {Map<number, number>} */
    const counts = new Map();
    const newestFirst = held.reverse().filter(({ writer }) => {
      const { keepAll, depth } = this.#told.get(writer)?.endpoint.qos ?? DEFAULT_QOS;
      const count = (counts.get(writer) ?? 0) + 1;
      counts.set(writer, count);
      return keepAll || count <= depth;
    });
    return newestFirst.reverse();
  }

  /** Whether the gateway is told of an endpoint. @param {Neighbour} neighbour */
  #isTold({ endpoint }) {
    if (!this.#scope.shows(endpoint)) return false;
    // What panels publish goes out without a node; what they look at, only while they do.
    return !isPrivate(endpoint.node) || (endpoint.kind === "publisher" && endpoint.node !== NODE);
  }

  /** @param {number} gid @param {Endpoint} endpoint */
  #describe(gid, endpoint) {
    const id = ++this.#ids;
    const own = { id, endpoint };
    this.#told.set(gid, own);
    this.#byId.set(id, own);
    const { kind, node, name, type, qos } = endpoint;
    return {
      id, kind, type, name: this.#scope.outside(kind === "node" ? node : name), node: isPrivate(node) ? "" : this.#scope.outside(node),
      hash: this.#hashes[type] ?? "", qos: writtenQos(qos),
    };
  }

  /** @param {number} gid @param {Endpoint} endpoint a publisher */
  #collect(gid, { name, type, qos }) {
    if (this.#collectors.has(gid)) return;
    const { reliable, transientLocal, depth, keepAll } = qos;
    const wanted = { ...DEFAULT_QOS, reliable, transientLocal, keepAll, depth: Math.max(depth, 1000) };
    this.#collectors.set(gid, this.#graph.create("subscription", NODE, name, type, wanted));
  }

  /** @param {number} gid */
  #stop(gid) {
    const collector = this.#collectors.get(gid);
    if (collector === undefined) return;
    this.#collectors.delete(gid);
    this.#graph.destroy(collector);
  }

  /** @param {number} gid @param {number} id */
  #forget(gid, id) {
    this.#byId.delete(id);
    this.#sent.delete(gid);
    this.#stop(gid);
    const service = this.#services.get(id);
    if (!service) return;
    this.#services.delete(id);
    this.#graph.destroy(service.caller);
  }

  /** @param {Service} service @param {number} sequence @param {Uint8Array} message */
  #request(service, sequence, message) {
    service.asked.set(this.#graph.request(service.caller, message), sequence);
    // Of a service that answers nothing.
    if (service.asked.size > MOST) service.asked.delete(/** @type {number} */ (service.asked.keys().next().value));
  }
}
