// @ts-check
// The images of a topic, raw or compressed.

import { isShown } from "../graphNames.js";
import { create, setText } from "../ui/elements.js";
import { download } from "../ui/download.js";
import { fullScreenButton } from "../ui/fullScreen.js";
import { whileNear } from "../ui/looking.js";
import { numberText } from "../ui/numbers.js";
import { tool, Toolbar } from "../ui/toolbar.js";
import { say } from "../ui/words.js";
import { Download } from "../vendor/icons.js";
import { hasRange } from "./image/decode.js";
import { COMPRESSED, ImageSource, RAW } from "./image/source.js";
import { ImageView } from "./image/view.js";

/** @import { Ros, Shared } from "../protocol.js" */
/** @import { Picture } from "./image/source.js" */

/** @typedef {{topic?: string | null, min?: number | null, max?: number | null}} Options */

/**
 * Show the images of `topic`, or of one that the visitor chooses.
 * @param {HTMLElement} element
 * @param {Ros} ros
 * @param {Options} options
 * @returns {() => void} unmount
 */
export function mount(element, ros, options) {
  const panel = new ImagePanel(element, ros, options);
  element.replaceChildren(...panel.elements);
  const shape = /** @type {const} */ ({ topic: "string", min: "string", max: "string" });
  ros.keep(element, shape, () => panel.read(), (state, odd) => panel.restore(state, odd));
  const unlook = whileNear(element, () => panel.begin());
  return () => {
    unlook();
    panel.close();
    element.replaceChildren();
  };
}

class ImagePanel {
  #ros;
  #options;
  #fixed;
  #source;
  #seen = false;
  #shown = false;
  /** What is wrong with the latest image, or "". */
  #fault = "";
  #view = new ImageView();
  #choice = create("select", "");
  #title = create("span", "ros-name");
  #about = create("span", "ros-type");
  #low = create("input", "ros-end");
  #high = create("input", "ros-end");
  #range = create("div", "ros-range-ends");
  #save = tool(say("Save"), Download, () => this.#saveImage(), say("Save the image as PNG"));
  #hint = create("p", "ros-hint");
  #note = create("p", "ros-note");
  elements;

  /** @param {HTMLElement} panel @param {Ros} ros @param {Options} options */
  constructor(panel, ros, options) {
    this.#ros = ros;
    this.#options = options;
    this.#fixed = options.topic ?? "";
    this.#source = this.#createSource(this.#fixed);
    this.#note.setAttribute("role", "status");
    this.#createRange();
    this.#setRange(options.min ?? NaN, options.max ?? NaN);
    const controls = new Toolbar([...this.#view.tools, this.#range, this.#save], [fullScreenButton(panel)]);
    const area = create("div", "ros-picture-area", this.#view.element, this.#hint);
    this.elements = [create("div", "ros-bar", this.#createHeading(), controls.element), area, this.#note];
    this.#look();
  }

  /** Subscribe while the panel is visible. @returns {() => void} end it */
  begin() {
    const look = () => this.#look();
    this.#seen = true;
    look();
    this.#ros.graph.addEventListener("change", look);
    return () => {
      this.#seen = false;
      this.#ros.graph.removeEventListener("change", look);
      this.#source.look(false);
    };
  }

  close() {
    this.#view.close();
  }

  /** Return what a link carries of the panel. */
  read() {
    const { min, max } = this.#options;
    const other = (/** @type {string} */ typed, /** @type {number | null | undefined} */ given) =>
      typed === textOf(given ?? NaN) ? "" : typed;
    return {
      topic: this.#fixed ? "" : this.#source.topic,
      min: other(this.#low.value, min), max: other(this.#high.value, max),
    };
  }

  /** @param {Shared} state as `read` returned it @param {() => void} odd */
  restore({ topic, min, max }, odd) {
    if (topic && this.#fixed) odd();
    else if (topic) this.#choose(topic);
    const ends = [min, max].map((text) => (text ? Number(text) : NaN));
    if ((min && Number.isNaN(ends[0])) || (max && Number.isNaN(ends[1]))) odd();
    this.#setRange(min ? ends[0] ?? NaN : this.#source.range.low, max ? ends[1] ?? NaN : this.#source.range.high);
  }

  #createHeading() {
    if (this.#fixed) {
      this.#title.textContent = this.#fixed;
      return create("div", "ros-node", this.#title, this.#about);
    }
    this.#choice.setAttribute("aria-label", say("topic"));
    this.#choice.addEventListener("change", () => {
      this.#choose(this.#choice.value);
      this.#look();
    });
    return create("div", "ros-node ros-picked", this.#choice, this.#about);
  }

  #createRange() {
    for (const [input, label] of /** @type {const} */ ([
      [this.#low, say("depth that is black")], [this.#high, say("depth that is white")],
    ])) {
      input.setAttribute("aria-label", label);
      input.title = label;
      input.inputMode = "decimal";
      input.addEventListener("change", () => {
        const [low, high] = [this.#low, this.#high].map(({ value }) =>
          (value.trim() ? Number(value.trim().replace(",", ".")) : NaN));
        this.#setRange(low ?? NaN, high ?? NaN);
      });
    }
    this.#range.append(this.#low, " – ", this.#high);
    this.#range.hidden = true;
  }

  /** @param {number} low NaN if automatic @param {number} high */
  #setRange(low, high) {
    this.#low.value = textOf(low);
    this.#high.value = textOf(high);
    this.#source.range = { low, high };
    this.#source.redraw();
  }

  /** @param {string} topic */
  #createSource(topic) {
    return new ImageSource(this.#ros, topic, (picture, fault) => this.#draw(picture, fault));
  }

  /** @param {string} topic */
  #choose(topic) {
    this.#source.look(false);
    const { range } = this.#source;
    this.#source = this.#createSource(topic);
    this.#source.range = range;
    this.#shown = false;
    this.#fault = "";
    this.#view.clear();
    setText(this.#about, "");
  }

  /** Follow changes of the graph. */
  #look() {
    if (!this.#fixed) this.#offer();
    this.#source.look(this.#seen);
    this.#write();
  }

  #offer() {
    const names = this.#ros.graph.topics()
      .filter(({ name, types }) => isShown(name) && types.some((type) => type === RAW || type === COMPRESSED))
      .map(({ name }) => name);
    const { topic } = this.#source;
    if (topic && !names.includes(topic)) names.push(topic);
    if (names.join() !== [...this.#choice.options].map(({ value }) => value).join()) {
      this.#choice.replaceChildren(...names.map((name) => new Option(name)));
    }
    this.#choice.hidden = names.length === 0;
    if (!topic && names[0]) this.#choose(names[0]);
    this.#choice.value = this.#source.topic;
  }

  /** @param {Picture | undefined} picture @param {string} fault */
  #draw(picture, fault) {
    this.#fault = fault;
    if (picture) {
      this.#shown = true;
      this.#view.draw(picture.image);
      const { width, height } = picture.image;
      const size = `${width} × ${height}, ${picture.encoding}`;
      const ends = Number.isNaN(picture.low) ? "" : `, ${numberText(picture.low)} – ${numberText(picture.high)}`;
      setText(this.#about, size + ends);
      this.#range.hidden = !hasRange(picture.encoding);
      this.#low.placeholder = numberText(picture.low);
      this.#high.placeholder = numberText(picture.high);
    }
    this.#write();
  }

  #write() {
    const { topic } = this.#source;
    this.#hint.hidden = this.#shown || Boolean(this.#fault);
    setText(this.#hint, this.#hint.hidden ? "" : this.#source.describeSilence());
    setText(this.#note, this.#fault);
    this.#note.classList.toggle("ros-wrong", Boolean(this.#fault));
    // An image that is followed by wrong ones is no longer true.
    this.#view.element.classList.toggle("ros-stale", Boolean(this.#fault));
    this.#save.disabled = !this.#shown;
    this.#view.element.setAttribute("aria-label", this.#shown
      ? say("Image of {}: {}", topic, this.#about.textContent ?? "") : say("No image of {} yet", topic || say("topic")));
  }

  #saveImage() {
    this.#view.canvas.toBlob((blob) => {
      if (blob) download(blob, "image.png");
    }, "image/png");
  }
}

/** @param {number} value */
function textOf(value) {
  return Number.isNaN(value) ? "" : String(value);
}
