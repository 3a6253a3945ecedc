// @ts-check
// The state of a node in words, with a bar while it loads.

import { create, setText } from "./elements.js";
import { say, states } from "./words.js";

/** @import { NodeHandle } from "../protocol.js" */

export class NodeStateView {
  #node;
  label = create("span", "ros-state");
  /** Shown while Python loads. */
  meter = create("progress", "ros-progress");
  /** What has loaded, in bytes. @type {{loaded: number, total: number} | undefined} */
  #progress;

  /**
   * @param {NodeHandle} node
   * @param {AbortSignal} signal ends it
   */
  constructor(node, signal) {
    this.#node = node;
    this.meter.setAttribute("aria-label", say("Loading Python"));
    node.addEventListener("state", () => {
      this.#progress = undefined;
      this.#show();
    }, { signal });
    node.addEventListener("progress", (event) => {
      const { detail } = /** @type {CustomEvent<{loaded: number, total: number}>} */ (event);
      if (node.state === "starting") this.#progress = detail;
      this.#show();
    }, { signal });
    this.#show();
  }

  #show() {
    const { state } = this.#node;
    this.label.dataset.state = state;
    setText(this.label, this.#describe());
    const { loaded, total } = this.#progress ?? { loaded: 0, total: 0 };
    this.meter.hidden = !total;
    if (loaded < total) this.meter.value = loaded / total;
    else this.meter.removeAttribute("value"); // it starts, which takes an unknown time
  }

  #describe() {
    if (!this.#progress) return states[this.#node.state];
    const { loaded, total } = this.#progress;
    if (loaded >= total) return say("starting Python");
    return say("loading Python: {} of {} MB", megabytes(loaded), megabytes(total));
  }
}

/** @param {number} bytes */
function megabytes(bytes) {
  return (bytes / 1e6).toFixed(1);
}
