// @ts-check
// Messages for clients as a WebSocket would carry them: JSON, PNG, CBOR, in fragments.

import { encode as encodeCbor } from "../vendor/cbor.js";
import { encode as encodePng } from "../vendor/png.js";
import { inFragments } from "./fragments.js";
import { encoded } from "./values.js";

/** @import { Sent } from "./session.js" */

let next = 1;

/** Return the frames of a message: texts, or bytes for CBOR. @param {Sent} sent @returns {(string | ArrayBuffer)[]} */
export function framesOf({ message, compression, fragment }) {
  if (compression === "cbor" || compression === "cbor-raw") {
    const bytes = encodeCbor(message);
    return [/** @type {ArrayBuffer} */ (bytes.buffer.slice(bytes.byteOffset, bytes.byteOffset + bytes.byteLength))];
  }
  const text = JSON.stringify(message);
  const whole = compression === "png" ? JSON.stringify({ op: "png", data: png(text) }) : text;
  return inFragments(whole, fragment, `fragment:${next++}`);
}

/** Return a text as the grey pixels of an image, filled up with spaces, in base64. @param {string} text */
function png(text) {
  const bytes = new TextEncoder().encode(text);
  // One line of pixels would be wider than some decoders allow.
  const width = Math.max(1, Math.ceil(Math.sqrt(bytes.length)));
  const height = Math.max(1, Math.ceil(bytes.length / width));
  const data = new Uint8Array(width * height).fill(32);
  data.set(bytes);
  return encoded(encodePng({ width, height, data, channels: 1, depth: 8 }));
}
