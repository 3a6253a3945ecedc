// @ts-check
// The timeline of a bag: a slider for the time, and a row for each topic with a mark for each of its messages.

import { create } from "../../ui/elements.js";
import { watchColours } from "../../ui/colours.js";
import { say } from "../../ui/words.js";
import { clockText, countText } from "./texts.js";

/** @import { Part, Summary } from "../../bag/orders.js" */
/** @import { Playback } from "../../bag/playback.js" */

// Drawings have this height in pixels; rows beyond these are not drawn.
const HEIGHT = 18;
const MOST_ROWS = 200;

export class Timeline {
  #seek;
  #choose;
  #duration = 0;
  #slider = create("input", "ros-bag-slider");
  #rows = create("div", "ros-bag-rows");
  /** By channel. @type {Map<number, HTMLCanvasElement>} */
  #strips = new Map();
  /** @type {Map<number, Uint32Array>} */
  #marks = new Map();
  #unwatch = () => {};
  element = create("div", "ros-bag-timeline", this.#slider, this.#rows);

  /** @param {(time: number) => void} seek @param {(id: number, on: boolean) => void} choose */
  constructor(seek, choose) {
    this.#seek = seek;
    this.#choose = choose;
    this.#slider.type = "range";
    this.#slider.min = "0";
    this.#slider.step = "any";
    this.#slider.setAttribute("aria-label", say("Time"));
    this.#slider.addEventListener("input", () => this.#seek(Number(this.#slider.value)));
    this.#slider.addEventListener("keydown", (event) => this.#move(event));
    this.element.hidden = true;
  }

  /** Move by a hundredth, or a tenth: without steps, browsers would move by a second. @param {KeyboardEvent} event */
  #move(event) {
    /** @type {Record<string, number>} */
    const keys = {
      ArrowLeft: -0.01, ArrowDown: -0.01, ArrowRight: 0.01, ArrowUp: 0.01, PageDown: -0.1, PageUp: 0.1,
    };
    const by = keys[event.key];
    if (by === undefined) return;
    event.preventDefault();
    const time = Number(this.#slider.value) + by * this.#duration;
    this.#seek(Math.max(0, Math.min(time, this.#duration)));
  }

  /**
   * @param {Summary} summary @param {Pick<Playback, "refused" | "differing">} played
   * @param {Set<number>} left channels that are left out
   */
  show({ duration, tracks }, { refused, differing }, left) {
    this.#duration = duration;
    this.#slider.max = String(duration);
    this.#strips.clear();
    const rows = tracks.slice(0, MOST_ROWS).map((track) => {
      const why = refused.get(track.id) ?? "";
      const box = create("input", "");
      box.type = "checkbox";
      box.checked = !why && !left.has(track.id);
      box.disabled = Boolean(why) || left.has(track.id);
      box.addEventListener("change", () => this.#choose(track.id, box.checked));
      const name = create("label", "ros-bag-topic", box, create("span", "ros-name", track.topic));
      const about = why ? say("not played: {}", why) : `${track.type} · ${countText(track.count)}`;
      const strip = create("canvas", "ros-bag-strip");
      strip.height = HEIGHT;
      strip.addEventListener("pointerdown", (event) => this.#press(strip, event));
      this.#strips.set(track.id, strip);
      const kind = create("span", why ? "ros-type ros-wrong" : "ros-type", about);
      const both = differing.get(track.id);
      return create("div", "ros-bag-row",
        create("div", "ros-bag-label", name, kind), ...(both ? [comparison(both)] : []), create("div", "ros-bag-lane", strip));
    });
    if (tracks.length > MOST_ROWS) {
      rows.push(create("p", "ros-hint", say("{} more topics", tracks.length - MOST_ROWS)));
    }
    this.#rows.replaceChildren(...rows);
    this.element.hidden = false;
    this.#unwatch();
    this.#unwatch = watchColours(() => this.#draw());
  }

  /** @param {Map<number, Uint32Array>} marks numbers of messages by channel */
  mark(marks) {
    this.#marks = marks;
    this.#draw();
  }

  /** Show the time. @param {number} time in seconds */
  at(time) {
    this.#slider.value = String(time);
    this.#slider.setAttribute("aria-valuetext", clockText(time));
    this.element.style.setProperty("--at", this.#duration ? String(time / this.#duration) : "0");
  }

  /** Show which part is played. @param {Part} part */
  limit({ from, to = this.#duration }) {
    this.element.style.setProperty("--from", String(from / this.#duration));
    this.element.style.setProperty("--to", String(to / this.#duration));
  }

  clear() {
    for (const name of ["--from", "--to"]) this.element.style.removeProperty(name);
    this.#unwatch();
    this.#unwatch = () => {};
    this.#marks = new Map();
    this.#strips.clear();
    this.#rows.replaceChildren();
    this.element.hidden = true;
  }

  /** Go where a strip is pressed. @param {HTMLElement} strip @param {PointerEvent} event */
  #press(strip, event) {
    const { left, width } = strip.getBoundingClientRect();
    this.#seek(Math.max(0, Math.min((event.clientX - left) / width, 1)) * this.#duration);
  }

  #draw() {
    for (const [id, strip] of this.#strips) {
      const counts = this.#marks.get(id);
      const brush = strip.getContext("2d");
      if (!counts || !brush) continue;
      strip.width = counts.length;
      brush.fillStyle = getComputedStyle(strip).color;
      const most = counts.reduce((a, b) => Math.max(a, b), 1);
      counts.forEach((count, column) => {
        if (count === 0) return;
        const height = Math.max(0.4, count / most) * HEIGHT;
        brush.fillRect(column, HEIGHT - height, 1, height);
      });
    }
  }
}

/** Show both definitions of a type. @param {{bag: string, page: string}} both */
function comparison({ bag, page }) {
  const one = (/** @type {string} */ title, /** @type {string} */ text) => {
    const shown = create("pre", "ros-bag-definition", text);
    shown.tabIndex = 0;
    return create("div", "", create("p", "ros-type", title), shown);
  };
  return create("details", "ros-bag-differs", create("summary", "", say("Compare the definitions")),
    create("div", "ros-bag-both", one(say("In the bag"), bag), one(say("On this page"), page)));
}
