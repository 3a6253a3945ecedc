// @ts-check
// The options of a display, as controls made from their defaults.

import { create } from "../../ui/elements.js";
import { NAMES } from "./optionNames.js";

/** @import { Setting, Shown } from "./shown.js" */

const COLOR = /^#[0-9a-f]{6}$/i;

let lastId = 0;

/**
 * Create a control for each option of a display. `look` shows the values that the options have now.
 * @param {Shown} shown @param {(key: string, value: Setting) => void} change
 */
export function createSettings(shown, change) {
  const { defaults, choices = {} } = shown.kind;
  /** @type {Map<string, HTMLInputElement | HTMLSelectElement>} */
  const controls = new Map();
  const element = create("div", "ros-settings");
  for (const [key, standard] of Object.entries(defaults)) {
    const control = createControl(standard, choices[key]);
    control.id = `ros-setting-${++lastId}`;
    controls.set(key, control);
    const label = create("label", "", NAMES[key] ?? key);
    label.htmlFor = control.id;
    // As authors write it.
    label.title = key;
    control.addEventListener("change", () => {
      const value = read(control, standard);
      if (value === undefined) put(control, shown.options[key]);
      else change(key, value);
    });
    element.append(label, control);
  }
  return {
    element,
    look() {
      for (const [key, control] of controls) {
        if (control !== document.activeElement) put(control, shown.options[key]);
      }
    },
  };
}

/** @param {Setting} standard @param {string[]} [choices] */
function createControl(standard, choices) {
  if (choices) return create("select", "", ...choices.map((choice) => new Option(NAMES[choice] ?? choice, choice)));
  const input = create("input", "");
  if (typeof standard === "boolean") {
    input.type = "checkbox";
  } else if (typeof standard === "number") {
    input.type = "number";
    input.step = "any";
  } else if (COLOR.test(standard)) {
    input.type = "color";
  } else {
    input.spellcheck = false;
    input.autocomplete = "off";
  }
  return input;
}

/** @param {HTMLInputElement | HTMLSelectElement} control @param {Setting} standard @returns {Setting | undefined} */
function read(control, standard) {
  if (typeof standard === "boolean") return /** @type {HTMLInputElement} */ (control).checked;
  if (typeof standard !== "number") return control.value;
  const number = control.value === "" ? NaN : Number(control.value);
  return Number.isFinite(number) ? number : undefined;
}

/** @param {HTMLInputElement | HTMLSelectElement} control @param {Setting} value */
function put(control, value) {
  if (typeof value === "boolean") /** @type {HTMLInputElement} */ (control).checked = value;
  else control.value = String(value);
}
