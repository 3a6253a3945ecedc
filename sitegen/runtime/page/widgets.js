// @ts-check
// Mount and unmount the widgets of a page.

import { place } from "../place.js";

/** @import { WidgetEntry } from "../protocol.js" */
/** @typedef {(element: any, ros: any, options: any) => (() => void) & {ready?: Promise<unknown>}} Mount */

export class Widgets {
  /** The unmount functions, by the id of the element. @type {Map<string, () => void>} */
  #unmounts = new Map();
  #known;
  /** Called with the element of a panel that was mounted. @type {(element: HTMLElement) => void} */
  mounted = () => {};

  /** @param {Record<string, Mount>} known the widgets that are loaded already, by kind */
  constructor(known) {
    this.#known = known;
    addEventListener("pagehide", ({ persisted }) => {
      // A page in the back/forward cache may be shown again and keeps its widgets.
      if (!persisted) this.unmount();
    });
  }

  /**
   * Mount a widget in its element, and unmount the widget that was there.
   * @param {WidgetEntry} widget @param {object} ros
   */
  async mount({ kind, element, target, options }, ros) {
    /** @type {Mount} */
    const mount = this.#known[kind] ?? (await import(place(`widgets/${kind}.js`))).mount;
    this.unmount(element);
    const unmount = mount(document.getElementById(element), ros, { node: target, ...options });
    this.#unmounts.set(element, unmount);
    if (!(kind in this.#known)) this.mounted(/** @type {HTMLElement} */ (document.getElementById(element)));
    // A panel of the author's loads its own module.
    await unmount.ready;
  }

  /** Unmount the widget in an element, or all widgets. @param {string} [element] its id */
  unmount(element) {
    for (const id of element === undefined ? [...this.#unmounts.keys()] : [element]) {
      this.#unmounts.get(id)?.();
      this.#unmounts.delete(id);
    }
  }
}
