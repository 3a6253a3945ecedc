// @ts-check
// A server that speaks rosbridge, as a gateway: what stands between the two protocols is here.

import { Codec } from "../../messages/codec.js";
import { isHidden } from "../../graphNames.js";
import { deliverFrame, endpointsOf, Frames, idsOf, parse } from "../../gateway/wire.js";
import { decode } from "../../vendor/cbor.js";
import { LONGEST_NAME } from "../limits.js";
import { textOf } from "../mistake.js";
import { Values } from "../values.js";
import { Actions } from "./actions.js";
import { ActionServers, SEND } from "./actionServers.js";
import { callOf, Calls, RESPONSE } from "./calls.js";
import { Discovery } from "./discovery.js";
import { parseJson, writeJson } from "./numbers.js";
import { RobotTypes } from "./robotTypes.js";
import { Services } from "./services.js";
import { Topics } from "./topics.js";

/** @import { Head } from "../../protocol.js" */
/** @import { RemoteEndpoint } from "../../gateway/wire.js" */

// rosbridge_server keeps a publisher for 10 s after its client has given it up (ms).
const LINGER = 15_000;
// The service by which the server shows that it is there, and what time it has; it is asked less often than a gateway,
// because each call costs the robot more (ms).
const TIME = "/rosapi/get_time";
const PING = 900;
// rosapi ends at some questions, and these are never answered (ms).
const ANSWER = 10_000;
// Calls of services that the server does not allow are never answered, either; others must not wait for them (ms).
const PATIENCE = 60_000;
// The panel shows fewer.
const MOST_NOTES = 100;
// What the page offers is there soon, or never (ms).
const SOON = 3000;

/** Has what a connection uses of a WebSocket to a gateway. */
export class Bridge {
  /** @type {((event: {data: string | ArrayBuffer}) => void) | null} */
  onmessage = null;
  /** @type {((event: {reason: string}) => void) | null} */
  onclose = null;
  #socket;
  #discovery;
  #topics;
  #actions;
  #actionServers;
  /** For questions about the graph, which calls of the page must not hold up. */
  #rosapi;
  #frames = new Frames((frame) => this.onmessage?.({ data: frame.buffer }));
  #isFlushing = false;
  /** What the robot has, by id. @type {Map<number, RemoteEndpoint>} */
  #remote = new Map();
  /** What the page has, by id. @type {Map<number, RemoteEndpoint>} */
  #own = new Map();
  /** When it was offered, by id. @type {Map<number, number>} */
  #since = new Map();
  /** When something of the page was there last, by kind and name. @type {Map<string, number>} */
  #gone = new Map();
  #described = Promise.resolve();
  #pinged = 0;
  /** Notes are told once. @type {Set<string>} */
  #noted = new Set();

  /** @param {WebSocket} socket that is open */
  constructor(socket) {
    this.#socket = socket;
    // Any answer shows that the server is there.
    const heard = () => this.say({ op: "pong" });
    this.calls = new Calls(socket.url, heard, { patience: PATIENCE });
    this.goals = new Calls(socket.url, heard);
    this.#rosapi = new Calls(socket.url, heard, { timeout: ANSWER });
    this.types = new RobotTypes(
      (wanted) => this.say({ op: "describe", types: wanted }), this.#rosapi, (name, reason) => this.note(name, reason));
    this.codec = new Codec(this.types.all);
    this.values = new Values(this.types.all);
    this.#topics = new Topics(this);
    this.services = new Services(this);
    this.#actions = new Actions(this);
    this.#actionServers = new ActionServers(this);
    this.#discovery = new Discovery(this.#rosapi, {
      change: (come, gone) => this.#change(come, gone),
      note: (name, reason) => this.note(name, reason),
      check: (time, offered) => this.#check(time, offered),
      owns: (kind, name) => this.#owns(kind, name),
      wantsLatched: (topic) => [...this.#own.values()].some(({ kind, name, qos }) =>
        kind === "subscription" && name === topic && qos.transientLocal),
      actionType: (action) => this.ownNamed("client", action + SEND)?.type.replace(/_SendGoal$/, "") ?? "",
    });
    socket.binaryType = "arraybuffer";
    socket.onmessage = ({ data }) => this.#hear(data);
    socket.onclose = ({ reason }) => this.onclose?.({ reason });
    queueMicrotask(() => this.say({ op: "challenge", keys: false }));
  }

  get readyState() {
    return this.#socket.readyState;
  }

  get bufferedAmount() {
    return this.#socket.bufferedAmount;
  }

  /** Handle what a page says to its gateway. @param {string | Uint8Array<ArrayBuffer>} data */
  send(data) {
    if (typeof data === "string") this.#obey(parse(data) ?? {});
    else deliverFrame(data.buffer, (head, message) => this.#pass(head, message));
  }

  close() {
    this.#discovery.close();
    this.calls.close();
    this.goals.close();
    this.#rosapi.close();
    this.#socket.onmessage = this.#socket.onclose = null;
    this.#socket.close();
  }

  /** Send something to the robot's server. @param {object} message */
  emit(message) {
    if (this.readyState === WebSocket.OPEN) this.#socket.send(writeJson(message));
  }

  /** Tell the page something, as a gateway. @param {object} message */
  say(message) {
    this.onmessage?.({ data: JSON.stringify(message) });
  }

  /** Let the page have a message. @param {Head} head @param {Uint8Array} message */
  deliver(head, message) {
    this.#frames.add(head, message);
    if (this.#isFlushing) return;
    this.#isFlushing = true;
    queueMicrotask(() => {
      this.#isFlushing = false;
      this.#frames.flush();
    });
  }

  /** Tell the visitor what fails, once. @param {string} name @param {string} reason */
  note(name, reason) {
    const text = `${name} ${reason}`;
    if (this.#noted.has(text) || this.#noted.size >= MOST_NOTES) return;
    this.#noted.add(text);
    this.say({ op: "note", name, reason });
  }

  /** @param {RemoteEndpoint["kind"]} kind @param {string} name */
  remoteNamed(kind, name) {
    return [...this.#remote.values()].find((one) => one.kind === kind && one.name === name);
  }

  /** @param {RemoteEndpoint["kind"]} kind @param {string} name */
  ownNamed(kind, name) {
    return [...this.#own.values()].find((one) => one.kind === kind && one.name === name);
  }

  /** @param {any} message of the page */
  #obey(message) {
    switch (message.op) {
      case "hello":
        this.#welcome();
        break;
      case "graph":
        for (const id of idsOf(message.gone)) this.#withdraw(id);
        for (const one of endpointsOf(message.come)) this.#offer(one);
        break;
      case "open":
      case "close":
        this.#look(message);
        break;
      case "describe":
        // Answers come in the order of the questions.
        this.#described = this.#described.then(() => this.types.describe(message.types)).then((types) => this.say({ op: "types", types }));
        break;
      case "types":
        this.types.learn(message.types);
        break;
      case "ping":
        this.#ping(message.sent);
        break;
    }
  }

  async #welcome() {
    const { distro = "" } = await this.#rosapi.call("/rosapi/get_ros_version").catch(() => ({}));
    this.say({ op: "welcome", session: 1, time: null, rmw: "rosbridge", domain: null, distribution: distro, until: null });
    this.#discovery.run();
  }

  /** @param {RemoteEndpoint} endpoint of the page */
  #offer(endpoint) {
    const { id, kind, name } = endpoint;
    this.#own.set(id, endpoint);
    this.#since.set(id, performance.now());
    if (isHidden(name)) this.#actionServers.offer(endpoint);
    else if (kind === "publisher") this.#topics.offer(endpoint);
    else if (kind === "service") this.services.offer(endpoint);
  }

  /** @param {number} id of the page */
  #withdraw(id) {
    const own = this.#own.get(id);
    if (!own) return;
    this.#own.delete(id);
    this.#since.delete(id);
    this.#gone.set(`${own.kind} ${own.name}`, performance.now());
    if (isHidden(own.name)) this.#actionServers.withdraw(own);
    else if (own.kind === "publisher") this.#topics.withdraw(own);
    // Of actions, too, whose services are asked.
    if (own.kind === "service") this.services.withdraw(own);
  }

  /**
   * Tell what the server has not taken, as it does not tell it.
   * @param {number} time when it had this @param {Set<string>} offered kinds and names
   */
  #check(time, offered) {
    for (const { id, kind, name, type } of this.#own.values()) {
      const isOffered = kind === "publisher" || this.services.offers(id);
      if (!isOffered || isHidden(name) || time - (this.#since.get(id) ?? 0) < SOON) continue;
      const isTaken = offered.has(`${kind} ${name}`);
      this.#topics.refuse(id, !isTaken);
      if (!isTaken) this.note(name, `the robot's server has not taken it: it may lack ${type}, or not allow the name`);
    }
  }

  /** Whether something of the server may be the page's. @param {RemoteEndpoint["kind"]} kind @param {string} name */
  #owns(kind, name) {
    const gone = this.#gone.get(`${kind} ${name}`) ?? -Infinity;
    if (performance.now() - gone < LINGER) return true;
    return kind === "subscription" ? this.#topics.subscribes(name) : this.ownNamed(kind, name) !== undefined;
  }

  /** @param {RemoteEndpoint[]} come @param {number[]} gone */
  #change(come, gone) {
    for (const one of come) this.#remote.set(one.id, one);
    this.say({ op: "graph", come, gone });
    for (const id of gone) {
      const remote = this.#remote.get(id);
      if (remote) this.#topics.leave(remote);
      this.#remote.delete(id);
    }
  }

  /** @param {{op: string, id: number, rate?: number}} message */
  #look({ op, id, rate }) {
    const remote = this.#remote.get(id);
    // Topics of actions tell of the page's goals.
    if (!remote || isHidden(remote.name)) return;
    if (op === "open") this.#topics.look(remote, rate);
    else this.#topics.leave(remote);
  }

  /**
   * Pass a record of the page on.
   * @param {Head} head @param {Uint8Array} message @param {boolean} [hasAsked] for its type
   */
  #pass(head, message, hasAsked = false) {
    const service = this.#remote.get(head.reader);
    const own = this.#own.get(head.writer);
    const one = service ?? own;
    if (!one) return;
    const type = service ? `${one.type}_Request` : one.kind === "service" ? `${one.type}_Response` : one.type;
    if (!hasAsked && !this.types.has(type)) {
      // Those of one type stay in their order.
      const copy = message.slice();
      this.types.need(type).then(() => this.#pass(head, copy, true));
      return;
    }
    try {
      if (service) (isHidden(service.name) ? this.#actions : this.services).call(service, head, message);
      else if (one.kind === "service") this.services.answer(head.sequence, message);
      else if (isHidden(one.name)) this.#actionServers.feed(one, message);
      else this.#topics.publish(one, message);
    } catch (error) {
      this.note(one.name, textOf(error));
    }
  }

  /** @param {string | ArrayBuffer} data of the robot's server */
  #hear(data) {
    let message;
    try {
      message = typeof data === "string" ? parseJson(data) : decode(new Uint8Array(data));
      this.#receive(message ?? {});
    } catch (error) {
      this.note(String(message?.topic ?? "rosbridge").slice(0, LONGEST_NAME), textOf(error));
    }
  }

  /** @param {any} message */
  #receive(message) {
    switch (message.op) {
      case "publish":
        this.#topics.receive(message);
        break;
      case "call_service":
        this.services.serve(message);
        break;
      case "send_action_goal":
        this.#actionServers.serve(message);
        break;
      case "cancel_action_goal":
        this.#actionServers.cancel(message);
        break;
      case "status":
        this.#complain(message);
        break;
      case "fragment":
        // rosbridge_server does not say correctly how many there are.
        this.note("rosbridge", "a message is larger than max_message_size of rosbridge_server");
        break;
    }
  }

  /** Ask whether the server is there, and for its time. @param {number} sent when the page has asked */
  async #ping(sent) {
    if (sent - this.#pinged < PING) return;
    this.#pinged = sent;
    try {
      const { sec, nanosec } = (await this.#rosapi.exchange(callOf(TIME), RESPONSE)).values?.time ?? {};
      this.say({ op: "pong", id: 1, sent, time: Number(sec) * 1000 + Number(nanosec) / 1e6 });
    } catch {
      // The connection is lost, which its silence tells.
    }
  }

  /** @param {{level?: unknown, msg?: unknown, id?: unknown}} status of the robot's server */
  #complain({ level, msg, id }) {
    const [kind = "", number = ""] = String(id ?? "").split(/:(.*)/);
    // A goal is of another connection, so a server may not know what is to be canceled here.
    if (level !== "error" || this.#actions.has(kind)) return;
    const name = kind === "own" ? this.#own.get(Number(number))?.name : kind === "topic" ? number : undefined;
    this.note(name ?? "rosbridge", String(msg).slice(0, 500));
  }
}
