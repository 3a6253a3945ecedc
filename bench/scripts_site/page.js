// Measures how long a message takes to a callback of a panel, of a script, of roslib, and over a WebSocket.
import { ros } from "sitegen";
import { transportFactory } from "sitegen/rosbridge";
import { Ros, Topic } from "sitegen/roslib";

const TYPE = "std_msgs/msg/UInt8MultiArray";
// What rosbridge puts around a message in CBOR, in bytes.
const AROUND = 60;

/** By what is measured: `begin(size, heard)` resolves with a function that sends one message. */
const ways = {
  async panel(size, heard) {
    // A panel's `ros` subscribes by this same function. A script gets what the publisher offers.
    const page = globalThis[Symbol.for("sitegen.ros")];
    const send = publisher("/panel", size);
    page.subscribe("/panel", TYPE, heard, { reliable: true });
    return heardBy("/panel", send);
  },
  async script(size, heard) {
    const send = publisher("/script", size);
    ros.topic("/script", TYPE).subscribe(heard);
    return heardBy("/script", send);
  },
  async roslib(size, heard) {
    const client = new Ros({ transportFactory });
    await client.connect("page:");
    const topic = new Topic({ ros: client, name: "/roslib", messageType: TYPE, compression: "cbor-raw" });
    const send = publisher("/roslib", size);
    topic.subscribe(heard);
    return heardBy("/roslib", send);
  },
  async socket(size, heard, address) {
    const socket = new WebSocket(address);
    socket.binaryType = "arraybuffer";
    socket.onmessage = heard;
    await new Promise((resolve, reject) => Object.assign(socket, { onopen: resolve, onerror: reject }));
    const bytes = new Uint8Array(size + AROUND);
    return () => socket.send(bytes);
  },
};

const node = ros.node("/bench");

/** Return a function that publishes a message of `size` bytes, from another node of the page. */
function publisher(topic, size) {
  const message = { data: new Uint8Array(size) };
  const out = node.topic(topic, TYPE, { depth: 1 });
  out.advertise();
  return () => out.publish(message);
}

/** Return `send` as soon as a topic has a subscription. */
async function heardBy(topic, send) {
  for await (const _ of ros.events()) {
    if (ros.topics().some(({ name, subscriptions }) => name === topic && subscriptions.length)) break;
  }
  return send;
}

globalThis.prepare = async (way, size, address) => {
  let done = () => {};
  const send = await ways[way](size, () => done(), address);
  return async (rounds) => {
    const times = [];
    for (let i = 0; i < rounds; i++) {
      const heard = new Promise((resolve) => { done = resolve; });
      const begun = performance.now();
      send();
      await heard;
      times.push(performance.now() - begun);
    }
    return times;
  };
};
document.body.dataset.ready = "yes";
