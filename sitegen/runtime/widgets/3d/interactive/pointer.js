// @ts-check
// The pointer on interactive markers: it drags, clicks and opens menus, and tells the node.

import { EVENTS } from "./events.js";
import { Drag, isMoving } from "./drag.js";
import { openMenu } from "./menu.js";
import { MODES } from "./modes.js";

/** @import { Stage } from "../stage.js" */
/** @import { Control, Handle } from "./handle.js" */

// A pointer that moves less than this (pixels) clicks.
const CLICK = 4;
// A node that hears nothing for a second lets other clients move the marker (ms).
const ALIVE = 300;

/** @typedef {(handle: Handle, feedback: Record<string, any>) => void} Send */
/**
 * @typedef {{handle: Handle, control: Control, point: any, drag: Drag | undefined, x: number, y: number, far: boolean,
 *   button: number, id: number, timer: ReturnType<typeof setInterval>}} Grip what is pressed
 */

export class Pointer {
  #stage;
  #handles;
  #send;
  /** @type {Grip | undefined} */
  #grip;
  #frame = 0;
  /** @type {PointerEvent | undefined} */
  #moved;
  #closeMenu = () => {};
  #listening = new AbortController();

  /** @param {Stage} stage @param {() => Handle[]} handles @param {Send} send */
  constructor(stage, handles, send) {
    this.#stage = stage;
    this.#handles = handles;
    this.#send = send;
    const { canvas } = stage;
    const { signal } = this.#listening;
    // Before the camera's own listener, which would turn the view.
    canvas.addEventListener("pointerdown", (event) => this.#press(event), { signal, capture: true });
    canvas.addEventListener("pointermove", (event) => this.#move(event), { signal });
    canvas.addEventListener("pointerup", (event) => this.#lift(event), { signal });
    canvas.addEventListener("pointercancel", () => this.release(), { signal });
    // A finger on a marker does not scroll the page.
    canvas.addEventListener("touchstart", (event) => this.#grip && event.preventDefault(), { signal, passive: false });
  }

  /** Let go of what is held, or of this marker. @param {Handle} [handle] */
  release(handle) {
    if (!this.#grip || (handle && this.#grip.handle !== handle)) return;
    clearInterval(this.#grip.timer);
    cancelAnimationFrame(this.#frame);
    this.#frame = 0;
    this.#grip.handle.held = false;
    this.#grip = undefined;
  }

  close() {
    this.release();
    this.#closeMenu();
    this.#listening.abort();
  }

  /** The control below the pointer. @param {PointerEvent} event */
  #under(event) {
    const handles = this.#handles();
    if (!handles.length || this.#stage.canvas.classList.contains("ros-aiming")) return undefined;
    const hits = this.#stage.ray(event).intersectObjects(handles.map(({ place }) => place), true);
    for (const { object, point } of hits) {
      /** @type {any} */
      let each = object;
      while (each && !each.userData.control) each = each.parent;
      if (each && each.userData.control.mode !== MODES.none) {
        return { handle: each.userData.handle, control: each.userData.control, point };
      }
    }
    return undefined;
  }

  /** @param {PointerEvent} event */
  #press(event) {
    const found = this.#grip ? undefined : this.#under(event);
    if (!found) return;
    event.stopImmediatePropagation();
    const { canvas, camera } = this.#stage;
    canvas.focus({ preventScroll: true });
    canvas.setPointerCapture(event.pointerId);
    const { handle, control, point } = found;
    const drag = event.button === 0 && isMoving(control) ? new Drag(handle, control, point, camera, event) : undefined;
    const timer = setInterval(() => this.#tell(EVENTS.keepAlive), ALIVE);
    this.#grip = {
      ...found, drag, timer, x: event.offsetX, y: event.offsetY, far: false, button: event.button, id: event.pointerId,
    };
    handle.held = true;
    this.#tell(EVENTS.down);
  }

  /** @param {PointerEvent} event */
  #move(event) {
    if (this.#grip && event.pointerId !== this.#grip.id) return;
    this.#moved = event;
    // Pointers may tell more often than the screen shows.
    this.#frame ||= requestAnimationFrame(() => this.#follow());
  }

  #follow() {
    this.#frame = 0;
    const event = this.#moved;
    if (!event) return;
    const grip = this.#grip;
    if (!grip) {
      const over = event.buttons === 0 && this.#under(event);
      this.#stage.canvas.classList.toggle("ros-grips", Boolean(over));
      return;
    }
    measure(grip, event);
    if (!grip.drag || !grip.far) return;
    grip.drag.to(this.#stage.ray(event).ray, event);
    this.#tell(EVENTS.pose);
  }

  /** @param {PointerEvent} event */
  #lift(event) {
    const grip = this.#grip;
    if (!grip || event.pointerId !== grip.id) return;
    // A quick movement ends before a frame was drawn.
    measure(grip, event);
    if (grip.drag && grip.far) {
      grip.drag.to(this.#stage.ray(event).ray, event);
      this.#tell(EVENTS.pose);
    }
    this.#tell(EVENTS.up);
    const { handle, control, far, button } = grip;
    if (!far && button === 0 && control.mode === MODES.button) this.#tell(EVENTS.click);
    const wantsMenu = button === 2 || (button === 0 && control.mode === MODES.menu);
    if (!far && wantsMenu && handle.menu.length) this.#open(grip, event);
    this.release();
  }

  /** @param {Grip} grip @param {PointerEvent} event */
  #open({ handle, control, point }, event) {
    this.#closeMenu();
    this.#closeMenu = openMenu(this.#stage.element, handle, event, (entry) => this.#send(handle, {
      event_type: EVENTS.menu, control_name: control.name, menu_entry_id: entry, ...mouse(point),
    }));
  }

  /** @param {number} event */
  #tell(event) {
    if (!this.#grip) return;
    const { handle, control, point } = this.#grip;
    this.#send(handle, { event_type: event, control_name: control.name, ...mouse(point) });
  }
}

/** Note whether the pointer has moved by more than a click. @param {Grip} grip @param {PointerEvent} event */
function measure(grip, { offsetX, offsetY }) {
  grip.far ||= Math.hypot(offsetX - grip.x, offsetY - grip.y) > CLICK;
}

/** @param {{x: number, y: number, z: number}} point */
function mouse({ x, y, z }) {
  return { mouse_point: { x, y, z }, mouse_point_valid: true };
}
