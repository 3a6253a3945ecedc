// @ts-check
// Cut a part out of a bag: a bag of its own, with the same topics, schemas and qualities of service.

import { Bag } from "../../bag/bag.js";
import { loadCompressor } from "../../bag/compression.js";
import { BagWriter } from "../../bag/writer.js";
import { readableOf, Target } from "./files.js";

/** @import { Said, ToCutter } from "../../bag/orders.js" */

/**
 * Return the part as a file, and notes for the visitor. Latched messages that a latecomer would have got at its start
 * are its first ones.
 * @param {ToCutter} order
 */
export async function cut({ source, part, left }) {
  /** @type {Said[]} */
  const notes = [];
  const bag = await Bag.open(await readableOf(source), (said) => notes.push(said));
  const target = new Target();
  const writer = new BagWriter((bytes) => target.write(bytes), await loadCompressor().catch(() => undefined));
  const copies = copyChannels(bag, writer, new Set(left));
  const [from, to] = [bag.timeAt(part.from), part.to === undefined ? bag.end : bag.timeAt(part.to)];
  for (const [id, copy] of copies) {
    if (!bag.qos.get(id)?.transientLocal) continue;
    for (const { sequence, publishTime, data } of await bag.latched(id, from)) {
      writer.add(copy, sequence, from, publishTime, data);
    }
  }
  for await (const { channelId, sequence, logTime, publishTime, data } of bag.messages(from, new Set(copies.keys()), to)) {
    writer.add(copies.get(channelId) ?? 0, sequence, logTime, publishTime, data);
  }
  writer.end();
  return { content: target.close(), notes };
}

/**
 * Add the channels of a bag and their schemas to another one, and return the new ids by the old ones.
 * @param {Bag} bag @param {BagWriter} writer @param {Set<number>} left channels that are left out
 */
function copyChannels(bag, writer, left) {
  /** @type {Map<number, number>} */
  const schemas = new Map();
  /** @type {Map<number, number>} */
  const copies = new Map();
  for (const { id, topic, messageEncoding, metadata, schema } of bag.channels()) {
    if (left.has(id)) continue;
    const schemaId = schema ? schemas.get(schema.id) ?? writer.addSchema(schema) : 0;
    if (schema) schemas.set(schema.id, schemaId);
    copies.set(id, writer.addChannel({ schemaId, topic, messageEncoding, metadata }));
  }
  return copies;
}
