// @ts-check
// Publish the time of a bag on /clock, for nodes with use_sim_time.

import { DEFAULT_QOS, now } from "../../protocol.js";

/** @import { Participant } from "../../participant/participant.js" */

// As often as `ros2 bag play --clock` does, in Hz.
const RATE = 40;

export class ClockPublisher {
  #participant;
  #id;
  #last = 0;
  /** In ms. */
  period;

  /** @param {Participant} participant @param {string} node @param {number} [rate] in Hz */
  constructor(participant, node, rate = RATE) {
    this.period = Math.max(1, 1000 / rate);
    this.#participant = participant;
    this.#id = participant.create("publisher", node, "/clock", "rosgraph_msgs/msg/Clock", { ...DEFAULT_QOS, depth: 1 });
  }

  /** Publish a time if it is time for that. @param {bigint} time in ns */
  tick(time) {
    if (now() - this.#last >= this.period) this.publish(time);
  }

  /** @param {bigint} time in ns */
  publish(time) {
    this.#last = now();
    const message = new DataView(new ArrayBuffer(12));
    message.setUint8(1, 1); // little endian
    message.setInt32(4, Number(time / 1_000_000_000n), true);
    message.setUint32(8, Number(time % 1_000_000_000n), true);
    this.#participant.publish(this.#id, new Uint8Array(message.buffer));
  }
}
