// @ts-check
// The programs of the page, and the topics and services that their nodes use.

import { isShown } from "../graphNames.js";
import { arrange, create, setText, toggle } from "../ui/elements.js";
import { whileNear } from "../ui/looking.js";
import { say, states } from "../ui/words.js";

/** @import { EndpointKind, NodeHandle, Ros } from "../protocol.js" */

// The time between updates of running times and memory (ms).
const REFRESH = 1000;
/** @type {[EndpointKind, string][]} */
const RELATIONS = [
  ["publisher", say("publishes")],
  ["subscription", say("subscribes to")],
  ["service", say("serves")],
  ["client", say("calls")],
];

/** @typedef {{element: HTMLElement, show(hidden: boolean): void, tell(): void}} Entry */

/**
 * Show the programs of the page.
 * @param {HTMLElement} element
 * @param {Ros} ros
 * @returns {() => void} unmount
 */
export function mount(element, ros) {
  let hidden = false;
  const all = toggle(say("Show hidden"), (on) => {
    hidden = on;
    look();
  });
  const bar = create("div", "ros-bar", create("span", "ros-title", say("Nodes")), all);
  /** @type {Map<NodeHandle, Entry>} */
  const entries = new Map();
  const list = create("ul", "ros-programs");
  // Programs that run once more come and go.
  const gather = () => {
    for (const node of ros.nodes.values()) if (!entries.has(node)) entries.set(node, createEntry(ros, node));
    for (const node of [...entries.keys()]) if (ros.nodes.get(node.name) !== node) entries.delete(node);
    arrange(list, [...entries.values()].map((entry) => entry.element));
  };
  gather();
  const frame = create("div", "ros-list", list);
  // Without a mouse, it is scrolled by keys, and nothing in it takes them.
  frame.tabIndex = 0;
  frame.setAttribute("role", "group");
  frame.setAttribute("aria-label", say("Nodes"));
  element.replaceChildren(bar, frame);

  const look = () => {
    gather();
    for (const entry of entries.values()) entry.show(hidden);
  };
  ros.keep(element, { hidden: "boolean" }, () => ({ hidden }), (state) => {
    if (state.hidden) all.querySelector("input")?.click();
  });
  const unlook = whileNear(element, () => {
    look();
    ros.graph.addEventListener("change", look);
    for (const node of ros.nodes.values()) node.addEventListener("state", look);
    const timer = setInterval(() => {
      for (const entry of entries.values()) entry.tell();
    }, REFRESH);
    return () => {
      ros.graph.removeEventListener("change", look);
      for (const node of ros.nodes.values()) node.removeEventListener("state", look);
      clearInterval(timer);
    };
  });
  return () => {
    unlook();
    element.replaceChildren();
  };
}

/** @param {Ros} ros @param {NodeHandle} node @returns {Entry} */
function createEntry(ros, node) {
  const state = create("span", "ros-state");
  const program = create("small", "ros-program", `${node.package}/${node.executable}`);
  const facts = create("small", "ros-facts");
  const nodes = create("div", "ros-graph-nodes");
  const head = create("div", "ros-head", create("span", "ros-name", node.name), state);
  const element = create("li", "", head, create("div", "ros-about", program, facts), nodes);

  const tell = () => {
    const parts = node.state === "running" ? [say("for {}", duration(Date.now() - node.since))] : [];
    if (node.memory) parts.push(say("{} MB of memory", (node.memory / 1e6).toFixed(1)));
    setText(facts, parts.join(" · "));
    facts.title = say("since {}", new Date(node.since).toLocaleTimeString());
  };
  return {
    element,
    tell,
    show(hidden) {
      state.dataset.state = node.state;
      setText(state, states[node.state]);
      tell();
      const endpoints = ros.graph.endpoints().filter(({ program: name }) => name === node.name);
      const names = [...new Set(endpoints.map((endpoint) => endpoint.node))].sort();
      arrange(nodes, names.map((name) => {
        const relations = RELATIONS.flatMap(([kind, verb]) => {
          const found = endpoints.filter((one) => one.node === name && one.kind === kind);
          const shown = new Set(found.map((one) => one.name).filter((one) => hidden || isShown(one)));
          return shown.size ? [{ verb, names: [...shown].sort() }] : [];
        });
        return describe(nodes, name, relations);
      }));
    },
  };
}

/**
 * Return the element that describes a node of the graph: the present one if nothing has changed.
 * @param {Element} list @param {string} name @param {{verb: string, names: string[]}[]} relations
 */
function describe(list, name, relations) {
  const digest = JSON.stringify([name, relations]);
  const there = [...list.children].find((child) => child instanceof HTMLElement && child.dataset.digest === digest);
  if (there) return there;
  const terms = relations.flatMap(({ verb, names }) => [
    create("dt", "", verb),
    ...names.map((one) => create("dd", "", one)),
  ]);
  const element = create("div", "ros-graph-node", create("p", "", name), create("dl", "", ...terms));
  element.dataset.digest = digest;
  return element;
}

/** @param {number} milliseconds */
function duration(milliseconds) {
  const seconds = Math.max(0, Math.floor(milliseconds / 1000));
  if (seconds < 60) return `${seconds} s`;
  const minutes = Math.floor(seconds / 60);
  return minutes < 60 ? `${minutes} min ${seconds % 60} s` : `${Math.floor(minutes / 60)} h ${minutes % 60} min`;
}
