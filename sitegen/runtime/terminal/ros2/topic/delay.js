// @ts-check
// ros2 topic delay: how old messages are when they arrive, by the time in their header.

import { Codec } from "../../../messages/codec.js";
import { Failure } from "../../shell/shell.js";
import { DIRECT } from "../verb.js";
import { awaitType, follow, QOS, Times, windowOption } from "./measure.js";

/** @import { Verb } from "../verb.js" */

/** @type {Verb} */
export const delay = {
  name: "delay",
  about: "Display delay of topic from timestamp in header",
  args: [
    { name: "topic", help: "Topic name to calculate the delay for", complete: "topic" },
    windowOption("window size, in # of messages, for calculating rate, string to ", 10_000),
    ...DIRECT,
    ...QOS,
  ],
  async run(io, args) {
    const { topic: name } = args;
    const { ros } = io;
    const type = await awaitType(io, name);
    if (!ros.types[type]?.fields.some((field) => field.name === "header" && field.type === "std_msgs/msg/Header")) {
      throw new Failure("msg does not have header");
    }
    const codec = new Codec(ros.types);
    const times = new Times(args.window);
    let begun = false;
    await follow(io, args, [{
      name, type,
      take(bytes, { received }) {
        const { stamp } = codec.read(type, bytes).header;
        // As upstream, which begins with the second message.
        if (begun) times.add(received / 1000 - stamp.sec - stamp.nanosec / 1e9);
        begun = true;
      },
    }], () => {
      const found = times.read();
      if (!found) return "";
      if (!found.fresh) return "no new messages\n";
      const { count, mean, least, most, deviation } = found;
      return `average delay: ${mean.toFixed(3)}\n\tmin: ${least.toFixed(3)}s max: ${most.toFixed(3)}s std dev: ${deviation.toFixed(5)}s window: ${count}\n`;
    });
  },
};
