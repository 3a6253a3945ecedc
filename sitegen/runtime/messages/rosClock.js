// @ts-check
// The time of ROS: that on /clock if it is simulated, else that of the computer.

import { now } from "../protocol.js";
import { timeOfMs } from "./time.js";

/** @import { GraphView, PageNode } from "../protocol.js" */

const CLOCK = "rosgraph_msgs/msg/Clock";

export class RosClock {
  #node;
  /**
   * The time on /clock, 0 before the first message, as in ROS; undefined if that of the computer counts.
   * @type {{sec: number, nanosec: number} | undefined}
   */
  #simulated;
  #unsubscribe = () => {};

  /** @param {Pick<PageNode, "types" | "subscribe">} node that subscribes */
  constructor(node) {
    this.#node = node;
  }

  /** Whether the time on /clock counts. */
  get isSimulated() {
    return !!this.#simulated;
  }

  set isSimulated(wanted) {
    if (wanted === this.isSimulated) return;
    this.#unsubscribe();
    this.#simulated = wanted ? { sec: 0, nanosec: 0 } : undefined;
    this.#unsubscribe = wanted ? this.#node.subscribe("/clock", CLOCK, ({ clock }) => {
      this.#simulated = clock;
      this.changed();
    }, { depth: 1 }) : () => {};
    this.changed();
  }

  /** Called after each message on /clock that it uses, and when it begins or ends to use them. */
  changed() {}

  /**
   * Use the time on /clock while somebody publishes it, until the returned function is called.
   * @param {GraphView} graph @returns {() => void}
   */
  follow(graph) {
    const look = () => {
      const published = graph.endpoints().some(({ kind, name }) => kind === "publisher" && name === "/clock");
      this.isSimulated = published && CLOCK in this.#node.types;
    };
    look();
    // Passive: a program that waits for nothing else is done.
    graph.addEventListener("change", look, { passive: true });
    return () => {
      graph.removeEventListener("change", look);
      this.isSimulated = false;
    };
  }

  /** The time now, as builtin_interfaces/msg/Time. */
  now() {
    return this.#simulated ?? timeOfMs(now());
  }
}
