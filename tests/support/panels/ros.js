// The ROS of a page, as a widget is given it, that does what a test says: protocol.js has the types.

import { DEFAULT_QOS } from "./runtime/protocol.js";

class FakeGraph extends EventTarget {
  all = [];
  /** By topic: what subscriptions missed, and who does not hear whom. */
  missed = {};
  mismatches = {};
  add(kind, node, name, type, { program = "", ...qos } = {}) {
    const policies = { ...DEFAULT_QOS, ...qos };
    this.all.push({ id: this.all.length + 1, kind, node, name, type, program, missed: 0, qos: policies });
    this.changed();
  }
  remove(node) {
    this.all = this.all.filter((endpoint) => endpoint.node !== node);
    this.changed();
  }
  changed() {
    this.dispatchEvent(new Event("change"));
  }
  endpoints() {
    return this.all;
  }
  nodes() {
    return this.all.filter(({ kind }) => kind === "node").map(({ node }) => node).sort();
  }
  topics() {
    return this.sides("publisher", "subscription", "publishers", "subscriptions").map((topic) => ({
      ...topic,
      missed: this.missed[topic.name] ?? 0,
      mismatches: this.mismatches[topic.name] ?? [],
    }));
  }
  services() {
    return this.sides("service", "client", "servers", "clients");
  }
  sides(one, other, ones, others) {
    const all = this.all.filter(({ kind }) => kind === one || kind === other);
    return [...new Set(all.map(({ name }) => name))].sort().map((name) => {
      const here = all.filter((endpoint) => endpoint.name === name);
      const nodes = (kind) => here.filter((endpoint) => endpoint.kind === kind).map(({ node }) => node);
      return {
        name,
        types: [...new Set(here.map(({ type }) => type))],
        [ones]: nodes(one),
        [others]: nodes(other),
      };
    });
  }
}

class FakeNode extends EventTarget {
  state = "stopped";
  since = Date.now();
  memory = 0;
  needs = [];
  constructor(name, packageName, executable) {
    super();
    this.name = name;
    this.package = packageName;
    this.executable = executable;
  }
  become(state, memory = 0) {
    this.state = state;
    this.since = Date.now();
    this.memory = memory;
    this.dispatchEvent(new Event("state"));
  }
  /** No interpreter answers. */
  check() {}
}

const fields = (text, constants = []) => ({
  fields: text.split(", ").filter(Boolean).map((field) => {
    const [type, name, value] = field.split(" ");
    return value === undefined ? { name, type } : { name, type, default: JSON.parse(value) };
  }),
  constants,
});

const graph = new FakeGraph();
export const ros = {
  graph,
  nodes: new Map(),
  /** @type {Record<string, any>} */
  types: {
    "std_msgs/msg/String": fields("string data"),
    "geometry_msgs/msg/Vector3": fields("float64 x, float64 y, float64 z"),
    "geometry_msgs/msg/Twist": fields("geometry_msgs/msg/Vector3 linear, geometry_msgs/msg/Vector3 angular"),
    "builtin_interfaces/msg/Time": fields("int32 sec, uint32 nanosec"),
    "rcl_interfaces/msg/Log": fields(
      "builtin_interfaces/msg/Time stamp, uint8 level, string name, string msg, string file, string function, uint32 line"),
    "std_srvs/srv/Empty_Request": fields(""),
    "std_srvs/srv/Empty_Response": fields(""),
    "tutorial_interfaces/srv/AddTwoInts_Request": fields("int64 a, int64 b"),
    "tutorial_interfaces/srv/AddTwoInts_Response": fields("int64 sum"),
  },
  /** What is subscribed to now. */
  subscriptions: [],
  /** What was published and what was called. */
  published: [],
  calls: [],
  closed: 0,
  answer: async () => ({}),

  fields,
  addNode(name, packageName, executable) {
    const node = new FakeNode(name, packageName, executable);
    ros.nodes.set(name, node);
    return node;
  },
  /** Let a message come to all that subscribe. */
  emit(topic, message, size = 24, timestamp = performance.timeOrigin + performance.now()) {
    for (const { topic: name, bytes, callback } of [...ros.subscriptions]) {
      const info = { size, sequence: 1, timestamp, received: timestamp, writer: 1 };
      if (name === topic) callback(bytes ? new Uint8Array(size) : message, info);
    }
  },
  /** What a link would keep of the panel, and what it is given from one. */
  kept: () => ({}),
  given: undefined,
  odd: 0,
  keep(element, shape, read, restore) {
    ros.kept = read;
    if (ros.given) restore(ros.given, () => ros.odd++);
  },
  subscribe(topic, type, callback, qos, bytes = false) {
    const entry = { topic, type, callback, qos, bytes };
    ros.subscriptions.push(entry);
    return () => {
      ros.subscriptions.splice(ros.subscriptions.indexOf(entry), 1);
    };
  },
  subscribeBytes(topic, type, callback, qos) {
    return ros.subscribe(topic, type, callback, qos, true);
  },
  advertise(topic, type) {
    return {
      publish: (message) => ros.published.push({ topic, type, message }),
      close: () => ros.closed++,
    };
  },
  call(service, type, request, timeout) {
    ros.calls.push({ service, type, request, timeout });
    return ros.answer(request);
  },
};
