// @ts-check
// Action servers of the page for the robot.

import { hex } from "../../messages/hex.js";
import { Mistake, textOf } from "../mistake.js";

/** @import { RemoteEndpoint } from "../../gateway/wire.js" */
/** @import { Bridge } from "./bridge.js" */

export const SEND = "/_action/send_goal";
const FEEDBACK = "/_action/feedback";
const ABORTED = 6;

export class ActionServers {
  #bridge;
  /** The services for goals of those that are offered, by action. @type {Map<string, RemoteEndpoint>} */
  #offered = new Map();
  /** Goals of the robot: its id and the page's, by the latter as text. @type {Map<string, {id: unknown, uuid: Uint8Array}>} */
  #running = new Map();

  /** @param {Bridge} bridge */
  constructor(bridge) {
    this.#bridge = bridge;
  }

  /** Offer an action, whose parts come one after another. @param {RemoteEndpoint} endpoint */
  offer(endpoint) {
    const { id, kind, name, type } = endpoint;
    if (kind === "publisher" && name.endsWith(FEEDBACK)) this.#bridge.say({ op: "open", id });
    if (kind !== "service" || !name.endsWith(SEND)) return;
    const action = name.slice(0, -SEND.length);
    this.#offered.set(action, endpoint);
    this.#bridge.emit({ op: "advertise_action", id: `own:${id}`, action, type: type.replace(/_SendGoal$/, "") });
  }

  /** A part of an action of the page has gone. @param {RemoteEndpoint} endpoint */
  withdraw({ id, name }) {
    const action = name.slice(0, -SEND.length);
    if (this.#offered.get(action)?.id !== id) return;
    this.#offered.delete(action);
    this.#bridge.emit({ op: "unadvertise_action", id: `own:${id}`, action });
  }

  /** The robot sends a goal. @param {{id?: unknown, action?: unknown, args?: any}} message */
  async serve({ id, action, args }) {
    const server = this.#offered.get(String(action));
    if (!server) return;
    const uuid = crypto.getRandomValues(new Uint8Array(16));
    this.#running.set(hex(uuid), { id, uuid });
    const answer = { op: "action_result", id, action };
    try {
      for (const type of ["SendGoal", "GetResult"]) await this.#bridge.types.need(server.type.replace(/SendGoal$/, `${type}_Request`));
      const { accepted } = await this.#ask(server, "send_goal", { goal_id: { uuid }, goal: args });
      if (!accepted) throw new Mistake("the server of this page rejected a goal");
      const { status, result } = await this.#ask(server, "get_result", { goal_id: { uuid } });
      this.#bridge.emit({ ...answer, values: result, status, result: true });
    } catch (error) {
      this.#bridge.note(String(action), textOf(error));
      this.#bridge.emit({ ...answer, values: {}, status: ABORTED, result: false });
    } finally {
      this.#running.delete(hex(uuid));
    }
  }

  /** The robot wants a goal to end. @param {{id?: unknown, action?: unknown}} message */
  cancel({ id, action }) {
    const server = this.#offered.get(String(action));
    const goal = [...this.#running.values()].find((one) => one.id === id);
    if (!server || !goal) return;
    this.#bridge.types.need("action_msgs/srv/CancelGoal_Request")
      .then(() => this.#ask(server, "cancel_goal", { goal_info: { goal_id: { uuid: goal.uuid } } }))
      .catch((error) => this.#bridge.note(String(action), textOf(error)));
  }

  /** A server of the page tells how far it is. @param {RemoteEndpoint} publisher @param {Uint8Array} message */
  feed({ name, type }, message) {
    if (!name.endsWith(FEEDBACK)) return;
    const { goal_id: { uuid }, feedback } = this.#bridge.codec.read(type, message);
    const goal = this.#running.get(hex(uuid));
    if (!goal) return;
    const { feedback: values } = this.#bridge.values.toExact(type, { goal_id: { uuid }, feedback });
    this.#bridge.emit({ op: "action_feedback", id: goal.id, action: name.slice(0, -FEEDBACK.length), values });
  }

  /** @param {RemoteEndpoint} server @param {string} part @param {any} args */
  #ask(server, part, args) {
    const name = server.name.replace(/send_goal$/, part);
    const service = this.#bridge.ownNamed("service", name);
    if (!service) throw new Mistake(`${name} is missing`);
    return this.#bridge.services.ask(service, args);
  }
}
