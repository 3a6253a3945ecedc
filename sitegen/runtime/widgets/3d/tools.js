// @ts-check
// What the pointer does in a 3D view besides moving the camera: set a goal or an estimated pose, point, measure.

import { Color, Group, Plane, Vector3 } from "../../vendor/three.js";
import { create, setText } from "../../ui/elements.js";
import { tool as button } from "../../ui/toolbar.js";
import { say } from "../../ui/words.js";
import { Flag, LocateFixed, MapPin, Ruler } from "../../vendor/icons.js";
import { Lines, segments } from "./lines.js";
import { Arrows } from "./shapes.js";

/** @import { Ros } from "../../protocol.js" */
/** @import { Icon } from "../../ui/toolbar.js" */
/** @import { Stage } from "./stage.js" */
/** @import { World } from "./world.js" */
/** @typedef {InstanceType<typeof Vector3>} Point */

const FLOOR = new Plane(new Vector3(0, 0, 1), 0);
const POSE = "geometry_msgs/msg/PoseStamped";
const ESTIMATE = "geometry_msgs/msg/PoseWithCovarianceStamped";
const POINT = "geometry_msgs/msg/PointStamped";
const GREEN = new Color(0x46d67f);
// For how long a hint is shown (ms).
const MOMENT = 2500;
// The uncertainty of RViz's estimate: 0.5 m, and 15 degrees.
const VARIANCE = { 0: 0.25, 7: 0.25, 35: (Math.PI / 12) ** 2 };

/**
 * @typedef {{name: string, text: string, icon: Icon, hint: string, type?: string, topic?: string, aims: boolean,
 *   message?(from: Point, angle: number, header: any): any}} Tool one that `aims` is dragged, for a direction or a distance
 */

/** @type {Tool[]} */
const TOOLS = [
  {
    name: "goal",
    text: say("Goal"),
    icon: Flag,
    hint: say("Drag from the goal in the direction to face"),
    type: POSE,
    topic: "/goal_pose",
    aims: true,
    message: (from, angle, header) => ({ header, pose: poseAt(from, angle) }),
  },
  {
    name: "estimate",
    text: say("Estimate"),
    icon: LocateFixed,
    hint: say("Drag from where the robot is in the direction that it faces"),
    type: ESTIMATE,
    topic: "/initialpose",
    aims: true,
    message(from, angle, header) {
      const covariance = new Float64Array(36);
      for (const [index, value] of Object.entries(VARIANCE)) covariance[Number(index)] = value;
      return { header, pose: { pose: poseAt(from, angle), covariance } };
    },
  },
  {
    name: "point",
    text: say("Point"),
    icon: MapPin,
    hint: say("Click a point to publish it"),
    type: POINT,
    topic: "/clicked_point",
    aims: false,
    message: ({ x, y, z }, _angle, header) => ({ header, point: { x, y, z } }),
  },
  { name: "measure", text: say("Measure"), icon: Ruler, hint: say("Drag from one point to another"), aims: true },
];

export class Tools {
  #ros;
  #stage;
  #world;
  #sketch = new Group();
  #arrows = new Arrows(this.#sketch);
  #line = new Lines(this.#sketch);
  note = create("p", "ros-scene-note");
  /** @type {HTMLButtonElement[]} */
  buttons;
  /** @type {Map<Tool, HTMLButtonElement>} */
  #pressed = new Map();
  /** @type {Tool | undefined} */
  #active;
  /** @type {Point | undefined} */
  #from;
  #topics;
  /** @type {PointerEvent | undefined} */
  #pointer;
  #frame = 0;
  /** @type {ReturnType<typeof setTimeout> | undefined} */
  #timer;
  #ends = new AbortController();

  /** @param {Ros} ros @param {Stage} stage @param {World} world @param {Record<string, string>} [topics] by tool */
  constructor(ros, stage, world, topics = {}) {
    this.#ros = ros;
    this.#stage = stage;
    this.#world = world;
    this.#topics = topics;
    this.note.setAttribute("role", "status");
    stage.scene.add(this.#sketch);
    // A message that no node of the page knows could not be published.
    for (const tool of TOOLS.filter(({ type }) => !type || ros.types[type])) {
      const about = tool.topic ? `${tool.hint} (${this.#topicOf(tool)})` : tool.hint;
      const press = button(tool.text, tool.icon, () => this.#choose(this.#active === tool ? undefined : tool), about);
      press.setAttribute("aria-pressed", "false");
      this.#pressed.set(tool, press);
    }
    this.buttons = [...this.#pressed.values()];
    const { canvas } = stage;
    const { signal } = this.#ends;
    canvas.addEventListener("pointerdown", (event) => this.#begin(event), { signal, capture: true });
    canvas.addEventListener("pointermove", (event) => this.#aim(event), { signal });
    canvas.addEventListener("pointerup", (event) => this.#finish(event), { signal });
    canvas.addEventListener("keydown", ({ key }) => key === "Escape" && this.#choose(undefined), { signal });
  }

  /** Tell for a moment how the view is moved. @param {string} text */
  hint(text) {
    if (this.#active) return;
    setText(this.note, text);
    clearTimeout(this.#timer);
    this.#timer = setTimeout(() => this.note.textContent === text && setText(this.note, ""), MOMENT);
  }

  close() {
    clearTimeout(this.#timer);
    cancelAnimationFrame(this.#frame);
    this.#ends.abort();
  }

  /** @param {Tool} tool */
  #topicOf({ name, topic }) {
    return this.#topics[name] ?? topic ?? "";
  }

  /** @param {Tool | undefined} tool */
  #choose(tool) {
    this.#active = tool;
    this.#from = undefined;
    for (const [each, element] of this.#pressed) element.setAttribute("aria-pressed", String(each === tool));
    this.#stage.movable = !tool;
    this.#stage.canvas.classList.toggle("ros-aiming", Boolean(tool));
    setText(this.note, tool?.hint ?? "");
    this.#erase();
  }

  /** The point of the scene below the pointer: of what is shown, or of the floor. @param {PointerEvent} event @returns {Point | undefined} */
  #under(event) {
    const caster = this.#stage.ray(event);
    caster.params.Points.threshold = 0.05;
    const floor = caster.ray.intersectPlane(FLOOR, new Vector3()) ?? undefined;
    if (this.#active?.type && this.#active.aims) return floor;
    const [hit] = caster.intersectObjects(visible(this.#stage.content), false);
    return hit?.point ?? floor;
  }

  /** @param {PointerEvent} event */
  #begin(event) {
    if (!this.#active || event.button !== 0) return;
    this.#from = this.#under(event);
    this.#stage.canvas.setPointerCapture(event.pointerId);
  }

  /** Show once in a frame where the pointer is: what is under it may have millions of points. @param {PointerEvent} event */
  #aim(event) {
    if (!this.#from) return;
    this.#pointer = event;
    this.#frame ||= requestAnimationFrame(() => {
      this.#frame = 0;
      if (this.#pointer) this.#draw(this.#pointer);
    });
  }

  /** @param {PointerEvent} event */
  #draw(event) {
    const to = this.#from && this.#active?.aims ? this.#under(event) : undefined;
    if (!this.#from || !to) return;
    const along = to.clone().sub(this.#from);
    if (this.#active?.type) {
      const length = along.length();
      this.#arrows.begin();
      this.#arrows.add(this.#from, along, { shaft: length * 0.08, head: length * 0.2, length: length * 0.3 }, GREEN);
      this.#arrows.end();
    } else {
      this.#line.show(segments([...this.#from, ...to]), { color: GREEN });
      setText(this.note, `${along.length().toFixed(3)} m`);
    }
    this.#stage.redraw();
  }

  /** @param {PointerEvent} event */
  #finish(event) {
    this.#draw(event);
    const tool = this.#active;
    const from = this.#from;
    this.#from = undefined;
    if (!tool || !from || !tool.message || !tool.type) return;
    const to = (tool.aims && this.#under(event)) || from;
    const angle = Math.atan2(to.y - from.y, to.x - from.x);
    const { fixed, clock } = this.#world;
    this.#choose(undefined);
    if (!fixed) {
      setText(this.note, say("not published: no frame is known yet"));
      return;
    }
    const publisher = this.#ros.advertise(this.#topicOf(tool), tool.type);
    publisher.publish(tool.message(from, angle, { stamp: clock.now(), frame_id: fixed }));
    // A subscription that has just matched must be able to take it first.
    setTimeout(() => publisher.close(), 1000);
    setText(this.note, say("published on {}", this.#topicOf(tool)));
  }

  #erase() {
    this.#arrows.begin();
    this.#arrows.end();
    this.#line.clear();
    this.#stage.redraw();
  }
}

/** Return what is shown of an object, itself included. @param {any} object @returns {any[]} */
function visible(object) {
  return object.visible ? [object, ...object.children.flatMap(visible)] : [];
}

/** @param {Point} position @param {number} angle around z (rad) */
function poseAt({ x, y, z }, angle) {
  return {
    position: { x, y, z },
    orientation: { x: 0, y: 0, z: Math.sin(angle / 2), w: Math.cos(angle / 2) },
  };
}
