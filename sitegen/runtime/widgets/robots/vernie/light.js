// @ts-check
// The light of Vernie, whose colour a topic sets by name.

import { shape } from "../../../ui/elements.js";

/** @import { Ros } from "../../../protocol.js" */

export const STRING = "std_msgs/msg/String";

const OFF = { index: 0, look: "" };
/** The colours of the hub's light by name: their number there, and how they look. */
const COLORS = new Map(Object.entries({
  off: OFF,
  pink: { index: 1, look: "#ff5fa8" },
  purple: { index: 2, look: "#9a45e8" },
  blue: { index: 3, look: "#2f6bff" },
  lightblue: { index: 4, look: "#63b8ff" },
  cyan: { index: 5, look: "#2fd6d0" },
  green: { index: 6, look: "#2bc95f" },
  yellow: { index: 7, look: "#ffd52e" },
  orange: { index: 8, look: "#ff8f2b" },
  red: { index: 9, look: "#f5333f" },
  white: { index: 10, look: "#ffffff" },
}));

export class Light {
  bulb = shape("circle", { class: "ros-light", r: 0.019, cx: -0.04 });
  glow = shape("circle", { class: "ros-glow", r: 0.15 });
  color = "off";
  /** The last name, if no colour has it. */
  unknown = "";
  close = () => {};

  /** @param {Ros} ros @param {string} topic @param {() => void} changed */
  constructor(ros, topic, changed) {
    if (!ros.types[STRING]) return;
    this.close = ros.subscribe(topic, STRING, ({ data }) => {
      this.#set(data);
      changed();
    });
  }

  /** The names of all colours. */
  get names() {
    return [...COLORS.keys()];
  }

  /** The number of the colour in the hub. */
  get index() {
    return this.#shown.index;
  }

  /** The colour for CSS, empty if the light is off. */
  get look() {
    return this.#shown.look;
  }

  get #shown() {
    return COLORS.get(this.color) ?? OFF;
  }

  /** @param {string} text the name of a colour, in any case and with any separators */
  #set(text) {
    const name = text.trim().toLowerCase().replace(/[ _-]/g, "");
    this.unknown = COLORS.has(name) ? "" : text;
    if (COLORS.has(name)) this.color = name;
    for (const element of [this.bulb, this.glow]) {
      element.style.setProperty("--light", this.look || "transparent");
    }
  }
}
