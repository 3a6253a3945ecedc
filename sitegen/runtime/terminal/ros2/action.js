// @ts-check
// ros2 action: list, types and goals of actions.

import { ActionClient, actionsOf, isFinal } from "../../messages/actionClient.js";
import { toYaml } from "../../messages/yaml.js";
import { FLOAT } from "../args/types.js";
import { Failure } from "../shell/shell.js";
import { populated } from "./populate.js";
import { quoted } from "./python.js";
import { fitted, valuesOf } from "./topic/pub.js";
import { absolute, checkName, endpoints, flag, fullType, isType, option, until } from "./verb.js";

/** @import { Goal } from "../../messages/actionClient.js" */
/** @import { Io } from "../shell/shell.js" */
/** @import { Group, Verb } from "./verb.js" */

const SEND = "/_action/send_goal";
const NAME = /** @type {const} */ ({ name: "action_name", complete: "action" });

/** @type {Verb} */
const list = {
  name: "list",
  about: "Output a list of action names",
  args: [
    flag("typed", ["-t", "--show-types"], "Additionally show the action type"),
    flag("count", ["-c", "--count-actions"], "Only display the number of actions discovered"),
  ],
  async run({ ros, out }, { typed, count }) {
    const found = actionsOf(ros);
    if (count) await out(`${found.length}\n`);
    else for (const { name, types } of found) await out(typed ? `${name} [${types.join(", ")}]\n` : `${name}\n`);
  },
};

/** @type {Verb} */
const info = {
  name: "info",
  about: "Print information about an action",
  args: [
    { ...NAME, help: "Name of the ROS action to get info (e.g. '/fibonacci')" },
    flag("typed", ["-t", "--show-types"], "Additionally show the action type"),
    flag("count", ["-c", "--count"], "Only display the number of action clients and action servers"),
  ],
  async run({ ros, out }, { action_name: name, typed, count }) {
    const side = (/** @type {"client" | "service"} */ kind) => endpoints(ros, { kind, name: absolute(name) + SEND })
      .map(({ node, type }) => `    ${node}${typed ? ` [${type.replace(/_SendGoal$/, "")}]` : ""}\n`);
    await out(`Action: ${name}\n`);
    for (const [title, lines] of /** @type {[string, string[]][]} */ ([["clients", side("client")], ["servers", side("service")]])) {
      await out(`Action ${title}: ${lines.length}\n`);
      if (!count) await out(lines.join(""));
    }
  },
};

/** @type {Verb} */
const type = {
  name: "type",
  about: "Print a action's type",
  args: [{ ...NAME, help: "Name of the ROS action to get info (e.g. '/fibonacci')" }],
  async run({ ros, out }, { action_name: name }) {
    const action = actionsOf(ros).find((one) => one.name === name);
    if (!action) return 1;
    for (const one of action.types) await out(`${one}\n`);
    return 0;
  },
};

/** @type {Verb} */
const find = {
  name: "find",
  about: "Find actions from type",
  args: [
    { name: "action_type", help: "Name of the ROS action type to find (e.g. 'test_msgs/action/Fibonacci')", complete: "actionType" },
    flag("count", ["-c", "--count-actions"], "Only display the number of actions discovered"),
  ],
  async run({ ros, out }, { action_type: wanted, count }) {
    const found = actionsOf(ros).filter(({ types }) => types.includes(wanted));
    if (count) await out(`${found.length}\n`);
    else for (const { name } of found) await out(`${name}\n`);
  },
};

/** @type {Verb} */
const sendGoal = {
  name: "send_goal",
  about: "Send an action goal",
  args: [
    { ...NAME, help: "Name of the ROS action (e.g. '/fibonacci')" },
    { name: "action_type", help: "Type of the ROS action (e.g. 'example_interfaces/action/Fibonacci')", complete: "actionType" },
    { name: "goal", count: "?", initial: "{}", group: "goal", help: "Goal request values in YAML format (e.g. '{order: 10}')", complete: "actionGoal" },
    flag("stdin", ["--stdin"], "Read goal from standard input", { group: "goal" }),
    flag("feedback", ["-f", "--feedback"], "Echo feedback messages for the goal"),
    option("timeout", ["-t", "--timeout"], "Wait for the result of the goal for N seconds", { metavar: "N", type: FLOAT }),
  ],
  async run(io, args) {
    const { ros, out } = io;
    checkName(args.action_name, "action");
    const name = absolute(args.action_name);
    const action = fullType(args.action_type, "action");
    if (!isType(ros, `${action}_Goal`)) throw new Failure("The passed action type is invalid");
    const values = await valuesOf(io, args);
    const { message: goal } = fitted("Failed to populate message fields: ", () => populated(values, `${action}_Goal`, ros.types),
      ({ kind, message }) => `${kind}(${quoted(message)})`);
    await out("Waiting for an action server to become available...\n");
    await until(io, () => endpoints(ros, { kind: "service", name: name + SEND }).some((one) => one.type === `${action}_SendGoal`));
    await new Sent(io, name, action, args).run(goal);
  },
};

/** One goal, from sending to its end. */
class Sent {
  #io;
  #client;
  #action;
  #args;
  /** What is printed, in its order. */
  #printed = Promise.resolve();

  /** @param {Io} io @param {string} name @param {string} action @param {any} args */
  constructor(io, name, action, args) {
    this.#io = io;
    this.#action = action;
    this.#args = args;
    this.#client = new ActionClient(io.ros, name, action);
  }

  /** @param {any} request */
  async run(request) {
    const { signal } = this.#io;
    const unwatch = this.#args.feedback ? this.#client.watch() : () => {};
    this.#print(`Sending goal:\n     ${this.#yaml(request, "Goal")}\n`);
    const goal = this.#client.send(request);
    let accepted = false;
    let feedback = goal.feedback;
    const change = (/** @type {Event} */ event) => {
      if (/** @type {CustomEvent<Goal>} */ (event).detail !== goal) return;
      if (!accepted && !["sending", "rejected", "lost"].includes(goal.state)) {
        accepted = true;
        this.#print(`Goal accepted with ID: ${goal.id}\n\n`);
      }
      if (goal.feedback === feedback) return;
      feedback = goal.feedback;
      this.#print(`Feedback:\n    ${this.#yaml(feedback, "Feedback")}\n`);
    };
    this.#client.addEventListener("change", change);
    try {
      await this.#ended(goal, signal);
      if (goal.state === "rejected") this.#print("Goal was rejected.\n");
      else if (goal.state === "lost") throw new Failure(goal.fault);
      else this.#print(`Result:\n    ${this.#yaml(goal.result, "Result")}\nGoal finished with status: ${goal.state.toUpperCase()}\n`);
    } finally {
      await this.#printed;
      this.#client.removeEventListener("change", change);
      unwatch();
      this.#client.close();
    }
  }

  /** Wait for the end of a goal; at Ctrl-C, cancel it. @param {Goal} goal @param {AbortSignal} signal */
  async #ended(goal, signal) {
    const { timeout } = this.#args;
    const late = timeout === undefined ? [] : [AbortSignal.timeout(timeout * 1000)];
    const stop = AbortSignal.any([signal, ...late]);
    const stopped = new Promise((_, reject) => stop.addEventListener("abort", () => reject(stop.reason), { once: true }));
    try {
      await Promise.race([goal.ended, stopped]);
    } catch (error) {
      if (isFinal(goal.state) || goal.state === "sending") throw error;
      this.#print("Canceling goal...\n");
      try {
        await this.#client.cancel(goal);
        this.#print("Goal canceled.\n");
      } catch {
        this.#print("Failed to cancel goal\n");
      }
      if (!signal.aborted) throw new Failure(`Timeout while waiting for the result of goal ${goal.id}`);
      throw error;
    }
  }

  /** @param {any} message @param {string} part */
  #yaml(message, part) {
    return `${toYaml(message, `${this.#action}_${part}`, this.#io.ros.types, Infinity)}\n`;
  }

  /** @param {string} text */
  #print(text) {
    this.#printed = this.#printed.then(() => this.#io.out(text));
  }
}

/** @type {Group} */
export const ACTION = { name: "action", about: "Various action related sub-commands", verbs: [find, info, list, sendGoal, type] };
