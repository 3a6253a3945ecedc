// @ts-check
// Operations of a server of actions: advertise_action, unadvertise_action, action_feedback, action_result, action_status.

import { ActionServer, STATUS } from "../client/actionServer.js";
import { fullName, fullType } from "../client/names.js";
import { checkFields, Mistake, textOf } from "./mistake.js";
import { MOST_NAMES } from "./limits.js";

/** @import { ServedGoal } from "../client/actionServer.js" */
/** @import { Session } from "./session.js" */

export class ActionServers {
  #session;
  /** @type {Map<string, ActionServer>} */
  #served = new Map();
  /** By the id that the client knows. @type {Map<unknown, {goal: ServedGoal, action: string, type: string}>} */
  #goals = new Map();
  #next = 1;

  /** @param {Session} session */
  constructor(session) {
    this.#session = session;
  }

  /** @type {Record<string, (message: any) => void>} */
  operations = {
    advertise_action: (message) => this.#advertise(message),
    unadvertise_action: (message) => this.#unadvertise(message),
    action_feedback: (message) => this.#feedback(message),
    action_result: (message) => this.#result(message),
    // What a goal is doing follows from its results.
    action_status: () => {},
  };

  /** @param {any} message */
  #advertise(message) {
    checkFields(message, { action: "string", type: "string" });
    const action = fullName(message.action);
    const type = fullType(message.type, "action");
    const { raw, values } = this.#session;
    if (!values.knows(`${type}_SendGoal_Request`)) throw new Mistake(`this page has no definition of ${type}`);
    this.#served.get(action)?.close();
    if (this.#served.size >= MOST_NAMES) throw new Mistake("advertise_action: too many actions");
    this.#served.set(action, new ActionServer(raw, action, type, {
      accepted: () => this.#goals.size < MOST_NAMES,
      execute: (goal) => {
        const id = `action_goal:${action}:${this.#next++}`;
        this.#goals.set(id, { goal, action, type });
        goal.ended.then(() => this.#goals.delete(id));
        const args = values.toJson(`${type}_Goal`, goal.request);
        this.#session.send({ op: "send_action_goal", id, action, action_type: type, args, feedback: true });
      },
      cancel: (goal) => {
        const [id] = [...this.#goals].find(([, one]) => one.goal === goal) ?? [];
        if (id !== undefined) this.#session.send({ op: "cancel_action_goal", id, action });
        return true;
      },
    }));
  }

  /** @param {any} message */
  #unadvertise(message) {
    checkFields(message, { action: "string" });
    const action = fullName(message.action);
    const server = this.#served.get(action);
    if (!server) throw new Mistake(`unadvertise_action: this client does not advertise ${action}`);
    this.#served.delete(action);
    server.close();
  }

  /** @param {any} message */
  #feedback(message) {
    checkFields(message, { action: "string", "values?": "object" });
    const { goal, type } = this.#known(message);
    goal.publish(this.#session.values.read(`${type}_Feedback`, message.values));
  }

  /** @param {any} message */
  #result(message) {
    checkFields(message, { action: "string", "status?": "number", "result?": "boolean" });
    const { goal, type } = this.#known(message);
    if (message.result === false) {
      const { action, id, values = "no reason given" } = message;
      this.#session.status("info", `${action}: ${textOf(values)}`, id);
      goal.finish(STATUS.aborted, {});
      return;
    }
    const { status = STATUS.succeeded } = message;
    if (status < STATUS.succeeded || status > STATUS.aborted || !Number.isInteger(status)) {
      throw new Mistake("action_result: 'status' is 4 (succeeded), 5 (canceled) or 6 (aborted)");
    }
    goal.finish(status, this.#session.values.read(`${type}_Result`, message.values));
  }

  /** @param {any} message */
  #known({ op, id, action }) {
    const known = this.#goals.get(id);
    if (!known) throw new Mistake(`${op}: ${action} has no active goal with this id`);
    return known;
  }
}
