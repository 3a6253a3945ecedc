// @ts-check
// One display of a 3D view: what it subscribes to, whether it is on, where its messages are placed, and its status.

import { Group } from "../../vendor/three.js";
import { say } from "../../ui/words.js";
import { seconds } from "../tf/transforms.js";

/** @import { Ros } from "../../protocol.js" */
/** @import { Pose } from "../tf/pose.js" */
/** @import { Found } from "../tf/transforms.js" */
/** @import { World } from "./world.js" */

/**
 * A kind of display; each has a module in displays/.
 * @typedef {{
 *   title: string, types: string[], defaults: Record<string, Setting>, choices?: Record<string, string[]>,
 *   create(context: Context, options: Record<string, any>): Display,
 * }} Kind `types` are those of the messages that it shows; without types, it needs no topic. `defaults` are its
 *   options with their values: a number, a colour like "#ff0000", true or false, a text, or one of `choices`
 * @typedef {string | number | boolean} Setting
 * @typedef {{
 *   receive?(message: any, type: string): void, frameOf?(message: any): {frame_id: string, stamp: any} | undefined,
 *   frame?(): string,
 *   set?(options: Record<string, any>): void, update?(now: number): void, clear?(): void, close?(): void,
 *   begin?(): void, end?(): void, controls?: HTMLElement,
 * }} Display `controls` stand with its options. `begin` and `end` are called when it is subscribed to its topic, and no
 *   longer. `receive` draws a message into the display's group, which is placed in the frame that `frameOf` returns, or
 *   always in `frame`; without these, the display places its parts itself in `update`, which is called before each frame
 * @typedef {{
 *   root: InstanceType<typeof Group>, floor: InstanceType<typeof Group>, world: World, ros: Ros,
 *   say(text: string): void, place(object: any, frame: string, time?: number): boolean, redraw(): void,
 *   resource(url: string): string, tint(color: string): InstanceType<typeof import("../../vendor/three.js").Color>,
 * }} Context what a display is given: the group to draw into, that for what stays in the fixed frame, its world; `say`
 *   shows a problem, `place` moves an object to the pose of a frame and returns whether that is known, `resource` is the
 *   address of a package:// file, `tint` a colour as it is drawn on the ground of the view
 */

// Messages that wait for their transforms.
const MOST_WAITING = 20;

export class Shown {
  root = new Group();
  #floor = new Group();
  /** What the display says is wrong. */
  #said = "";
  /** Why it is not in its place, or not in the place of its newest message. */
  #lost = "";
  enabled;
  options;
  #display;
  #world;
  #kind;
  #unsubscribe = () => {};
  #subscribed = "";
  /** Messages whose transforms are not known yet, in order. @type {{message: any, type: string}[]} */
  #waiting = [];
  /** Where the last message is: to place it again in another fixed frame. */
  #header = { frame_id: "", stamp: { sec: 0, nanosec: 0 } };
  #placedIn = "";
  drawn = false;

  /**
   * @param {string} name its kind @param {Kind} kind @param {World} world
   * @param {Record<string, any>} options @param {boolean} enabled
   */
  constructor(name, kind, world, options, enabled = true) {
    this.name = name;
    this.#kind = kind;
    this.#world = world;
    this.enabled = enabled;
    this.options = { ...kind.defaults, ...options };
    /** The topic that it showed first: part of its name in links. */
    this.firstTopic = String(this.options.topic ?? "");
    this.root.visible = enabled;
    this.#floor.visible = enabled;
    world.floor.add(this.#floor);
    this.#display = kind.create({
      root: this.root,
      floor: this.#floor,
      world,
      ros: world.ros,
      say: (text) => this.tell(text),
      place: (object, frame, time) => this.#place(object, frame, time),
      redraw: () => world.redraw(),
      resource: world.resource,
      tint: (color) => world.stage.tint(color),
    }, this.options);
    this.#display.set?.(this.options);
  }

  get title() {
    return this.#kind.title;
  }

  get kind() {
    return this.#kind;
  }

  /** What is wrong; "" if nothing is. */
  get status() {
    return this.#lost || this.#said;
  }

  /** What the visitor can do with what it shows, beside its options. */
  get controls() {
    return this.#display.controls;
  }

  /** The topic that it shows; "" if it has none. @returns {string} */
  get topic() {
    return this.#kind.types.length ? String(this.options.topic ?? "") : "";
  }

  /** Whether messages are placed in the frame of their header. */
  get #headed() {
    return Boolean(this.#display.receive && this.#display.frameOf);
  }

  /** Subscribe if that is not done, with the type and the durability that the topic has now. */
  begin() {
    if (!this.enabled || !this.topic) return;
    const found = this.#world.ros.graph.topics().find(({ name }) => name === this.topic);
    const known = found?.types.find((type) => this.#kind.types.includes(type));
    const other = found?.types[0];
    if (found && !known && found.publishers.length) {
      const wanted = this.#kind.types.join(", ");
      this.tell(say("{} is of type {}, not {}", this.topic, other ?? "", wanted));
      this.end();
      return;
    }
    const type = known ?? this.#kind.types.find((each) => this.#world.ros.types[each]) ?? "";
    const offers = this.#world.ros.graph.endpoints().filter(
      ({ kind, name }) => kind === "publisher" && name === this.topic);
    const latched = offers.length > 0 && offers.every(({ qos }) => qos.transientLocal);
    const wanted = `${type} ${latched}`;
    if (wanted === this.#subscribed) return;
    this.end();
    if (!this.#world.ros.types[type]) {
      if (found || !offers.length) this.tell(say("no node on this page uses {}", this.#kind.types[0] ?? ""));
      return;
    }
    this.#subscribed = wanted;
    const qos = latched ? { transientLocal: true, depth: 10, reliable: true } : { depth: 10 };
    this.#unsubscribe = this.#world.ros.subscribe(this.topic, type, (message) => this.#receive(message, type), qos);
    this.#display.begin?.();
    if (!this.drawn) this.tell(offers.length ? say("no messages yet") : say("{}: no publishers", this.topic));
  }

  /** Stop receiving messages. */
  end() {
    if (this.#subscribed) this.#display.end?.();
    this.#unsubscribe();
    this.#unsubscribe = () => {};
    this.#subscribed = "";
  }

  /** @param {boolean} on */
  enable(on) {
    this.enabled = on;
    this.root.visible = on;
    this.#floor.visible = on;
    if (on) this.begin();
    else this.end();
    this.#world.redraw();
  }

  /** Change options. @param {Record<string, any>} changed */
  set(changed) {
    const { topic } = this.options;
    Object.assign(this.options, changed);
    if (this.options.topic !== topic) {
      this.clear();
      this.end();
      this.begin();
    }
    this.#display.set?.(this.options);
    this.#world.redraw();
  }

  clear() {
    this.#waiting = [];
    this.drawn = false;
    this.#said = "";
    this.#lost = "";
    this.#display.clear?.();
  }

  close() {
    this.end();
    this.#display.close?.();
    this.root.removeFromParent();
    this.#floor.removeFromParent();
  }

  /** Say what is wrong, or nothing. @param {string} text */
  tell(text) {
    if (this.#said === text) return;
    this.#said = text;
    this.#world.told();
  }

  /** @param {string} fault */
  #lose(fault) {
    if (this.#lost === fault) return;
    this.#lost = fault;
    this.#world.told();
  }

  /** Place what waits and what moves; called before each frame. @param {number} now (ms) */
  update(now) {
    if (!this.enabled) return;
    if (this.#waiting.length) this.#settle();
    if (this.#display.frame) this.#move(this.#find(this.#display.frame()));
    else if (this.#headed && this.drawn && this.#placedIn !== this.#world.fixed) {
      this.#move(this.#find(this.#header.frame_id, seconds(this.#header.stamp)));
    }
    this.#display.update?.(now);
  }

  /** @param {any} message @param {string} type */
  #receive(message, type) {
    this.#world.heard(this.#display.frameOf?.(message)?.frame_id);
    if (!this.#headed) {
      this.drawn = true;
      this.tell("");
      this.#draw(message, type);
      return;
    }
    this.#waiting.push({ message, type });
    if (this.#waiting.length > MOST_WAITING) this.#waiting.shift();
    this.#world.redraw();
  }

  /** Draw the newest message whose transform is known, and drop those before it. */
  #settle() {
    let fault = "";
    for (let index = this.#waiting.length - 1; index >= 0; index--) {
      const { message, type } = /** @type {{message: any, type: string}} */ (this.#waiting[index]);
      const header = this.#display.frameOf?.(message) ?? { frame_id: this.#world.fixed, stamp: { sec: 0, nanosec: 0 } };
      const found = this.#find(header.frame_id, seconds(header.stamp));
      if (!found.pose) {
        fault ||= found.fault;
        continue;
      }
      this.#waiting.splice(0, index + 1);
      this.#header = header;
      this.tell("");
      // What it leaves behind is where the group is before that moves.
      this.#draw(message, type);
      this.#move(found);
      if (!this.drawn) {
        this.drawn = true;
        this.#world.appeared();
      }
      return;
    }
    this.#lose(fault);
  }

  /** Move the group to a pose; where there is none, nothing can be shown. @param {Found} found */
  #move({ pose, fault }) {
    if (pose) put(this.root, pose);
    this.root.visible = Boolean(pose);
    this.#placedIn = pose ? this.#world.fixed : "";
    this.#lose(fault);
  }

  /** The pose of a frame in the fixed one. @param {string} frame @param {number} [time] */
  #find(frame, time) {
    return this.#world.transforms.lookup(this.#world.fixed, frame, time);
  }

  /** @param {any} message @param {string} type */
  #draw(message, type) {
    try {
      this.#display.receive?.(message, type);
    } catch (error) {
      this.tell(error instanceof Error ? error.message : String(error));
    }
    this.#world.redraw();
  }

  /** @param {any} object @param {string} frame @param {number} [time] */
  #place(object, frame, time) {
    const { pose, fault } = this.#find(frame, time);
    if (pose) put(object, pose);
    else this.tell(fault);
    return Boolean(pose);
  }
}

/** Move an object to a pose. @param {any} object @param {Pose} pose */
export function put(object, { position, rotation }) {
  object.position.set(...position);
  object.quaternion.set(...rotation);
}
