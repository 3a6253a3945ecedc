// Ask a gateway what Lichtblick asks, with Lichtblick's own client and readers; print what was seen as JSON.
import { parse } from "@lichtblick/rosmsg";
import { MessageReader } from "@foxglove/rosmsg2-serialization";
import { WebSocket } from "ws";

// It is made for browsers.
globalThis.WebSocket = WebSocket;
const { default: roslib } = await import("@lichtblick/roslibjs");

const ros = new roslib.Ros({ url: process.argv[2] });
const asked = (ask) => new Promise(ask);
await new Promise((resolve, reject) => {
  ros.on("connection", resolve);
  ros.on("error", reject);
});

/** It asks again every few seconds: a gateway that has just begun does not know the robot yet. */
async function graph() {
  for (;;) {
    const found = await asked((...done) => ros.getTopicsAndRawTypes(...done));
    if (found.topics.includes("/scan")) return found;
    await new Promise((resolve) => setTimeout(resolve, 100));
  }
}

const { topics, types, typedefs_full_text: texts } = await graph();
const readers = new Map(topics.map((name, index) => [name, new MessageReader(parse(texts[index], { ros2: true }))]));

function message(name) {
  const topic = new roslib.Topic({ ros, name, compression: "cbor-raw" });
  return new Promise((resolve) => topic.subscribe(({ bytes }) => {
    topic.unsubscribe();
    resolve(readers.get(name).readMessage(new Uint8Array(bytes)));
  }));
}

/** Publish until the robot says what it has heard. */
async function told() {
  const topic = new roslib.Topic({ ros, name: "/cmd_vel", messageType: "geometry_msgs/msg/Twist", queue_size: 0 });
  topic.advertise();
  const heard = message("/heard");
  const speed = { linear: { x: 0.5, y: 0, z: 0 }, angular: { x: 0, y: 0, z: 0.25 } };
  const timer = setInterval(() => topic.publish(speed), 100);
  const { data } = await heard;
  clearInterval(timer);
  topic.unadvertise();
  return data;
}

async function called(name, request) {
  const serviceType = await asked((...done) => ros.getServiceType(name, ...done));
  const service = new roslib.Service({ ros, name, serviceType });
  return [serviceType, await asked((...done) => service.callService(request, ...done))];
}

const nodes = await asked((...done) => ros.getNodes(...done));
const details = await Promise.all(nodes.map((node) => asked((resolve, reject) =>
  ros.getNodeDetails(node, (...lists) => resolve([node, lists.map((list) => list.length > 0)]), reject))));
const { ranges } = await message("/scan");
console.log(JSON.stringify({
  isRos2: types.includes("rcl_interfaces/msg/Log"),
  unread: topics.filter((_, index) => !texts[index]),
  scan: [ranges.constructor.name, String([...ranges])],
  map: await message("/map"),
  told: await told(),
  called: await called("/set", { data: true }),
  robot: details.find(([node]) => node === "/robot"),
}));
ros.close();
