// @ts-check
// Texts on the screen: those of nodes cannot drive the terminal, and only the terminal itself colours them.

/** @typedef {"" | "bold" | "faint" | "red" | "green" | "yellow" | "blue" | "magenta" | "cyan"} Style */

/** @type {Record<Style, string>} */
const CODES = {
  "": "", bold: "1", faint: "2", red: "31", green: "32", yellow: "33", blue: "34", magenta: "35", cyan: "36",
};
// C0 and C1 controls except tabs and line ends, and characters that reorder others.
const CONTROL = /[\0-\x08\x0b-\x1f\x7f-\x9f\u202a-\u202e\u2066-\u2069]/g;

/** Return a text with all control characters written as ^X, <XX> or <XXXX>. @param {string} text */
export function harmless(text) {
  return text.replace(CONTROL, (letter) => {
    const code = letter.charCodeAt(0);
    if (code < 0x20) return `^${String.fromCharCode(code + 64)}`;
    if (code === 0x7f) return "^?";
    return `<${code.toString(16).toUpperCase().padStart(2, "0")}>`;
  });
}

/** Return a text, made harmless, for the screen. @param {string} text @param {Style} [style] */
export function styled(text, style = "") {
  const shown = harmless(text).replaceAll("\n", "\r\n");
  return style && shown ? `\x1b[${CODES[style]}m${shown}\x1b[0m` : shown;
}
