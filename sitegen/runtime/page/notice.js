// @ts-check
// A notice in the corner of the page, about the link that led there. A page has one at a time.

import { button, create } from "../ui/elements.js";
import { say } from "../ui/words.js";

/**
 * Show a sentence until the visitor or the caller closes it. If there is a notice already, add the sentence to it.
 * @param {string} sentence
 * @param {{label: string, press: () => void}} [action] a button that also closes the notice
 * @returns {() => void} close the notice, unless other sentences are in it
 */
export function notify(sentence, action) {
  const act = action && button(action.label, "ros-act", () => {
    act?.parentElement?.remove();
    action.press();
  });
  const shown = document.querySelector(".ros-word");
  if (shown) {
    shown.firstElementChild?.append(` ${sentence}`);
    if (act) shown.firstElementChild?.after(act);
    return () => {};
  }
  const close = button("", "ros-close", () => notice.remove());
  close.setAttribute("aria-label", say("Close"));
  const notice = create("div", "ros-word", create("span", "", sentence));
  if (act) notice.append(act);
  notice.append(close);
  notice.setAttribute("role", "status");
  document.body.append(notice);
  return () => {
    if (notice.firstElementChild?.textContent === sentence) notice.remove();
  };
}
