// @ts-check
// The sending side of a client: requests that have no room at their server wait here.

import { KEPT } from "../budgets.js";
import { hasRoom } from "./writer.js";

/** @import { Remote } from "./local.js" */
/** @import { Sample } from "./writer.js" */
/** @typedef {{remote: Remote, records: number, bytes: number, waiting: Sample[]}} Flow to one server */

export class Calls {
  #name;
  #send;
  /** By the gid of the server. @type {Map<number, Flow>} */
  #flows = new Map();
  #kept = { records: 0, bytes: 0 };

  /** @param {string} name of the service @param {(remote: Remote, sample: Sample) => void} send sends a copy of a request */
  constructor(name, send) {
    this.#name = name;
    this.#send = send;
  }

  /**
   * Send a request, or keep a copy until the server has room. Throws an Error if too many wait: the program would fill
   * the memory of the page, and must not lose any.
   * @param {Remote} remote @param {Sample} sample
   */
  request(remote, sample) {
    const flow = this.#flows.get(remote.gid) ?? { remote, records: 0, bytes: 0, waiting: [] };
    this.#flows.set(remote.gid, flow);
    if (flow.waiting.length === 0 && hasRoom(flow)) {
      this.#pass(flow, sample);
      return;
    }
    const { records, bytes } = this.#kept;
    if (records >= KEPT.records || bytes >= KEPT.bytes) {
      throw new Error(`${records} requests wait for ${this.#name}, which takes no more`);
    }
    this.#keep(1, sample.size);
    // The program continues, and may reuse the memory of its message.
    flow.waiting.push({ ...sample, message: sample.message.slice() });
  }

  /**
   * A server has taken requests, and has room for more. Return whether it was asked.
   * @param {number} gid of the server @param {number} records @param {number} bytes
   */
  credit(gid, records, bytes) {
    const flow = this.#flows.get(gid);
    if (!flow) return false;
    flow.records = Math.max(0, flow.records - records);
    flow.bytes = Math.max(0, flow.bytes - bytes);
    for (let sample; hasRoom(flow) && (sample = flow.waiting.shift());) {
      this.#keep(-1, -sample.size);
      this.#pass(flow, sample);
    }
    return true;
  }

  /** A server is gone, and with it the requests that waited for it. @param {number} gid */
  unmatch(gid) {
    for (const { size } of this.#flows.get(gid)?.waiting ?? []) this.#keep(-1, -size);
    this.#flows.delete(gid);
  }

  /** @param {Flow} flow @param {Sample} sample */
  #pass(flow, sample) {
    flow.records += 1;
    flow.bytes += sample.size;
    this.#send(flow.remote, sample);
  }

  /** @param {number} records @param {number} bytes */
  #keep(records, bytes) {
    this.#kept.records += records;
    this.#kept.bytes += bytes;
  }
}
