// The modules that read bags, in Node.

import { createRequire } from "node:module";

export async function bagModules() {
  // LZ4 was compiled for Node, too, and expects a module of its older kind there.
  Object.assign(globalThis, { require: createRequire(import.meta.url), __dirname: import.meta.dirname });
  const { Bag } = await import("../../sitegen/runtime/bag/bag.js");
  const { Fault, saidOf } = await import("../../sitegen/runtime/bag/orders.js");
  const { fromBlob } = await import("../../sitegen/runtime/bag/source.js");
  return { Bag, Fault, saidOf, fromBlob };
}
