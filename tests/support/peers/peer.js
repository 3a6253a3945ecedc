// A worker with a participant and no program: it does what the test says, and checks what it hears.
//
// A message is a list of uint32 that begins and ends with its number. What is wrong with what arrives is
// kept in `faults`; what may be missing depends on both sides, so the test looks at what was heard.

import { Participant } from "./runtime/participant/participant.js";
import { DEFAULT_QOS, gidOf } from "./runtime/protocol.js";

/** @type {Participant} */
let participant;
// The worker's id in the page.
let self = 0;
/** By id: how much was published, what waits because there was no room, and how much was published as each
 * reader matched. */
const publishers = new Map();
/** By id: what was heard from each writer: the first and the last number, and how many. */
const subscriptions = new Map();
const faults = [];
// How many messages are taken at each look; fewer make a slow reader.
let appetite = Infinity;

const COMMANDS = {
  start({ id }) {
    self = id;
    participant = new Participant(id, (message) => postMessage(message));
    live();
  },
  create({ kind, topic, qos }) {
    const full = { ...DEFAULT_QOS, ...qos };
    const id = participant.create(kind, `/peer_${kind}`, topic, "test/msg/Numbers", full);
    if (kind === "publisher") {
      const began = new Map([...subscriptions.keys()].map((reader) => [gidOf(self, reader), 0]));
      publishers.set(id, { number: 0, waiting: [], began });
    } else if (kind === "subscription") {
      for (const { began, number } of publishers.values()) began.set(gidOf(self, id), number);
      subscriptions.set(id, { writers: new Map(), count: 0 });
    }
    return id;
  },
  destroy({ id }) {
    participant.destroy(id);
    publishers.delete(id);
    subscriptions.delete(id);
  },
  destroyAll() {
    for (const id of [...publishers.keys(), ...subscriptions.keys()]) COMMANDS.destroy({ id });
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
  /** All that there is to know of this worker's endpoints. */
  tell: () => ({
    faults,
    publishers: new Map([...publishers].map(([id, { number, waiting, began }]) =>
      [id, { number, waiting: waiting.length, began, matched: participant.matched(id) }])),
    subscriptions: new Map([...subscriptions].map(([id, { writers }]) =>
      [id, { writers, matched: participant.matched(id) }])),
  }),
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
    if (data.op === "match") {
      const publisher = publishers.get(data.local);
      publisher?.began.set(gidOf(data.peer, data.remote), publisher.number);
    }
    participant.receive(data);
  }
};

/** As a program does: look at what there is, then wait. */
async function live() {
  for (;;) {
    for (const [id, publisher] of publishers) send(id, publisher);
    for (const [id, subscription] of subscriptions) hear(id, subscription);
    // A slow one sleeps on, whatever arrives.
    if (appetite < Infinity) await new Promise((resolve) => setTimeout(resolve, 5));
    await participant.wait(appetite < Infinity ? 0 : -1);
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
  message[message.length - 1] = publisher.number + 1;
  if (!participant.publish(id, new Uint8Array(message.buffer))) return false;
  publisher.number += 1;
  return true;
}

function hear(id, subscription) {
  const { writers } = subscription;
  for (let n = 0; n < appetite; n++) {
    const sample = participant.take(id);
    if (!sample) return;
    const { writer, sequence, message } = sample;
    const view = new DataView(message.buffer, message.byteOffset, message.length);
    const number = view.getUint32(0, true);
    const known = writers.get(writer) ?? { first: number, last: 0, count: 0 };
    if (number !== sequence) faults.push(`${id}: message ${sequence} of ${writer} is ${number}`);
    if (view.getUint32(message.length - 4, true) !== number) faults.push(`${id}: ${number} of ${writer} is torn`);
    if (number <= known.last) faults.push(`${id}: ${number} of ${writer} after ${known.last}`);
    known.last = number;
    known.count += 1;
    writers.set(writer, known);
    subscription.count += 1;
  }
}
