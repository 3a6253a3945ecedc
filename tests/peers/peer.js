// A worker with a participant and no program: it does what the test says, and checks what it hears.
//
// A message is a list of uint32: its number, then anything. What is wrong with what arrives is kept in
// `faults`.

import { Participant } from "./runtime/participant/participant.js";
import { DEFAULT_QOS } from "./runtime/protocol.js";

/** @type {Participant} */
let participant;
/** By id: what was published, and what waits because there was no room. */
const publishers = new Map();
/** By id: what was heard from each writer. */
const subscriptions = new Map();
const faults = [];
// How many messages are taken at each look; fewer make a slow reader.
let appetite = Infinity;

const COMMANDS = {
  start({ id }) {
    participant = new Participant(id, (message) => postMessage(message));
    live();
  },
  create({ kind, topic, qos }) {
    const full = { ...DEFAULT_QOS, ...qos };
    const id = participant.create(kind, `/peer_${kind}`, topic, "test/msg/Numbers", full);
    if (kind === "publisher") publishers.set(id, { number: 0, waiting: [] });
    if (kind === "subscription") subscriptions.set(id, { qos: full, writers: new Map(), count: 0 });
    return id;
  },
  destroy({ id }) {
    participant.destroy(id);
    publishers.delete(id);
    subscriptions.delete(id);
  },
  publish({ id, count, size = 4 }) {
    const publisher = publishers.get(id);
    if (!publisher) return;
    for (let n = 0; n < count; n++) publisher.waiting.push(size);
    send(id, publisher);
  },
  /** Publish so many, letting the event loop turn now and then. */
  async flood({ id, size, count }) {
    const publisher = publishers.get(id);
    const end = publisher.number + count;
    while (publisher.number < end) {
      for (let n = 0; n < 100 && publisher.number < end && publishOne(id, publisher, size); n++);
      await participant.wait(0);
    }
    return publisher.number;
  },
  /** Do nothing at all for so long (ms). */
  block({ duration }) {
    const end = performance.now() + duration;
    while (performance.now() < end);
  },
  eat({ count }) {
    appetite = count;
  },
  published: ({ id }) => publishers.get(id).number,
  waiting: () => [...publishers.values()].some((publisher) => publisher.waiting.length > 0),
  matched: ({ id }) => participant.matched(id),
  event: ({ id, kind }) => participant.takeEvent(id, kind),
  heard: ({ id }) => {
    const { count, writers } = subscriptions.get(id);
    return { count, last: [...writers.values()].map(({ last }) => last) };
  },
  faults: () => faults,
};

onmessage = async ({ data }) => {
  if (data.command) {
    const answer = await COMMANDS[data.command](data);
    postMessage({ answer, number: data.number });
    participant.wake();
  } else {
    participant.receive(data);
  }
};

/** As a program does: look at what there is, then wait. */
async function live() {
  for (;;) {
    for (const [id, publisher] of publishers) send(id, publisher);
    for (const [id, subscription] of subscriptions) hear(id, subscription);
    await participant.wait(appetite === Infinity ? -1 : 5);
  }
}

function send(id, publisher) {
  while (publisher.waiting.length > 0 && publishOne(id, publisher, publisher.waiting[0])) {
    publisher.waiting.shift();
  }
}

function publishOne(id, publisher, size) {
  const message = new Uint32Array(Math.max(1, size >> 2));
  message[0] = publisher.number + 1;
  if (!participant.publish(id, new Uint8Array(message.buffer))) return false;
  publisher.number += 1;
  return true;
}

function hear(id, subscription) {
  const { qos, writers } = subscription;
  for (let n = 0; n < appetite; n++) {
    const sample = participant.take(id);
    if (!sample) return;
    const { writer, sequence, message } = sample;
    const number = new DataView(message.buffer, message.byteOffset).getUint32(0, true);
    const known = writers.get(writer) ?? { last: 0 };
    if (number !== sequence) faults.push(`${id}: message ${sequence} of ${writer} is ${number}`);
    if (number <= known.last) faults.push(`${id}: ${number} of ${writer} after ${known.last}`);
    if (known.last > 0 && number > known.last + 1 && qos.keepAll) {
      faults.push(`${id}: ${known.last + 1} to ${number - 1} of ${writer} are missing`);
    }
    known.last = number;
    writers.set(writer, known);
    subscription.count += 1;
  }
}
