// @ts-check
// A drawing of the nodes, topics and services of the page, as in rqt_graph.

import { isHidden, isShown } from "../graphNames.js";
import { Drawing } from "../ui/drawing.js";
import { create, shape, toggle } from "../ui/elements.js";
import { fullScreenButton } from "../ui/fullScreen.js";
import { whileNear } from "../ui/looking.js";
import { Graph, layout } from "../vendor/dagre.js";
import { Toolbar } from "../ui/toolbar.js";
import { say } from "../ui/words.js";

/** @import { Ros } from "../protocol.js" */

// In pixels: the width of a letter of the monospaced font, and the size of a box around the letters.
const LETTER = 8.5;
const PADDING = 28;
const HEIGHT = 38;
// In a narrower area (pixels) the graph is drawn from top to bottom.
const NARROW = 600;

/**
 * @typedef {"node" | "topic" | "service"} Kind
 * @typedef {{name: string, kind: Kind}} Box
 * @typedef {{from: Box, to: Box}} Arrow from a publisher to a topic to a subscription, or from a client to a service
 *   to its server
 */
/** @type {[Kind, string][]} */
const KINDS = [["node", say("node")], ["topic", say("topic")], ["service", say("service")]];

/**
 * Draw the graph.
 * @param {HTMLElement} element
 * @param {Ros} ros
 * @returns {() => void} unmount
 */
export function mount(element, ros) {
  let hidden = false;
  let drawn = "";
  const drawing = new Drawing();
  const hint = create("p", "ros-hint", say("No nodes now. The graph shows running nodes."));
  const all = toggle(say("Show hidden"), (on) => {
    hidden = on;
    look();
  });
  const controls = new Toolbar([all, ...drawing.tools], [fullScreenButton(element)]);
  const bar = create("div", "ros-bar", create("span", "ros-title", say("Graph")), controls.element);
  const legend = create("p", "ros-legend", ...KINDS.map(([kind, text]) => create("span", `ros-${kind}-sign`, text)));
  element.replaceChildren(bar, drawing.element, hint, legend);
  drawing.svg.setAttribute("aria-label", inWords([], []));

  const look = () => {
    const { boxes, arrows } = partsOf(ros, hidden);
    const direction = drawing.element.clientWidth < NARROW ? "TB" : "LR";
    const digest = JSON.stringify([boxes, arrows, direction]);
    hint.hidden = boxes.length > 0;
    if (digest === drawn) return;
    drawn = digest;
    const { width, height } = draw(drawing.layer, boxes, arrows, direction);
    drawing.resize(width, height);
    drawing.svg.setAttribute("aria-label", inWords(boxes, arrows));
  };
  ros.keep(element, { hidden: "boolean" }, () => ({ hidden }), (state) => {
    if (state.hidden) all.querySelector("input")?.click();
  });
  const resized = new ResizeObserver(look);
  const unlook = whileNear(element, () => {
    resized.observe(drawing.element);
    look();
    ros.graph.addEventListener("change", look);
    return () => {
      resized.disconnect();
      ros.graph.removeEventListener("change", look);
    };
  });
  return () => {
    unlook();
    drawing.close();
    element.replaceChildren();
  };
}

/** Return the key of a box: a node and a topic may have the same name. @param {Box} box */
function keyOf({ name, kind }) {
  return `${kind} ${name}`;
}

/** @param {Ros} ros @param {boolean} hidden @returns {{boxes: Box[], arrows: Arrow[]}} */
function partsOf({ graph }, hidden) {
  const listed = (/** @type {string} */ name) => hidden || !isHidden(name);
  /** @type {Map<string, Box>} */
  const boxes = new Map();
  /** @type {Map<string, Arrow>} */
  const arrows = new Map();
  const add = (/** @type {Kind} */ kind, /** @type {string} */ name) => {
    const box = { name, kind };
    boxes.set(keyOf(box), box);
    return box;
  };
  const connect = (/** @type {Box} */ from, /** @type {Box} */ to) =>
    arrows.set(`${keyOf(from)} > ${keyOf(to)}`, { from, to });
  for (const name of graph.nodes().filter(listed)) add("node", name);
  const channels = [
    ...graph.topics().map(({ name, publishers, subscriptions }) =>
      ({ kind: /** @type {Kind} */ ("topic"), name, from: publishers, to: subscriptions })),
    ...graph.services().map(({ name, clients, servers }) =>
      ({ kind: /** @type {Kind} */ ("service"), name, from: clients, to: servers })),
  ];
  for (const { kind, name, from, to } of channels) {
    const [senders, receivers] = [from.filter(listed), to.filter(listed)];
    if (!(hidden || isShown(name)) || senders.length + receivers.length === 0) continue;
    const middle = add(kind, name);
    for (const node of senders) connect(add("node", node), middle);
    for (const node of receivers) connect(middle, add("node", node));
  }
  return { boxes: [...boxes.values()], arrows: [...arrows.values()] };
}

/**
 * Draw the graph into `layer` and return its size.
 * @param {SVGElement} layer @param {Box[]} boxes @param {Arrow[]} arrows @param {string} direction
 */
function draw(layer, boxes, arrows, direction) {
  const graph = new Graph();
  graph.setGraph({ rankdir: direction, nodesep: 32, ranksep: 44 });
  for (const box of boxes) {
    graph.setNode(keyOf(box), { width: box.name.length * LETTER + PADDING, height: HEIGHT });
  }
  for (const { from, to } of arrows) graph.setEdge(keyOf(from), keyOf(to), {});
  layout(graph);
  const lines = arrows.map(({ from, to }) => {
    const { points } = /** @type {{points: {x: number, y: number}[]}} */ (graph.edge(keyOf(from), keyOf(to)));
    const called = from.kind === "service" || to.kind === "service";
    const style = called ? "ros-arrow ros-call-arrow" : "ros-arrow";
    return shape("path", { class: style, d: curve(points), "marker-end": "url(#ros-arrowhead)" });
  });
  const shapes = boxes.map((box) => {
    const { x, y, width } = /** @type {{x: number, y: number, width: number}} */ (graph.node(keyOf(box)));
    const rx = box.kind === "node" ? HEIGHT / 2 : 6;
    const size = { x: x - width / 2, y: y - HEIGHT / 2, width, height: HEIGHT, rx };
    const group = shape("g", { class: `ros-${box.kind}-box` });
    const text = shape("text", { x, y, "text-anchor": "middle", "dominant-baseline": "central" });
    text.textContent = box.name;
    group.append(shape("rect", size), text);
    return group;
  });
  layer.replaceChildren(arrowhead(), ...lines, ...shapes);
  const { width = 1, height = 1 } = /** @type {{width?: number, height?: number}} */ (graph.graph());
  return { width: Math.max(width, 1), height: Math.max(height, 1) };
}

/** A smooth line through the points of an edge. @param {{x: number, y: number}[]} points */
function curve(points) {
  const [first, ...rest] = points;
  const last = rest.at(-1);
  if (!first || !last) return "";
  const bends = rest.slice(0, -1).map(({ x, y }, index) => {
    const next = rest[index + 1] ?? last;
    const end = next === last ? last : { x: (x + next.x) / 2, y: (y + next.y) / 2 };
    return `Q ${x} ${y} ${end.x} ${end.y}`;
  });
  return `M ${first.x} ${first.y} ${bends.join(" ") || `L ${last.x} ${last.y}`}`;
}

function arrowhead() {
  const marker = shape("marker", {
    id: "ros-arrowhead", viewBox: "0 0 8 8", refX: 7, refY: 4, markerWidth: 7, markerHeight: 7,
    orient: "auto",
  });
  marker.append(shape("path", { d: "M 0 0 L 8 4 L 0 8 z" }));
  const definitions = shape("defs");
  definitions.append(marker);
  return definitions;
}

/** Describe the graph for screen readers. @param {Box[]} boxes @param {Arrow[]} arrows */
function inWords(boxes, arrows) {
  const sentences = arrows.map(({ from, to }) => {
    if (to.kind === "topic") return say("{} publishes {}", from.name, to.name);
    if (from.kind === "topic") return say("{} subscribes to {}", to.name, from.name);
    return to.kind === "service" ? say("{} calls {}", from.name, to.name) : say("{} serves {}", to.name, from.name);
  });
  const connected = new Set(arrows.flatMap(({ from, to }) => [keyOf(from), keyOf(to)]));
  const alone = boxes.filter((box) => !connected.has(keyOf(box)));
  return [...sentences, ...alone.map(({ name }) => say("{} has no connections", name))].join("; ") || say("no nodes");
}
