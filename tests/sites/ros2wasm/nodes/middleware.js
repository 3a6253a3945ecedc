// What the page sees of a program that the ROS2WASM project compiled, written to its protocol, with its
// habits: the one place for each topic's message, the wrong topic when it takes something back, and the
// commas that it makes line ends of. Programs load it with importScripts.

const PAUSE = 10;
const PARAMETER_SERVICES = [
  "get_parameters", "get_parameter_types", "set_parameters", "set_parameters_atomically",
  "describe_parameters", "list_parameters",
];
/** The message of each topic, and whether the program has read it. */
const places = new Map();

onmessage = (event) => {
  const text = event.data.message.replaceAll(", ", "\n");
  places.set(event.data.topic, { text, read: false });
};

function pause(milliseconds) {
  return new Promise((resolve) => setTimeout(resolve, milliseconds));
}

function register(name, role) {
  newest = name; // not declared, as in theirs: no module could do this
  const gid = Math.random().toString(16).slice(2);
  postMessage({ command: "register", topic: name, role, gid });
  return { gid, role };
}

function deregister({ gid, role }) {
  postMessage({ command: "deregister", topic: newest, role, gid });
}

function publish(topic, message) {
  postMessage({ command: "publish", topic, message });
}

/** The next message of a topic; nothing, after a pause, when there is none. */
async function retrieve(topic) {
  const place = places.get(topic);
  if (place && !place.read) {
    place.read = true;
    return place.text;
  }
  postMessage({ command: "retrieve", topic });
  await pause(PAUSE);
  return "";
}

/** A service is a participant itself, and has a publisher and a subscriber. */
function registerService(name, role) {
  const [out, into] = role === "service_server" ? ["/response", "/request"] : ["/request", "/response"];
  return [
    register(name, role),
    register(out + name, "publisher"),
    register(into + name, "subscriber"),
  ];
}

/** What each node has for its log and its parameters. */
function registerNode(name) {
  return [
    register("/rosout", "publisher"),
    ...PARAMETER_SERVICES.flatMap((service) => registerService(`/${name}/${service}`, "service_server")),
    register("/parameter_events", "publisher"),
  ];
}

const COLORS = { DEBUG: "32", INFO: "0", WARN: "33", ERROR: "31", FATAL: "31" };

/** A line of the log: to the terminal, which the page shows, and to the topic of the log. */
function log(severity, node, text) {
  const time = (Date.now() / 1000).toFixed(9);
  const line = `[${severity}] [${time}] [${node}]: ${text}`;
  postMessage({ command: "console", role: "talker", message: `\x1b[${COLORS[severity]}m${line}\x1b[0m` });
  publish("/rosout", `level: 20\nname: ${node}\nmsg: ${JSON.stringify(text)}`);
}

/** The fields of a message that has nothing else than plain fields. */
function fields(yaml) {
  const pairs = yaml.split("\n").map((line) => /^(\w+): (.*)$/.exec(line).slice(1));
  return Object.fromEntries(pairs.map(([key, value]) => [key, value.startsWith('"') ? JSON.parse(value) : value]));
}
