// @ts-check
// Operations of a client of actions: send_action_goal, cancel_action_goal.

import { STATUS } from "../client/actionServer.js";
import { fullName, fullType } from "../client/names.js";
import { ActionClient, isFinal } from "../messages/actionClient.js";
import { checkFields, Mistake, textOf } from "./mistake.js";
import { MOST_NAMES } from "./limits.js";

/** @import { Ros } from "../protocol.js" */
/** @import { Goal } from "../messages/actionClient.js" */
/** @import { Session } from "./session.js" */
/**
 * @typedef {{feedback(values: any): void, state(status: number): void, done(status: number, values: any, result:
 *   boolean): void}} Told
 */

/** Actions that ROS has replaced by others, and that roslib's examples still name. @type {Record<string, string>} */
const NEWER = { "action_tutorials_interfaces/action/Fibonacci": "example_interfaces/action/Fibonacci" };

export class Actions {
  #session;
  /** By name and type. @type {Map<string, ActionClient>} */
  #clients = new Map();
  /** What cancels a goal, by the client's id of it. @type {Map<unknown, () => void>} */
  #goals = new Map();

  /** @param {Session} session */
  constructor(session) {
    this.#session = session;
  }

  /** @type {Record<string, (message: any) => void>} */
  operations = {
    send_action_goal: (message) => this.#send(message),
    cancel_action_goal: (message) => this.#cancel(message),
  };

  close() {
    for (const client of this.#clients.values()) client.close();
  }

  /** @param {any} message */
  #send(message) {
    const { id, action } = message;
    // Without an id, a goal cannot be canceled.
    const key = id ?? Symbol("goal");
    const about = { ...(id !== undefined && { id }), action };
    const { compression = "none", fragment_size: fragment } = message;
    const form = compression === "png" ? "png" : "none";
    /** @type {Told} */
    const told = {
      feedback: (values) => {
        if (message.feedback) this.#session.send({ op: "action_feedback", ...about, values }, form, fragment);
      },
      state: (status) => this.#session.send({ op: "action_status", ...about, status }),
      done: (status, values, result) => {
        this.#goals.delete(key);
        this.#session.send({ op: "action_result", ...about, values, status, result }, form, fragment);
      },
    };
    try {
      checkFields(message, { action: "string", action_type: "string", "args?": "object" });
      if (this.#goals.has(key)) throw new Mistake("send_action_goal: there is a goal with this id already");
      if (this.#goals.size >= MOST_NAMES) throw new Mistake("send_action_goal: too many goals");
      this.#goals.set(key, this.start(action, message.action_type, message.args, told));
    } catch (error) {
      this.#session.status("error", textOf(error), id);
      told.done(STATUS.unknown, textOf(error), false);
    }
  }

  /** @param {any} message */
  #cancel(message) {
    checkFields(message, { action: "string" });
    const cancel = this.#goals.get(message.id);
    if (!cancel) throw new Mistake(`cancel_action_goal: this client has no such goal of ${message.action}`);
    cancel();
  }

  /**
   * Begin a goal and return a function that cancels it.
   * @param {string} action @param {string} actionType "" for that of the graph @param {any} args @param {Told} told
   */
  start(action, actionType, args, told) {
    const name = fullName(action);
    const { surroundings, republisher, values } = this.#session;
    const served = surroundings.serversOf(`${name}/_action/send_goal`).length > 0;
    if (!served && /^tf2_web_republisher/.test(actionType)) return republisher.start(args, told);
    if (!served) throw new Mistake(`there is no action ${name}`);
    const there = surroundings.typeOf("services", `${name}/_action/send_goal`).replace(/_SendGoal$/, "");
    const given = actionType ? fullType(actionType, "action") : there;
    const type = NEWER[given] === there ? there : given;
    if (type !== there) throw new Mistake(`${name} has the type ${there}, not ${type}`);
    const client = this.#clientOf(name, type);
    const goal = client.send(values.read(`${type}_Goal`, args));
    this.#follow(client, goal, type, told);
    return () => client.cancel(goal).catch((error) => this.#session.status("warning", `${name}: ${textOf(error)}`));
  }

  /** @param {ActionClient} client @param {Goal} goal @param {string} type @param {Told} told */
  #follow(client, goal, type, told) {
    const { values } = this.#session;
    let { feedback, state } = goal;
    const changed = (/** @type {Event} */ event) => {
      if (/** @type {CustomEvent<Goal>} */ (event).detail !== goal) return;
      if (goal.feedback !== feedback) {
        feedback = goal.feedback;
        told.feedback(values.toJson(`${type}_Feedback`, feedback));
      }
      if (goal.state === state) return;
      state = goal.state;
      if (!isFinal(state)) {
        told.state(statusOf(state));
        return;
      }
      client.removeEventListener("change", changed);
      if (goal.result !== undefined) told.done(statusOf(state), values.toJson(`${type}_Result`, goal.result), true);
      else told.done(statusOf(state), goal.fault || `the goal was ${state}`, false);
    };
    client.addEventListener("change", changed);
  }

  /** @param {string} name @param {string} type */
  #clientOf(name, type) {
    const key = `${name} ${type}`;
    let client = this.#clients.get(key);
    if (client) return client;
    const { graph, raw } = this.#session;
    client = new ActionClient(/** @type {Ros} */ (/** @type {unknown} */ ({
      graph, types: raw.types, subscribe: raw.subscribe.bind(raw), call: raw.call.bind(raw),
    })), name, type);
    if (client.missing) throw new Mistake(`this page has no definition of ${client.missing}`);
    client.watch();
    this.#clients.set(key, client);
    return client;
  }
}

/** @param {string} state */
function statusOf(state) {
  return /** @type {Record<string, number>} */ (STATUS)[state] ?? STATUS.unknown;
}
