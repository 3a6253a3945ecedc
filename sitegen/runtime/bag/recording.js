// @ts-check
// A bag that is recorded on this page, by a worker that takes part in the graph.

import { translated } from "./playback.js";

/** @import { Companion, Ros } from "../protocol.js" */
/** @import { FromRecorder, Wanted } from "./orders.js" */

/** Emits `topic` for each topic that it begins to record, `grow` while it records, and `end` when it has ended, by itself or by `stop`. */
export class Recording extends EventTarget {
  #ros;
  /** @type {Companion} */
  #worker;
  #types = 0;
  #follow = () => this.#tellTypes();
  name;
  began = Date.now();
  /** Whether it is in the browser's storage, where it stays. */
  kept = true;
  limit;
  size = 0;
  count = 0;
  topics = 0;
  over = false;
  /** Its content, if it is not in the browser's storage. @type {Blob | undefined} */
  blob;
  /** Why it ended by itself, or "". */
  reason = "";

  /** @param {Ros} ros @param {string} folder of the page's recordings @param {string} name @param {Wanted} wanted */
  constructor(ros, folder, name, wanted) {
    super();
    this.#ros = ros;
    this.name = name;
    this.limit = wanted.limit;
    this.#worker = ros.join("bag/bagNode", (message) => this.#told(message), (error) => this.#end(error));
    const types = { ...ros.types };
    this.#types = Object.keys(types).length;
    this.#worker.tell({ op: "record", folder, name, wanted, types });
    // A bag that is played brings types that the page did not have.
    ros.graph.addEventListener("change", this.#follow);
  }

  /** End it; `end` follows. */
  stop() {
    this.#worker.tell({ op: "end" });
  }

  /** Write what has come so far, because the page may be about to end. */
  flush() {
    this.#worker.tell({ op: "flush" });
  }

  #tellTypes() {
    const types = { ...this.#ros.types };
    if (Object.keys(types).length === this.#types) return;
    this.#types = Object.keys(types).length;
    this.#worker.tell({ op: "types", types });
  }

  /** @param {FromRecorder} message */
  #told(message) {
    if (message.op === "began") {
      this.kept = message.kept;
      this.limit = message.limit;
    } else if (message.op === "subscribed") {
      this.dispatchEvent(new CustomEvent("topic", { detail: message.topic }));
      return;
    } else if (message.op === "failed") {
      this.#end(translated(message.said));
      return;
    } else {
      this.size = message.size;
      this.count = message.count;
      this.topics = message.topics;
    }
    if (message.op === "ended") {
      this.blob = message.blob;
      this.#end(message.reason ? translated(message.reason) : "");
    } else {
      this.dispatchEvent(new Event("grow"));
    }
  }

  /** @param {string} reason */
  #end(reason) {
    if (this.over) return;
    this.over = true;
    this.reason = reason;
    this.#ros.graph.removeEventListener("change", this.#follow);
    this.#worker.leave();
    this.dispatchEvent(new Event("end"));
  }
}
