// @ts-check
// Actions as ROS 1 has them, in five topics, for clients that know no others: roslib's ActionClient and TFClient. What
// they publish becomes a goal of an action of ROS 2, and what becomes of it, messages in JSON.

import { fullName } from "../client/names.js";
import { STATUS } from "../client/actionServer.js";
import { stamp } from "../messages/time.js";
import { Mistake, textOf } from "./mistake.js";
import { LONGEST_ID, MOST_NAMES } from "./limits.js";

/** @import { Session } from "./session.js" */

const GOAL = /ActionGoal$/;
const ANSWERS = /(ActionFeedback|ActionResult)$|^actionlib_msgs\/(msg\/)?GoalStatusArray$/;
const CANCEL = /^actionlib_msgs\/(msg\/)?GoalID$/;
/** States of actionlib_msgs/GoalStatus, by those of action_msgs. */
const STATES = [0, 0, 1, 6, 3, 2, 4];

export class Actionlib {
  #session;
  /** The topics that this client uses so, with the types of actions. @type {Map<string, string>} */
  #topics = new Map();
  /** What cancels a goal, by server and id. @type {Map<string, () => void>} */
  #goals = new Map();

  /** @param {Session} session */
  constructor(session) {
    this.#session = session;
  }

  /** Whether an advertisement is one of these topics. @param {any} message */
  advertise({ topic, type }) {
    return (GOAL.test(type) || CANCEL.test(type)) && this.#take(topic, type);
  }

  /** @param {any} message */
  subscribe({ topic, type = "" }) {
    return ANSWERS.test(type) && this.#take(topic, type);
  }

  /** @param {string} name */
  unadvertise(name) {
    return this.#topics.delete(name);
  }

  /** @param {string} name */
  unsubscribe(name) {
    return this.#topics.delete(name);
  }

  /** @param {any} message */
  publish({ topic, msg }) {
    const name = fullName(topic);
    const type = this.#topics.get(name);
    if (type === undefined) return false;
    const server = name.slice(0, name.lastIndexOf("/"));
    if (CANCEL.test(type)) this.#cancel(server, msg?.id);
    else this.#start(server, type.replace(GOAL, ""), msg);
    return true;
  }

  /** @param {string} topic @param {string} type */
  #take(topic, type) {
    // A page may have the definitions after all.
    if (this.#session.values.knows(type.includes("/msg/") ? type : type.replace("/", "/msg/"))) return false;
    if (this.#topics.size >= MOST_NAMES) throw new Mistake("too many topics");
    this.#topics.set(fullName(topic), type);
    return true;
  }

  /** @param {string} server @param {string} type of the action @param {any} msg */
  #start(server, type, msg) {
    const id = msg?.goal_id?.id;
    if (typeof id !== "string" || id.length > LONGEST_ID) throw new Mistake(`${server}: a goal needs an id`);
    const key = `${server} ${id}`;
    if (this.#goals.has(key)) throw new Mistake(`${server}: there is a goal with this id already`);
    if (this.#goals.size >= MOST_NAMES) throw new Mistake(`${server}: too many goals`);
    const status = (/** @type {number} */ state, text = "") =>
      ({ goal_id: { stamp: { secs: 0, nsecs: 0 }, id }, status: STATES[state] ?? 9, text });
    /** @type {number} */
    let state = STATUS.accepted;
    try {
      const known = type.startsWith("tf2_web_republisher") ? type : "";
      this.#goals.set(key, this.#session.actions.start(server, known, msg.goal, {
        feedback: (feedback) => this.#say(`${server}/feedback`, { status: status(state), feedback }),
        state: (now) => {
          state = now;
          this.#say(`${server}/status`, { status_list: [status(now)] });
        },
        done: (now, result, whole) => {
          this.#goals.delete(key);
          const told = status(now, whole ? "" : String(result));
          this.#say(`${server}/result`, { status: told, result: whole ? result : {} });
        },
      }));
    } catch (error) {
      this.#say(`${server}/result`, { status: { ...status(STATUS.aborted, textOf(error)), status: 5 }, result: {} });
      throw error;
    }
  }

  /** @param {string} server @param {unknown} id without one, of all goals */
  #cancel(server, id) {
    for (const [key, cancel] of [...this.#goals]) {
      if (id ? key === `${server} ${id}` : key.startsWith(`${server} `)) cancel();
    }
  }

  /** @param {string} topic @param {any} content */
  #say(topic, content) {
    if (!this.#topics.has(topic)) return;
    const { sec: secs, nanosec: nsecs } = stamp();
    const header = { seq: 0, stamp: { secs, nsecs }, frame_id: "" };
    this.#session.send({ op: "publish", topic, msg: { header, ...content } });
  }
}
