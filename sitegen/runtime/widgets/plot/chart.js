// @ts-check
// The chart of a plot. uPlot draws the axes and lets visitors select a part; the curves are drawn here, from outlines.

import { watchColours } from "../../ui/colours.js";
import { create } from "../../ui/elements.js";
import { uPlot } from "../../vendor/uplot.js";
import { empty, include } from "./extents.js";
import { emptyOutline, outlineTime } from "./outline.js";
import { dot, prepare } from "./pen.js";
import { Trail } from "./trail.js";

/** @import { Curve } from "./curve.js" */
/** @import { Outline } from "./outline.js" */
/** @import { Look } from "./pen.js" */

/**
 * @typedef {{left: number, right: number, low: number, high: number}} View what the axes show; `low` and `high` are
 *   NaN where they follow the curves
 */

export const COLOURS = 8;
/** The lines of curves whose colour is used already (px). */
const DASHES = [[], [8, 4], [2, 3], [12, 3, 2, 3], [5, 2]];
// How much of its height a chart leaves free above and below the curves.
const MARGIN = 0.06;
// By which share of its length an axis against x may differ from this: while it stays, curves need not be drawn again.
const SLACK = 0.04;
const FONT = '12px system-ui, -apple-system, "Segoe UI", Roboto, "Noto Sans", sans-serif';

export class Chart {
  element = create("div", "ros-chart");
  points = false;
  /** What is written behind the numbers of the horizontal axis. */
  #unit = "";
  #plot;
  /** @type {{curve: Curve, outline: Outline}[]} */
  #drawn = [];
  /** @type {Map<Curve, Outline>} */
  #outlines = new Map();
  /** What the axes against x followed the curves to. @type {View | undefined} */
  #kept;
  /** The curves against x. @type {Curve[] | undefined} */
  #against;
  /** @type {Trail | undefined} */
  #trail;
  #colours = { ink: "", line: "", curves: /** @type {string[]} */ ([]) };
  #redraw;
  #resized = new ResizeObserver(() => this.#resize());
  #unwatch;

  /**
   * @param {() => void} redraw called when the chart must be drawn again
   * @param {(view: View) => void} select called for a part that the visitor has selected
   * @param {() => void} reset called for a double click
   * @param {(time: number | undefined) => void} point called with the x under the pointer
   */
  constructor(redraw, select, reset, point) {
    this.#redraw = redraw;
    this.element.tabIndex = 0;
    this.element.setAttribute("role", "img");
    this.#plot = new uPlot(this.#options(select, reset, point), [[0, 1], [null, null]], this.element);
    this.#unwatch = watchColours(() => {
      this.#colours.ink = "";
      redraw();
    });
    this.#resized.observe(this.element);
  }

  close() {
    this.#resized.disconnect();
    this.#unwatch();
    this.#plot.destroy();
  }

  /** What the axes show now. @returns {View} */
  get view() {
    const { x, y } = this.#plot.scales;
    return { left: x?.min ?? 0, right: x?.max ?? 1, low: y?.min ?? 0, high: y?.max ?? 1 };
  }

  /** Draw curves against the time. @param {Curve[]} curves @param {View} view */
  drawTime(curves, view) {
    const columns = Math.max(Math.round(this.#plot.bbox.width), 1);
    let [low, high] = [Infinity, -Infinity];
    this.#drawn = this.#outlined(curves, (curve, outline) => {
      outlineTime(curve.trace, view.left, view.right, columns, outline);
      low = Math.min(low, outline.low);
      high = Math.max(high, outline.high);
    });
    this.#unit = " s";
    this.#show(view.left, view.right, ...padded(low, high, view.low, view.high));
  }

  /** Draw curves against x. @param {Curve[]} curves @param {View} view all of it may be NaN */
  drawAgainst(curves, view) {
    const extent = empty();
    for (const { trace } of curves) include(extent, trace.extents.whole);
    const [left, right] = padded(extent.left, extent.right, view.left, view.right);
    const [low, high] = padded(extent.low, extent.high, view.low, view.high);
    const wanted = { left, right, low, high };
    // What a visitor has selected is shown as it is.
    this.#kept = Number.isNaN(view.left) ? steady(wanted, this.#kept) : undefined;
    this.#against = curves;
    const shown = this.#kept ?? wanted;
    this.#show(shown.left, shown.right, shown.low, shown.high);
  }

  /** @param {Curve[]} curves @param {(curve: Curve, outline: Outline) => void} fill */
  #outlined(curves, fill) {
    for (const curve of this.#outlines.keys()) if (!curves.includes(curve)) this.#outlines.delete(curve);
    return curves.map((curve) => {
      const outline = this.#outlines.get(curve) ?? emptyOutline(Math.max(Math.round(this.#plot.bbox.width), 1));
      this.#outlines.set(curve, outline);
      fill(curve, outline);
      return { curve, outline };
    });
  }

  /** @param {number} left @param {number} right @param {number} low @param {number} high */
  #show(left, right, low, high) {
    if (!this.#colours.ink) this.#readColours();
    this.#plot.batch(() => {
      this.#plot.setScale("x", { min: left, max: right });
      this.#plot.setScale("y", { min: low, max: high });
    });
  }

  /** Draw the curves above the grid. */
  #paint() {
    const { ctx, bbox } = this.#plot;
    const { left, right, low, high } = this.view;
    const look = {
      left, high, scaleX: bbox.width / (right - left), scaleY: bbox.height / (high - low), ratio: uPlot.pxRatio,
      points: this.points, colours: this.#colours.curves, dashes: DASHES,
    };
    ctx.save();
    ctx.beginPath();
    ctx.rect(bbox.left, bbox.top, bbox.width, bbox.height);
    ctx.clip();
    if (this.#against) {
      this.#trail ??= new Trail();
      this.#trail.paint(ctx, this.#against, bbox, look);
    } else {
      ctx.translate(bbox.left, bbox.top);
      for (const { curve, outline } of this.#drawn) paintOutline(ctx, curve, outline, look);
    }
    ctx.restore();
  }

  #readColours() {
    const style = getComputedStyle(this.element);
    const probe = create("span", "");
    this.element.append(probe);
    const curves = Array.from({ length: COLOURS }, (_, number) => {
      probe.className = `ros-series ros-series-${number}`;
      return getComputedStyle(probe).color;
    });
    probe.remove();
    this.#colours = { ink: style.color, line: style.borderTopColor, curves };
  }

  #resize() {
    const { clientWidth: width, clientHeight: height } = this.element;
    if (!width || !height || (width === this.#plot.width && height === this.#plot.height)) return;
    this.#outlines.clear();
    this.#plot.setSize({ width, height });
    this.#redraw();
  }

  /**
   * @param {(view: View) => void} select @param {() => void} reset @param {(time: number | undefined) => void} point
   * @returns {uPlot.Options}
   */
  #options(select, reset, point) {
    const axis = {
      stroke: () => this.#colours.ink || "gray", font: FONT,
      grid: { stroke: () => this.#colours.line || "gray", width: 1 },
      ticks: { stroke: () => this.#colours.line || "gray", width: 1, size: 5 },
    };
    const scale = {
      time: false, auto: false,
      range: (/** @type {uPlot} */ _, /** @type {number} */ min, /** @type {number} */ max) =>
        /** @type {uPlot.Range.MinMax} */ ([min ?? 0, max ?? 1]),
    };
    return {
      width: Math.max(this.element.clientWidth, 300), height: 200,
      legend: { show: false },
      scales: { x: { ...scale }, y: { ...scale } },
      axes: [{ ...axis, size: 30, values: (_, splits) => splits.map((x) => tickText(x) + this.#unit) }, { ...axis, size: fitted, values: (_, splits) => splits.map(tickText) }],
      series: [{}, { scale: "y", auto: false, paths: () => null, points: { show: false } }],
      cursor: {
        y: false, points: { show: false },
        drag: { x: true, y: true, uni: 24, setScale: false },
        bind: { dblclick: () => () => (reset(), null) },
      },
      hooks: {
        draw: [() => this.#paint()],
        setSelect: [(plot) => {
          const { left, top, width, height } = plot.select;
          if (width < 4 || height < 4) return;
          plot.setSelect({ left: 0, top: 0, width: 0, height: 0 }, false);
          select({
            left: plot.posToVal(left, "x"), right: plot.posToVal(left + width, "x"),
            low: plot.posToVal(top + height, "y"), high: plot.posToVal(top, "y"),
          });
        }],
        setCursor: [({ cursor: { left = -1 }, posToVal }) => point(left < 0 ? undefined : posToVal(left, "x"))],
      },
    };
  }
}

/**
 * Draw a curve against the time.
 * @param {CanvasRenderingContext2D} paper @param {Curve} curve @param {Outline} outline @param {Look} look
 */
function paintOutline(paper, curve, { xs, ys, count }, look) {
  prepare(paper, curve, look);
  paper.beginPath();
  let joined = false;
  const dots = new Path2D();
  for (let index = 0; index < count; index++) {
    const y = (look.high - /** @type {number} */ (ys[index])) * look.scaleY;
    const x = (/** @type {number} */ (xs[index]) - look.left) * look.scaleX;
    const there = !Number.isNaN(y);
    if (there && joined) paper.lineTo(x, y);
    else if (there) paper.moveTo(x, y);
    // A sample between two gaps is a point.
    const alone = there && !joined && !(index + 1 < count && !Number.isNaN(ys[index + 1] ?? NaN));
    if (there && (look.points || alone)) dot(dots, x, y, look);
    joined = there;
  }
  paper.stroke();
  paper.fill(dots);
}

/**
 * What the axes show: what is wanted, or else what they showed before, if that is nearly the same.
 * @param {View} wanted @param {View | undefined} before @returns {View}
 */
function steady(wanted, before) {
  if (!before) return wanted;
  const across = (wanted.right - wanted.left) * SLACK;
  const along = (wanted.high - wanted.low) * SLACK;
  const stays = Math.abs(wanted.left - before.left) <= across && Math.abs(wanted.right - before.right) <= across &&
    Math.abs(wanted.low - before.low) <= along && Math.abs(wanted.high - before.high) <= along;
  return stays ? before : wanted;
}

/**
 * The ends of an axis: those wanted, or else somewhat more than the values.
 * @param {number} low @param {number} high @param {number} wantedLow NaN if any @param {number} wantedHigh
 * @returns {[number, number]}
 */
function padded(low, high, wantedLow, wantedHigh) {
  if (!(low <= high)) [low, high] = [Number.isFinite(wantedLow) ? wantedLow : 0, Number.isFinite(wantedHigh) ? wantedHigh : 1];
  let margin = (high - low) * MARGIN;
  // A constant lies in the middle; one that differs in its last digits only is a constant.
  if (high - low <= Math.abs(high) * 1e-12) margin = Math.abs(high) * 0.1 || 1;
  if (!Number.isFinite(margin)) margin = 0;
  const from = Number.isNaN(wantedLow) ? low - margin : wantedLow;
  const to = Number.isNaN(wantedHigh) ? high + margin : wantedHigh;
  return to > from ? [from, to] : [from, from + 1];
}

/** @param {number | null} value */
function tickText(value) {
  if (value === null) return "";
  const size = Math.abs(value);
  if (size !== 0 && (size >= 1e6 || size < 1e-4)) return value.toExponential().replace(/(\.\d{1,3})\d*/, "$1");
  return String(Number(value.toPrecision(10))).replace("-", "−");
}

/** The width of the axis for its longest number. @param {uPlot} _ @param {string[]} values */
function fitted(_, values) {
  const longest = Math.max(0, ...(values ?? []).map((text) => text.length));
  // In steps, so that the chart does not become wider and narrower all the time.
  return 18 + 7 * Math.max(Math.ceil(longest / 2) * 2, 4);
}
