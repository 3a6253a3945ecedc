// @ts-check
// Translate between the commands of a ROS2WASM script and the graph.

import { ROSOUT } from "../../graphNames.js";
import { shown } from "./complaints.js";
import { Endpoints } from "./endpoints.js";
import { toLines, toLog } from "./log.js";
import { absolute, ownOf, partOf } from "./names.js";
import { Codec } from "../../messages/codec.js";
import { DEFAULT_QOS, ROSOUT_QOS } from "../../protocol.js";

/** @import { Ros2wasmEntry } from "../../protocol.js" */
/** @import { Participant } from "../../participant/participant.js" */
/** @import { Printer } from "../printer.js" */
/** @import { Complaints } from "./complaints.js" */
/** @import { Endpoint, Kind } from "./endpoints.js" */

/**
 * A participant that a script has registered under a gid of its own. `endpoint` is the key of its endpoint in the
 * graph, empty if it has none.
 * @typedef {{gid: unknown, role: string, name: string, endpoint: string}} Registered
 */

/** The properties of each command that must be text. @type {Map<unknown, ("topic" | "message" | "role")[]>} */
const COMMANDS = new Map([
  ["register", ["topic", "role"]],
  ["deregister", ["topic", "role"]],
  ["publish", ["topic", "message"]],
  ["retrieve", ["topic"]],
  ["console", ["message"]],
]);
/** @type {Map<string, Kind>} */
const KINDS = new Map([
  ["publisher", "publisher"],
  ["subscriber", "subscription"],
  ["service_server", "service"],
  ["service_client", "client"],
]);
const ACTIONS = ["action_server", "action_client"];
const LOG = "rcl_interfaces/msg/Log";
// A script requests a message every 10 ms until it finds one, and keeps only one per topic, which the next one
// replaces, read or not. So requests that it sent before an answer arrived must not get another answer: after each
// answer, requests for the topic are ignored for this time (ms).
const REST = 5;

export class Script {
  #participant;
  #endpoints;
  #codec;
  #program;
  #name;
  #answer;
  #printer;
  #complaints;
  /** By kind and name. @type {Map<string, Endpoint>} */
  #held = new Map();
  /** @type {Registered[]} */
  #registered = [];
  /** Topics and services that were registered and have no endpoint. @type {Set<string>} */
  #without = new Set();
  /** The endpoints that send and receive, by topic. @type {Map<string, Endpoint>} */
  #outlets = new Map();
  /** @type {Map<string, Endpoint>} */
  #inlets = new Map();
  /** The ids of the nodes in the graph, by name; the node that registers now; the publisher of the log. */
  #nodes = new Map();
  #node = "";
  #log = 0;
  /** @type {Set<string>} */
  #resting = new Set();
  #turn = new MessageChannel();

  /**
   * @param {Participant} participant
   * @param {string} name of the node, unless the script has another
   * @param {Ros2wasmEntry} program
   * @param {(message: {topic: string, message: string}) => void} answer to the script
   * @param {Printer} printer
   * @param {Complaints} complaints
   */
  constructor(participant, name, program, answer, printer, complaints) {
    this.#participant = participant;
    this.#endpoints = new Endpoints(participant, program.types, complaints);
    this.#codec = new Codec(program.types);
    this.#program = program;
    this.#name = name;
    this.#answer = answer;
    this.#printer = printer;
    this.#complaints = complaints;
    this.#turn.port1.onmessage = ({ data: name }) => this.#resting.delete(name);
  }

  /** Handle a message of the script. @param {any} data */
  receive(data) {
    const { command, topic, message, role, gid } = Object(data);
    const texts = { topic, message, role };
    const needs = COMMANDS.get(command);
    if (!needs) {
      const what = typeof command === "string" ? `'${shown(command)}'` : shown(data);
      this.#complaints.add(`command ${what}`, `sent ${what}, which is not a command`);
      return;
    }
    const lacks = needs.find((key) => typeof texts[key] !== "string");
    if (lacks) {
      const what = `sent '${command}' with ${shown(texts[lacks])} for '${lacks}', which must be text`;
      this.#complaints.add(`${command} ${lacks}`, what);
      return;
    }
    switch (command) {
      case "register":
        this.#register(absolute(topic), role, gid);
        break;
      case "deregister":
        this.#deregister(absolute(topic), role, gid);
        break;
      case "publish":
        this.#publish(absolute(topic), message);
        break;
      case "retrieve":
        this.#retrieve(absolute(topic), topic);
        break;
      case "console":
        this.#print(message);
        break;
    }
  }

  /** The graph has changed. */
  look() {
    for (const endpoint of this.#held.values()) endpoint.look();
  }

  /** @param {string} name @param {string} role @param {unknown} gid */
  #register(name, role, gid) {
    const { kind, of, type } = this.#meaning(name, role);
    const key = type && `${kind} ${of}`;
    this.#registered.push({ gid, role, name, endpoint: key });
    if (!type) this.#without.add(name);
    if (!type || this.#held.has(key)) return;
    this.#enterNode(this.#node || `/${this.#name}`);
    const endpoint = this.#endpoints.create(kind, this.#node, of, type);
    this.#held.set(key, endpoint);
    for (const topic of endpoint.out) this.#outlets.set(topic, endpoint);
    for (const topic of endpoint.in) this.#inlets.set(topic, endpoint);
    endpoint.look();
  }

  /**
   * Return the endpoint that a registration stands for; it has none if `type` is empty.
   * @param {string} name @param {string} role @returns {{kind: Kind, of: string, type: string}}
   */
  #meaning(name, role) {
    const none = { kind: /** @type {Kind} */ ("publisher"), of: name, type: "" };
    const { topics } = this.#program;
    const kind = KINDS.get(role);
    const own = topics[name] ? null : ownOf(name);
    if (own) {
      if (own.node) this.#enterNode(own.node);
      return none;
    }
    if (!kind) {
      const what = ACTIONS.includes(role)
        ? `registered as ${role} of ${shown(name)}; ROS2WASM does not define how the parts of an action ` +
          "travel, so it cannot be reached"
        : `registered as '${shown(role)}' of ${shown(name)}, which is not a role`;
      this.#complaints.add(`role ${role} ${name}`, what);
      return none;
    }
    const isTopic = kind === "publisher" || kind === "subscription";
    const part = isTopic && !topics[name] ? partOf(name) : null;
    if (part && (topics[part.service] || this.#without.has(part.service))) {
      const asks = part.isRequest === (kind === "publisher");
      return { kind: asks ? "client" : "service", of: part.service, type: topics[part.service] ?? "" };
    }
    const type = topics[name] ?? "";
    if (type.includes(isTopic ? "/msg/" : "/srv/")) return { kind, of: name, type };
    const wanted = isTopic ? "package/msg/Name" : "package/srv/Name";
    const given = type ? `, whose type in site.yaml is ${type}` : ", whose type is not in site.yaml";
    this.#complaints.add(
      `type ${name}`,
      `registered as ${role} of ${shown(name)}${given}; ` +
        `give '${this.#name}' there types: {${shown(name)}: ${wanted}}`,
    );
    return none;
  }

  /**
   * Scripts send the topic that they registered last instead of the one to deregister; the gid is correct.
   * @param {string} name @param {string} role @param {unknown} gid
   */
  #deregister(name, role, gid) {
    const same = this.#registered.filter((one) => one.gid === gid && one.role === role);
    const gone = same.find((one) => one.name === name) ?? same[0];
    if (!gone) {
      const what = `unregistered ${shown(name)} (${shown(role)}), which it had not registered`;
      this.#complaints.add(`deregister ${name}`, what);
      return;
    }
    this.#registered.splice(this.#registered.indexOf(gone), 1);
    const endpoint = this.#held.get(gone.endpoint);
    if (endpoint && !this.#registered.some((one) => one.endpoint === gone.endpoint)) {
      this.#held.delete(gone.endpoint);
      for (const routes of [this.#outlets, this.#inlets]) {
        for (const [topic, one] of routes) if (one === endpoint) routes.delete(topic);
      }
      this.#participant.destroy(endpoint.id);
    }
    if (this.#registered.length === 0) this.#leaveNodes();
  }

  /** @param {string} name @param {string} yaml */
  #publish(name, yaml) {
    const outlet = this.#outlets.get(name);
    if (outlet) outlet.send(yaml);
    else this.#tellUnknown(name, "published on", "publisher");
  }

  /** @param {string} name @param {string} topic as the script wrote it */
  #retrieve(name, topic) {
    const inlet = this.#inlets.get(name);
    if (!inlet) this.#tellUnknown(name, "asked for messages of", "subscriber");
    if (!inlet || this.#resting.has(name)) return;
    const message = inlet.take();
    if (message === undefined) return;
    this.#answer({ topic, message });
    this.#resting.add(name);
    // A message queues behind the requests that have arrived in the meantime.
    setTimeout(() => this.#turn.port2.postMessage(name), REST);
  }

  /** @param {string} name @param {string} did @param {string} role */
  #tellUnknown(name, did, role) {
    if (this.#without.has(name)) return; // reported when it was registered
    this.#complaints.add(`unknown ${role} ${name}`, `${did} ${shown(name)} and is no ${role} of it`);
  }

  /** @param {string} text */
  #print(text) {
    for (const line of toLines(text)) this.#printer.print(line.severity, line.text);
    const entry = toLog(text);
    if (entry && this.#log) this.#participant.publish(this.#log, this.#codec.write(LOG, entry));
    this.#participant.flush();
  }

  /** Assign the next registrations to a node. @param {string} node */
  #enterNode(node) {
    this.#node = node;
    if (this.#nodes.has(node)) return;
    this.#nodes.set(node, this.#participant.create("node", node, "", "", DEFAULT_QOS));
    this.#log ||= this.#participant.create("publisher", node, ROSOUT, LOG, { ...DEFAULT_QOS, ...ROSOUT_QOS });
  }

  /** Remove all nodes, because nothing is registered any more. */
  #leaveNodes() {
    for (const id of [...this.#nodes.values(), this.#log]) this.#participant.destroy(id);
    this.#nodes.clear();
    this.#node = "";
    this.#log = 0;
  }
}
