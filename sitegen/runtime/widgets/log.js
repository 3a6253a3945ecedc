// @ts-check
// What all nodes log, from /rosout, by severity, node and text.

import { ROSOUT } from "../graphNames.js";
import { button, create, setText } from "../ui/elements.js";
import { whileSeen } from "../ui/looking.js";
import { say } from "../ui/words.js";

/** @import { Ros } from "../protocol.js" */

const TYPE = "rcl_interfaces/msg/Log";
/** Nodes keep what they logged lately for those who come late, and so does this panel. */
const QOS = { depth: 1000, reliable: true, transientLocal: true };
const LEVELS = /** @type {const} */ ([
  [10, "debug"],
  [20, "info"],
  [30, "warn"],
  [40, "error"],
  [50, "fatal"],
]);
// A reader this near to the end, in pixels, is taken to read the newest line.
const NEAR = 24;

/** @typedef {{time: number, level: number, severity: string, node: string, text: string, key: string}} Entry */

/**
 * Show the log; `lines` is how many it keeps, the oldest leave.
 * @param {HTMLElement} element
 * @param {Ros} ros
 * @param {{lines?: number}} options
 * @returns {() => void} unmount
 */
export function mount(element, ros, { lines: limit = 1000 }) {
  const severity = create("select", "", ...LEVELS.map(([, name]) => new Option(say("{} and above", name), name)));
  severity.value = "info";
  severity.setAttribute("aria-label", say("severity"));
  const node = create("select", "", new Option(say("all nodes"), ""));
  node.setAttribute("aria-label", say("node"));
  const search = create("input", "");
  search.type = "search";
  search.placeholder = say("Find text");
  search.setAttribute("aria-label", say("text"));
  const clear = button(say("Clear"), "ros-clear", () => {
    entries = [];
    redraw();
  });
  const controls = create("div", "ros-controls ros-filters", severity, node, search, clear);
  const bar = create("div", "ros-bar", create("span", "ros-title", say("Log")), controls);
  const log = create("div", "ros-lines");
  log.setAttribute("role", "log");
  log.setAttribute("aria-label", say("log of all nodes"));
  log.tabIndex = 0;
  const hint = create("p", "ros-hint");
  element.replaceChildren(bar, log, hint);

  /** In the order of their times. @type {Entry[]} */
  let entries = [];
  /** Those that came since the last drawing; null when all must be drawn again. @type {Entry[] | null} */
  let fresh = [];
  let frame = 0;
  let following = true;
  // What nodes keep comes again with each subscription: what was shown or cleared does not.
  /** @type {Map<string, number>} */
  const known = new Map();

  const shown = (/** @type {Entry} */ entry) => {
    const least = LEVELS.find(([, name]) => name === severity.value)?.[0] ?? 0;
    const text = search.value.trim().toLowerCase();
    return entry.level >= least && (!node.value || entry.node === node.value) &&
      (!text || entry.text.toLowerCase().includes(text));
  };

  const draw = () => {
    frame = 0;
    if (!fresh) log.replaceChildren();
    log.append(...(fresh ?? entries).filter(shown).map(createRow));
    fresh = [];
    while (log.childElementCount > limit) log.firstElementChild?.remove();
    if (following) log.scrollTop = log.scrollHeight;
    hint.hidden = log.hasChildNodes();
    setText(hint, hintFor(ros, entries.length));
  };
  const redraw = () => {
    fresh = null;
    frame ||= requestAnimationFrame(draw);
  };

  /** @param {any} message */
  const receive = (message) => {
    const entry = read(message);
    if (known.has(entry.key)) return;
    known.set(entry.key, entry.time);
    if (known.size > 4 * limit) known.delete(known.keys().next().value ?? "");
    const before = entries.findLastIndex(({ time }) => time <= entry.time);
    entries.splice(before + 1, 0, entry);
    if (entries.length > limit) entries.shift();
    if (![...node.options].some(({ value }) => value === entry.node)) node.append(new Option(entry.node));
    if (before + 2 < entries.length) fresh = null;
    else fresh?.push(entry);
    if (fresh && fresh.length > limit) fresh = null;
    frame ||= requestAnimationFrame(draw);
  };

  for (const control of [severity, node, search]) control.addEventListener("input", redraw);
  log.addEventListener("scroll", () => {
    following = log.scrollHeight - log.scrollTop - log.clientHeight < NEAR;
  });
  draw();
  const said = () => ({
    severity: severity.value === "info" ? "" : severity.value, node: node.value, text: search.value.trim(),
  });
  ros.keep(element, { severity: "string", node: "string", text: "string" }, said, (state, odd) => {
    if (LEVELS.some(([, name]) => name === state.severity)) severity.value = state.severity;
    else if (state.severity) odd();
    if (state.node) {
      node.append(new Option(state.node));
      node.value = state.node;
    }
    search.value = state.text ?? "";
    redraw();
  });

  const unlook = whileSeen(element, () => {
    draw();
    const unsubscribe = ros.types[TYPE] ? ros.subscribe(ROSOUT, TYPE, receive, QOS) : () => {};
    return () => {
      unsubscribe();
      cancelAnimationFrame(frame);
      frame = 0;
    };
  });
  return () => {
    unlook();
    element.replaceChildren();
  };
}

/** @param {Ros} ros @param {number} count of what came */
function hintFor(ros, count) {
  if (!ros.types[TYPE]) return say("No program on this page logs to /rosout");
  return count ? say("No lines match the filters") : say("Nothing logged yet");
}

/** @param {any} message rcl_interfaces/msg/Log @returns {Entry} */
function read({ stamp, level, name, msg: text }) {
  const severity = LEVELS.findLast(([least]) => level >= least)?.[1] ?? "debug";
  const time = stamp.sec * 1000 + stamp.nanosec / 1e6;
  return { time, level, severity, node: name, text, key: `${stamp.sec} ${stamp.nanosec} ${name} ${text}` };
}

/** @param {Entry} entry */
function createRow({ time, severity, node, text }) {
  const at = new Date(time);
  const clock = [at.getHours(), at.getMinutes(), at.getSeconds()].map((part) => String(part).padStart(2, "0"));
  const when = `${clock.join(":")}.${String(at.getMilliseconds()).padStart(3, "0")}`;
  const row = create("div", "", create("span", "ros-when", when), ` ${severity.toUpperCase()} `);
  row.append(create("b", "", node), `: ${text}`);
  row.dataset.severity = severity;
  return row;
}
