// @ts-check
// Who publishes each frame, how often, and when last.

import { Rate } from "../../messages/rate.js";
import { plain } from "./transforms.js";

/** @import { MessageInfo, Ros } from "../../protocol.js" */
/** @typedef {{writer: number, node: string, rate: Rate, received: number}} Source */

// Bounds what nodes publish.
const MOST = 1000;

export class FrameSources {
  #ros;
  /** By frame. @type {Map<string, Source>} */
  #sources = new Map();

  /** @param {Ros} ros */
  constructor(ros) {
    this.#ros = ros;
  }

  /** @param {any} stamped a geometry_msgs/msg/TransformStamped @param {MessageInfo} info */
  add({ child_frame_id: child }, { received, writer }) {
    const frame = plain(child);
    let source = this.#sources.get(frame);
    if (!source) {
      if (this.#sources.size >= MOST) return;
      source = { writer: NaN, node: "", rate: new Rate(), received };
      this.#sources.set(frame, source);
    }
    if (source.writer !== writer) {
      source.writer = writer;
      source.node = this.#ros.graph.endpoints().find(({ gid }) => gid === writer)?.node ?? "";
    }
    source.received = received;
    source.rate.add(received, 0);
  }

  /** @param {string} frame @param {number} now ms @returns {{node: string, hertz: number, age: number} | undefined} */
  about(frame, now) {
    const source = this.#sources.get(frame);
    return source && { node: source.node, hertz: source.rate.read(now).hertz, age: (now - source.received) / 1000 };
  }
}
