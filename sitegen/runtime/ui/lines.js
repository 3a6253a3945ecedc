// @ts-check
// The output of a node, as in a terminal: the newest line stays in view unless the visitor scrolls up.

import { place } from "../place.js";
import { button, create } from "./elements.js";
import { createRow } from "./logPrefix.js";
import { Tail } from "./tail.js";
import { say } from "./words.js";

/** @import { Line, NodeHandle, NodeState } from "../protocol.js" */

/** @import { LineTools } from "./lineTools.js" */
/** @typedef {{find?: string, folded?: boolean}} ToolState what the visitor looks for, and whether lines are folded */
/** @typedef {Partial<Record<NodeState, string>>} Hints shown in each state while there is no output */

/**
 * Append the last `limit` lines of a node's output to `element`.
 * @param {HTMLElement} element
 * @param {NodeHandle} node
 * @param {number} limit
 * @param {Hints} hints
 * @returns {Lines} `close` removes them
 */
export function showLines(element, node, limit, hints) {
  // The id of a second console of a node ends with ":2", and so does its name with 2.
  const [, number = ""] = element.id.split(":");
  const lines = new Lines(node, limit, hints, `${node.name} ${number}`.trim());
  element.append(...lines.elements);
  return lines;
}

class Lines {
  #label;
  #node;
  #limit;
  #hints;
  #log = create("div", "ros-lines");
  #hint = create("p", "ros-hint");
  #newest = button(`↓ ${say("Newest")}`, "ros-newest", () => {
    this.#tail.jump();
    // The button disappears, so move the keyboard focus to the log.
    this.#log.focus({ preventScroll: true });
  });
  #more = button("", "ros-line-more", () => (this.#tools ? this.#closeTools() : this.#openTools().then((tools) => tools?.focus())));
  /** @type {LineTools | undefined} */
  #tools;
  elements = [this.#log, this.#hint, this.#newest, this.#more];
  #tail = new Tail(this.#log, () => {
    this.#newest.hidden = this.#tail.following;
  });
  #resized = new ResizeObserver(() => this.#tail.follow());
  #listening = new AbortController();
  /** Lines that are not drawn yet. @type {Line[]} */
  #waiting = [];
  #frame = 0;
  /** The node that logged last. */
  #name = "";

  /** @param {NodeHandle} node @param {number} limit @param {Hints} hints @param {string} label */
  constructor(node, limit, hints, label) {
    this.#node = node;
    this.#limit = limit;
    this.#hints = hints;
    this.#label = label;
    this.#log.setAttribute("role", "log");
    this.#log.setAttribute("aria-label", label);
    this.#log.tabIndex = 0;
    this.#newest.hidden = true;
    this.#more.hidden = true;
    this.#more.title = say("Find, copy, save, fold");
    this.#more.setAttribute("aria-label", say("Tools for the lines of {}", label));
    this.#more.setAttribute("aria-expanded", "false");
    this.#listen();
    this.#showHint();
  }

  /** What links carry of the tools. @returns {ToolState} */
  get state() {
    return this.#tools?.state ?? {};
  }

  /** @param {ToolState} state as `state` returned it */
  async restore({ find = "", folded = false }) {
    if (!find && !folded) return;
    const tools = await this.#openTools();
    tools?.find(find);
    tools?.fold(folded);
  }

  close() {
    this.#listening.abort();
    this.#tools?.close();
    this.#resized.disconnect();
    cancelAnimationFrame(this.#frame);
    for (const element of this.elements) element.remove();
  }

  /** Most visitors never need them, so pages load this module when someone does. */
  async #openTools() {
    const { LineTools } = await import(place("ui/lineTools.js"));
    if (this.#tools || this.#listening.signal.aborted) return this.#tools;
    const changed = () => {
      this.#tail.follow();
      this.#showHint();
    };
    this.#tools = /** @type {LineTools} */ (new LineTools({ log: this.#log, name: this.#label, changed },
      () => this.#closeTools()));
    this.#log.before(this.#tools.element);
    this.#more.hidden = false;
    this.#more.setAttribute("aria-expanded", "true");
    return this.#tools;
  }

  #closeTools() {
    this.#tools?.close();
    this.#tools = undefined;
    this.#more.setAttribute("aria-expanded", "false");
    this.#more.hidden = !this.#log.hasChildNodes();
    this.#more.focus({ preventScroll: true });
  }

  #listen() {
    const { signal } = this.#listening;
    this.#node.addEventListener("lines", (event) => {
      this.#add(/** @type {CustomEvent<Line[]>} */ (event).detail);
    }, { signal });
    this.#node.addEventListener("clear", () => this.#clear(), { signal });
    this.#node.addEventListener("state", () => this.#showHint(), { signal });
    this.#resized.observe(this.#log);
  }

  /** @param {Line[]} lines */
  #add(lines) {
    this.#waiting = lines.length < this.#limit ? this.#waiting : [];
    this.#waiting.push(...lines.slice(-this.#limit));
    // Hidden tabs draw no frames: drop lines that would be dropped when drawn.
    if (this.#waiting.length > 2 * this.#limit) this.#waiting = this.#waiting.slice(-this.#limit);
    if (!this.#frame && this.#waiting.length) this.#frame = requestAnimationFrame(() => this.#draw());
  }

  #draw() {
    this.#frame = 0;
    const fresh = document.createDocumentFragment();
    for (const { severity, text } of this.#waiting.slice(-this.#limit)) {
      const { row, name } = createRow(text, this.#name);
      this.#name = name || this.#name;
      row.dataset.severity = severity;
      // Few programs print colours, so pages load this module when one does.
      if (text.includes("\x1b")) import(place("ui/escapes.js")).then(({ colour }) => colour(row));
      fresh.append(row);
    }
    this.#waiting = [];
    const surplus = this.#log.childElementCount + fresh.childElementCount - this.#limit;
    dropOldest(this.#log, surplus, !this.#tail.following);
    this.#log.append(fresh);
    this.#hint.hidden = true;
    this.#more.hidden = false;
    this.#tools?.look();
    this.#tail.follow();
  }

  #clear() {
    this.#waiting = [];
    this.#name = "";
    this.#log.replaceChildren();
    this.#more.hidden = !this.#tools;
    this.#tools?.look();
    this.#tail.following = true;
    this.#newest.hidden = true;
    this.#showHint();
  }

  #showHint() {
    this.#hint.textContent = this.#hints[this.#node.state] ?? "";
    this.#hint.hidden = this.#log.hasChildNodes() || this.#log.hidden;
  }
}

/**
 * Remove the first `count` rows; with `keepView` the rows in view stay where they are.
 * Safari has no scroll anchoring, so the theme turns it off and this function replaces it in all browsers.
 * @param {HTMLElement} log
 * @param {number} count
 * @param {boolean} keepView
 */
function dropOldest(log, count, keepView) {
  if (count <= 0) return;
  if (count >= log.childElementCount) {
    log.replaceChildren();
    return;
  }
  // Measuring costs a layout, which a log that follows its end does not need.
  const fromEnd = keepView ? log.scrollHeight - log.scrollTop : 0;
  const rows = document.createRange();
  rows.setStart(log, 0);
  rows.setEnd(log, count);
  rows.deleteContents();
  if (keepView) log.scrollTop = log.scrollHeight - fromEnd;
}
