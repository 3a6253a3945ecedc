// @ts-check
// Which of black and white is read on a colour.

/** Whether black is read better on a colour than white. @param {InstanceType<typeof import("../../vendor/three.js").Color>} color */
export function isLight({ r, g, b }) {
  // The luminance of WCAG, of which 0.18 has the same contrast to both.
  return 0.2126 * r + 0.7152 * g + 0.0722 * b > 0.18;
}
