// Orders messages from the robot, or sends some, by the gateway or over a bare WebSocket.
import { ros } from "sitegen";

const TYPE = "std_msgs/msg/UInt8MultiArray";
// What gets nothing for so long waits no more (ms).
const QUIET = 2000;

const node = ros.node("/bench");
const go = node.topic("/go", "std_msgs/msg/String");
const out = node.topic("/to_robot", TYPE, { depth: 1000 });
go.advertise();
out.advertise();

/** When messages were sent and received (ms since 1970). @type {[number, number][]} */
let found = [];

const clock = () => performance.timeOrigin + performance.now();

const pause = (ms) => new Promise((resolve) => setTimeout(resolve, ms));

function heard(bytes) {
  const sent = new DataView(bytes.buffer, bytes.byteOffset).getBigUint64(0, true);
  found.push([Number(sent) / 1e6, clock()]);
}

/** By way: how orders are given, and how a message is sent. */
const ways = {
  gateway: { order: (text) => go.publish({ data: text }), send: (data) => out.publish({ data }) },
};

ros.topic("/bytes", TYPE).subscribe(({ data }) => heard(data));

globalThis.openBare = async (address) => {
  const socket = new WebSocket(address);
  socket.binaryType = "arraybuffer";
  socket.onmessage = ({ data }) => heard(new Uint8Array(data));
  await new Promise((resolve, reject) => Object.assign(socket, { onopen: resolve, onerror: reject }));
  ways.bare = { order: (text) => socket.send(text), send: (data) => socket.send(data) };
};

/** Resolve with what was found for an order: size, count and period (s) as text. */
globalThis.receive = async (way, order) => {
  found = [];
  ways[way].order(order);
  const count = Number(order.split(" ")[1]);
  const begun = clock();
  while (found.length < count && clock() - (found.at(-1)?.[1] ?? begun) < QUIET) await pause(20);
  return found;
};

globalThis.send = async (way, order) => {
  const [size, count, period] = order.split(" ").map(Number);
  let due = performance.now();
  for (let i = 0; i < count; i++) {
    const data = new Uint8Array(size);
    new DataView(data.buffer).setBigUint64(0, BigInt(Math.round(clock() * 1e6)), true);
    ways[way].send(data);
    due += period * 1000;
    if (period) await pause(Math.max(0, due - performance.now()));
  }
};

// Both ways through the gateway are there when the robot answers.
while ((await receive("gateway", "16 1 0")).length === 0);
document.body.dataset.ready = "yes";
