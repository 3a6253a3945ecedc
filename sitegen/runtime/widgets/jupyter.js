// @ts-check
// JupyterLab in a frame, with the notebooks of the site; their kernels are nodes of the page.

import { place } from "../place.js";
import { create, setText } from "../ui/elements.js";
import { say } from "../ui/words.js";

/** @import { NodeHandle, Ros } from "../protocol.js" */

// On narrower screens (px), JupyterLab has no space for its side bars.
const NARROW = 700;

/**
 * Show JupyterLab, with the notebook `open` if it is given.
 * @param {HTMLElement} element
 * @param {Ros} ros
 * @param {{node: string, open?: string | null, interfaces?: string, resources?: Record<string, string>}} options `node`
 *   is the node that runs cells; panels in outputs need the others
 * @returns {() => void} unmount
 */
export function mount(element, ros, { node, open: first, interfaces, resources }) {
  /** @type {Set<NodeHandle>} */
  const running = new Set();
  const state = create("span", "ros-state");
  state.setAttribute("aria-live", "polite");
  const show = () => setText(state, describe(running));
  const frame = document.createElement("iframe");
  frame.className = "ros-jupyter";
  frame.title = "JupyterLab";
  const around = {
    ...(interfaces && { interfaces: address(interfaces) }),
    ...(resources && { resources: Object.fromEntries(Object.entries(resources).map(([url, one]) => [url, address(one)])) }),
  };
  Object.assign(frame, {
    rosPanels: { ros, around, document },
    rosKernels: {
      run() {
        const kernel = ros.run(node);
        running.add(kernel);
        kernel.addEventListener("state", () => {
          if (kernel.state === "stopped" || kernel.state === "failed") running.delete(kernel);
          show();
        });
        show();
        return kernel;
      },
    },
  });
  // Pages of notebooks link to the lab with the name of one.
  const open = new URLSearchParams(location.search).get("notebook") ?? first;
  const app = open && element.clientWidth < NARROW ? "notebooks" : "lab";
  frame.src = place(`../jupyter/${app}/index.html${open ? `?path=${encodeURIComponent(open)}` : ""}`);
  frame.loading = "lazy";
  const title = create("div", "ros-node", create("span", "ros-title", "JupyterLab"), state);
  element.replaceChildren(create("div", "ros-bar", title), frame);
  show();
  return () => {
    frame.remove();
    for (const kernel of running) kernel.stop();
    element.replaceChildren();
  };
}

/** The address of a file of the page, also for documents in frames. @param {string} file */
function address(file) {
  return new URL(file, document.baseURI).href;
}

/** @param {Set<NodeHandle>} kernels */
function describe(kernels) {
  if (!kernels.size) return "";
  if ([...kernels].some(({ state }) => state === "starting")) return say("Starting Python");
  return kernels.size === 1 ? say("1 kernel") : say("{} kernels", kernels.size);
}
