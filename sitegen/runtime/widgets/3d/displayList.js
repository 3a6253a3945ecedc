// @ts-check
// The displays of a 3D view: switched on and off, with their options and what is wrong with them.

import { arrange, button, create, setNote, setText } from "../../ui/elements.js";
import { say } from "../../ui/words.js";
import { createSettings } from "./settings.js";

/** @import { Shown } from "./shown.js" */
/** @import { World } from "./world.js" */

/** @typedef {{element: HTMLElement, box: HTMLInputElement, look(): void, changed: Record<string, any>}} Row */

export class DisplayList {
  #world;
  #list = create("ul", "ros-display-list");
  #count = create("span", "ros-quiet");
  #summary = create("summary", "", say("Displays"), " ", this.#count);
  element = create("details", "ros-displays", this.#summary, this.#list);
  /** @type {Map<Shown, Row>} */
  #rows = new Map();
  /** What a link says of displays that are not here yet, by name. @type {Record<string, any>} */
  #given = {};

  /** @param {World} world */
  constructor(world) {
    this.#world = world;
    this.look();
  }

  /** Show the displays that there are, and their status. */
  look() {
    const { displays } = this.#world;
    for (const [shown] of this.#rows) if (!displays.includes(shown)) this.#rows.delete(shown);
    for (const shown of displays) {
      const row = this.#rows.get(shown) ?? this.#add(shown);
      row.look();
    }
    arrange(this.#list, displays.map((shown) => /** @type {Row} */ (this.#rows.get(shown)).element));
    const wrong = displays.filter(({ enabled, status }) => enabled && status).length;
    setText(this.#count, wrong ? say("{}, {} with a note", displays.length, wrong) : String(displays.length));
    this.element.classList.toggle("ros-noted", wrong > 0);
  }

  /** What the visitor has changed, by the name of the display. */
  changed() {
    const said = [...this.#rows].filter(([, { changed }]) => Object.keys(changed).length)
      .map(([shown, { changed }]) => [nameOf(shown), changed]);
    const all = { ...this.#given, ...Object.fromEntries(said) };
    return Object.keys(all).length ? all : undefined;
  }

  /** @param {Record<string, any>} given what `changed` returned @param {() => void} odd */
  restore(given, odd) {
    for (const [name, options] of Object.entries(given)) {
      if (typeof options !== "object" || options === null) odd();
      else this.#given[name] = options;
    }
    for (const [shown, row] of this.#rows) this.#apply(shown, row);
    this.look();
  }

  /** @param {Shown} shown @returns {Row} */
  #add(shown) {
    const box = create("input", "");
    box.type = "checkbox";
    const name = create("span", "", shown.title);
    const topic = create("span", "ros-type");
    const note = create("p", "ros-note");
    const label = create("label", "ros-toggle", box, create("span", "", name, " ", topic));
    /** @type {Record<string, any>} */
    const changed = {};
    const settings = createSettings(shown, (key, value) => {
      changed[key] = value;
      shown.set({ [key]: value });
    });
    const more = button(say("Options"), "ros-more", () => {
      settings.element.hidden = !settings.element.hidden;
      more.setAttribute("aria-expanded", String(!settings.element.hidden));
    });
    more.setAttribute("aria-expanded", "false");
    more.setAttribute("aria-label", say("Options of {}", `${shown.title} ${shown.topic}`.trim()));
    settings.element.hidden = true;
    box.addEventListener("change", () => {
      changed["enabled"] = box.checked;
      shown.enable(box.checked);
      this.look();
    });
    const row = {
      element: create("li", "", label, more, note, settings.element, ...(shown.controls ? [shown.controls] : [])),
      box,
      changed,
      look() {
        box.checked = shown.enabled;
        setText(topic, shown.topic);
        setNote(note, shown.enabled ? shown.status : "");
        note.hidden = !note.textContent;
        settings.look();
      },
    };
    this.#rows.set(shown, row);
    this.#apply(shown, row);
    return row;
  }

  /** Restore what a link says of a display. @param {Shown} shown @param {Row} row */
  #apply(shown, row) {
    const name = nameOf(shown);
    const given = Object.hasOwn(this.#given, name) ? this.#given[name] : undefined;
    if (!given) return;
    delete this.#given[name];
    for (const [key, value] of Object.entries(given)) {
      if (key === "enabled" && typeof value === "boolean") {
        shown.enable(value);
      } else if (Object.hasOwn(shown.kind.defaults, key) && typeof value === typeof shown.kind.defaults[key]) {
        shown.set({ [key]: value });
      } else {
        continue;
      }
      row.changed[key] = value;
    }
  }
}

/** The name of a display in links. @param {Shown} shown */
function nameOf({ name, kind, firstTopic }) {
  return kind.types.length ? `${name} ${firstTopic}` : name;
}
