// @ts-check
// Cut a part out of a bag, in a worker of its own, so that what plays is not disturbed.

import { translated } from "./playback.js";

/** @import { Ros } from "../protocol.js" */
/** @import { FromCutter, Part, Source } from "./orders.js" */

/**
 * Return the part as a file, and what the visitor should know of it; rejects with an Error for the visitor.
 * @param {Ros} ros @param {Source} source @param {Part} part @param {number[]} left channels that are left out
 * @returns {Promise<{content: Blob, notes: string[]}>}
 */
export function partOf(ros, source, part, left) {
  return new Promise((resolve, reject) => {
    const told = (/** @type {FromCutter} */ message) => {
      worker.leave();
      if (message.op === "cut") resolve({ content: message.content, notes: message.notes.map(translated) });
      else reject(new Error(translated(message.said)));
    };
    const worker = ros.join("bag/bagNode", told, (error) => reject(new Error(error)));
    worker.tell({ op: "cut", source, part, left });
  });
}
