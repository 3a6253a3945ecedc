// @ts-check
// A managed node: its state, and a button for each transition.

import { button, create, setNote, setText } from "../../ui/elements.js";
import { say } from "../../ui/words.js";

/** @import { Ros } from "../../protocol.js" */

const SRV = "lifecycle_msgs/srv";
const EVENT = "lifecycle_msgs/msg/TransitionEvent";
const GET_STATE = "/get_state";
const SERVICES = ["get_state", "get_available_transitions", "change_state"];
/** The types that the page needs. */
export const TYPES = [
  `${SRV}/GetState_Request`, `${SRV}/GetAvailableTransitions_Request`, `${SRV}/ChangeState_Request`,
];
/** Transitions from this id on are results of callbacks, which nobody can ask for; see lifecycle_msgs/msg/Transition. */
const RESULTS = 10;

/** The full names of the managed nodes, as soon as all of these services have servers. @param {Ros} ros */
export function managedNodes(ros) {
  const services = ros.graph.services();
  const served = new Set(services.filter(({ servers }) => servers.length).map(({ name }) => name));
  return services
    .filter(({ name, types }) => name.endsWith(GET_STATE) && types.includes(`${SRV}/GetState`))
    .map(({ name }) => name.slice(0, -GET_STATE.length))
    .filter((node) => SERVICES.every((service) => served.has(`${node}/${service}`)));
}

export class ManagedNode {
  #ros;
  #name;
  #state = create("span", "ros-managed-state");
  #buttons = create("div", "ros-controls");
  #note = create("p", "ros-note");
  /** @type {(() => void) | undefined} */
  #unfollow;
  #closed = new AbortController();
  /** Counts queries: only the last one is shown. */
  #queries = 0;
  #changing = false;
  element;

  /** @param {Ros} ros @param {string} name */
  constructor(ros, name) {
    this.#ros = ros;
    this.#name = name;
    this.#note.setAttribute("role", "status");
    this.#buttons.setAttribute("role", "group");
    this.#buttons.setAttribute("aria-label", say("transitions of {}", name));
    const head = create("div", "ros-managed-head", create("b", "ros-name", name), this.#state);
    this.element = create("li", "ros-managed", head, this.#buttons, this.#note);
  }

  /** Follow the state; others may change it, too. */
  follow() {
    if (this.#unfollow) return;
    const known = this.#ros.types[EVENT];
    this.#unfollow = known
      ? this.#ros.subscribe(`${this.#name}/transition_event`, EVENT, () => this.#look(), { depth: 10, reliable: true })
      : () => {};
    this.#look();
  }

  rest() {
    this.#unfollow?.();
    this.#unfollow = undefined;
  }

  close() {
    this.rest();
    this.#closed.abort(new Error(say("{} ended", this.#name)));
  }

  /** Ask for the state and the transitions. */
  async #look() {
    const mine = ++this.#queries;
    try {
      const [{ current_state: state }, { available_transitions: available }] = await Promise.all([
        this.#call("get_state", "GetState", {}, 5000),
        this.#call("get_available_transitions", "GetAvailableTransitions", {}, 5000),
      ]);
      if (mine !== this.#queries) return;
      setText(this.#state, state.label);
      this.element.dataset.state = state.label;
      const transitions = available.map((/** @type {any} */ { transition }) => transition);
      this.#offer(transitions.filter((/** @type {{id: number}} */ { id }) => id < RESULTS));
    } catch (error) {
      if (mine === this.#queries && !this.#closed.signal.aborted) this.#fail(error);
    }
  }

  /** @param {{id: number, label: string}[]} transitions */
  #offer(transitions) {
    const shown = [...this.#buttons.children].map(({ textContent }) => textContent).join();
    if (shown !== transitions.map(({ label }) => label).join()) {
      const focused = this.#buttons.contains(document.activeElement);
      this.#buttons.replaceChildren(...transitions.map((transition) =>
        button(transition.label, "", () => this.#change(transition))));
      if (focused) this.#buttons.querySelector("button")?.focus();
    }
    this.#enable();
  }

  #enable() {
    const buttons = [...this.#buttons.children];
    // A disabled button would lose the keyboard focus, which the next transition needs.
    for (const one of buttons) one.setAttribute("aria-disabled", String(this.#changing));
  }

  /** @param {{id: number, label: string}} transition */
  async #change(transition) {
    if (this.#changing) return;
    this.#changing = true;
    this.#enable();
    setNote(this.#note, say("{}…", transition.label));
    try {
      const { success } = await this.#call("change_state", "ChangeState", { transition }, Infinity);
      setNote(this.#note, success ? say("{}: done", transition.label) : say("{}: failed", transition.label), !success);
    } catch (error) {
      this.#fail(error);
    }
    this.#changing = false;
    await this.#look();
  }

  /** @param {unknown} error */
  #fail(error) {
    setNote(this.#note, error instanceof Error ? error.message : String(error), true);
  }

  /** @param {string} service @param {string} type @param {any} request @param {number} timeout */
  #call(service, type, request, timeout) {
    return this.#ros.call(`${this.#name}/${service}`, `${SRV}/${type}`, request, timeout, this.#closed.signal);
  }
}
