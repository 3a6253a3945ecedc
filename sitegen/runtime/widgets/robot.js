// @ts-check
// A robot that does what a topic tells it: drawn on the page, and real where its kind reaches one.
// What only one kind has is in robots/<kind>.js.

import { arrange, button, create, setText } from "../ui/elements.js";
import { place } from "../place.js";
import { say } from "../ui/words.js";

/** @import { Ros } from "../protocol.js" */
/** @import { Reading, Robot } from "./robots/parts/robot.js" */

// Numbers that change more often than this (ms) cannot be read.
const READABLE = 100;
// A tab that was hidden must not move its robots by all the time that it was away (s).
const LONGEST = 0.1;

/**
 * Show a robot of `kind`; the other options are that kind's.
 * @param {HTMLElement} element
 * @param {Ros} ros
 * @param {{kind: string}} options
 * @returns {() => void} unmount
 */
export function mount(element, ros, { kind, ...options }) {
  let unmounted = false;
  let unmount = () => {};
  // A page brings only the kinds that it shows.
  import(place(`widgets/robots/${kind}.js`)).then(({ create: make }) => {
    if (!unmounted) unmount = show(element, ros, make, options);
  });
  return () => {
    unmounted = true;
    unmount();
    element.replaceChildren();
  };
}

/**
 * @param {HTMLElement} element @param {Ros} ros
 * @param {(ros: Ros, options: object, changed: () => void) => Robot} make @param {object} options
 */
function show(element, ros, make, options) {
  let frame = 0;
  let last = 0;
  let read = 0;

  const draw = (/** @type {number} */ time) => {
    frame = 0;
    const moving = robot.advance(Math.min((time - last) / 1000, LONGEST));
    last = time;
    if (!moving || time - read > READABLE) {
      read = time;
      tell();
    }
    if (moving) frame = requestAnimationFrame(draw);
  };
  const changed = () => {
    if (frame) return;
    last = performance.now();
    frame = requestAnimationFrame(draw);
  };

  const robot = make(ros, options, changed);
  const listens = create("span", "ros-type");
  const heading = create("div", "ros-node", create("span", "ros-title", robot.title), listens);
  const restart = button(say("Reset"), "ros-again", () => robot.reset());
  const controls = create("div", "ros-controls", ...robot.controls, restart);
  const stage = create("div", "ros-stage", robot.drawing);
  const values = create("dl", "ros-readings");
  const note = create("p", "ros-note");
  note.setAttribute("role", "status");
  element.replaceChildren(create("div", "ros-bar", heading, controls), stage, values, note);

  /** @type {Map<string, ReturnType<typeof createReading>>} */
  const rows = new Map();
  const tell = () => {
    const readings = robot.readings();
    arrange(values, readings.map((reading) => {
      const row = rows.get(reading.name) ?? createReading(reading);
      rows.set(reading.name, row);
      row.show(reading);
      return row.element;
    }));
    const { text, wrong } = robot.note();
    note.classList.toggle("ros-wrong", wrong);
    setText(note, text);
  };
  const look = () => {
    const topics = ros.graph.topics();
    setText(listens, robot.inputs.map(({ topic, type }) => {
      if (!ros.types[type]) return say("{}: no node on this page uses {}, so it cannot be read", topic, type);
      const from = topics.find(({ name }) => name === topic)?.publishers ?? [];
      return from.length ? say("{} from {}", topic, from.join(", ")) : say("{}: no publishers", topic);
    }).join(" · "));
  };

  look();
  tell();
  changed();
  ros.graph.addEventListener("change", look);
  return () => {
    ros.graph.removeEventListener("change", look);
    robot.close();
    cancelAnimationFrame(frame);
  };
}

/** @param {Reading} first */
function createReading({ name, level, color }) {
  const dot = create("span", "ros-dot");
  const text = create("span", "");
  const value = create("dd", "", text);
  if (color !== undefined) value.prepend(dot);
  const meter = create("span", "ros-level");
  const fill = create("i", "");
  meter.append(fill);
  if (level !== undefined) value.append(meter);
  return {
    element: create("div", "", create("dt", "", name), value),
    show(/** @type {Reading} */ reading) {
      setText(text, reading.text);
      dot.style.setProperty("--dot", reading.color || "transparent");
      const share = Math.max(-1, Math.min(1, reading.level ?? 0));
      fill.style.insetInlineStart = `${50 + Math.min(share, 0) * 50}%`;
      fill.style.inlineSize = `${Math.abs(share) * 50}%`;
    },
  };
}
