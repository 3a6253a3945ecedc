// @ts-check
// The protocol of interactive markers: all of them by a service, then changes by a topic, in order and without a gap.

/** @import { Ros } from "../../../protocol.js" */

const SERVICE = "visualization_msgs/srv/GetInteractiveMarkers";
const UPDATE = 1;
// Updates that wait for the answer of the service.
const MOST_WAITING = 200;

/**
 * @typedef {{reset(markers: any[]): void, update(update: any): void, lost(): void, say(text: string): void}} Listener
 *   `lost` is called when the server has gone
 */

export class MarkerClient {
  #ros;
  #namespace;
  #listener;
  #seen = false;
  /** The number of the last update, or undefined before the markers are known. @type {bigint | undefined} */
  #last;
  #asking = false;
  /** @type {any[]} */
  #waiting = [];
  #look = () => this.#ask();

  /** @param {Ros} ros @param {() => string} namespace @param {Listener} listener */
  constructor(ros, namespace, listener) {
    this.#ros = ros;
    this.#namespace = namespace;
    this.#listener = listener;
  }

  /** Whether the markers of the server are known. */
  get known() {
    return this.#last !== undefined;
  }

  /** Ask for all markers, now or when there is a server. */
  begin() {
    this.#seen = true;
    this.#last = undefined;
    this.#ros.graph.addEventListener("change", this.#look);
    this.#ask();
  }

  end() {
    this.#seen = false;
    this.#waiting = [];
    this.#ros.graph.removeEventListener("change", this.#look);
  }

  close() {
    this.end();
  }

  /** Take an update. @param {any} update */
  take(update) {
    if (update.type !== UPDATE) return;
    if (this.#last === undefined) {
      this.#waiting.push(update);
      if (this.#waiting.length > MOST_WAITING) this.#waiting.shift();
      this.#ask();
      return;
    }
    if (update.seq_num <= this.#last) return;
    if (update.seq_num > this.#last + 1n) {
      // Something was missed.
      this.#last = undefined;
      this.#waiting = [update];
      this.#ask();
      return;
    }
    this.#last = update.seq_num;
    this.#listener.update(update);
  }

  async #ask() {
    const service = `${this.#namespace()}/get_interactive_markers`;
    const served = this.#ros.graph.services().some(({ name, servers }) => name === service && servers.length > 0);
    if (!served && this.#last !== undefined) {
      this.#last = undefined;
      this.#listener.lost();
    }
    if (!this.#seen || !served || this.#asking || this.#last !== undefined) return;
    if (!this.#ros.types[`${SERVICE}_Request`]) return;
    this.#asking = true;
    try {
      const { sequence_number: last, markers } = await this.#ros.call(service, SERVICE, {});
      if (!this.#seen) return;
      this.#last = last;
      this.#listener.reset(markers);
      for (const update of this.#waiting.splice(0)) this.take(update);
    } catch (error) {
      this.#listener.say(error instanceof Error ? error.message : String(error));
    } finally {
      this.#asking = false;
    }
  }
}
