// Read a bag as the page does, in Node: `readbag.mjs FILE [TYPES]`, where TYPES is a JSON file of the types of a page.
// Prints JSON: how many messages of how many topics there are, what was noted, topics whose messages are not the same
// bytes after they were read and written, and types that the page has with another definition.

import { openAsBlob, readFileSync } from "node:fs";

import { bagModules } from "./bagmodules.mjs";
import { isSame } from "../../sitegen/runtime/bag/definition.js";
import { Codec } from "../../sitegen/runtime/messages/codec.js";

const [file, page] = process.argv.slice(2);
const { Bag, fromBlob } = await bagModules();
const known = page ? JSON.parse(readFileSync(page, "utf8")) : {};

const notes = [];
const bag = await Bag.open(fromBlob(await openAsBlob(file)), (said) => notes.push(said));
const { tracks, types, notes: others } = bag.summary();
const codec = new Codec(types);
const byId = new Map(tracks.map((track) => [track.id, track]));
const changed = new Set();
let count = 0;
let last = 0n;
for await (const { channelId, logTime, data } of bag.messages(bag.start, new Set(byId.keys()))) {
  if (logTime < last) throw new Error("out of order");
  last = logTime;
  count++;
  const { topic, type } = byId.get(channelId);
  if (page && !Buffer.from(codec.write(type, codec.read(type, data))).equals(data)) changed.add(topic);
}
const different = page ? tracks.map(({ type }) => type).filter((type) => known[type] && !isSame(types, known, type)) : [];
console.log(JSON.stringify({
  count, topics: tracks.length, notes: [...notes, ...others], refused: tracks.filter(({ why }) => why).map(({ topic }) => topic),
  changed: [...changed], different, compared: tracks.filter(({ type }) => known[type]).length,
}));
