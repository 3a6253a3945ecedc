// @ts-check
// What a cell printed and showed: text, tracebacks, images, tables, and panels on the graph of the page.

import { place } from "../../place.js";
import { cleanHtml } from "../../ui/cleanHtml.js";
import { create } from "../../ui/elements.js";
import { plain } from "../../ui/plain.js";
import { say } from "../../ui/words.js";

/** @import { Line, Ros } from "../../protocol.js" */
/** @import { Outcome } from "../../ui/kernel.js" */
/** @import { Around } from "./panel.js" */

/**
 * @typedef {{kind: "stdout" | "stderr" | "error", text: string}
 *   | {kind: "value", data: Record<string, string>}} Shown
 */

// As the module jupyros writes a panel: its kind and its options.
const PANEL = "application/vnd.sitegen.panel+json";
// What is shown of an image, by media type.
const IMAGES = ["image/png", "image/jpeg", "image/svg+xml"];
// More lines than this are removed, the oldest first.
const MOST = 1000;

export class Output {
  element = create("div", "ros-output");
  #ros;
  #around;
  /** The functions that unmount panels, by their element. @type {Map<Element, () => void>} */
  #panels = new Map();

  /** @param {Ros} ros @param {() => Around} around what panels need besides */
  constructor(ros, around) {
    this.#ros = ros;
    this.#around = around;
    this.element.setAttribute("role", "log");
    this.element.setAttribute("aria-label", say("Output"));
    this.element.tabIndex = 0;
    this.#show();
  }

  clear() {
    for (const unmount of this.#panels.values()) unmount();
    this.#panels.clear();
    this.element.replaceChildren();
    this.#show();
  }

  /** @param {Line[]} lines */
  lines(lines) {
    for (const { severity, text } of lines) {
      const wrong = severity === "fatal" ? "error" : severity === "stdout" || severity === "info" ? "stdout" : "stderr";
      this.add({ kind: wrong, text });
    }
  }

  /** @param {Record<string, string>} data */
  show(data) {
    this.add({ kind: "value", data });
  }

  /** @param {Outcome} outcome */
  end({ traceback = [] }) {
    for (const text of traceback) this.add({ kind: "error", text });
  }

  /** @param {Shown} shown */
  add(shown) {
    const line = shown.kind === "value" ? this.#value(shown.data) : create("pre", "", plain(shown.text));
    line.classList.add(`ros-${shown.kind}`);
    this.element.append(line);
    while (this.element.childElementCount > MOST) this.#remove(this.element.firstElementChild);
    this.#show();
  }

  #show() {
    this.element.hidden = !this.element.childElementCount;
  }

  /** @param {Element | null} line */
  #remove(line) {
    if (!line) return;
    this.#panels.get(line)?.();
    this.#panels.delete(line);
    line.remove();
  }

  /** @param {Record<string, string>} data by media type */
  #value(data) {
    if (data[PANEL]) return this.#panel(data[PANEL], data["text/plain"] ?? "");
    const kind = IMAGES.find((one) => data[one]);
    if (kind) {
      const image = create("img", "");
      image.src = `data:${kind};base64,${data[kind]}`;
      image.alt = data["text/plain"] ?? "";
      return image;
    }
    const html = data["text/html"];
    if (!html) return create("pre", "", data["text/plain"] ?? "");
    const element = create("div", "ros-html prose");
    element.append(cleanHtml(html));
    return element;
  }

  /** Show a panel of the page. @param {string} described as JSON @param {string} text shown until it is mounted */
  #panel(described, text) {
    const element = create("div", "ros-output-panel");
    element.textContent = text;
    this.#mount(element, described).catch((error) => {
      element.textContent = `${text}\n${error instanceof Error ? error.message : error}`;
    });
    return element;
  }

  /** @param {HTMLElement} element @param {string} described */
  async #mount(element, described) {
    /** @type {typeof import("./panel.js")} */
    const { mountPanel } = await import(place("widgets/cell/panel.js"));
    const unmount = await mountPanel(element, this.#ros, described, this.#around());
    // The cell may have been run again meanwhile.
    if (element.isConnected) this.#panels.set(element, unmount);
    else unmount();
  }
}
