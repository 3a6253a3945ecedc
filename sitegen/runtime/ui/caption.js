// @ts-check
// The newest line that nodes print, over the view of what they move, because their consoles may be folded or far below.

import { create } from "./elements.js";
import { createRow } from "./logPrefix.js";
import { plain } from "./plain.js";

/** @import { Line, Ros } from "../protocol.js" */

// As long as a line is shown (ms): enough to read it, and not so long that it seems to be true still.
const READ = 8000;

/** Whether a node printed it, and not only an empty line. @param {Line} line */
const isSaid = ({ severity, text }) => severity !== "typed" && text.trim();

/**
 * Show what nodes print over `view`, for as long as it takes to read.
 * @param {HTMLElement} view
 * @param {Ros} ros
 * @param {string[]} names of the nodes
 * @param {AbortSignal} signal ends it
 */
export function showCaption(view, ros, names, signal) {
  const caption = create("p", "ros-caption");
  caption.hidden = true;
  view.append(caption);
  let timer = 0;
  const hide = () => {
    clearTimeout(timer);
    caption.hidden = true;
  };
  for (const name of names) {
    const node = ros.nodes.get(name);
    node?.addEventListener("clear", hide, { signal });
    node?.addEventListener("lines", (event) => {
      const { severity, text } = /** @type {CustomEvent<Line[]>} */ (event).detail.findLast(isSaid) ?? {};
      if (!text) return;
      const { row } = createRow(plain(text), "");
      caption.dataset.severity = severity;
      caption.replaceChildren(...row.childNodes);
      caption.hidden = false;
      clearTimeout(timer);
      timer = setTimeout(hide, READ);
    }, { signal });
  }
  signal.addEventListener("abort", hide);
}
