// @ts-check
// A Python node in a browser without JavaScript Promise Integration. While Python waits, this worker is blocked and
// receives nothing, so its participant is in the worker that started it, pythonNode.js.

import { siteFolder } from "../../place.js";
import { confine } from "../confine.js";
import { Caller } from "./calls.js";
import { Printer } from "../printer.js";
import { Python, describe } from "./python.js";
import { pythonHost } from "./pythonHost.js";
import { remoteParticipant } from "./remoteParticipant.js";

/** @import { FromWorker, Interpret } from "../../protocol.js" */
/** @import { FromCaller } from "./calls.js" */

confine(siteFolder);
const python = new Python();
const post = (/** @type {FromWorker | FromCaller} */ message) => postMessage(message);
const printer = new Printer(post);

self.onmessage = ({ data }) => {
  run(data).then((code) => end(code, ""), (error) => end(1, describe(error)));
};

/** @param {Interpret} node */
async function run(node) {
  await python.prepare(node, printer, post);
  const caller = new Caller(post);
  const participant = remoteParticipant(caller, node.byte);
  const host = pythonHost(participant, printer, () => caller.ask("typed", []), post);
  return python.run(node, Object.assign(host, { file: (/** @type {string} */ address) => caller.ask("file", [address]) }));
}

/** @param {number} code @param {string} error */
function end(code, error) {
  printer.flush();
  post({ op: "exit", code, error });
}
