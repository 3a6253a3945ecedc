// @ts-check
// A list of names of the graph, of which one is chosen.

import { arrange, button, create, pressAnywhere, setText } from "./elements.js";

/**
 * @typedef {{name: string, type: string, about: string, idle: boolean}} Pick
 * @typedef {{element: HTMLElement, pick: HTMLButtonElement, type: HTMLElement, about: HTMLElement}} Row
 */

export class Picks {
  /** @type {Map<string, Row>} */
  #rows = new Map();
  #choose;
  #chosen = "";
  element = create("ul", "ros-picks");

  /** @param {(name: string) => void} choose called when the visitor chooses one */
  constructor(choose) {
    this.#choose = choose;
  }

  /** Mark the chosen one. @param {string} name */
  choose(name) {
    this.#chosen = name;
    for (const [each, { pick }] of this.#rows) pick.setAttribute("aria-pressed", String(each === name));
  }

  /** List these, and no others. @param {Pick[]} picks */
  update(picks) {
    const names = new Set(picks.map(({ name }) => name));
    for (const name of this.#rows.keys()) if (!names.has(name)) this.#rows.delete(name);
    arrange(this.element, picks.map((pick) => this.#row(pick)));
  }

  /** @param {Pick} pick */
  #row({ name, type, about, idle }) {
    const row = this.#rows.get(name) ?? this.#create(name);
    this.#rows.set(name, row);
    setText(row.type, type);
    setText(row.about, about);
    row.element.classList.toggle("ros-idle", idle);
    return row.element;
  }

  /** @param {string} name @returns {Row} */
  #create(name) {
    const pick = button(name, "ros-pick", () => this.#choose(name));
    pick.setAttribute("aria-pressed", String(name === this.#chosen));
    const type = create("small", "");
    const about = create("small", "");
    const element = create("li", "", pick, type, about);
    pressAnywhere(element, pick);
    return { element, pick, type, about };
  }
}
