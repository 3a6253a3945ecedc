// Print messages as the terminal does, in Node: takes {types, messages: [[type, bytes as hex]]} as JSON, and prints a
// list of texts as JSON.

import { readFileSync } from "node:fs";
import { Codec } from "../../sitegen/runtime/messages/codec.js";
import { repr } from "../../sitegen/runtime/terminal/ros2/python.js";

const { types, messages } = JSON.parse(readFileSync(0, "utf8"));
const codec = new Codec(types);
console.log(JSON.stringify(messages.map(([type, bytes]) =>
  repr(codec.read(type, Uint8Array.from(Buffer.from(bytes, "hex"))), type, types))));
