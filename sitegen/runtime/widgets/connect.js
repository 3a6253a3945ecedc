// @ts-check
// A button that joins the graph behind a gateway, and what became of it.

import { button, create, setNote, setText } from "../ui/elements.js";
import { say } from "../ui/words.js";
import { addressOf, blocked, hint, isAddress } from "./connect/address.js";
import { Countdown } from "./connect/countdown.js";
import { withNested } from "./connect/nested.js";
import { PeopleList } from "./connect/people.js";
import { clockNote, describe, graphText, keptNote, rosbridgeNote, turnNote, untilNote } from "./connect/texts.js";

/** @import { Companion, MessageType, Ros } from "../protocol.js" */
/** @import { Connect, FromGateway, State } from "../gateway/orders.js" */

const WORKER = "gateway/gatewayNode";
// Of what stays out, a page names this many.
const MOST = 20;

/**
 * Show the connection to a gateway.
 * @param {HTMLElement} element
 * @param {Ros} ros
 * @param {{connect: Connect, hashes: Record<string, string>}} options `hashes` are those of the page's types
 * @returns {() => void} unmount
 */
export function mount(element, ros, options) {
  const panel = new ConnectPanel(element, ros, options);
  if (options.connect.autoconnect) panel.join();
  return () => panel.close();
}

class ConnectPanel {
  #ros;
  #connect;
  #hashes;
  #button = button("", "ros-start", () => this.#press());
  /** Several addresses are a choice. */
  #choice = create("select", "ros-connect-choice");
  /** For gateways that ask for one. */
  #key = create("input", "ros-connect-key");
  #state = create("p", "ros-connect-state");
  #notes = create("div", "ros-connect-notes");
  #clock = create("p", "ros-connect-note");
  #nodes = create("ul", "ros-connect-nodes");
  #title = create("p", "ros-connect-note");
  #good = new Countdown();
  #turn = new Countdown();
  #people = new PeopleList();
  /** @type {Companion | undefined} */
  #worker;
  /** @type {State} */
  #now = "off";
  #graph = "";
  /** What stays out, and why. @type {Set<string>} */
  #kept = new Set();
  /** @type {ReturnType<typeof setInterval> | undefined} */
  #timer;

  /**
   * @param {HTMLElement} element @param {Ros} ros
   * @param {{connect: Connect, hashes: Record<string, string>}} options
   */
  constructor(element, ros, { connect, hashes }) {
    this.#ros = ros;
    this.#connect = connect;
    this.#hashes = hashes;
    for (const address of connect.addresses) this.#choice.append(new Option(addressOf(address), address));
    this.#choice.setAttribute("aria-label", say("Gateway"));
    this.#state.setAttribute("role", "status");
    this.#choice.hidden = connect.addresses.length < 2;
    this.#key.type = "password";
    this.#key.autocomplete = "off";
    this.#key.placeholder = say("Key");
    this.#key.setAttribute("aria-label", say("Key"));
    this.#key.addEventListener("keydown", ({ key }) => key === "Enter" && this.#isIdle() && this.join());
    this.#key.hidden = true;
    const title = create("span", "ros-title", say("Connection"));
    const controls = create("div", "ros-controls", this.#choice, this.#key, this.#button);
    const body = create(
      "div", "ros-connect-body", this.#state, this.#turn.element, this.#good.element, this.#clock, this.#notes, this.#people.element,
      this.#title, this.#nodes);
    const bar = create("div", "ros-bar", title, controls);
    element.replaceChildren(bar, body);
    this.#listNodes([]);
    this.#show("off");
  }

  /** Join the chosen gateway. */
  join() {
    const address = addressOf(this.#choice.value);
    const why = isAddress(address) ? blocked(address) : say("'{}' is not an address", address);
    this.#clearNotes();
    if (why) {
      this.#show("refused", why);
      return;
    }
    this.#worker ??= this.#ros.join(WORKER, (message) => this.#hear(message), (error) => this.#fail(error));
    this.#worker.tell({ op: "connect", address, connect: this.#connect, hashes: this.#hashes, key: this.#key.value });
    this.#show("connecting");
  }

  close() {
    clearInterval(this.#timer);
    this.#good.end();
    this.#turn.end();
    this.#worker?.leave();
    this.#worker = undefined;
  }

  #press() {
    if (this.#isIdle()) this.join();
    else this.#worker?.tell({ op: "disconnect" });
  }

  #isIdle() {
    return ["off", "key", "refused", "ended"].includes(this.#now);
  }

  /** @param {FromGateway} message */
  #hear(message) {
    switch (message.op) {
      case "state":
        this.#show(message.state, message.reason, message.retry);
        break;
      case "joined":
        this.#graph = graphText(message);
        this.#clearNotes();
        if (message.rmw === "rosbridge") this.#note(rosbridgeNote());
        break;
      case "nodes":
        this.#listNodes(message.nodes);
        break;
      case "kept":
        this.#note(keptNote(message.name, message.reason));
        break;
      case "note":
        this.#note(`${message.name}: ${message.reason}`);
        break;
      case "differs":
        this.#note(say("{} is left out: its type {} differs from the one that this page was built with.",
          message.name, message.type));
        break;
      case "until":
        this.#until(message.seconds);
        break;
      case "people":
        this.#people.show(message.people);
        break;
      case "turn":
        this.#turn.begin((passed) => turnNote(message, passed));
        break;
      case "types":
        this.#learn(message.types);
        break;
      case "describe":
        this.#worker?.tell({ op: "types", types: withNested(this.#ros.types, message.types) });
        break;
      case "clock":
        setText(this.#clock, clockNote(message.offset));
        break;
    }
  }

  /** @param {number | null} seconds for which the key is good */
  #until(seconds) {
    if (seconds === null) this.#good.end();
    else this.#good.begin((passed) => untilNote(seconds - passed));
  }

  /** Let panels read and write messages of types that come from elsewhere. @param {Record<string, MessageType>} types */
  #learn(types) {
    const known = this.#ros.types;
    for (const [name, type] of Object.entries(types)) known[name] ??= type;
    this.#ros.graph.dispatchEvent(new Event("change"));
  }

  /** @param {string} error */
  #fail(error) {
    this.#worker = undefined;
    this.#show("refused", error);
  }

  /** @param {State} state @param {string} [reason] @param {number} [retry] ms */
  #show(state, reason = "", retry = 0) {
    this.#now = state;
    clearInterval(this.#timer);
    const idle = this.#isIdle();
    this.#button.className = idle ? "ros-start" : "ros-stop";
    setText(this.#button, idle ? say("Connect") : say("Disconnect"));
    this.#choice.disabled = !idle;
    this.#key.disabled = !idle;
    if (state === "key") {
      this.#key.hidden = false;
      this.#key.focus();
    }
    this.#state.dataset.connection = state;
    const address = addressOf(this.#choice.value);
    const until = Date.now() + retry;
    const write = () => {
      const seconds = Math.max(0, Math.ceil((until - Date.now()) / 1000));
      const text = describe(state, { address, graph: this.#graph, reason, seconds });
      const more = state === "lost" ? hint(address) : "";
      setNote(this.#state, more ? `${text} ${more}` : text, ["late", "lost", "refused"].includes(state));
    };
    write();
    if (state === "lost") this.#timer = setInterval(write, 1000);
    if (state === "connected" || state === "late") return;
    setText(this.#clock, "");
    this.#people.hide();
    this.#good.end();
    this.#turn.end();
  }

  /** @param {string} text */
  #note(text) {
    if (this.#kept.has(text) || this.#kept.size >= MOST) return;
    this.#kept.add(text);
    this.#notes.append(create("p", "ros-connect-note", text));
  }

  #clearNotes() {
    this.#kept.clear();
    this.#notes.replaceChildren();
  }

  /** @param {string[]} nodes */
  #listNodes(nodes) {
    setText(this.#title, nodes.length > 0 ? say("Remote nodes") : "");
    this.#nodes.replaceChildren(...nodes.map((name) => create("li", "", name)));
  }
}
