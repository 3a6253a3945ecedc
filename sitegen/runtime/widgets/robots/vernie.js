// @ts-check
// Vernie, a LEGO BOOST robot on two tracks with a light: drawn from above, and real over Bluetooth.

import { shape } from "../../ui/drawing.js";
import { button, setText, toggle } from "../../ui/elements.js";
import { obey, TWIST } from "./parts/commands.js";
import { createFloor } from "./parts/floor.js";
import { describe, drive } from "./parts/motion.js";
import { connect, obstacle } from "./parts/moveHub.js";
import { createSenses } from "./parts/senses.js";
import { say } from "../../ui/words.js";

/** @import { Ros } from "../../protocol.js" */
/** @import { MoveHub } from "./parts/moveHub.js" */
/** @import { Robot } from "./parts/robot.js" */
/** @import { Pose } from "./parts/motion.js" */

const STRING = "std_msgs/msg/String";
// The colours that its light has, by their number there, as they look.
const OFF = { index: 0, look: "" };
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
// A track at full power (m/s), and how far the tracks are apart (m).
const FULL_SPEED = 0.3;
const APART = 0.16;
const START = { x: 0, y: 0, heading: Math.PI / 2 };

/**
 * What power (%) the motors get for a command: 1 m/s and 1 rad/s are both taken as full power, and if
 * a motor had to do more than it can, both do less in the same proportion.
 * @param {number} speed in m/s @param {number} turn in rad/s
 * @returns {[a: number, b: number]} of the left and the right motor
 */
export function motorPower(speed, turn) {
  const [a, b] = [speed - turn, speed + turn];
  const largest = Math.max(1, Math.abs(a), Math.abs(b));
  const percent = (/** @type {number} */ share) => Math.round((100 * share) / largest) || 0;
  return [percent(a), percent(b)];
}

/**
 * @param {Ros} ros
 * @param {{color: string, twist: string, sensors: string}} options
 * @param {() => void} changed
 * @returns {Robot}
 */
export function create(ros, { color: colors, twist, sensors }, changed) {
  /** @type {Pose} */
  let pose = START;
  let [a, b] = [0, 0];
  let color = "off";
  let unknown = "";
  let reason = "";
  const light = shape("circle", { class: "ros-light", r: 0.019, cx: -0.04 });
  const glow = shape("circle", { class: "ros-glow", r: 0.15 });
  const floor = createFloor(say("Vernie, seen from above"), body(glow, light));

  /** @type {MoveHub | undefined} */
  let hub;
  const power = (/** @type {[number, number]} */ [left, right]) => {
    [a, b, reason] = [left, right, ""];
    hub?.drive(a, b);
    changed();
  };
  const stopObeying = obey(ros, twist, (speed, turn) => power(motorPower(speed, turn)), (why) => {
    [a, b, reason] = [0, 0, why];
    hub?.halt();
    changed();
  });
  const stopListening = !ros.types[STRING] ? () => {} : ros.subscribe(colors, STRING, ({ data }) => {
    const name = data.trim().toLowerCase().replace(/[ _-]/g, "");
    unknown = COLORS.has(name) ? "" : data;
    if (COLORS.has(name)) color = name;
    const { index, look } = COLORS.get(color) ?? OFF;
    for (const element of [light, glow]) element.style.setProperty("--light", look || "transparent");
    if (!unknown) hub?.light(index);
    changed();
  });

  const senses = createSenses(ros, sensors, changed);
  const hand = toggle(say("Hand in front of it"), (held) => senses.hold(held));

  let trouble = "";
  let connecting = false;
  let closed = false;
  const ask = button(say("Connect"), "ros-connect", () => (hub ? leave("") : reach()));
  const show = () => {
    setText(ask, hub ? say("Disconnect") : connecting ? say("Connecting…") : say("Connect"));
    ask.disabled = connecting || obstacle() !== "";
    hand.hidden = !senses.seen || hub !== undefined;
    changed();
  };
  const leave = (/** @type {string} */ why) => {
    hub?.halt();
    hub?.disconnect();
    hub = undefined;
    trouble = why;
    senses.clear();
    show();
  };
  const reach = async () => {
    [connecting, trouble] = [true, ""];
    // From now on the eyes are those of the real robot.
    if (hand.querySelector("input")?.checked) hand.click();
    show();
    try {
      const found = await connect({
        ...senses.listener,
        lost: () => leave(say("The connection was lost: the hub is off or too far away. Connect again.")),
      });
      if (closed) {
        found.disconnect();
        return;
      }
      hub = found;
      hub.light(COLORS.get(color)?.index ?? 0);
      hub.drive(a, b);
    } catch (error) {
      trouble = error instanceof Error ? error.message : String(error);
    }
    connecting = false;
    show();
  };
  show();

  return {
    title: "Vernie",
    inputs: [{ topic: colors, type: STRING }, { topic: twist, type: TWIST }],
    drawing: floor.element,
    controls: [hand, ask],
    advance(seconds) {
      const moving = a !== 0 || b !== 0;
      const [left, right] = [(a / 100) * FULL_SPEED, (b / 100) * FULL_SPEED];
      if (moving) pose = drive(pose, (left + right) / 2, (right - left) / APART, seconds);
      floor.place(pose);
      return moving;
    },
    readings: () => [
      { name: say("Robot"), text: hub?.name ?? say("simulated") },
      ...(hub ? senses.readings() : []),
      { name: say("Light"), text: color, color: COLORS.get(color)?.look ?? "" },
      { name: say("Motor {}", "A"), text: `${a} %`, level: a / 100 },
      { name: say("Motor {}", "B"), text: `${b} %`, level: b / 100 },
      ...describe(pose),
    ],
    note() {
      if (trouble) return { text: trouble, wrong: true };
      if (unknown) {
        const known = [...COLORS.keys()].join(", ");
        return { text: say("The light has no colour '{}'; choose one of {}", unknown, known), wrong: true };
      }
      return { text: reason ? say("Stopped: {}", reason) : obstacle(), wrong: false };
    },
    reset() {
      pose = START;
      floor.clear();
      changed();
    },
    close() {
      stopObeying();
      stopListening();
      closed = true;
      leave("");
      senses.close();
    },
  };
}

/** Two tracks, a body, arms and a head with eyes. @param {Element} glow @param {Element} light */
function body(glow, light) {
  const track = (/** @type {number} */ y) =>
    shape("rect", { class: "ros-wheel", x: -0.085, y, width: 0.17, height: 0.042, rx: 0.018 });
  const arm = (/** @type {number} */ y) =>
    shape("rect", { class: "ros-arm", x: 0.02, y, width: 0.085, height: 0.026, rx: 0.013 });
  const eye = (/** @type {number} */ y) => shape("circle", { class: "ros-eye", cx: 0.062, cy: y, r: 0.011 });
  return shape("g", {},
    glow,
    track(0.053), track(-0.095),
    arm(0.05), arm(-0.076),
    shape("rect", { class: "ros-hull", x: -0.075, y: -0.06, width: 0.135, height: 0.12, rx: 0.03 }),
    shape("rect", { class: "ros-head", x: -0.012, y: -0.044, width: 0.088, height: 0.088, rx: 0.03 }),
    eye(0.023), eye(-0.023),
    light);
}
