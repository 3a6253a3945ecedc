// @ts-check
// Sliders for the joints of a robot, which publish their positions as joint_state_publisher_gui does.

import { RosClock } from "../messages/rosClock.js";
import { button, create, setNote } from "../ui/elements.js";
import { say } from "../ui/words.js";
import { positionsOf, readJoints } from "./joints/description.js";

/** @import { Publisher, Ros } from "../protocol.js" */
/** @import { Joint } from "./joints/description.js" */

const STATE = "sensor_msgs/msg/JointState";
const STRING = "std_msgs/msg/String";
// Milliseconds between two messages while nothing moves: nodes that start later hear of the positions, too.
const PERIOD = 100;
const DIGITS = 3;
// The largest speed on the way of a motion, as a multiple of its mean.
const PEAK = 1.5;
// Nobody wants to watch longer (s).
const LONGEST = 4;

let lastId = 0;

/**
 * Show a slider for each joint of a description.
 * @param {HTMLElement} element
 * @param {Ros} ros
 * @param {{topic?: string, description?: string, zeros?: Record<string, number> | null}} options the topics of the
 *   positions and of the description, and where joints are at first, by name
 * @returns {() => void} unmount
 */
export function mount(element, ros, { topic = "/joint_states", description = "/robot_description", zeros }) {
  const joints = new Joints(ros, topic, description, zeros ?? {});
  element.replaceChildren(...joints.elements);
  ros.keep(element, { positions: "object" }, () => joints.kept(), ({ positions }) => joints.restore(positions ?? {}));
  // Other nodes wait for the positions, so they are published wherever the visitor looks.
  const end = joints.begin();
  return () => {
    end();
    element.replaceChildren();
  };
}

class Joints {
  #ros;
  #clock;
  #topic;
  #source;
  #zeros;
  /** @type {Joint[]} */
  #joints = [];
  #text = "";
  /** @type {Map<string, number>} */
  #positions = new Map();
  /** @type {Map<string, (position: number) => void>} */
  #show = new Map();
  /** What a link says, until the description is here. @type {Record<string, unknown>} */
  #given = {};
  #rows = create("div", "ros-joint-list");
  #note = create("p", "ros-joints-note");
  /** @type {Publisher | undefined} */
  #publisher;
  #frame = 0;
  /** The next step of a motion. */
  #step = 0;
  elements;

  /** @param {Ros} ros @param {string} topic @param {string} source @param {Record<string, number>} zeros */
  constructor(ros, topic, source, zeros) {
    this.#ros = ros;
    this.#clock = new RosClock(ros);
    this.#topic = topic;
    this.#source = source;
    this.#zeros = zeros;
    const center = button(say("Center"), "", () => this.#move(({ start }) => start));
    const random = button(say("Random"), "", () =>
      this.#move(({ lower, upper }) => lower + Math.random() * (upper - lower)));
    const heading = create("div", "ros-node", create("span", "ros-title", say("Joints")), create("span", "ros-type", topic));
    const bar = create("div", "ros-bar", heading, create("div", "ros-controls", center, random));
    this.elements = [bar, this.#rows, this.#note];
  }

  /** Read the description and publish the positions. @returns {() => void} end it */
  begin() {
    for (const type of [STRING, STATE]) {
      if (this.#ros.types[type]) continue;
      setNote(this.#note, say("no node on this page uses {}", type), true);
      return () => {};
    }
    if (!this.#joints.length) setNote(this.#note, say("Waiting for a robot description on {}", this.#source));
    const qos = { depth: 1, reliable: true, transientLocal: true };
    const unsubscribe = this.#ros.subscribe(this.#source, STRING, ({ data }) => this.#describe(data), qos);
    this.#publisher = this.#ros.advertise(this.#topic, STATE);
    const timer = setInterval(() => this.#publish(), PERIOD);
    const unfollow = this.#clock.follow(this.#ros.graph);
    return () => {
      clearInterval(timer);
      unfollow();
      cancelAnimationFrame(this.#frame);
      cancelAnimationFrame(this.#step);
      this.#frame = 0;
      unsubscribe();
      this.#publisher?.close();
      this.#publisher = undefined;
    };
  }

  /** The positions that differ from the start, for links. */
  kept() {
    const moved = this.#joints.filter(({ name, start, mimic }) => !mimic && this.#positions.get(name) !== start);
    const found = moved.map(({ name }) => [name, Number((this.#positions.get(name) ?? 0).toFixed(DIGITS))]);
    return { positions: found.length ? Object.fromEntries(found) : undefined };
  }

  /** @param {Record<string, unknown>} positions */
  restore(positions) {
    this.#given = positions;
    this.#take();
  }

  #take() {
    for (const joint of this.#joints) {
      const given = Object.hasOwn(this.#given, joint.name) ? this.#given[joint.name] : undefined;
      if (typeof given === "number" && Number.isFinite(given)) this.#set(joint, given);
    }
    if (this.#joints.length) this.#given = {};
  }

  /** @param {string} text */
  #describe(text) {
    if (text === this.#text) return;
    this.#text = text;
    try {
      this.#joints = readJoints(text, this.#zeros);
    } catch (error) {
      this.#joints = [];
      setNote(this.#note, error instanceof Error ? error.message : String(error), true);
      this.#rows.replaceChildren();
      return;
    }
    const own = this.#joints.filter(({ mimic }) => !mimic);
    const former = this.#positions;
    this.#positions = new Map(own.map(({ name, start }) => [name, start]));
    this.#show.clear();
    this.#rows.replaceChildren(...own.map((joint) => this.#row(joint)));
    setNote(this.#note, own.length ? "" : say("This robot has no joints that move"));
    for (const joint of own) this.#set(joint, former.get(joint.name) ?? joint.start);
    this.#take();
  }

  /** @param {Joint} joint */
  #row(joint) {
    const { name, unit, lower, upper } = joint;
    const slider = create("input", "");
    Object.assign(slider, {
      type: "range", min: String(lower), max: String(upper), step: "any", id: `ros-joint-${++lastId}`,
    });
    const label = create("label", "", name);
    label.htmlFor = slider.id;
    const typed = create("input", "");
    Object.assign(typed, { type: "number", min: String(lower), max: String(upper), step: "any" });
    typed.setAttribute("aria-label", say("{} in {}", name, unit));
    const put = (/** @type {number} */ position) => {
      cancelAnimationFrame(this.#step);
      this.#set(joint, position);
    };
    slider.addEventListener("input", () => put(Number(slider.value)));
    typed.addEventListener("change", () => put(typed.value === "" ? NaN : Number(typed.value)));
    this.#show.set(name, (position) => {
      slider.value = String(position);
      typed.value = position.toFixed(DIGITS);
    });
    return create("div", "ros-joint", label, slider, typed, create("span", "ros-quiet", unit));
  }

  /** Move all joints, as fast as they can; they arrive at the same time. @param {(joint: Joint) => number} position */
  #move(position) {
    const ways = this.#joints.filter(({ mimic }) => !mimic).map((joint) => {
      return { joint, from: this.#positions.get(joint.name) ?? joint.start, to: position(joint) };
    });
    const seconds = Math.max(0, ...ways.map(({ joint, from, to }) => (PEAK * Math.abs(to - from)) / joint.speed));
    const duration = matchMedia("(prefers-reduced-motion: reduce)").matches ? 0 : Math.min(seconds, LONGEST);
    const begin = performance.now();
    const step = (/** @type {number} */ now) => {
      const part = duration ? Math.min(1, Math.max(0, now - begin) / 1000 / duration) : 1;
      // Speeds up and slows down.
      const done = part * part * (3 - 2 * part);
      for (const { joint, from, to } of ways) this.#set(joint, part < 1 ? from + (to - from) * done : to);
      if (part < 1) this.#step = requestAnimationFrame(step);
    };
    cancelAnimationFrame(this.#step);
    step(begin);
  }

  /** @param {Joint} joint @param {number} position */
  #set({ name, lower, upper }, position) {
    if (!this.#positions.has(name)) return;
    if (Number.isFinite(position)) this.#positions.set(name, Math.min(upper, Math.max(lower, position)));
    this.#show.get(name)?.(this.#positions.get(name) ?? 0);
    this.#frame ||= requestAnimationFrame(() => {
      this.#frame = 0;
      this.#publish();
    });
  }

  #publish() {
    if (!this.#publisher || !this.#joints.length) return;
    const positions = positionsOf(this.#joints, this.#positions);
    try {
      this.#publisher.publish({
        header: { stamp: this.#clock.now(), frame_id: "" },
        name: [...positions.keys()],
        position: Float64Array.from(positions.values()),
        velocity: new Float64Array(),
        effort: new Float64Array(),
      });
    } catch {
      // A queue that is full takes the next message.
    }
  }
}
