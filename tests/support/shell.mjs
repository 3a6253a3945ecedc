// Run lines in the shell of terminals, in Node: reads {types, lines} as JSON and prints what each line shows and its
// status. The graph, the participants and the commands are those of a page. Of nodes, there is /talker: publishers of
// /chatter and /points, and services, as JavaScript.

import { setMaxListeners } from "node:events";
import { readFileSync } from "node:fs";
import { PageClient } from "../../sitegen/runtime/page/pageClient.js";
import { Graph } from "../../sitegen/runtime/page/graph.js";
import { ROS2 } from "../../sitegen/runtime/terminal/ros2/ros2.js";
import { BUILTINS } from "../../sitegen/runtime/terminal/shell/builtins.js";
import { FILTERS } from "../../sitegen/runtime/terminal/shell/filters.js";
import { Shell } from "../../sitegen/runtime/terminal/shell/shell.js";

const { types, hashes, texts, lines, longest = 10_000, columns = 80 } = JSON.parse(readFileSync(0, "utf8"));
const graph = new Graph();
// Jobs in the background wait for it, as many as lines start.
setMaxListeners(0, graph);
const page = new PageClient(graph, types);
const ros = { nodes: new Map(), graph, types };
for (const name of ["subscribe", "subscribeBytes", "advertise", "call", "serve", "node"]) ros[name] = page[name].bind(page);

// Which Node has from version 21 on.
globalThis.navigator ??= { userAgent: "Node" };
let shown = "";
const screen = {
  columns: () => columns,
  write: async (text) => {
    shown += text;
  },
  rows: () => 24,
  clear() {},
  eraseLine() {},
  keys: () => () => {},
};
const bags = { names: async () => [], recordings: async () => [], find: async () => undefined, file: async () => undefined, remove: async () => false };
const interfaces = { hashes: async () => hashes, load: async () => {}, text: async (name) => texts[name] };
const shell = new Shell(ros, screen, new Map([ROS2, ...BUILTINS, ...FILTERS].map((one) => [one.name, one])), new Map(), bags, interfaces);

/** A node with two topics and services. */
function talk() {
  const talker = page.node("/talker");
  const chatter = talker.advertise("/chatter", "std_msgs/msg/String");
  const points = talker.advertise("/points", "geometry_msgs/msg/PointStamped", { transientLocal: true, depth: 1 });
  talker.subscribe("/said", "std_msgs/msg/String", () => {});
  talker.serve("/mute", "std_srvs/srv/SetBool", ({ data }) => ({ success: data, message: data ? "muted" : "it's on" }));
  talker.serve("/talker/get_state", "lifecycle_msgs/srv/GetState", () => ({ current_state: { id: 2, label: "inactive" } }));
  const transition = { transition: { id: 3, label: "activate" }, start_state: { id: 2, label: "inactive" }, goal_state: { id: 13, label: "activating" } };
  talker.serve("/talker/get_available_transitions", "lifecycle_msgs/srv/GetAvailableTransitions", () => ({ available_transitions: [transition] }));
  talker.serve("/talker/change_state", "lifecycle_msgs/srv/ChangeState", () => ({ success: false }));
  let count = 0;
  return setInterval(() => {
    const now = performance.timeOrigin + performance.now();
    const stamp = { sec: Math.floor(now / 1000), nanosec: Math.floor((now % 1000) * 1e6) };
    // A subscription that is slow has full queues.
    try {
      chatter.publish({ data: `hello ${++count}` });
      points.publish({ header: { stamp, frame_id: "map" }, point: { x: 1.5 } });
    } catch (error) {
      if (!/full/.test(error.message)) throw error;
    }
  }, 100);
}

const timer = talk();
const found = [];
for (const line of lines) {
  shown = "";
  const [text, wait] = Array.isArray(line) ? line : [line, longest];
  // Ctrl-C, after what the line may take.
  const stop = setTimeout(() => shell.interrupt(), wait);
  await shell.run(text);
  clearTimeout(stop);
  found.push([shown, shell.status]);
}
clearInterval(timer);
process.stdout.write(JSON.stringify(found), () => process.exit(0));
