// @ts-check
// The actions of the page, a form to send goals, and what becomes of them.

import { isHidden } from "../graphNames.js";
import { actionsOf } from "../messages/actionClient.js";
import { create } from "../ui/elements.js";
import { whileNear } from "../ui/looking.js";
import { Picks } from "../ui/picks.js";
import { say } from "../ui/words.js";
import { Sender } from "./actions/sender.js";

/** @import { Ros } from "../protocol.js" */

/**
 * Show all actions, or only those in `show`.
 * @param {HTMLElement} element
 * @param {Ros} ros
 * @param {{show?: string[] | null}} options
 * @returns {() => void} unmount
 */
export function mount(element, ros, { show }) {
  const first = show?.[0] ?? "";
  let chosen = "";
  let seen = false;
  const sender = new Sender(ros);
  const picks = new Picks((name) => choose(name));
  const hint = create("p", "ros-hint", say("No actions now. They appear when nodes start."));
  const list = create("div", "ros-list", picks.element, hint);
  const bar = create("div", "ros-bar", create("span", "ros-title", say("Actions")));
  element.replaceChildren(bar, create("div", "ros-split", list, sender.element));

  const look = () => {
    const known = actionsOf(ros);
    const shown = show?.map((name) => known.find((action) => action.name === name) ?? { name, types: [], servers: [] }) ??
      known.filter(({ name }) => !isHidden(name));
    picks.update(shown.map(({ name, types, servers }) => ({
      name,
      type: types.join(", "),
      about: servers.length ? say("served by {}", servers.join(", ")) : say("no server now"),
      idle: !servers.length,
    })));
    hint.hidden = shown.length > 0;
    const action = known.find(({ name }) => name === chosen);
    sender.show(chosen, action?.types[0] ?? "", action?.servers.length ?? 0, seen);
  };
  const choose = (/** @type {string} */ name) => {
    chosen = name;
    picks.choose(name);
    look();
  };
  choose(first);
  const read = () => ({ action: chosen === first ? "" : chosen, goal: sender.request.typed() });
  ros.keep(element, { action: "string", goal: "object" }, read, (state, odd) => {
    // A link chooses among what the visitor could choose.
    if (state.action && (show ? !show.includes(state.action) : isHidden(state.action))) {
      odd();
      return;
    }
    sender.request.fill(state.goal, odd, state.action ?? first);
    if (state.action) choose(state.action);
  });
  const unlook = whileNear(element, () => {
    seen = true;
    look();
    ros.graph.addEventListener("change", look);
    return () => {
      seen = false;
      ros.graph.removeEventListener("change", look);
      sender.rest();
    };
  });
  return () => {
    unlook();
    sender.close();
    element.replaceChildren();
  };
}
