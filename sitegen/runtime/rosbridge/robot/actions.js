// @ts-check
// Actions of the robot for the page. rosbridge has goals with feedback and a result; the page has the three services and
// two topics of an action.

import { hex } from "../../messages/hex.js";
import { stamp } from "../../messages/time.js";
import { now } from "../../protocol.js";
import { Mistake, textOf } from "../mistake.js";
import { reasonOf } from "./calls.js";

/** @import { RemoteEndpoint } from "../../gateway/wire.js" */
/** @import { Head } from "../../protocol.js" */
/** @import { Bridge } from "./bridge.js" */
/**
 * @typedef {{action: string, type: string, uuid: Uint8Array, accepted: {sec: number, nanosec: number}, status: number,
 *   result: any, waiting: (() => void)[]}} Goal `status` is as in action_msgs/msg/GoalStatus, and `waiting` are
 *   questions for the result
 */

const PART = /^(.+)\/_action\/(\w+)$/;
const [EXECUTING, CANCELING, ABORTED] = [2, 3, 6];
const GOALS = "action_msgs/msg/GoalStatusArray";
// Goals that are remembered.
const MOST = 200;

export class Actions {
  #bridge;
  /** By action, then by id. @type {Map<string, Map<string, Goal>>} */
  #goals = new Map();
  /** Messages of each topic. @type {Map<number, number>} */
  #sequences = new Map();

  /** @param {Bridge} bridge */
  constructor(bridge) {
    this.#bridge = bridge;
  }

  /**
   * Handle a call of the page for a part of an action.
   * @param {RemoteEndpoint} service @param {Head} head @param {Uint8Array} message
   */
  async call(service, head, message) {
    const [, action = "", part] = PART.exec(service.name) ?? [];
    const { codec, services, types } = this.#bridge;
    const respond = (/** @type {any} */ values) => services.respond(service, head, values);
    try {
      const request = codec.read(`${service.type}_Request`, message);
      await Promise.all([types.need(`${service.type}_Response`), types.need(GOALS)]);
      if (part === "send_goal") await this.#send(action, service.type, request, respond);
      else if (part === "get_result") this.#fetch(action, request, respond);
      else this.#cancel(action, request, respond);
    } catch (error) {
      this.#bridge.note(action, textOf(error));
    }
  }

  /** @param {string} action @param {string} type of the service @param {any} request @param {(values: any) => void} respond */
  async #send(action, type, request, respond) {
    const { goal } = this.#bridge.values.toExact(`${type}_Request`, request);
    const id = hex(request.goal_id.uuid);
    /** @type {Goal} */
    const one = {
      action, type: type.replace(/_SendGoal$/, ""), uuid: request.goal_id.uuid.slice(), accepted: stamp(), status: EXECUTING,
      result: {}, waiting: [],
    };
    await this.#bridge.types.need(`${one.type}_FeedbackMessage`);
    this.#remember(id, one);
    // rosbridge does not tell whether the robot accepts a goal.
    respond({ accepted: true, stamp: one.accepted });
    this.#tellStatus(action);
    try {
      const sent = { op: "send_action_goal", id, action, action_type: one.type, args: goal, feedback: true };
      const { result, values, status } = await this.#bridge.goals.exchange(sent, "action_result", (message) =>
        this.#feed(one, message));
      if (result !== true) throw new Mistake(reasonOf(values));
      // Older servers have the result with its status.
      const isWhole = status === undefined && typeof values?.status === "number";
      one.result = isWhole ? values.result : values;
      one.status = Number(isWhole ? values.status : status);
    } catch (error) {
      one.status = ABORTED;
      this.#bridge.note(action, textOf(error));
    }
    for (const answer of one.waiting.splice(0)) answer();
    this.#tellStatus(action);
  }

  /** @param {Goal} goal @param {any} message of the robot's server */
  #feed({ action, type, uuid }, { op, values }) {
    if (op === "action_feedback") this.#publish(action, "feedback", `${type}_FeedbackMessage`, { goal_id: { uuid }, feedback: values });
  }

  /** @param {string} action @param {any} request @param {(values: any) => void} respond */
  #fetch(action, request, respond) {
    const goal = this.#goals.get(action)?.get(hex(request.goal_id.uuid));
    const answer = () => respond(goal ? { status: goal.status, result: goal.result } : { status: 0 });
    if (goal && goal.status <= CANCELING) goal.waiting.push(answer);
    else answer();
  }

  /** @param {string} action @param {any} request @param {(values: any) => void} respond */
  #cancel(action, request, respond) {
    const id = hex(request.goal_info.goal_id.uuid);
    const isAll = /^0*$/.test(id);
    const meant = [...(this.#goals.get(action) ?? [])].filter(([own, { status }]) => (isAll || own === id) && status <= CANCELING);
    for (const [own, goal] of meant) {
      goal.status = CANCELING;
      const message = { op: "cancel_action_goal", id: own, action };
      // rosbridge_server knows goals of all connections, but may not read this one until the goal has ended. Others,
      // such as a gateway behind a proxy, know only those of the same connection.
      this.#bridge.goals.tell(own, message);
      this.#bridge.emit(message);
    }
    const goals = meant.map(([, { uuid, accepted }]) => ({ goal_id: { uuid }, stamp: accepted }));
    respond({ return_code: meant.length > 0 || isAll ? 0 : 2, goals_canceling: goals });
    this.#tellStatus(action);
  }

  /** Whether an id is that of a goal. @param {string} id */
  has(id) {
    return [...this.#goals.values()].some((goals) => goals.has(id));
  }

  /** @param {string} action */
  #tellStatus(action) {
    const goals = [...(this.#goals.get(action)?.values() ?? [])];
    this.#publish(action, "status", GOALS, {
      status_list: goals.map(({ uuid, accepted, status }) => ({ goal_info: { goal_id: { uuid }, stamp: accepted }, status })),
    });
  }

  /** @param {string} action @param {string} part @param {string} type @param {any} values */
  #publish(action, part, type, values) {
    const topic = this.#bridge.remoteNamed("publisher", `${action}/_action/${part}`);
    if (!topic) return;
    const sequence = (this.#sequences.get(topic.id) ?? 0) + 1;
    this.#sequences.set(topic.id, sequence);
    const message = this.#bridge.codec.write(type, this.#bridge.values.read(type, values));
    this.#bridge.deliver({ reader: 0, writer: topic.id, sequence, timestamp: now() }, message);
  }

  /** @param {string} id @param {Goal} goal */
  #remember(id, goal) {
    const goals = this.#goals.get(goal.action) ?? new Map();
    this.#goals.set(goal.action, goals.set(id, goal));
    for (const [old, { status }] of goals) {
      if (goals.size <= MOST) break;
      if (status > CANCELING) goals.delete(old);
    }
  }
}
