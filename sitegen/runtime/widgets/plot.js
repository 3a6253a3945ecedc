// @ts-check
// A plot of numbers in messages, against the time or against each other.

import { parsePath } from "../messages/path.js";
import { create, setText } from "../ui/elements.js";
import { download } from "../ui/download.js";
import { fullScreenButton } from "../ui/fullScreen.js";
import { whileNear } from "../ui/looking.js";
import { numberText } from "../ui/numbers.js";
import { setTool, tool, Toolbar, zoomTools } from "../ui/toolbar.js";
import { say } from "../ui/words.js";
import { ChartScatter, Download, Eraser, Pause, Play } from "../vendor/icons.js";
import { Chart } from "./plot/chart.js";
import { Chooser } from "./plot/chooser.js";
import { toCsv } from "./plot/csv.js";
import { Legend } from "./plot/legend.js";
import { MOST_SERIES, Samples } from "./plot/samples.js";

/** @import { Ros, Shared } from "../protocol.js" */
/** @import { View } from "./plot/chart.js" */
/** @import { Curve } from "./plot/curve.js" */

/**
 * @typedef {{series?: string[] | string | null, x?: string | null, window?: number | null, title?: string | null,
 *   points?: boolean | null, min?: number | null, max?: number | null, time?: string | null}} Options
 */

// Values are written this often (ms), so that they can be read.
const READABLE = 250;
const STEP = 1.5;
// The longest window (s).
const LONGEST = 3600;
const FREE = { left: NaN, right: NaN, low: NaN, high: NaN };

/**
 * Plot the series, to which visitors add others.
 * @param {HTMLElement} element
 * @param {Ros} ros
 * @param {Options} options
 * @returns {() => void} unmount
 */
export function mount(element, ros, options) {
  const panel = new PlotPanel(element, ros, options);
  element.replaceChildren(...panel.elements);
  const shape = /** @type {const} */ ({ series: "object", window: "string", points: "boolean" });
  ros.keep(element, shape, () => panel.read(), (state, odd) => panel.restore(state, odd));
  const unlook = whileNear(element, () => panel.begin());
  return () => {
    unlook();
    panel.close();
    element.replaceChildren();
  };
}

class PlotPanel {
  #ros;
  #options;
  #samples;
  #chart;
  #legend;
  #chooser;
  #paused = false;
  /** Whether the pause ends with the zoom. */
  #pausedByZoom = false;
  #seen = false;
  /** The part that the visitor has selected. @type {View | undefined} */
  #zoom;
  /** @type {number | undefined} */
  #pointed;
  #frame = 0;
  #timer = 0;
  #first;

  #pause = tool(say("Pause"), Pause, () => this.#setPaused(!this.#paused));
  #seconds = create("input", "ros-seconds");
  #points = tool(say("Points"), ChartScatter, () => this.#setPoints(!this.#chart.points), say("Show each sample"));
  #hint = create("p", "ros-hint");
  elements;

  /** @param {HTMLElement} panel @param {Ros} ros @param {Options} options */
  constructor(panel, ros, options) {
    this.#ros = ros;
    this.#options = options;
    this.#first = [options.series ?? []].flat();
    const window = options.window ?? 30;
    this.#samples = new Samples(ros, { x: options.x, time: options.time, window }, () => this.redraw());
    this.#chart = new Chart(() => this.redraw(), (view) => this.#setZoom(view), () => this.#setZoom(undefined), (x) => {
      this.#pointed = x;
      this.#write();
    });
    this.#legend = new Legend(() => this.redraw(), (series) => {
      this.#choose(this.#samples.series.filter((one) => one !== series).map(({ text }) => text));
    });
    this.#chooser = new Chooser(ros, (path) => this.#add(path));
    this.#chart.element.addEventListener("keydown", (event) => this.#press(event));
    const about = create("div", "ros-key-area", this.#legend.element, this.#chooser.element);
    const area = create("div", "ros-chart-area", this.#chart.element, this.#hint);
    this.elements = [this.#createBar(options.title, panel), area, about];
    this.#seconds.value = String(window);
    this.#setPoints(Boolean(options.points));
    this.#samples.choose(this.#first);
  }

  /** @param {string | null | undefined} title @param {HTMLElement} panel */
  #createBar(title, panel) {
    this.#seconds.inputMode = "decimal";
    this.#seconds.addEventListener("change", () => this.#setWindow(this.#seconds.value));
    const seconds = create("label", "ros-every", this.#seconds, say("seconds"));
    const controls = new Toolbar([
      this.#pause,
      ...zoomTools((closer) => this.#scale(closer ? 1 / STEP : STEP), () => this.#setZoom(undefined)),
      seconds,
      this.#points,
      tool("CSV", Download, () => this.#save(), say("Save what is shown as a table")),
      tool(say("Clear"), Eraser, () => {
        this.#samples.clear();
        this.redraw();
      }),
    ], [fullScreenButton(panel)]);
    const heading = create("div", "ros-node", create("span", "ros-title", title || say("Plot")));
    return create("div", "ros-bar", heading, controls.element);
  }

  /** Subscribe and draw while the panel is visible. @returns {() => void} end it */
  begin() {
    const look = () => {
      this.#samples.look();
      this.#chooser.look();
      this.#write();
    };
    this.#seen = true;
    this.#samples.work(!this.#paused);
    this.#ros.graph.addEventListener("change", look);
    look();
    this.redraw();
    return () => {
      this.#ros.graph.removeEventListener("change", look);
      this.#seen = false;
      this.#samples.work(false);
      cancelAnimationFrame(this.#frame);
      clearTimeout(this.#timer);
      this.#frame = this.#timer = 0;
    };
  }

  close() {
    this.#samples.choose([]);
    this.#chart.close();
  }

  /** Draw in the next frame. */
  redraw() {
    if (this.#seen) this.#frame ||= requestAnimationFrame(() => this.#draw());
  }

  /** Return what a link carries of the panel. */
  read() {
    const texts = this.#samples.series.map(({ text }) => text);
    const same = texts.join("\n") === this.#first.join("\n");
    const { window } = this.#samples;
    const points = this.#chart.points !== Boolean(this.#options.points);
    return {
      series: same ? undefined : texts, window: window === (this.#options.window ?? 30) ? "" : String(window), points,
    };
  }

  /** @param {Shared} state as `read` returned it @param {() => void} odd */
  restore({ series, window, points }, odd) {
    if (series) {
      const sound = Array.isArray(series) ? series.filter(isPath).slice(0, MOST_SERIES) : undefined;
      if (!sound || sound.length < series.length) odd();
      if (sound) this.#choose(sound);
    }
    if (window && !this.#setWindow(window)) odd();
    if (points) this.#setPoints(!this.#options.points);
  }

  /** @param {string[]} paths */
  #choose(paths) {
    this.#samples.choose(paths);
    this.#write();
    this.redraw();
  }

  /** Add a series; return why that is not possible, or "". @param {string} path */
  #add(path) {
    const texts = this.#samples.series.map(({ text }) => text);
    if (texts.includes(path)) return say("{} is plotted already", path);
    if (texts.length >= MOST_SERIES) return say("A plot has at most {} paths; remove one first", MOST_SERIES);
    this.#choose([...texts, path]);
    return "";
  }

  /** @param {boolean} on */
  #setPoints(on) {
    this.#chart.points = on;
    this.#points.setAttribute("aria-pressed", String(on));
    this.redraw();
  }

  /** Show so many seconds; return whether that is possible. @param {string} text */
  #setWindow(text) {
    const window = Number(String(text).replace(",", "."));
    const valid = window >= 0.1 && window <= LONGEST;
    if (valid) this.#samples.window = window;
    this.#seconds.value = String(this.#samples.window);
    this.redraw();
    return valid;
  }

  /** @param {boolean} paused */
  #setPaused(paused) {
    this.#paused = paused;
    this.#pausedByZoom = false;
    if (!paused) this.#zoom = undefined;
    this.#samples.work(this.#seen && !paused);
    setTool(this.#pause, paused ? say("Resume") : say("Pause"), paused ? Play : Pause);
    this.redraw();
  }

  /** Show a part, in which nothing moves; or all. @param {View | undefined} view */
  #setZoom(view) {
    const wasPaused = this.#paused && !this.#pausedByZoom;
    if (view) {
      if (!this.#paused) this.#setPaused(true);
      this.#zoom = withRoom(view);
      this.#pausedByZoom = !wasPaused;
    } else {
      this.#zoom = undefined;
      if (this.#pausedByZoom) this.#setPaused(false);
    }
    this.redraw();
  }

  /** Zoom, or move by a share of the width and the height. @param {number} by @param {number} [x] @param {number} [y] */
  #scale(by, x = 0, y = 0) {
    const { left, right, low, high } = this.#chart.view;
    const [width, height] = [right - left, high - low];
    const across = this.#samples.against ? by : 1;
    const middle = (low + high) / 2 + y * height;
    const centre = (left + right) / 2 + x * width;
    this.#setZoom({
      left: centre - (width * by) / 2, right: centre + (width * by) / 2,
      low: middle - (height * across) / 2, high: middle + (height * across) / 2,
    });
  }

  /** @param {KeyboardEvent} event */
  #press(event) {
    if (event.ctrlKey || event.metaKey || event.altKey) return;
    /** @type {Record<string, () => void>} */
    const keys = {
      "+": () => this.#scale(1 / STEP),
      "=": () => this.#scale(1 / STEP),
      "-": () => this.#scale(STEP),
      0: () => this.#setZoom(undefined),
      ArrowLeft: () => this.#scale(1, -0.1),
      ArrowRight: () => this.#scale(1, 0.1),
      ArrowUp: () => this.#scale(1, 0, 0.1),
      ArrowDown: () => this.#scale(1, 0, -0.1),
      " ": () => this.#setPaused(!this.#paused),
    };
    const act = keys[event.key];
    if (!act) return;
    event.preventDefault();
    act();
  }

  #draw() {
    this.#frame = 0;
    this.#samples.trim();
    const curves = this.#samples.curves.filter(({ shown }) => shown);
    const { min, max } = this.#options;
    const free = { ...FREE, low: min ?? NaN, high: max ?? NaN };
    if (this.#samples.against) this.#chart.drawAgainst(curves, this.#zoom ?? free);
    else this.#chart.drawTime(curves, this.#zoom ?? { ...free, ...this.#lastSeconds() });
    this.#timer ||= setTimeout(() => {
      this.#timer = 0;
      this.#write();
    }, READABLE);
    this.#hint.hidden = this.#samples.curves.length > 0;
    if (!this.#hint.hidden) setText(this.#hint, this.#describeSilence());
  }

  #lastSeconds() {
    const { newest, window } = this.#samples;
    const right = Number.isNaN(newest) ? window : newest;
    return { left: right - window, right };
  }

  /** Write the values, for eyes and for screen readers. */
  #write() {
    const { series, against, error } = this.#samples;
    this.#legend.show(series, (one) => this.#samples.describe(one), (curve) => this.#valueOf(curve));
    const values = this.#samples.curves.map(({ name, latest }) => `${name} ${numberText(latest ?? NaN)}`).join(", ");
    const what = against ? say("Plot against {}", against.text) : say("Plot against time");
    this.#chart.element.setAttribute("aria-label", values ? say("{}. Latest values: {}", what, values) : what);
    this.#hint.classList.toggle("ros-wrong", Boolean(error));
    if (!this.#hint.hidden) setText(this.#hint, this.#describeSilence());
  }

  /** The value under the pointer, or else the latest. @param {Curve} curve */
  #valueOf({ trace, latest }) {
    if (this.#pointed === undefined || this.#samples.against || trace.size === 0) return latest;
    return trace.value(Math.max(Math.min(trace.find(this.#pointed), trace.size - 1), 0));
  }

  #describeSilence() {
    const { series, error } = this.#samples;
    if (error) return error;
    return series.length ? say("Nothing received yet") : say("Add a message path to plot it");
  }

  #save() {
    const { left, right } = this.#samples.against ? { left: -Infinity, right: Infinity } : this.#chart.view;
    const curves = this.#samples.curves.filter(({ shown }) => shown);
    const csv = toCsv(curves, left, right, this.#samples.zero, this.#samples.against?.text ?? "");
    download(new Blob([csv], { type: "text/csv" }), "plot.csv");
  }
}

/** @param {unknown} text */
function isPath(text) {
  try {
    return typeof text === "string" && Boolean(parsePath(text));
  } catch {
    return false;
  }
}

/** A part that is large enough for the digits of its numbers. @param {View} view @returns {View} */
function withRoom({ left, right, low, high }) {
  const across = Math.max(Math.abs(left), Math.abs(right), 1) * 1e-9;
  const along = Math.max(Math.abs(low), Math.abs(high), 1e-12) * 1e-9;
  if (right - left < across) [left, right] = [(left + right - across) / 2, (left + right + across) / 2];
  if (high - low < along) [low, high] = [(low + high - along) / 2, (low + high + along) / 2];
  return { left, right, low, high };
}
