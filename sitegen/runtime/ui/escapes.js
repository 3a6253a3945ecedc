// @ts-check
// Escape sequences that programs print for terminals (ECMA-48): colours and styles are shown, all others left out.

import { create } from "./elements.js";

// Control sequences, with parameters and a letter; titles and links; and short ones.
const ESCAPES = /\x1b(?:\[([0-?]*)[ -/]*([@-~])|\][^\x07\x1b]*(?:\x07|\x1b\\)?|[ -/]*[0-~])?/g;
// The colours 0 to 7, black to white, by those of the theme: its paper may be of any colour. Bright ones are the same.
const [BLACK, RED, GREEN, YELLOW, BLUE, WHITE] = [
  "terminal-muted", "severity-error", "severity-debug", "severity-warn", "terminal-accent", "terminal-text",
].map((name) => `var(--${name})`);
const [MAGENTA, CYAN] = [RED, GREEN].map((other) => `color-mix(in srgb, ${other}, ${BLUE})`);
const COLOURS = [BLACK, RED, GREEN, YELLOW, BLUE, MAGENTA, CYAN, WHITE];
// The steps of red, green and blue in the colours 16 to 231.
const STEPS = [0, 95, 135, 175, 215, 255];
/** What sets and what resets a style. @type {[number, number, Partial<Style>][]} */
const STYLES = [
  [1, 22, { fontWeight: "600" }], [2, 22, { opacity: "0.7" }], [3, 23, { fontStyle: "italic" }],
  [4, 24, { textDecoration: "underline" }], [9, 29, { textDecoration: "line-through" }],
];

/** @typedef {{color?: string, backgroundColor?: string, fontWeight?: string, opacity?: string, fontStyle?: string,
 *   textDecoration?: string, reverse?: boolean}} Style */

/** Show a row, whose texts have escape sequences, in colours. @param {HTMLElement} row */
export function colour(row) {
  for (const node of [...row.childNodes]) {
    if (node instanceof Text) node.replaceWith(...styled(node.data));
  }
}

/**
 * Return the parts of a text, each in its colours.
 * @param {string} text
 * @returns {(HTMLElement | string)[]}
 */
function styled(text) {
  const parts = [];
  /** @type {Style} */
  let style = {};
  let from = 0;
  for (const found of text.matchAll(ESCAPES)) {
    if (found.index > from) parts.push(part(text.slice(from, found.index), style));
    from = found.index + found[0].length;
    if (found[2] === "m") style = changed(style, found[1] ?? "");
  }
  if (from < text.length) parts.push(part(text.slice(from), style));
  return parts;
}

/** @param {string} text @param {Style} style */
function part(text, { reverse, ...style }) {
  if (reverse) {
    const { color = "var(--terminal-text)", backgroundColor = "var(--terminal)" } = style;
    Object.assign(style, { color: backgroundColor, backgroundColor: color });
  } else if (style.backgroundColor && !style.color) {
    style.color = "var(--terminal)";
  }
  if (!Object.keys(style).length) return text;
  const element = create("span", "ros-styled", text);
  Object.assign(element.style, style);
  return element;
}

/** Return a style after the parameters of "select graphic rendition". @param {Style} before @param {string} parameters */
function changed(before, parameters) {
  let style = { ...before };
  const codes = parameters.replaceAll("::", ":").split(/[;:]/).map(Number);
  while (codes.length) {
    const code = codes.shift() ?? 0;
    if (code === 0) style = {};
    else if (code === 7 || code === 27) style.reverse = code === 7;
    else if (code === 38) style.color = extended(codes);
    else if (code === 48) style.backgroundColor = extended(codes);
    else if ((code >= 30 && code <= 37) || (code >= 90 && code <= 97)) style.color = COLOURS[code % 10];
    else if ((code >= 40 && code <= 47) || (code >= 100 && code <= 107)) style.backgroundColor = COLOURS[code % 10];
    else if (code === 39) delete style.color;
    else if (code === 49) delete style.backgroundColor;
    for (const [on, off, its] of STYLES) {
      if (code === on) Object.assign(style, its);
      if (code === off) for (const name of Object.keys(its)) delete style[/** @type {keyof Style} */ (name)];
    }
  }
  return style;
}

/** Take a colour of 256, or one of red, green and blue, from the codes that follow. @param {number[]} codes */
function extended(codes) {
  if (codes.shift() === 2) {
    const [red = 0, green = 0, blue = 0] = codes.splice(0, 3);
    return `rgb(${red} ${green} ${blue})`;
  }
  const at = codes.shift() ?? 0;
  if (at < 16) return COLOURS[at % 8];
  if (at >= 232) return `rgb(${Array(3).fill(8 + 10 * (at - 232)).join(" ")})`;
  return `rgb(${[36, 6, 1].map((size) => STEPS[Math.floor((at - 16) / size) % 6]).join(" ")})`;
}
