// @ts-check
// What there is in the graph of the robot, as rosapi tells when it is asked.

import { infrastructureOf, isHidden } from "../../graphNames.js";
import { DEFAULT_QOS } from "../../protocol.js";
import { textOf } from "../mistake.js";
import { SEND } from "./actionServers.js";
import { callOf, RESPONSE } from "./calls.js";

/** @import { RemoteEndpoint } from "../../gateway/wire.js" */
/** @import { Calls } from "./calls.js" */
/**
 * @typedef {{change(come: RemoteEndpoint[], gone: number[]): void, note(name: string, reason: string): void,
 *   owns(kind: RemoteEndpoint["kind"], name: string): boolean, wantsLatched(topic: string): boolean,
 *   actionType(action: string): string, check(time: number, offered: Set<string>): void}} Ways `owns` says whether an
 *   endpoint of the robot's server may be the page's, `wantsLatched` whether a subscription of the page asks for what was
 *   published before, and `actionType` the type with which the page uses an action, or ""; `check` is told the kinds and
 *   names of what the server had at a time
 */

// The pause between two looks (ms), and how long it is compared with a look: a robot's processor has other work.
const PAUSE = 1000;
const SHARE = 9;
// rosapi may begin later than the server. After so many looks in vain, the visitor is told.
const VAIN = 5;
// Topics, services or nodes.
const MOST = 20_000;
/** The node of rosbridge_server is known by what it publishes. */
const CLIENTS = "rosbridge_msgs/msg/ConnectedClients";
/** Its services are those of rosbridge. */
const ROSAPI = "/rosapi/";
const OWN_NODE = "/rosbridge_websocket";
/** Topics that are published once, for whoever comes: rosapi tells no quality of service. */
const LATCHED = /\/(?:tf_static|robot_description|map)$/;

export class Discovery {
  #calls;
  #ways;
  /** By what it is. @type {Map<string, RemoteEndpoint>} */
  #known = new Map();
  #ids = 0;
  /** Of services, by name. @type {Map<string, string>} */
  #types = new Map();
  /** Of actions, by name. @type {Map<string, string>} */
  #actionTypes = new Map();
  /** Whether rosapi tells the types of actions, which older ones do not. */
  #canTell = true;
  /** Actions whose type the server does not tell. @type {Set<string>} */
  #untold = new Set();
  /** What rosapi tells of nodes, by name. @type {Map<string, {time: number, told: any}>} */
  #details = new Map();
  /** The topics and services when all nodes were asked for. */
  #offered = "";
  #turn = 0;
  #closed = false;

  /** @param {Calls} calls @param {Ways} ways */
  constructor(calls, ways) {
    this.#calls = calls;
    this.#ways = ways;
  }

  /** Look again and again, until the connection ends. */
  async run() {
    for (let vain = 0; !this.#closed;) {
      const begin = performance.now();
      try {
        this.#compare(await this.#look());
        vain = 0;
      } catch (error) {
        vain += 1;
        if (vain === VAIN) this.#ways.note("rosapi", textOf(error));
      }
      const pause = Math.max(PAUSE, SHARE * (performance.now() - begin));
      await new Promise((resolve) => setTimeout(resolve, pause));
    }
  }

  close() {
    this.#closed = true;
  }

  /** Return what there is; the ids are not given yet. @returns {Promise<RemoteEndpoint[]>} */
  async #look() {
    const [{ topics, types }, { services }] = await Promise.all([this.#ask("topics"), this.#ask("services")]);
    const named = textsOf(types);
    const typeOf = new Map(textsOf(topics).map((name, index) => [name, named[index] ?? ""]));
    await this.#learn(textsOf(services));
    await this.#refresh(JSON.stringify([topics, services]));
    const found = [...this.#details].flatMap(([node, { told }]) => endpointsOf(node, told, typeOf, this.#types));
    const shown = found.filter(({ name }) => !isHidden(name) && !name.startsWith(ROSAPI)).map((one) => this.#latched(one));
    return [...shown, ...(await this.#actions(shown))];
  }

  /** @param {string} name of a service of rosapi @param {object} [args] @returns {Promise<any>} */
  #ask(name, args) {
    return this.#calls.call(ROSAPI + name, args);
  }

  async #nodes() {
    return textsOf((await this.#ask("nodes")).nodes).filter((node) => !isHidden(node));
  }

  /**
   * Ask for the details of the nodes that may have changed: of all if topics or services have, and always of one, which
   * may have a further subscription.
   * @param {string} offered what stands for the topics and services
   */
  async #refresh(offered) {
    const nodes = await this.#nodes();
    for (const node of this.#details.keys()) if (!nodes.includes(node)) this.#details.delete(node);
    this.#turn += 1;
    const one = nodes[this.#turn % nodes.length];
    const due = nodes.filter((node) => offered !== this.#offered || node === one || !this.#details.has(node));
    for (const node of due) {
      // rosapi ends when it is asked for a node that has just gone.
      const time = performance.now();
      if ((await this.#nodes()).includes(node)) this.#details.set(node, { time, told: await this.#ask("node_details", { node }) });
      else this.#details.delete(node);
    }
    this.#offered = offered;
  }

  /** Return the parts of the robot's actions. @param {RemoteEndpoint[]} found @returns {Promise<RemoteEndpoint[]>} */
  async #actions(found) {
    // Which node has an action is not told. rosbridge_server has the goals.
    const { node } = found.find(isServer) ?? { node: OWN_NODE };
    const { action_servers: names } = await this.#ask("action_servers").catch(() => ({}));
    const parts = [];
    for (const name of textsOf(names)) {
      const type = this.#ways.owns("service", name + SEND) ? "" : await this.#actionType(name);
      if (type) parts.push(...partsOf(node, name, type));
    }
    return parts;
  }

  /** Return the type of an action, or "". @param {string} action @returns {Promise<string>} */
  async #actionType(action) {
    const known = this.#actionTypes.get(action) ?? this.#ways.actionType(action);
    if (known || this.#untold.has(action)) return known;
    const told = (await this.#toldType(action)) ?? (await this.#complaint(action));
    if (typeof told.type === "string" && told.type) this.#actionTypes.set(action, told.type);
    // Then a client of the page may know.
    else this.#untold.add(action);
    return this.#actionTypes.get(action) ?? "";
  }

  /** @param {string} action @returns {Promise<any>} undefined if rosapi does not tell it */
  async #toldType(action) {
    if (!this.#canTell) return undefined;
    return this.#ask("action_type", { action }).catch(() => {
      this.#canTell = false;
    });
  }

  /**
   * Learn the type of an action from a server whose rosapi cannot tell it: it does not find the class of the service for
   * goals, and says so before it calls the service.
   * @param {string} action @returns {Promise<{type: string}>}
   */
  async #complaint(action) {
    const { values } = await this.#calls.exchange(callOf(action + SEND, { "": 0 }), RESPONSE);
    const [, name = "", group] = /class (\w+)_SendGoal from package (\w+)/.exec(String(values)) ?? [];
    return { type: group ? `${group}/action/${name}` : "" };
  }

  /** Learn the types of services. @param {string[]} services */
  async #learn(services) {
    for (const name of this.#types.keys()) if (!services.includes(name)) this.#types.delete(name);
    for (const service of services) {
      if (this.#types.has(service) || isHidden(service) || service.startsWith(ROSAPI)) continue;
      const type = parameterType(service) || (await this.#ask("service_type", { service })).type;
      if (typeof type === "string" && type) this.#types.set(service, type);
    }
  }

  /** Return an endpoint with what it keeps for others. @param {RemoteEndpoint} endpoint @returns {RemoteEndpoint} */
  #latched(endpoint) {
    const { kind, name, qos } = endpoint;
    const transientLocal = kind === "publisher" && (LATCHED.test(name) || this.#ways.wantsLatched(name));
    return { ...endpoint, qos: { ...qos, transientLocal } };
  }

  /** Tell what has changed. @param {RemoteEndpoint[]} found */
  #compare(found) {
    const servers = new Set(found.filter(isServer).map(({ node }) => node));
    const times = [...servers].map((node) => this.#details.get(node)?.time ?? 0);
    const offered = found.filter(({ node }) => servers.has(node)).map(({ kind, name }) => `${kind} ${name}`);
    if (times.length > 0) this.#ways.check(Math.min(...times), new Set(offered));
    // What the page offers stands there as the server's.
    const others = found.filter(({ kind, node, name }) => !(servers.has(node) && this.#ways.owns(kind, name)));
    const present = new Map(others.map((one) => [keyOf(one), one]));
    const gone = [...this.#known].filter(([key]) => !present.has(key));
    const come = [...present].filter(([key]) => !this.#known.has(key));
    for (const [key] of gone) this.#known.delete(key);
    for (const [key, one] of come) {
      this.#ids += 1;
      this.#known.set(key, { ...one, id: this.#ids });
    }
    if (gone.length + come.length === 0) return;
    this.#ways.change(
      come.map(([key]) => /** @type {RemoteEndpoint} */ (this.#known.get(key))), gone.map(([, { id }]) => id));
  }
}

/**
 * @param {string} node @param {any} details @param {Map<string, string>} topics types by name
 * @param {Map<string, string>} services types by name @returns {RemoteEndpoint[]}
 */
function endpointsOf(node, { publishing, subscribing, services: serving }, topics, services) {
  const of = (/** @type {RemoteEndpoint["kind"]} */ kind, /** @type {unknown} */ names, /** @type {Map<string, string>} */ types) =>
    textsOf(names).flatMap((name) => {
      const type = types.get(name);
      // A subscription must not ask for more than the page's publishers offer, and a publisher offers all it can.
      const qos = { ...DEFAULT_QOS, reliable: kind !== "subscription" };
      return type ? [{ id: 0, kind, node, name, type, hash: "", qos }] : [];
    });
  return [
    { id: 0, kind: "node", node, name: node, type: "", hash: "", qos: DEFAULT_QOS },
    ...of("publisher", publishing, topics), ...of("subscription", subscribing, topics), ...of("service", serving, services),
  ];
}

/** Whether an endpoint shows that its node is rosbridge_server. @param {RemoteEndpoint} endpoint */
function isServer({ kind, type, node }) {
  return (kind === "publisher" && type === CLIENTS) || node === OWN_NODE;
}

/** @param {string} node @param {string} action @param {string} type @returns {RemoteEndpoint[]} */
function partsOf(node, action, type) {
  const part = (/** @type {RemoteEndpoint["kind"]} */ kind, /** @type {string} */ name, /** @type {string} */ its, latched = false) =>
    ({ id: 0, kind, node, name: `${action}/_action/${name}`, type: its, hash: "", qos: { ...DEFAULT_QOS, transientLocal: latched } });
  return [
    part("service", "send_goal", `${type}_SendGoal`), part("service", "cancel_goal", "action_msgs/srv/CancelGoal"),
    part("service", "get_result", `${type}_GetResult`), part("publisher", "feedback", `${type}_FeedbackMessage`),
    part("publisher", "status", "action_msgs/msg/GoalStatusArray", true),
  ];
}

/** @param {RemoteEndpoint} endpoint */
function keyOf({ kind, node, name, type, qos }) {
  return [kind, node, name, type, qos.transientLocal].join(" ");
}

/** Return the type of a service that every node has for its parameters, or "". @param {string} service */
function parameterType(service) {
  if (!infrastructureOf(service)) return "";
  const words = service.slice(service.lastIndexOf("/") + 1).split("_");
  const name = words.map((word) => word.charAt(0).toUpperCase() + word.slice(1)).join("");
  return `${name === "GetTypeDescription" ? "type_description_interfaces" : "rcl_interfaces"}/srv/${name}`;
}

/** @param {unknown} given @returns {string[]} */
function textsOf(given) {
  return Array.isArray(given) ? given.slice(0, MOST).filter((one) => typeof one === "string") : [];
}
