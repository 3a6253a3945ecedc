// @ts-check
// The controls of interactive markers as a list, for those who use a keyboard or a screen reader.

import { arrange, button, create } from "../../../ui/elements.js";
import { say } from "../../../ui/words.js";
import { isMoving } from "./drag.js";
import { EVENTS } from "./events.js";
import { openMenu } from "./menu.js";
import { MODES } from "./modes.js";
import { isNudge, nudge } from "./nudge.js";

/** @import { Control, Handle } from "./handle.js" */
/** @import { Send } from "./pointer.js" */

// More would be no list that somebody goes through.
const MOST = 50;
// A node answers with the pose that it was sent. Until it has had time for that, its answers to earlier keys would move
// the marker back (ms).
const ECHO = 500;

export class KeyList {
  #area;
  #send;
  #list = create("ul", "ros-marker-list");
  #more = create("p", "ros-quiet");
  element = create("div", "ros-marker-keys", this.#list, this.#more);
  /** @type {Map<Handle, HTMLElement>} */
  #rows = new Map();
  /** When what a node wants of a marker is shown again. @type {WeakMap<Handle, ReturnType<typeof setTimeout>>} */
  #resting = new WeakMap();
  #closeMenu = () => {};

  /** @param {HTMLElement} area where menus open @param {Send} send */
  constructor(area, send) {
    this.#area = area;
    this.#send = send;
    this.#list.setAttribute("aria-label", say("Interactive markers"));
    this.show([]);
  }

  /** List these markers. @param {Handle[]} handles */
  show(handles) {
    const listed = handles.slice(0, MOST);
    const focused = this.#focused();
    for (const handle of this.#rows.keys()) if (!listed.includes(handle)) this.#rows.delete(handle);
    for (const handle of listed) if (!this.#rows.has(handle)) this.#rows.set(handle, this.#row(handle));
    arrange(this.#list, listed.map((handle) => /** @type {HTMLElement} */ (this.#rows.get(handle))));
    this.#more.textContent = handles.length > MOST ? say("… and {} more", handles.length - MOST) : "";
    this.element.hidden = handles.length === 0;
    // A node may send a marker again while the visitor moves it.
    const again = focused && listed.find(({ name }) => name === focused.name);
    if (again) this.#rows.get(again)?.querySelectorAll("button")[focused.index]?.focus();
  }

  /** Which button of which marker has the focus. */
  #focused() {
    for (const [{ name }, row] of this.#rows) {
      const index = [...row.querySelectorAll("button")].findIndex((each) => each === document.activeElement);
      if (index >= 0) return { name, index };
    }
    return undefined;
  }

  close() {
    this.#closeMenu();
  }

  /** @param {Handle} handle */
  #row(handle) {
    const row = create("li", "", create("span", "", handle.name.slice(0, 100)));
    for (const control of handle.controls) {
      if (isMoving(control)) row.append(this.#mover(handle, control));
      else if (control.mode === MODES.button) row.append(this.#presser(handle, control));
    }
    if (handle.menu.length) row.append(this.#opener(handle));
    return row;
  }

  /** A button whose arrow keys move the marker. @param {Handle} handle @param {Control} control */
  #mover(handle, control) {
    const key = button(nameOf(control), "ros-marker-mover", () => {});
    key.title = keysOf(control);
    let down = false;
    const release = () => {
      if (!down) return;
      down = false;
      this.#tell(handle, control, EVENTS.up);
      this.#resting.set(handle, setTimeout(() => {
        handle.held = false;
      }, ECHO));
    };
    key.addEventListener("keydown", (event) => {
      if (event.ctrlKey || event.altKey || event.metaKey || !isNudge(event.key, control)) return;
      event.preventDefault();
      clearTimeout(this.#resting.get(handle));
      handle.held = true;
      if (!down) this.#tell(handle, control, EVENTS.down);
      down = true;
      nudge(handle, control, event.key, event.shiftKey);
      this.#tell(handle, control, EVENTS.pose);
    });
    key.addEventListener("keyup", release);
    key.addEventListener("blur", release);
    return key;
  }

  /** @param {Handle} handle @param {Control} control */
  #presser(handle, control) {
    return button(nameOf(control), "", () => {
      for (const event of [EVENTS.down, EVENTS.up, EVENTS.click]) this.#tell(handle, control, event);
    });
  }

  /** @param {Handle} handle */
  #opener(handle) {
    const { name = "" } = handle.controls.find(({ mode }) => mode === MODES.menu) ?? handle.controls[0] ?? {};
    const opener = button(say("Menu"), "", () => {
      this.#closeMenu();
      this.#closeMenu = openMenu(this.#area, handle, { offsetX: 8, offsetY: 8 }, (entry) => this.#send(handle, {
        event_type: EVENTS.menu, control_name: name, menu_entry_id: entry, mouse_point_valid: false,
      }), opener);
    });
    opener.setAttribute("aria-haspopup", "menu");
    opener.setAttribute("aria-label", say("Menu of {}", handle.name));
    return opener;
  }

  /** @param {Handle} handle @param {Control} control @param {number} event */
  #tell(handle, control, event) {
    this.#send(handle, { event_type: event, control_name: control.name, mouse_point_valid: false });
  }
}

/** @param {Control} control */
function nameOf({ name, mode }) {
  const does = mode === MODES.button ? say("press")
    : mode === MODES.rotateAxis || mode === MODES.rotate3d ? say("turn")
      : mode === MODES.moveRotate || mode === MODES.moveRotate3d ? say("move and turn") : say("move");
  return name && name !== does ? `${name.slice(0, 60)} (${does})` : does;
}

/** Which keys a control takes. @param {Control} control */
function keysOf({ mode }) {
  const keys = mode >= MODES.move3d ? say("Arrow keys, Page up, Page down") : say("Arrow keys");
  return mode === MODES.moveRotate || mode === MODES.moveRotate3d ? say("{}; with Shift, they turn it", keys) : keys;
}
