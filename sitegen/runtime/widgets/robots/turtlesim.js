// @ts-check
// The window of turtlesim: turtles, the lines that they draw, and buttons to drive one of them.

import { create as make, setNote, shape } from "../../ui/elements.js";
import { say } from "../../ui/words.js";
import { plain } from "./parts/motion.js";
import { createPad, Driver } from "./turtlesim/driving.js";
import { color, Paper, SIZE } from "./turtlesim/paper.js";
import { Turtle } from "./turtlesim/turtle.js";

/** @import { Ros } from "../../protocol.js" */
/** @import { Robot } from "./parts/robot.js" */

const WINDOW = "turtlesim_window/msg/Window";
const EMPTY = "std_srvs/srv/Empty";

/**
 * Show the window of the turtlesim_node that publishes on `window`.
 * @param {Ros} ros
 * @param {{window: string}} options
 * @param {() => void} changed
 * @returns {Robot}
 */
export function create(ros, { window: topic }, changed) {
  return new Turtlesim(ros, topic, changed);
}

class Turtlesim {
  #ros;
  #topic;
  #changed;
  /** By number. @type {Map<number, Turtle>} */
  #turtles = new Map();
  /** The last message. @type {any} */
  #shown;
  #paper = new Paper();
  #layer = shape("g");
  /** The name of the turtle to drive. */
  #chosen = "";
  #choice = make("select", "");
  #driver;
  /** What the window says while there is no turtle. */
  #empty = make("p", "ros-empty");
  #unsubscribe = () => {};
  // Clear the window when the node is gone: its successor begins with an empty one.
  #graphChanged = () => {
    if (this.#shown && !this.#published) this.#clear();
  };
  title = "turtlesim";
  /** Its window says so itself. */
  waits = "";
  inputs;
  drawing;
  controls;

  /** @param {Ros} ros @param {string} topic @param {() => void} changed */
  constructor(ros, topic, changed) {
    this.#ros = ros;
    this.#topic = topic;
    this.#changed = changed;
    this.inputs = [{ topic, type: WINDOW }];
    const view = shape("svg", { viewBox: `0 0 ${SIZE} ${SIZE}`, "aria-hidden": "true" }, this.#layer);
    this.drawing = make("div", "ros-turtles", this.#paper.canvas, view, this.#empty);
    this.#empty.setAttribute("role", "status");
    this.#invite();
    this.drawing.tabIndex = 0;
    // An application gets the arrow keys from screen readers, an image does not.
    this.drawing.setAttribute("role", "application");
    this.drawing.setAttribute("aria-label", say("The turtlesim window. Arrow keys drive a turtle."));

    this.#driver = new Driver(ros, () => this.#driven?.look.cmd_vel, () => {
      const killed = say("No turtle to drive. Call the service spawn first.");
      setNote(this.#empty, this.#shown ? killed : say("No turtle to drive. Start turtlesim first."), true);
    });
    this.controls = [this.#choice, createPad(this.drawing, this.#driver)];
    this.#choice.hidden = true;
    this.#choice.setAttribute("aria-label", say("Which turtle to drive"));
    this.#choice.addEventListener("change", () => {
      this.#chosen = this.#choice.value;
      changed();
    });
    ros.graph.addEventListener("change", this.#graphChanged);
    if (!ros.types[WINDOW]) return;
    this.#unsubscribe = ros.subscribe(topic, WINDOW, (window) => this.#show(window), { transientLocal: true });
  }

  advance() {
    for (const turtle of this.#turtles.values()) turtle.draw(this.#layer, this.#turtles.size > 1);
    return false;
  }

  readings() {
    const pose = this.#driven?.pose;
    const text = (/** @type {string} */ known) => (pose ? known : "–");
    return [
      { name: say("Position"), text: text(`${plain(pose?.x ?? 0, 2)}, ${plain(pose?.y ?? 0, 2)}`) },
      { name: say("Heading"), text: text(`${plain(((pose?.theta ?? 0) * 180) / Math.PI, 0)}°`) },
      { name: say("Speed"), text: text(plain(pose?.linear_velocity ?? 0, 2)) },
      { name: say("Turn"), text: text(plain(pose?.angular_velocity ?? 0, 2)) },
    ];
  }

  note() {
    return { text: "", wrong: false };
  }

  reset() {
    if (this.#shown) this.#ros.call(this.#shown.reset, EMPTY, {}).catch(() => {});
  }

  close() {
    this.#ros.graph.removeEventListener("change", this.#graphChanged);
    this.#unsubscribe();
    this.#driver.close();
    for (const number of this.#turtles.keys()) this.#remove(number);
  }

  /** The turtle to drive: the chosen one, or else the first. */
  get #driven() {
    const turtles = [...this.#turtles.values()];
    return turtles.find(({ look }) => look.name === this.#chosen) ?? turtles[0];
  }

  get #published() {
    return this.#ros.graph.topics().some(({ name, publishers }) => name === this.#topic && publishers.length);
  }

  /** @param {any} window turtlesim_window/msg/Window */
  #show(window) {
    if (window.cleared !== this.#shown?.cleared) {
      this.#paper.clear();
      for (const turtle of this.#turtles.values()) turtle.lift();
    }
    this.#shown = window;
    const { background_r: r, background_g: g, background_b: b } = window;
    this.drawing.style.setProperty("--paper", color(r, g, b));
    const numbers = new Set(window.turtles.map((/** @type {any} */ { number }) => number));
    for (const number of this.#turtles.keys()) if (!numbers.has(number)) this.#remove(number);
    for (const look of window.turtles) {
      const known = this.#turtles.get(look.number);
      if (known) known.look = look;
      else this.#turtles.set(look.number, new Turtle(this.#ros, look, this.#paper, this.#changed));
    }
    this.#offer();
    this.#invite();
    this.#changed();
  }

  #clear() {
    this.#shown = undefined;
    for (const number of this.#turtles.keys()) this.#remove(number);
    this.#invite();
    this.#changed();
  }

  /** Say how to get a turtle while no turtlesim_node runs. */
  #invite() {
    setNote(this.#empty, this.#shown ? "" : say("The turtle appears when turtlesim starts."));
  }

  /** Offer the turtles to drive. */
  #offer() {
    const names = [...this.#turtles.values()].map(({ look }) => look.name);
    this.#choice.replaceChildren(...names.map((name) => new Option(name)));
    this.#choice.value = this.#driven?.look.name ?? "";
    this.#choice.hidden = names.length < 2;
  }

  /** @param {number} number */
  #remove(number) {
    this.#turtles.get(number)?.close();
    this.#turtles.delete(number);
  }
}
