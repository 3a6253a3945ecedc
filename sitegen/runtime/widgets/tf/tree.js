// @ts-check
// A drawing of the frames, each below its parent.

import { Drawing } from "../../ui/drawing.js";
import { shape } from "../../ui/elements.js";
import { say } from "../../ui/words.js";

/** @import { Transforms } from "./transforms.js" */
/** @typedef {{x: number, y: number, width: number}} Box around its centre */
/** @typedef {{frame: string, width: number, span: number, below: Branch[]}} Branch the width of it, and of all below */

// In pixels: the width of a letter of the monospaced font, and the size of a box around the letters.
const LETTER = 8.5;
const PADDING = 24;
const HEIGHT = 34;
const GAP = 24;
const ROW = HEIGHT + 36;

export class FrameTree {
  #drawing = new Drawing();
  element = this.#drawing.element;
  tools = this.#drawing.tools;

  constructor() {
    this.#drawing.svg.setAttribute("aria-label", say("no frames"));
  }

  close() {
    this.#drawing.close();
  }

  /** @param {string[]} frames @param {Transforms} transforms */
  draw(frames, transforms) {
    const { boxes, width, height } = place(frames, (frame) => transforms.parentOf(frame));
    const lines = [...boxes].flatMap(([frame, to]) => {
      const from = boxes.get(transforms.parentOf(frame) ?? "");
      if (!from) return [];
      const style = transforms.about(frame)?.fixed ? "ros-arrow" : "ros-arrow ros-moving-arrow";
      const d = `M ${from.x} ${from.y + HEIGHT / 2} L ${to.x} ${to.y - HEIGHT / 2}`;
      return [shape("path", { class: style, d })];
    });
    const shapes = [...boxes].map(([frame, { x, y, width }]) => {
      const box = shape("rect", { x: x - width / 2, y: y - HEIGHT / 2, width, height: HEIGHT, rx: 6 });
      const text = shape("text", { x, y, "text-anchor": "middle", "dominant-baseline": "central" });
      text.textContent = frame;
      return shape("g", { class: "ros-topic-box" }, box, text);
    });
    this.#drawing.layer.replaceChildren(...lines, ...shapes);
    this.#drawing.resize(width, height);
    const sentences = frames.map((frame) => {
      const parent = transforms.parentOf(frame);
      return parent === undefined ? say("{} is a root", frame) : say("{} is below {}", frame, parent);
    });
    this.#drawing.svg.setAttribute("aria-label", sentences.join("; ") || say("no frames"));
  }
}

/**
 * Place each frame above the middle of those below it, and the trees beside each other.
 *
 * The layered layout of the graph panel would do, but is 50 kB that a tree does not need.
 * @param {string[]} frames @param {(frame: string) => string | undefined} parentOf
 */
function place(frames, parentOf) {
  /** @type {Map<string, string[]>} */
  const children = new Map(frames.map((frame) => [frame, []]));
  for (const frame of frames) children.get(parentOf(frame) ?? "")?.push(frame);
  const roots = frames.filter((frame) => !children.has(parentOf(frame) ?? ""));
  /** @type {Map<string, Box>} */
  const boxes = new Map();
  const met = new Set();
  let [left, height] = [0, 1];
  // Frames of a cycle have no root: they begin with any of them.
  for (const root of [...roots, ...frames]) {
    if (met.has(root)) continue;
    const tree = branch(root, children, met);
    height = Math.max(height, put(tree, left, HEIGHT / 2, boxes));
    left += tree.span + GAP;
  }
  return { boxes, width: Math.max(left - GAP, 1), height };
}

/** @param {string} frame @param {Map<string, string[]>} children @param {Set<string>} met @returns {Branch} */
function branch(frame, children, met) {
  met.add(frame);
  const below = (children.get(frame) ?? []).filter((child) => !met.has(child)).map((child) =>
    branch(child, children, met));
  const width = frame.length * LETTER + PADDING;
  return { frame, width, span: Math.max(width, spanOf(below)), below };
}

/**
 * Put a branch at the right of `left`, and return where its lowest box ends.
 * @param {Branch} branch @param {number} left @param {number} y @param {Map<string, Box>} boxes @returns {number}
 */
function put({ frame, width, span, below }, left, y, boxes) {
  boxes.set(frame, { x: left + span / 2, y, width });
  let next = left + (span - spanOf(below)) / 2;
  let lowest = y + HEIGHT / 2;
  for (const one of below) {
    lowest = Math.max(lowest, put(one, next, y + ROW, boxes));
    next += one.span + GAP;
  }
  return lowest;
}

/** @param {Branch[]} branches */
function spanOf(branches) {
  return branches.reduce((sum, { span }) => sum + span + GAP, -GAP);
}
