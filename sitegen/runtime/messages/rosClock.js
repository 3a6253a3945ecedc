// @ts-check
// The time of ROS: that on /clock if it is simulated, else that of the computer.

import { now } from "../protocol.js";
import { timeOfMs } from "./time.js";

/** @import { GraphView, PageNode } from "../protocol.js" */

const CLOCK = "rosgraph_msgs/msg/Clock";

/** Emits `change` after each message on /clock that it uses, and when it begins or ends to use them. */
export class RosClock extends EventTarget {
  #node;
  /**
   * The time on /clock, 0 before the first message, as in ROS; undefined if that of the computer counts.
   * @type {{sec: number, nanosec: number} | undefined}
   */
  #simulated;
  #unsubscribe = () => {};

  /** @param {Pick<PageNode, "types" | "subscribe">} node that subscribes */
  constructor(node) {
    super();
    this.#node = node;
  }

  /** Whether the time on /clock counts. */
  get isSimulated() {
    return this.#simulated !== undefined;
  }

  set isSimulated(wanted) {
    if (wanted === this.isSimulated) return;
    this.#unsubscribe();
    this.#unsubscribe = () => {};
    this.#simulated = wanted ? { sec: 0, nanosec: 0 } : undefined;
    if (wanted) {
      this.#unsubscribe = this.#node.subscribe("/clock", CLOCK, ({ clock }) => {
        this.#simulated = clock;
        this.dispatchEvent(new Event("change"));
      }, { depth: 1 });
    }
    this.dispatchEvent(new Event("change"));
  }

  /**
   * Use the time on /clock while somebody publishes it, until the returned function is called.
   * @param {GraphView} graph @returns {() => void}
   */
  follow(graph) {
    const look = () => {
      const published = graph.topics().some(({ name, publishers }) => name === "/clock" && publishers.length > 0);
      this.isSimulated = published && this.#node.types[CLOCK] !== undefined;
    };
    look();
    graph.addEventListener("change", look);
    return () => {
      graph.removeEventListener("change", look);
      this.isSimulated = false;
    };
  }

  /** The time now in ms. */
  get ms() {
    return this.#simulated ? this.#simulated.sec * 1000 + this.#simulated.nanosec / 1e6 : now();
  }

  /** The time now, as builtin_interfaces/msg/Time. */
  now() {
    return this.#simulated ?? timeOfMs(now());
  }
}
