// @ts-check
// Start the page: read page.json, create the graph and the nodes, mount the widgets, run the nodes.

import { Graph } from "./page/graph.js";
import { Instances } from "./page/instances.js";
import { noteIsolation } from "./page/isolated.js";
import { NodeProcess } from "./page/nodeProcess.js";
import { runScripts } from "./page/script.js";
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
  const { isolate } = await import(place("page/isolation.js"));
  await parsed;
  noteIsolation(await isolate(new URL(page.isolate, link.href).href));
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

// Only pages with panels or a script take part in the graph, and load the modules for that. A script may use all
// interfaces; those of nodes come with page.json.
const [interfaces, panels] = await Promise.all([
  page.interfaces && read(page.interfaces), page.types && import(place("page/pageClient.js")),
]);
if (interfaces) page.types = { ...interfaces, ...page.types };
const client = panels && new panels.PageClient(graph, page.types);
if (panels) widgets.mounted = panels.addFullScreen;

const instances = new Instances(nodes, graph, (name, entry) => add(name, entry));

/** The ROS API of the page; see Ros in protocol.js. */
export const ros = {
  nodes,
  graph,
  types: page.types ?? {},
  launch: page.launch,
  subscribe: client?.subscribe.bind(client),
  subscribeBytes: client?.subscribeBytes.bind(client),
  advertise: client?.advertise.bind(client),
  call: client?.call.bind(client),
  serve: client?.serve.bind(client),
  node: client?.node.bind(client),
  join: client?.join.bind(client),
  keep: sharing.keep.bind(sharing),
  link: () => sharing.fragment([...nodes.values()].filter(({ name }) => !instances.has(name))),
  run: instances.run.bind(instances),
  unmount: widgets.unmount.bind(widgets),
};

// For the modules that an author's scripts import, which are bundles of their own.
Object.assign(globalThis, { [Symbol.for("sitegen.ros")]: ros });

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
await Promise.all([
  ...page.widgets.map((widget) => widgets.mount(widget, ros)),
  ...(page.scripts ? [runScripts(page.scripts, link.href)] : []),
]);
if (page.messagesFrom) (await import(place("rosbridge/rosbridge.js"))).listen(page.messagesFrom);

showTime();
sharing.begin(nodes);
sharing.tell();

/** Return the content of a file in JSON. @param {string} file as page.json names it */
async function read(file) {
  return (await fetch(file.startsWith("sitegen:") ? place(file) : new URL(file, link.href))).json();
}

/** Add a node to the page, without starting it. @param {string} name @param {NodeEntry} entry */
function add(name, entry) {
  const node = new NodeProcess(name, entry, link.href, graph, { ready, mounted }, groups);
  nodes.set(name, node);
  return node;
}
