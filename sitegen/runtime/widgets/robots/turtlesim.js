// @ts-check
// The window of turtlesim: turtles, the lines that they draw, and keys that drive one of them.

import { shape } from "../../ui/drawing.js";
import { button, create as make } from "../../ui/elements.js";
import { plain } from "./parts/motion.js";
import { say } from "../../ui/words.js";

/** @import { Ros, Publisher } from "../../protocol.js" */
/** @import { Robot } from "./parts/robot.js" */

const WINDOW = "turtlesim_window/msg/Window";
const TWIST = "geometry_msgs/msg/Twist";
const EMPTY = "std_srvs/srv/Empty";
// The window in pixels, and how many of them are a metre; lines are drawn finer, for sharp screens.
const SIZE = 500;
const METER = 45;
const FINE = 2;
// What one press of a key makes of a turtle, in m/s and rad/s, as turtle_teleop_key does.
const SPEED = 2;
const SHELLS = ["#6ec25b", "#e8a33d", "#d76fb0", "#5fc4c4", "#c9c14a", "#b78be0"];

/**
 * A turtle of the window: where it was last, in pixels, and how it goes.
 * @typedef {{look: any, body: Element, label: Element, pose?: any, last?: any, close(): void}} Turtle
 */

/**
 * Show what the turtlesim_node shows that publishes on `window`.
 * @param {Ros} ros
 * @param {{window: string}} options
 * @param {() => void} changed
 * @returns {Robot}
 */
export function create(ros, { window: topic }, changed) {
  /** By their numbers. @type {Map<number, Turtle>} */
  const turtles = new Map();
  let shown = /** @type {any} */ (undefined);
  let driven = "";
  const paper = createPaper();
  const layer = shape("g");
  const view = shape("svg", { viewBox: `0 0 ${SIZE} ${SIZE}`, "aria-hidden": "true" }, layer);
  const drawing = make("div", "ros-turtles", paper.canvas, view);
  drawing.tabIndex = 0;
  drawing.setAttribute("role", "img");
  drawing.setAttribute("aria-label", say("The turtlesim window. Arrow keys drive a turtle."));

  const { drive, close: endDriving } = createDriving(ros, () => current()?.look.cmd_vel);
  const current = () =>
    [...turtles.values()].find(({ look }) => look.name === driven) ?? turtles.values().next().value;
  const choice = make("select", "");
  choice.setAttribute("aria-label", say("Which turtle to drive"));
  choice.addEventListener("change", () => {
    driven = choice.value;
    changed();
  });

  const add = (/** @type {any} */ look) => {
    const label = shape("text", { class: "ros-turtle-name", y: 36, "text-anchor": "middle" });
    label.textContent = look.name;
    /** @type {Turtle} */
    const turtle = { look, body: body(look.number), label, close: () => {} };
    turtles.set(look.number, turtle);
    turtle.close = followPoses(ros, look.pose, (pose) => {
      const { last } = turtle;
      turtle.pose = turtle.last = pose;
      if (last && turtle.look.width) paper.line(turtle.look, last, pose);
      changed();
    });
  };
  const remove = (/** @type {Turtle} */ turtle) => {
    turtle.close();
    turtle.body.remove();
    turtle.label.remove();
    turtles.delete(turtle.look.number);
  };
  const show = (/** @type {any} */ window) => {
    if (window.cleared !== shown?.cleared) {
      paper.clear();
      // A way that began before belongs to the old paper.
      for (const turtle of turtles.values()) turtle.last = undefined;
    }
    shown = window;
    drawing.style.setProperty("--paper", color(window.background_r, window.background_g, window.background_b));
    const numbers = new Set(window.turtles.map((/** @type {any} */ { number }) => number));
    for (const turtle of [...turtles.values()]) if (!numbers.has(turtle.look.number)) remove(turtle);
    for (const look of window.turtles) {
      const known = turtles.get(look.number);
      if (known) known.look = look;
      else add(look);
    }
    const names = [...turtles.values()].map(({ look }) => look.name);
    choice.replaceChildren(...names.map((name) => new Option(name)));
    choice.value = current()?.look.name ?? "";
    choice.hidden = names.length < 2;
    changed();
  };
  const publishes = () => ros.graph.topics().some(({ name, publishers }) => name === topic && publishers.length);
  // Whoever comes next begins with an empty window.
  const left = () => {
    if (!shown || publishes()) return;
    shown = undefined;
    for (const turtle of [...turtles.values()]) remove(turtle);
    changed();
  };
  ros.graph.addEventListener("change", left);
  const unsubscribe = ros.types[WINDOW]
    ? ros.subscribe(topic, WINDOW, show, { transientLocal: true })
    : () => {};
  choice.hidden = true;

  return {
    title: "turtlesim",
    inputs: [{ topic, type: WINDOW }],
    drawing,
    controls: [choice, createPad(drawing, drive)],
    advance() {
      for (const { pose, body, label } of turtles.values()) {
        if (!pose) continue;
        const [x, y] = pixels(pose);
        body.setAttribute("transform", `translate(${x} ${y}) rotate(${(-pose.theta * 180) / Math.PI})`);
        label.setAttribute("transform", `translate(${x} ${y})`);
        if (!body.isConnected) layer.append(body);
        if (turtles.size > 1) layer.append(label);
        else label.remove();
      }
      return false;
    },
    readings() {
      const pose = current()?.pose;
      const text = (/** @type {string} */ some) => (pose ? some : "–");
      return [
        { name: say("Position"), text: text(`${plain(pose?.x ?? 0, 2)}, ${plain(pose?.y ?? 0, 2)}`) },
        { name: say("Heading"), text: text(`${plain(((pose?.theta ?? 0) * 180) / Math.PI, 0)}°`) },
        { name: say("Speed"), text: text(plain(pose?.linear_velocity ?? 0, 2)) },
        { name: say("Turn"), text: text(plain(pose?.angular_velocity ?? 0, 2)) },
      ];
    },
    note: () => ({ text: "", wrong: false }),
    reset() {
      if (shown) ros.call(shown.reset, EMPTY, {}).catch(() => {});
    },
    close() {
      ros.graph.removeEventListener("change", left);
      unsubscribe();
      endDriving();
      for (const turtle of [...turtles.values()]) remove(turtle);
    },
  };
}

/**
 * Buttons, and keys for whom the drawing has the focus.
 * @param {Element} drawing @param {(linear: number, angular: number) => void} drive
 */
function createPad(drawing, drive) {
  const ways = [
    { key: "ArrowLeft", sign: "↶", name: say("Turn left"), linear: 0, angular: SPEED },
    { key: "ArrowUp", sign: "↑", name: say("Forward"), linear: SPEED, angular: 0 },
    { key: "ArrowDown", sign: "↓", name: say("Backward"), linear: -SPEED, angular: 0 },
    { key: "ArrowRight", sign: "↷", name: say("Turn right"), linear: 0, angular: -SPEED },
  ];
  drawing.addEventListener("keydown", (event) => {
    const { key, ctrlKey, metaKey, altKey } = /** @type {KeyboardEvent} */ (event);
    const way = ways.find((one) => one.key === key);
    if (!way || ctrlKey || metaKey || altKey) return;
    event.preventDefault();
    drive(way.linear, way.angular);
  });
  const pad = make("div", "ros-pad", ...ways.map(({ sign, name, linear, angular }) => {
    const one = button(sign, "", () => drive(linear, angular));
    one.setAttribute("aria-label", name);
    one.title = name;
    return one;
  }));
  pad.setAttribute("role", "group");
  pad.setAttribute("aria-label", say("Drive"));
  return pad;
}

/**
 * Publish on whatever topic the driven turtle has; nobody is told of a publisher that is not used.
 * @param {Ros} ros @param {() => string | undefined} topic
 */
function createDriving(ros, topic) {
  /** @type {Map<string, Publisher>} */
  const publishers = new Map();
  return {
    /** @param {number} linear @param {number} angular */
    drive(linear, angular) {
      const name = topic();
      if (!name) return;
      const publisher = publishers.get(name) ?? ros.advertise(name, TWIST);
      publishers.set(name, publisher);
      publisher.publish({ linear: { x: linear, y: 0, z: 0 }, angular: { x: 0, y: 0, z: angular } });
    },
    close() {
      for (const publisher of publishers.values()) publisher.close();
    },
  };
}

/** Of whichever of its packages the program uses. @param {Ros} ros @param {string} topic @param {(pose: any) => void} moved */
function followPoses(ros, topic, moved) {
  const type = ["turtlesim/msg/Pose", "turtlesim_msgs/msg/Pose"].find((name) => ros.types[name]);
  return type ? ros.subscribe(topic, type, moved) : () => {};
}

function createPaper() {
  const canvas = document.createElement("canvas");
  canvas.width = canvas.height = FINE * SIZE;
  const context = /** @type {CanvasRenderingContext2D} */ (canvas.getContext("2d"));
  context.scale(FINE, FINE);
  context.lineCap = "round";
  return {
    canvas,
    clear: () => context.clearRect(0, 0, SIZE, SIZE),
    /** @param {any} pen @param {any} from @param {any} to poses */
    line({ r, g, b, width }, from, to) {
      if (from.x === to.x && from.y === to.y) return;
      context.strokeStyle = color(r, g, b);
      context.lineWidth = width;
      context.beginPath();
      context.moveTo(...pixels(from));
      context.lineTo(...pixels(to));
      context.stroke();
    },
  };
}

/** @param {{x: number, y: number}} pose @returns {[number, number]} */
function pixels({ x, y }) {
  return [x * METER, SIZE - 1 - y * METER];
}

/** @param {number} r @param {number} g @param {number} b */
function color(r, g, b) {
  return `rgb(${r} ${g} ${b})`;
}

/** A turtle that looks to the right. @param {number} number */
function body(number) {
  const leg = (/** @type {number} */ x, /** @type {number} */ y, /** @type {number} */ turn) =>
    shape("ellipse", { class: "ros-skin", rx: 7, ry: 4, transform: `translate(${x} ${y}) rotate(${turn})` });
  const turtle = shape("g", { class: "ros-turtle" },
    leg(10, -13, -50), leg(10, 13, 50), leg(-11, -12, 40), leg(-11, 12, -40),
    shape("path", { class: "ros-skin", d: "M -15 -3 L -24 0 L -15 3 Z" }),
    shape("ellipse", { class: "ros-skin", cx: 20, rx: 7, ry: 5.5 }),
    shape("circle", { class: "ros-turtle-eye", cx: 22.5, cy: -2.6, r: 1.2 }),
    shape("circle", { class: "ros-turtle-eye", cx: 22.5, cy: 2.6, r: 1.2 }),
    shape("ellipse", { class: "ros-shell", rx: 16, ry: 13 }),
    shape("path", { class: "ros-plates", d: "M -7 0 L -3 -6 H 5 L 9 0 L 5 6 H -3 Z M -7 0 H -16 M 9 0 H 16 M -3 -6 L -7 -12 M -3 6 L -7 12 M 5 -6 L 8 -11 M 5 6 L 8 11" }));
  turtle.style.setProperty("--shell", SHELLS[(number - 1) % SHELLS.length] ?? "");
  return turtle;
}
