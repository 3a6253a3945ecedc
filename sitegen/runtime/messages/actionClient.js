// @ts-check
// Actions as a client uses them: goals with feedback, status and result, from three services and two topics.

import { say } from "../ui/words.js";
import { hex } from "./hex.js";

/** @import { Ros } from "../protocol.js" */

/**
 * @typedef {"sending" | "rejected" | "lost" | "unknown" | "accepted" | "executing" | "canceling" | "succeeded" |
 *   "canceled" | "aborted"} GoalState
 * @typedef {{id: string, own: boolean, state: GoalState, since: number, feedback: any, result: any, fault: string,
 *   ended: Promise<void>}} Goal `since` is when this client learned of it (ms since 1970), `own` whether this client
 *   sent it, and `fault` why there is no result. `ended` resolves when its state is final
 */

/** The states of action_msgs/msg/GoalStatus, by number. @type {GoalState[]} */
const STATES = ["unknown", "accepted", "executing", "canceling", "succeeded", "canceled", "aborted"];
/** @type {Set<GoalState>} */
const FINAL = new Set(["rejected", "lost", "succeeded", "canceled", "aborted"]);
/** Goals of which more is not remembered; those that ended first are forgotten first. */
const MOST = 50;

const SEND = "/_action/send_goal";
const NAMES = { send: SEND, cancel: "/_action/cancel_goal", result: "/_action/get_result" };
/** The QoS of the topics in ROS 2. */
const STATUS_QOS = { depth: 1, reliable: true, transientLocal: true };
const FEEDBACK_QOS = { depth: 10, reliable: true };
/** By return code of action_msgs/srv/CancelGoal. */
const REFUSED = say("the server refused to cancel");
const REFUSALS = ["", REFUSED, say("the server does not know this goal"), say("the goal has ended already")];

/** Whether a goal in this state does not change any more. @param {GoalState} state */
export function isFinal(state) {
  return FINAL.has(state);
}

/**
 * The actions of the graph.
 * @param {Ros} ros @returns {{name: string, types: string[], servers: string[]}[]}
 */
export function actionsOf(ros) {
  return ros.graph.services().filter(({ name }) => name.endsWith(SEND)).map(({ name, types, servers }) => ({
    name: name.slice(0, -SEND.length),
    types: types.map((type) => type.replace(/_SendGoal$/, "")),
    servers,
  }));
}

/** A client of one action. Emits `change` (detail: Goal) when anything about a goal changes. */
export class ActionClient extends EventTarget {
  #ros;
  #action;
  #type;
  /** By id; those of others only while `watch` lasts. @type {Map<string, Goal>} */
  goals = new Map();
  /** @type {Map<string, () => void>} */
  #ends = new Map();
  /** The goals whose result is waited for. @type {Set<string>} */
  #asked = new Set();
  #closed = new AbortController();

  /** @param {Ros} ros @param {string} action @param {string} type such as "example_interfaces/action/Fibonacci" */
  constructor(ros, action, type) {
    super();
    this.#ros = ros;
    this.#action = action;
    this.#type = type;
  }

  /** Return the first type that the page has no definition of, or "". */
  get missing() {
    const parts = ["SendGoal_Request", "SendGoal_Response", "GetResult_Request", "GetResult_Response", "FeedbackMessage"];
    const names = [
      ...parts.map((part) => `${this.#type}_${part}`), "action_msgs/srv/CancelGoal_Request",
      "action_msgs/srv/CancelGoal_Response", "action_msgs/msg/GoalStatusArray",
    ];
    return names.find((name) => !this.#ros.types[name]) ?? "";
  }

  /** Follow the feedback and the states of all goals. @returns {() => void} stop */
  watch() {
    const ends = [
      this.#ros.subscribe(`${this.#action}/_action/feedback`, `${this.#type}_FeedbackMessage`, (message) => {
        const goal = this.#known(message.goal_id.uuid);
        goal.feedback = message.feedback;
        this.#changed(goal);
      }, FEEDBACK_QOS),
      this.#ros.subscribe(`${this.#action}/_action/status`, "action_msgs/msg/GoalStatusArray", (message) => {
        for (const { goal_info: { goal_id: { uuid } }, status } of message.status_list) {
          this.#follow(uuid, STATES[status] ?? "unknown");
        }
      }, STATUS_QOS),
    ];
    return () => ends.forEach((end) => end());
  }

  /** Send a goal. @param {any} request its fields @returns {Goal} */
  send(request) {
    const uuid = crypto.getRandomValues(new Uint8Array(16));
    const goal = this.#add(uuid, true);
    this.#run(goal, uuid, request);
    return goal;
  }

  /** Ask the server to cancel a goal. Reject with the reason if it refuses. @param {Goal} goal */
  async cancel({ id }) {
    const uuid = Uint8Array.from(id.match(/../g) ?? [], (byte) => parseInt(byte, 16));
    const request = { goal_info: { goal_id: { uuid }, stamp: { sec: 0, nanosec: 0 } } };
    const { return_code: code } = await this.#call("cancel", "action_msgs/srv/CancelGoal", request, 5000);
    if (code !== 0) throw new Error(REFUSALS[code] ?? REFUSED);
  }

  /** Stop waiting for results. */
  close() {
    this.#closed.abort(new Error(say("closed")));
  }

  /** @param {Goal} goal @param {Uint8Array} uuid @param {any} request */
  async #run(goal, uuid, request) {
    try {
      const sent = { goal_id: { uuid }, goal: request };
      const { accepted } = await this.#call("send", `${this.#type}_SendGoal`, sent, 5000);
      if (!accepted) {
        this.#become(goal, "rejected");
        return;
      }
      if (goal.state === "sending") this.#become(goal, "accepted");
    } catch (error) {
      this.#lose(goal, error);
      return;
    }
    await this.#fetch(goal, uuid);
  }

  /**
   * Wait for the result of a goal; `state` is what it became if the server has forgotten it.
   * @param {Goal} goal @param {Uint8Array} uuid @param {GoalState} [state]
   */
  async #fetch(goal, uuid, state = "lost") {
    if (this.#asked.has(goal.id)) return;
    this.#asked.add(goal.id);
    const gone = new AbortController();
    const look = () => {
      const service = this.#ros.graph.services().find(({ name }) => name === this.#action + NAMES.result);
      if (!service?.servers.length) gone.abort(new Error(say("the server of {} ended", this.#action)));
    };
    this.#ros.graph.addEventListener("change", look);
    try {
      const { status, result } = await this.#call(
        "result", `${this.#type}_GetResult`, { goal_id: { uuid } }, Infinity, gone.signal);
      const known = STATES[status] ?? "unknown";
      if (isFinal(known)) goal.result = result;
      this.#become(goal, isFinal(known) ? known : state);
    } catch (error) {
      this.#lose(goal, error);
    } finally {
      this.#ros.graph.removeEventListener("change", look);
      this.#asked.delete(goal.id);
    }
  }

  /**
   * @param {keyof typeof NAMES} name @param {string} type @param {any} request @param {number} timeout
   * @param {AbortSignal} [signal]
   */
  #call(name, type, request, timeout, signal) {
    const signals = [this.#closed.signal, ...(signal ? [signal] : [])];
    return this.#ros.call(this.#action + NAMES[name], type, request, timeout, AbortSignal.any(signals));
  }

  /**
   * Take the state of a goal from the topic; the results of other clients' goals come by the same service.
   * @param {Uint8Array} uuid @param {GoalState} state
   */
  #follow(uuid, state) {
    const before = this.goals.get(hex(uuid));
    // A final state of an own goal comes with its result.
    if (before && (isFinal(before.state) || (before.own && isFinal(state)) || before.state === state)) return;
    const goal = before ?? this.#known(uuid);
    if (!isFinal(state)) this.#become(goal, state);
    else this.#fetch(goal, uuid, state);
  }

  /** @param {Uint8Array} uuid */
  #known(uuid) {
    return this.goals.get(hex(uuid)) ?? this.#add(uuid, false);
  }

  /** @param {Uint8Array} uuid @param {boolean} own @returns {Goal} */
  #add(uuid, own) {
    const id = hex(uuid);
    /** @type {Promise<void>} */
    const ended = new Promise((resolve) => this.#ends.set(id, resolve));
    /** @type {Goal} */
    const goal = {
      id, own, state: own ? "sending" : "unknown", since: Date.now(), feedback: undefined, result: undefined, fault: "",
      ended,
    };
    this.goals.set(id, goal);
    for (const [old, { state }] of this.goals) {
      if (this.goals.size <= MOST) break;
      if (isFinal(state)) this.goals.delete(old);
    }
    this.#changed(goal);
    return goal;
  }

  /** @param {Goal} goal @param {unknown} error */
  #lose(goal, error) {
    goal.fault = error instanceof Error ? error.message : String(error);
    this.#become(goal, "lost");
  }

  /** @param {Goal} goal @param {GoalState} state */
  #become(goal, state) {
    goal.state = state;
    if (isFinal(state)) {
      this.#ends.get(goal.id)?.();
      this.#ends.delete(goal.id);
    }
    this.#changed(goal);
  }

  /** @param {Goal} goal */
  #changed(goal) {
    this.dispatchEvent(new CustomEvent("change", { detail: goal }));
  }
}
