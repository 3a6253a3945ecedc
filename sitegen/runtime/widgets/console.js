// @ts-check
// What a node prints, as a terminal shows it.

import { say, states } from "../words.js";

/** @import {Line, Ros} from "../protocol.js" */

// A reader this near to the end, in pixels, is taken to read the newest line.
const NEAR = 24;

/**
 * Show the lines of a node; `lines` is how many stay, the oldest leave.
 * @param {HTMLElement} element
 * @param {Ros} ros
 * @param {{node: string, lines?: number}} options
 * @returns {() => void} unmount
 */
export function mount(element, ros, { node: name, lines: limit = 1000 }) {
  const node = ros.nodes.get(name);
  if (!node) throw new Error(`console: no node '${name}' in this page`);

  const bar = create("div", "ros-bar");
  const title = create("div", "ros-node");
  const state = create("span", "ros-state");
  title.append(create("span", "ros-name", name), state);
  bar.append(title);
  const log = create("div", "ros-lines");
  log.setAttribute("role", "log");
  log.setAttribute("aria-label", name);
  log.tabIndex = 0;
  const hint = create("p", "ros-hint");
  const newest = /** @type {HTMLButtonElement} */ (create("button", "ros-newest", `↓ ${say("Newest")}`));
  newest.type = "button";
  newest.hidden = true;
  element.replaceChildren(bar, log, hint, newest);

  const hasButtons = element.parentElement?.querySelector('[data-ros-widget="buttons"]');
  const hints = {
    stopped: hasButtons ? say("Press Start to run {}", name) : say("Not running"),
    starting: say("Starting…"),
    running: say("Running, nothing printed yet"),
    stopping: say("Stopping…"),
    failed: say("Failed"),
  };

  /** @type {Line[]} */
  let waiting = [];
  let frame = 0;
  let following = true;

  const follow = () => {
    log.scrollTop = log.scrollHeight;
  };
  const showState = () => {
    state.dataset.state = node.state;
    state.textContent = states[node.state];
    hint.textContent = hints[node.state];
    hint.hidden = log.hasChildNodes();
  };

  const draw = () => {
    frame = 0;
    const fresh = document.createDocumentFragment();
    for (const line of waiting.slice(-limit)) {
      const row = create("div", "", line.text);
      row.dataset.severity = line.severity;
      fresh.append(row);
    }
    waiting = [];
    dropOldest(log, log.childElementCount + fresh.childElementCount - limit, !following);
    log.append(fresh);
    hint.hidden = true;
    if (following) follow();
  };

  const listening = new AbortController();
  const { signal } = listening;
  node.addEventListener("lines", (event) => {
    const { detail } = /** @type {CustomEvent<Line[]>} */ (event);
    waiting = detail.length < limit ? waiting : [];
    waiting.push(...detail.slice(-limit));
    // No frame comes while the tab is hidden: what would not stay need not wait either.
    if (waiting.length > 2 * limit) waiting = waiting.slice(-limit);
    if (!frame && waiting.length) frame = requestAnimationFrame(draw);
  }, { signal });
  node.addEventListener("clear", () => {
    waiting = [];
    log.replaceChildren();
    following = true;
    newest.hidden = true;
    showState();
  }, { signal });
  node.addEventListener("state", showState, { signal });
  log.addEventListener("scroll", () => {
    following = log.scrollHeight - log.scrollTop - log.clientHeight < NEAR;
    newest.hidden = following;
  }, { signal });
  newest.addEventListener("click", () => {
    follow();
    // The button hides, and the keyboard must not lose its place with it.
    log.focus({ preventScroll: true });
  }, { signal });
  const resized = new ResizeObserver(() => {
    if (following) follow();
  });
  resized.observe(log);
  showState();

  return () => {
    listening.abort();
    resized.disconnect();
    cancelAnimationFrame(frame);
    element.replaceChildren();
  };
}

/**
 * Remove the first `count` rows; with `keepView` what the reader looks at stays where it is.
 * Safari does not anchor scrolling, so the theme turns it off and this does it everywhere.
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
  // Measuring costs a layout, which a console that follows its end does not need.
  const fromEnd = keepView ? log.scrollHeight - log.scrollTop : 0;
  const rows = document.createRange();
  rows.setStart(log, 0);
  rows.setEnd(log, count);
  rows.deleteContents();
  if (keepView) log.scrollTop = log.scrollHeight - fromEnd;
}

/**
 * @param {string} tag
 * @param {string} className
 * @param {string} [text]
 */
function create(tag, className, text = "") {
  const element = document.createElement(tag);
  element.className = className;
  element.textContent = text;
  return element;
}
