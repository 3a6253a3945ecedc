// Read damaged copies of a bag as the page does, in Node: `mutatedbags.mjs FILE HOW SEED COUNT`. Prints what is wrong, a
// line each, and how many copies were read.

import { readFileSync } from "node:fs";

import { bagModules } from "./bagmodules.mjs";

const { Bag, Fault, saidOf, fromBlob } = await bagModules();

const [file, how, seed, count] = process.argv.slice(2);
const original = new Uint8Array(readFileSync(file));
let state = Number(seed);
/** A number from 0 up to `below`: mulberry32. */
function chance(below) {
  state = (state + 0x6d2b79f5) | 0;
  let t = Math.imul(state ^ (state >>> 15), 1 | state);
  t = (t + Math.imul(t ^ (t >>> 7), 61 | t)) ^ t;
  return ((t ^ (t >>> 14)) >>> 0) % below;
}

const whole = await read(original);
const chunks = whole.bag.chunks.map(({ chunkStartOffset, chunkLength }) => [Number(chunkStartOffset), Number(chunkLength)]);
// The messages of each chunk, as a copy without that chunk does not have them.
const inside = await Promise.all(chunks.map(async ([at, length]) => {
  const copy = original.slice();
  copy.fill(0, at, at + length);
  return whole.messages.length - (await read(copy)).messages.length;
}));

/** Make copies: where they are damaged, and which messages they have at least, the first ones or all but some. */
const MAKERS = {
  // Cut off at each byte, or at as many places as were asked for.
  cut(number) {
    const end = Math.round((number * original.length) / Number(count));
    const kept = chunks.filter(([at, length]) => at + length <= end).length;
    return { copy: original.slice(0, end), least: kept === 0 ? 0 : inside.slice(0, kept).reduce((a, b) => a + b, 0), prefix: true };
  },
  // A byte of the content of a chunk.
  chunk() {
    const which = chance(chunks.length);
    const [at, length] = chunks[which];
    const copy = original.slice();
    copy[at + 60 + chance(length - 60)] ^= 1 + chance(255);
    return { copy, least: whole.messages.length - inside[which], prefix: false };
  },
  // Any bytes, of the index, too; parts that are doubled, left out, or zero.
  any() {
    const copy = original.slice();
    const [at, length] = [8 + chance(copy.length - 8), chance(200)];
    const kind = chance(5);
    if (kind === 0) copy.fill(0, at, at + length);
    else if (kind === 1) copy.copyWithin(at, chance(copy.length), at + length);
    else for (let left = 1 + chance(6); left > 0; left--) copy[8 + chance(copy.length - 8)] = chance(256);
    if (kind !== 2) return { copy, least: 0, prefix: false };
    const shorter = new Uint8Array(copy.length - Math.min(length, copy.length - at));
    shorter.set(copy.subarray(0, at));
    shorter.set(copy.subarray(copy.length - (shorter.length - at)), at);
    return { copy: shorter, least: 0, prefix: false };
  },
};

/** Read a bag to its end. */
async function read(bytes) {
  const told = [];
  const bag = await Bag.open(fromBlob(new Blob([bytes])), (said) => told.push(said));
  const summary = bag.summary();
  const channels = new Set(summary.tracks.map(({ id }) => id));
  const messages = [];
  for await (const { channelId, logTime, data } of bag.messages(bag.start, channels)) {
    messages.push({ key: `${channelId} ${logTime} ${data.length}`, logTime });
    if (messages.length > 100_000) throw new Error("there is no end of messages");
  }
  for (const id of channels) await bag.latched(id, bag.end);
  return { bag, messages, told };
}

/** What is wrong with how a copy was read. */
async function check({ copy, least, prefix }) {
  let found;
  try {
    found = await read(copy);
  } catch (error) {
    const { text, values } = saidOf(error);
    const line = values.reduce((all, value) => all.replace("{}", String(value)), text);
    const ours = error instanceof Fault || error.constructor === Error || error instanceof RangeError;
    if (!ours || line.includes("\n") || line.length > 400) return `${error.stack}`;
    return least > 0 ? `nothing was read of ${least} messages: ${line}` : "";
  }
  const { messages } = found;
  if (messages.some(({ logTime }, index) => index > 0 && logTime < messages[index - 1].logTime)) return "out of order";
  if (messages.length < least) return `${messages.length} of at least ${least} messages`;
  if (prefix && messages.some(({ key }, index) => key !== whole.messages[index].key)) return "not the first messages";
  return "";
}

for (let number = 0; number < Number(count); number++) {
  const wrong = await check(MAKERS[how](number));
  if (wrong) console.log(`${how} ${number} (seed ${seed}): ${wrong}`);
}
console.log(`${count} read, of ${whole.messages.length} messages in ${chunks.length} chunks`);
