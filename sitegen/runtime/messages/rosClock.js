// @ts-check
// The time of nodes: that of /clock while somebody publishes it, else that of the computer.

/** @import { Ros } from "../protocol.js" */

const CLOCK = "rosgraph_msgs/msg/Clock";

export class RosClock {
  #ros;
  /** The time on /clock. @type {{sec: number, nanosec: number} | undefined} */
  #simulated;
  /** @type {(() => void) | undefined} */
  #unsubscribe;

  /** @param {Ros} ros */
  constructor(ros) {
    this.#ros = ros;
  }

  /** Follow the time until the returned function is called. @returns {() => void} */
  begin() {
    const { graph, types } = this.#ros;
    const look = () => {
      const published = graph.topics().some(({ name, publishers }) => name === "/clock" && publishers.length > 0);
      if (!published) this.#end();
      else if (!this.#unsubscribe && types[CLOCK]) this.#listen();
    };
    look();
    graph.addEventListener("change", look);
    return () => {
      graph.removeEventListener("change", look);
      this.#end();
    };
  }

  /** As builtin_interfaces/msg/Time. @returns {{sec: number, nanosec: number}} */
  now() {
    if (this.#simulated) return this.#simulated;
    const milliseconds = Date.now();
    return { sec: Math.floor(milliseconds / 1000), nanosec: (milliseconds % 1000) * 1e6 };
  }

  #listen() {
    // As nodes have it before the first message.
    this.#simulated = { sec: 0, nanosec: 0 };
    this.#unsubscribe = this.#ros.subscribe("/clock", CLOCK, ({ clock }) => {
      this.#simulated = clock;
    }, { depth: 1 });
  }

  #end() {
    this.#unsubscribe?.();
    this.#unsubscribe = undefined;
    this.#simulated = undefined;
  }
}
