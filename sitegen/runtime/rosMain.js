// @ts-check
// The page: read page.json, make the nodes and their graph, mount the widgets, start what starts by
// itself.

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

// The theme may have written there what is being read. Firefox does not tell the address of a file.
const opened = performance.getEntriesByType("navigation")[0]?.name ?? "";
const fragment = opened.includes("#") ? opened.slice(opened.indexOf("#")) : location.hash;
/** Resolves when all elements of the page are there: this file may be sooner. @type {Promise<void>} */
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

// Nodes load while the widgets do. They run at once, and their lines wait for the consoles; but with panels,
// which would miss the first messages, they run when those are there.
let showTime = () => {};
/** @type {Promise<void>} */
const mounted = new Promise((resolve) => {
  showTime = resolve;
});
const ready = page.types ? mounted : Promise.resolve();

// A shared link says what ran and what panels showed.
const sharing = new Sharing(page, fragment);

const graph = new Graph();
const groups = new WorkerGroups();
// Most pages have these, so they come with this file.
const widgets = new Widgets({ buttons: mountButtons, console: mountConsole });
/** @type {Map<string, NodeProcess>} */
const nodes = new Map();
for (const [name, entry] of Object.entries(page.nodes)) {
  const node = add(name, entry);
  if (sharing.starts(name)) node.start();
}

// Only pages with panels take part in the graph themselves; the others do not load what that needs.
const client = page.types && new (await import(place("page/pageClient.js"))).PageClient(graph, page.types);

/** The page's ROS, for widgets and for scripts of the page. */
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

/** For a page that is edited while it is open: see sitegen/commands/serve/update.js. */
export const editing = {
  add,
  mount: (/** @type {WidgetEntry} */ widget) => widgets.mount(widget, ros),
  /** Take another page.json for what links carry. */
  rename: sharing.rename.bind(sharing),
};

await parsed;
sharing.restore();
await Promise.all(page.widgets.map((widget) => widgets.mount(widget, ros)));

showTime();
sharing.tell();

/** Make a node of the page, which does not run yet. @param {string} name @param {NodeEntry} entry */
function add(name, entry) {
  const node = new NodeProcess(name, entry, link.href, graph, { ready, mounted }, groups);
  nodes.set(name, node);
  return node;
}
