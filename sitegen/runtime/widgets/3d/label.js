// @ts-check
// A text that faces the camera.

import { CanvasTexture, Color, Sprite, SpriteMaterial, SRGBColorSpace } from "../../vendor/three.js";
import { isLight } from "./color.js";

const PIXELS = 48;
const FONT = `${PIXELS * 0.75}px system-ui, sans-serif`;
const RIM = 4;
// Longer texts are cut: nodes may send anything.
const LONGEST = 200;
const MOST_LINES = 20;

/**
 * Return a sprite that shows a text.
 * @param {string} text @param {number} height of a line, in metres; in parts of the view's height if `fixed`
 * @param {{color?: any, opacity?: number, fixed?: boolean}} [look]
 */
export function createLabel(text, height, { color = new Color(0xffffff), opacity = 1, fixed = false } = {}) {
  const lines = text.split("\n").slice(0, MOST_LINES).map((line) => line.slice(0, LONGEST));
  const canvas = document.createElement("canvas");
  const measure = /** @type {CanvasRenderingContext2D} */ (canvas.getContext("2d"));
  measure.font = FONT;
  canvas.width = Math.min(4096, Math.max(1, ...lines.map((line) => Math.ceil(measure.measureText(line).width))) + 8);
  canvas.height = lines.length * PIXELS;
  const context = /** @type {CanvasRenderingContext2D} */ (canvas.getContext("2d"));
  context.font = FONT;
  context.textBaseline = "middle";
  context.textAlign = "center";
  context.fillStyle = `#${color.getHexString()}`;
  // Around the letters, so that they are read on any ground.
  context.strokeStyle = isLight(color) ? "rgb(0 0 0 / 0.7)" : "rgb(255 255 255 / 0.7)";
  context.lineWidth = RIM;
  context.lineJoin = "round";
  lines.forEach((line, index) => {
    const place = /** @type {const} */ ([line, canvas.width / 2, (index + 0.5) * PIXELS]);
    context.strokeText(...place);
    context.fillText(...place);
  });
  const map = new CanvasTexture(canvas);
  map.colorSpace = SRGBColorSpace;
  const sprite = new Sprite(new SpriteMaterial({
    map, opacity, transparent: true, depthTest: !fixed, depthWrite: false, sizeAttenuation: !fixed,
  }));
  sprite.scale.set((height * canvas.width) / PIXELS, height * lines.length, 1);
  return sprite;
}
