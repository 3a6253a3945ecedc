// @ts-check
// The widgets of a page, from the moment that they are mounted until they are removed.

import { place } from "../place.js";

/** @import { WidgetEntry } from "../protocol.js" */
/** @typedef {(element: any, ros: any, options: any) => () => void} Mount */

export class Widgets {
  /** How to remove each widget, by the id of its element. @type {Map<string, () => void>} */
  #unmounts = new Map();
  #known;

  /** @param {Record<string, Mount>} known those that need not be loaded, by kind */
  constructor(known) {
    this.#known = known;
    addEventListener("pagehide", ({ persisted }) => {
      // A page in the back/forward cache may be shown again, with its widgets.
      if (!persisted) this.unmount();
    });
  }

  /** Mount a widget, in place of the one that its element holds. @param {WidgetEntry} widget @param {object} ros */
  async mount({ kind, element, target, options }, ros) {
    /** @type {Mount} */
    const mount = this.#known[kind] ?? (await import(place(`widgets/${kind}.js`))).mount;
    this.unmount(element);
    this.#unmounts.set(element, mount(document.getElementById(element), ros, { node: target, ...options }));
  }

  /** Remove the widget in an element, or all widgets of the page. @param {string} [element] its id */
  unmount(element) {
    for (const id of element === undefined ? [...this.#unmounts.keys()] : [element]) {
      this.#unmounts.get(id)?.();
      this.#unmounts.delete(id);
    }
  }
}
