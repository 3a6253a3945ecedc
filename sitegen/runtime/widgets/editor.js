// @ts-check
// The source of a Python node, to be changed and run. What a reader makes of it stays in the browser, and
// travels in links.

import { button, create, setText } from "../ui/elements.js";
import { codeView } from "../ui/codeView.js";
import { say } from "../ui/words.js";

/** @import { Line, Ros } from "../protocol.js" */

// So long (ms) after the last key it is kept.
const PAUSE = 300;

/**
 * Show a file of a node, installed at `place`, as it is in the workspace: `text`.
 * @param {HTMLElement} element
 * @param {Ros} ros
 * @param {{node: string, file: string, place: string, text: string}} options
 * @returns {() => void} unmount
 */
export function mount(element, ros, { node: name, file, place, text: original }) {
  const node = ros.nodes.get(name);
  if (!node) throw new Error(`editor: no node '${name}' on this page`);

  const store = `sitegen:edit:${location.pathname}:${name}:${place}`;
  const kept = recall(store);
  // One of another version of the source would undo what its author has changed since.
  let text = kept?.of === original ? kept.text : original;
  let given = false;
  ros.keep(element, { text: "string" }, () => ({ text: text === original ? "" : text }), (state) => {
    given = true;
    text = state.text;
  });
  // Code of a link is somebody else's: it runs when its reader says so, and not before.
  if (!given && text !== original) node.edit(place, text);

  const state = create("span", "ros-edited");
  state.setAttribute("role", "status");
  const title = create("div", "ros-node", create("span", "ros-name", file), state);
  const run = button(say("Run"), "ros-start", () => {
    given = false;
    keep();
    node.edit(place, text === original ? undefined : text);
    view.mark(0);
    show();
    node.restart();
  });
  const reset = button(say("Reset"), "ros-clear", () => {
    view.set(original);
    view.focus();
  });
  const controls = create("div", "ros-controls", run, reset);
  controls.setAttribute("role", "group");
  controls.setAttribute("aria-label", file);
  const hint = create("p", "ros-leave", say("Press Esc, then Tab to leave the editor."));
  const code = create("div", "ros-code");
  element.replaceChildren(create("div", "ros-bar", title, controls), code, hint);

  /** @type {ReturnType<typeof setTimeout> | undefined} */
  let timer;
  let error = 0;
  const keep = () => {
    clearTimeout(timer);
    if (!given) remember(store, text === original ? undefined : { of: original, text });
  };
  const show = () => {
    const changed = given ? say("changed by the link: read it before you run it") : say("changed");
    const how = text === original ? say("unchanged") : changed;
    setText(state, error ? say("error in line {}", error) : how);
    state.dataset.changed = String(text !== original || error > 0);
    reset.disabled = text === original;
  };
  const view = codeView(code, text, say("Python source {}", file), (now) => {
    text = now;
    error = 0;
    clearTimeout(timer);
    timer = setTimeout(() => {
      keep();
      show();
    }, PAUSE);
    reset.disabled = text === original;
  });

  const listening = new AbortController();
  const { signal } = listening;
  // The last line of the file in a traceback is where the program was.
  const sign = `File "/ros/${place}", line `;
  node.addEventListener("lines", (event) => {
    const { detail } = /** @type {CustomEvent<Line[]>} */ (event);
    for (const line of detail) {
      const at = line.severity === "stderr" ? line.text.lastIndexOf(sign) : -1;
      if (at >= 0) error = Number.parseInt(line.text.slice(at + sign.length), 10) || 0;
    }
    view.mark(error);
    show();
  }, { signal });
  node.addEventListener("state", () => {
    if (node.state !== "starting") return;
    error = 0;
    view.mark(0);
    show();
  }, { signal });
  addEventListener("pagehide", keep, { signal });
  show();

  return () => {
    keep();
    listening.abort();
    view.destroy();
    element.replaceChildren();
  };
}

/** @param {string} store @returns {{of: string, text: string} | undefined} */
function recall(store) {
  try {
    const { of, text } = JSON.parse(localStorage.getItem(store) ?? "{}");
    return typeof of === "string" && typeof text === "string" ? { of, text } : undefined;
  } catch {
    return undefined; // no storage, or not ours
  }
}

/** @param {string} store @param {{of: string, text: string} | undefined} edit */
function remember(store, edit) {
  try {
    if (edit) localStorage.setItem(store, JSON.stringify(edit));
    else localStorage.removeItem(store);
  } catch {
    // A browser that keeps nothing: the text stays as long as the page.
  }
}
