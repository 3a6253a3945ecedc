// @ts-check
// A robot that obeys a topic: drawn on the page and, if its kind supports that, connected over Bluetooth.
// robots/<kind>.js has what is specific to a kind.

import { button, create, setNote, setText } from "../ui/elements.js";
import { place } from "../place.js";
import { say } from "../ui/words.js";
import { Readings } from "./robots/parts/readings.js";

/** @import { Ros } from "../protocol.js" */
/** @import { Input, Robot } from "./robots/parts/robot.js" */

// Readings of a moving robot are written this often (ms), so that they can be read.
const READABLE = 100;
// A robot moves for at most this time (s) between two frames: hidden tabs draw none.
const LONGEST = 0.1;

/**
 * Show a robot of `kind`, and over it what the nodes named in `captions` print; the other options depend on the kind.
 * @param {HTMLElement} element
 * @param {Ros} ros
 * @param {{kind: string, captions?: string[]}} options
 * @returns {() => void} unmount
 */
export function mount(element, ros, { kind, captions, ...options }) {
  let unmounted = false;
  let unmount = () => {};
  // A page loads only the kinds that it shows.
  import(place(`widgets/robots/${kind}.js`)).then(({ create: make }) => {
    if (!unmounted) unmount = show(element, ros, make, options, captions);
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
 * @param {string[]} [captions]
 */
function show(element, ros, make, options, captions = []) {
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
  const waits = create("p", "ros-empty", say("The robot moves when a node publishes on {}.", robot.waits));
  const stage = create("div", "ros-stage", robot.drawing, waits);
  const readings = new Readings();
  const note = create("p", "ros-note");
  note.setAttribute("role", "status");
  element.replaceChildren(create("div", "ros-bar", heading, controls), stage, readings.element, note);

  const tell = () => {
    readings.show(robot.readings());
    const { text, wrong } = robot.note();
    setNote(note, text, wrong);
  };
  const look = () => {
    setText(listens, robot.inputs.map((input) => describeInput(ros, input)).join(" · "));
    waits.hidden = !robot.waits || publishersOf(ros, robot.waits).length > 0;
  };

  const shown = new AbortController();
  if (captions.length) {
    import(place("ui/caption.js")).then(({ showCaption }) => showCaption(stage, ros, captions, shown.signal));
  }
  look();
  tell();
  changed();
  ros.graph.addEventListener("change", look);
  return () => {
    ros.graph.removeEventListener("change", look);
    shown.abort();
    robot.close();
    cancelAnimationFrame(frame);
  };
}

/** @param {Ros} ros @param {string} topic */
function publishersOf(ros, topic) {
  return ros.graph.topics().find(({ name }) => name === topic)?.publishers ?? [];
}

/** @param {Ros} ros @param {Input} input */
function describeInput(ros, { topic, type }) {
  if (!ros.types[type]) return say("{}: no node on this page uses {}, so it cannot be read", topic, type);
  const publishers = publishersOf(ros, topic);
  return publishers.length ? say("{} from {}", topic, publishers.join(", ")) : say("{}: no publishers", topic);
}
