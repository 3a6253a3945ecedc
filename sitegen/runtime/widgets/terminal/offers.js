// @ts-check
// The commands in the text of the page (```ros2): each has a button that runs it in the terminal.

import { say } from "../../ui/words.js";

// Written by sitegen/site/prose/fences.py, hidden: a page without a terminal shows the commands alone.
const BUTTONS = "button[data-ros-run]";

/**
 * Show the buttons of the commands.
 * @param {(text: string, by: HTMLElement) => void} run called with a command and its button
 * @returns {() => void} hide them
 */
export function offerCommands(run) {
  const listening = new AbortController();
  const { signal } = listening;
  // Of several terminals, the first one runs the commands.
  const buttons = [...document.querySelectorAll(BUTTONS)].filter((one) => one instanceof HTMLButtonElement && one.hidden);
  for (const one of /** @type {HTMLButtonElement[]} */ (buttons)) {
    one.hidden = false;
    one.setAttribute("aria-label", say("Run {}", one.dataset.rosRun ?? ""));
    one.title = say("Run in the terminal");
    one.addEventListener("click", () => run(one.dataset.rosRun ?? "", one), { signal });
  }
  return () => {
    listening.abort();
    for (const one of buttons) /** @type {HTMLButtonElement} */ (one).hidden = true;
  };
}

/** Select the tabs that contain an element, and scroll to it. @param {HTMLElement} element */
export function bringIntoView(element) {
  for (let part = element.closest(".tabbed-block"); part; part = part.parentElement?.closest(".tabbed-block") ?? null) {
    const set = part.closest(".tabbed-set");
    const index = [...(part.parentElement?.children ?? [])].indexOf(part);
    const tab = set?.querySelectorAll(":scope > input[type=radio]")[index];
    if (tab instanceof HTMLInputElement) tab.checked = true;
  }
  for (let part = element.closest("details"); part; part = part.parentElement?.closest("details") ?? null) part.open = true;
  (element.closest(".ros-panel") ?? element).scrollIntoView({ block: "nearest" });
}
