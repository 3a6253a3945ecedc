// @ts-check
// Start the page: read page.json, create the graph and the nodes, mount the widgets, run the nodes.

import { Graph } from "./page/graph.js";
import { isolate } from "./page/isolation.js";
import { NodeProcess } from "./page/nodeProcess.js";
import { Sharing } from "./page/sharing.js";
import { Widgets } from "./page/widgets.js";
import { WorkerGroups } from "./page/workerGroup.js";
import { place } from "./place.js";
import { mount as mountButtons } from "./widgets/buttons.js";
import { mount as mountConsole } from "./widgets/console.js";

/** @import { NodeEntry, PageEntry, WidgetEntry } from "./protocol.js" */

// Read from the navigation, because the theme may have changed the address when the visitor scrolled. Firefox does
// not tell the address of a page that was opened as a file.
const opened = performance.getEntriesByType("navigation")[0]?.name ?? "";
const fragment = opened.includes("#") ? opened.slice(opened.indexOf("#")) : location.hash;
/** Resolves when the page has all its elements; this module may run before that. @type {Promise<void>} */
const parsed = new Promise((resolve) => {
  if (document.readyState === "loading") document.addEventListener("readystatechange", () => resolve(), { once: true });
  else resolve();
});
const link = /** @type {HTMLLinkElement} */ (document.getElementById("ros-page"));
/** @type {PageEntry} */
const page = await (await fetch(link.href)).json();

if (page.isolate) {
  await parsed;
  await isolate(new URL(page.isolate, link.href).href);
}

// Nodes load at the same time as the widgets and run as soon as they can, because consoles show earlier lines, too. On
// a page with panels, which would miss the first messages, they run after the widgets are mounted.
let showTime = () => {};
/** @type {Promise<void>} */
const mounted = new Promise((resolve) => {
  showTime = resolve;
});
const ready = page.types ? mounted : Promise.resolve();

// Restore what ran and what panels showed, if the visitor came by a shared link.
const sharing = new Sharing(page, fragment);

const graph = new Graph();
const groups = new WorkerGroups();
// Most pages show these widgets, so this module imports them statically.
const widgets = new Widgets({ buttons: mountButtons, console: mountConsole });
/** @type {Map<string, NodeProcess>} */
const nodes = new Map();
for (const [name, entry] of Object.entries(page.nodes)) {
  const node = add(name, entry);
  if (sharing.starts(name)) node.start();
}

// Only pages with panels take part in the graph, and load the modules for that.
const client = page.types && new (await import(place("page/pageClient.js"))).PageClient(graph, page.types);

/** The ROS API of the page; see Ros in protocol.js. */
export const ros = {
  nodes,
  graph,
  types: page.types ?? {},
  subscribe: client?.subscribe.bind(client),
  subscribeBytes: client?.subscribeBytes.bind(client),
  advertise: client?.advertise.bind(client),
  call: client?.call.bind(client),
  keep: sharing.keep.bind(sharing),
  link: () => sharing.fragment(nodes.values()),
  unmount: widgets.unmount.bind(widgets),
};

/** For live updates of a page that is being edited; see sitegen/commands/serve/update.js. */
export const editing = {
  add,
  mount: (/** @type {WidgetEntry} */ widget) => widgets.mount(widget, ros),
  /** Use another page.json for shared links. */
  rename: sharing.rename.bind(sharing),
};

await parsed;
sharing.restore();
sharing.ask(nodes);
await Promise.all(page.widgets.map((widget) => widgets.mount(widget, ros)));

showTime();
sharing.tell();

/** Add a node to the page, without starting it. @param {string} name @param {NodeEntry} entry */
function add(name, entry) {
  const node = new NodeProcess(name, entry, link.href, graph, { ready, mounted }, groups);
  nodes.set(name, node);
  return node;
}
