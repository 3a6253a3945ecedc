// @ts-check
// The services of the page, and a form to call one.

import { isShown } from "../graphNames.js";
import { create, setText, toggle } from "../ui/elements.js";
import { whileNear } from "../ui/looking.js";
import { Picks } from "../ui/picks.js";
import { say } from "../ui/words.js";
import { Call } from "./services/call.js";

/** @import { Ros } from "../protocol.js" */

const NONE = say("No services now. They appear when nodes start.");
const ALL_HIDDEN = say("Only hidden services now.");

/** @typedef {{name: string, types: string[], servers: string[]}} Service */

/**
 * Show all services, or only those in `show`.
 * @param {HTMLElement} element
 * @param {Ros} ros
 * @param {{show?: string[] | null}} options
 * @returns {() => void} unmount
 */
export function mount(element, ros, { show }) {
  const list = new ServiceList(ros, show ?? null);
  element.replaceChildren(...list.elements);
  const first = show?.[0] ?? "";
  if (first) list.choose(first);
  const read = () => ({
    service: list.chosen === first ? "" : list.chosen, hidden: list.hidden, request: list.call.request.typed(),
  });
  ros.keep(element, { service: "string", hidden: "boolean", request: "object" }, read, (state, odd) => {
    // A link chooses among what the visitor could choose.
    if (state.service && show && !show.includes(state.service)) odd();
    else {
      list.call.request.fill(state.request, odd, state.service ?? first);
      if (state.service) list.choose(state.service);
    }
    if (state.hidden) list.showHidden();
  });
  const unlook = whileNear(element, () => {
    const look = () => list.look();
    look();
    ros.graph.addEventListener("change", look);
    return () => ros.graph.removeEventListener("change", look);
  });
  return () => {
    unlook();
    element.replaceChildren();
  };
}

class ServiceList {
  #ros;
  #show;
  hidden = false;
  chosen = "";
  #picks = new Picks((name) => this.choose(name));
  #all = toggle(say("Show hidden"), (on) => {
    this.hidden = on;
    this.look();
  });
  #hint = create("p", "ros-hint");
  call;
  elements;

  /** @param {Ros} ros @param {string[] | null} show */
  constructor(ros, show) {
    this.#ros = ros;
    this.#show = show;
    this.call = new Call(ros);
    const bar = create("div", "ros-bar", create("span", "ros-title", say("Services")));
    if (!show) bar.append(this.#all);
    const list = create("div", "ros-list", this.#picks.element, this.#hint);
    this.elements = [bar, create("div", "ros-split", list, this.call.element)];
  }

  /** @param {string} name of the service to call */
  choose(name) {
    this.chosen = name;
    this.#picks.choose(name);
    this.look();
  }

  showHidden() {
    this.#all.querySelector("input")?.click();
  }

  /** Follow changes of the graph. */
  look() {
    const known = this.#ros.graph.services();
    const services = listed(known, this.#show, this.hidden);
    this.#picks.update(services.map(({ name, types, servers }) => ({
      name,
      type: types.join(", "),
      about: servers.length ? say("served by {}", servers.join(", ")) : say("no server now"),
      idle: !servers.length,
    })));
    this.#hint.hidden = services.length > 0;
    setText(this.#hint, known.length ? ALL_HIDDEN : NONE);
    const service = known.find(({ name }) => name === this.chosen);
    this.call.show(this.chosen, service?.types[0] ?? "", service?.servers.length ?? 0);
  }
}

/** @param {Service[]} services @param {string[] | null} show @param {boolean} hidden @returns {Service[]} */
function listed(services, show, hidden) {
  if (show) {
    return show.map((name) => services.find((s) => s.name === name) ?? { name, types: [], servers: [] });
  }
  return services.filter(({ name }) => hidden || isShown(name));
}
