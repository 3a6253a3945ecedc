// @ts-check
// A button that lets the panel of a widget fill the screen; the window, where browsers have no full screen.

import { Maximize2 } from "../vendor/icons.js";
import { tool } from "./toolbar.js";
import { say } from "./words.js";

const FILLING = "ros-filling";

/** @param {HTMLElement} element of the widget */
export function fullScreenButton(element) {
  const press = tool(say("Full screen"), Maximize2, () => {
    const panel = element.closest(".ros-panel") ?? element;
    if (document.fullscreenElement) document.exitFullscreen();
    else if (panel.classList.contains(FILLING)) panel.classList.remove(FILLING);
    // Safari on iPhones has full screen for videos only.
    else if (panel.requestFullscreen) panel.requestFullscreen().catch(() => panel.classList.add(FILLING));
    else panel.classList.add(FILLING);
  });
  press.classList.add("ros-full");
  return press;
}

/** Let the panel of a widget fill the screen by a button in its bar, unless it has one. @param {HTMLElement} element */
export function addFullScreen(element) {
  // Lines have it among their tools, and the buttons of a notebook have nothing to fill it with.
  const bar = element.querySelector(":scope:not(.ros-prompt, .ros-notebook) > .ros-bar");
  if (!bar || element.closest(".ros-panel")?.querySelector(".ros-full")) return;
  (bar.querySelector(":scope > .ros-controls:not([role])") ?? bar).append(fullScreenButton(element));
}
