// @ts-check
// What drives a robot: a stick on the page, keys, and a gamepad. Each says how far forward and to the left, -1 to 1.

/** @typedef {{forward: number, left: number}} Drive */

/** @type {Drive} */
export const NOTHING = Object.freeze({ forward: 0, left: 0 });

/** @type {Record<string, [number, number]>} */
const KEYS = {
  ArrowUp: [1, 0], ArrowDown: [-1, 0], ArrowLeft: [0, 1], ArrowRight: [0, -1],
  KeyW: [1, 0], KeyS: [-1, 0], KeyA: [0, 1], KeyD: [0, -1],
};
// The part of a gamepad's stick that counts as its middle.
const IDLE = 0.12;
/** The shoulder buttons, one of which must be held. */
const SHOULDERS = [4, 5];

/** Keys that are held while an element has the focus. */
export class Keys {
  #held = new Set();
  #shift = false;

  /** @param {HTMLElement} element @param {() => void} changed */
  constructor(element, changed) {
    element.addEventListener("keydown", (event) => {
      this.#shift = event.shiftKey;
      if (!(event.code in KEYS) || event.ctrlKey || event.altKey || event.metaKey) return;
      if (event.target instanceof HTMLInputElement) return;
      event.preventDefault();
      this.#held.add(event.code);
      changed();
    });
    element.addEventListener("keyup", (event) => {
      this.#shift = event.shiftKey;
      if (this.#held.delete(event.code) || event.key === "Shift") changed();
    });
    element.addEventListener("focusout", () => {
      this.#held.clear();
      changed();
    });
  }

  clear() {
    this.#held.clear();
  }

  /** @param {boolean} guarded whether Shift must be held @returns {Drive} */
  read(guarded) {
    if (guarded && !this.#shift) return NOTHING;
    const sum = [...this.#held].reduce(([x, y], code) => {
      const [a, b] = KEYS[code] ?? [0, 0];
      return [x + a, y + b];
    }, [0, 0]);
    return { forward: Math.sign(sum[0]), left: Math.sign(sum[1]) };
  }
}

/** A stick that is dragged with the mouse or a finger. */
export class Stick {
  #base;
  #knob;
  #drive = NOTHING;
  #changed;

  /** @param {HTMLElement} base @param {HTMLElement} knob @param {() => void} changed */
  constructor(base, knob, changed) {
    this.#base = base;
    this.#knob = knob;
    this.#changed = changed;
    base.addEventListener("pointerdown", (event) => {
      if (event.button !== 0) return;
      base.setPointerCapture(event.pointerId);
      this.#move(event);
    });
    base.addEventListener("pointermove", (event) => {
      if (base.hasPointerCapture(event.pointerId)) this.#move(event);
    });
    for (const end of ["pointerup", "pointercancel", "lostpointercapture"]) base.addEventListener(end, () => this.clear());
  }

  clear() {
    if (this.#drive === NOTHING) return;
    this.#drive = NOTHING;
    this.#draw();
    this.#changed();
  }

  /** @returns {Drive} */
  read() {
    return this.#drive;
  }

  /** @param {PointerEvent} event */
  #move({ clientX, clientY }) {
    const { left, top, width, height } = this.#base.getBoundingClientRect();
    const x = ((clientX - left) / width) * 2 - 1;
    const y = 1 - ((clientY - top) / height) * 2;
    const far = Math.max(1, Math.hypot(x, y));
    this.#drive = { forward: y / far, left: -x / far };
    this.#draw();
    this.#changed();
  }

  #draw() {
    const { forward, left } = this.#drive;
    this.#knob.style.translate = `${-left * 100}% ${-forward * 100}%`;
  }
}

/**
 * Read the first gamepad. @param {boolean} guarded whether a shoulder button must be held
 * @returns {{drive: Drive, axes: number[], buttons: number[]} | undefined}
 */
export function readGamepad(guarded) {
  const pad = [...(navigator.getGamepads?.() ?? [])].find((each) => each?.connected);
  if (!pad) return undefined;
  const axis = (/** @type {number} */ index) => {
    const value = pad.axes[index] ?? 0;
    return Math.abs(value) < IDLE ? 0 : value;
  };
  const held = !guarded || SHOULDERS.some((index) => pad.buttons[index]?.pressed);
  // Upwards and to the left are negative on gamepads, and positive in ROS.
  const drive = held ? { forward: -axis(1) || 0, left: -axis(0) || 0 } : NOTHING;
  return { drive, axes: pad.axes.map((value) => -value || 0), buttons: pad.buttons.map(({ pressed }) => Number(pressed)) };
}
