// @ts-check
// ros2 daemon: upstream asks it for the graph. A page knows its graph at once, so here it is only a word.

import { flag } from "./verb.js";

/** @import { Group } from "./verb.js" */

// As on a computer where some command has started it.
let running = true;

/** @type {Group} */
export const DAEMON = {
  name: "daemon",
  about: "Various daemon related sub-commands",
  verbs: [
    {
      name: "start",
      about: "Start the daemon if it isn't running",
      args: [flag("debug", ["--debug", "-d"], "Print debug messages")],
      async run({ out }) {
        await out(running ? "The daemon is already running\n" : "The daemon has been started\n");
        running = true;
      },
    },
    {
      name: "status",
      about: "Output the status of the daemon",
      args: [],
      async run({ out }) {
        await out(running ? "The daemon is running\n" : "The daemon is not running\n");
      },
    },
    {
      name: "stop",
      about: "Stop the daemon if it is running",
      args: [],
      async run({ out }) {
        await out(running ? "The daemon has been stopped\n" : "The daemon is not running\n");
        running = false;
      },
    },
  ],
};
