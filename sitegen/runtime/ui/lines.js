// @ts-check
// The lines that a node prints, as a terminal shows them: the newest in sight, unless the reader scrolled up.

import { create } from "./elements.js";
import { say } from "./words.js";

/** @import { Line, NodeHandle, NodeState } from "../protocol.js" */

// A reader this near to the end, in pixels, is taken to read the newest line.
const NEAR = 24;

/**
 * Show what a node prints in `element`, the last `limit` lines; while there is none, the hint for its state.
 * @param {HTMLElement} element
 * @param {NodeHandle} node
 * @param {number} limit
 * @param {Partial<Record<NodeState, string>>} hints
 * @returns {() => void} end it
 */
export function showLines(element, node, limit, hints) {
  const log = create("div", "ros-lines");
  log.setAttribute("role", "log");
  log.setAttribute("aria-label", node.name);
  log.tabIndex = 0;
  const hint = create("p", "ros-hint");
  const newest = create("button", "ros-newest", `↓ ${say("Newest")}`);
  newest.type = "button";
  newest.hidden = true;
  element.append(log, hint, newest);

  /** @type {Line[]} */
  let waiting = [];
  let frame = 0;
  let following = true;

  const follow = () => {
    log.scrollTop = log.scrollHeight;
  };
  const showHint = () => {
    hint.textContent = hints[node.state] ?? "";
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
    showHint();
  }, { signal });
  node.addEventListener("state", showHint, { signal });
  node.addEventListener("progress", (event) => {
    const { loaded, total } = /** @type {CustomEvent<{loaded: number, total: number}>} */ (event).detail;
    const [done, all] = [loaded, total].map((bytes) => (bytes / 1e6).toFixed(1));
    hint.textContent = loaded < total ? say("Loading Python: {} of {} MB", done, all) : say("Starting Python…");
    hint.hidden = false;
    if (following) follow();
  }, { signal });
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
  showHint();

  return () => {
    listening.abort();
    resized.disconnect();
    cancelAnimationFrame(frame);
    for (const part of [log, hint, newest]) part.remove();
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
