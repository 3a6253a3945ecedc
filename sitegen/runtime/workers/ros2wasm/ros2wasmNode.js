// @ts-check
// The worker of a node that the ROS2WASM project compiled. Its script runs unchanged in another worker, which this one
// represents in the graph.

import { siteFolder } from "../../place.js";
import { startScript } from "../../worker.js";
import { confine } from "../confine.js";
import { Participant } from "../../participant/participant.js";
import { Printer } from "../printer.js";
import { Complaints } from "./complaints.js";
import { Script } from "./script.js";

/** @import { FromWorker, ToWorker } from "../../protocol.js" */

/** @param {FromWorker} message */
const post = (message) => postMessage(message);
const printer = new Printer(post);
/** @type {Participant | undefined} */
let participant;
/** @type {Script | undefined} */
let script;
/** The worker that runs the script. @type {Worker | undefined} */
let worker;

/** @param {MessageEvent<ToWorker>} event */
onmessage = (event) => {
  if (event.data.op === "adopt") {
    run(event.data);
  } else if (event.data.op === "stop") {
    end(0, ""); // scripts do not support signals
  } else {
    participant?.receive(event.data);
    script?.look();
    flushSoon();
  }
};

/** @param {Extract<ToWorker, {op: "adopt"}>} node */
function run({ id, name, program }) {
  const graph = new Participant(id, post);
  participant = graph;
  const complaints = new Complaints((text) => printer.print("warn", `${name}: ${text}`));
  const own = startScript(scriptOf(program.script), name);
  worker = own;
  const answer = (/** @type {{topic: string, message: string}} */ message) => own.postMessage(message);
  script = new Script(graph, name, program, answer, printer, complaints);
  own.onmessage = ({ data }) => {
    script?.receive(data);
    flushSoon();
  };
  own.onerror = (event) => {
    event.preventDefault();
    // What importScripts throws for a script that is missing.
    const lost = !event.message || event.message.includes("NetworkError");
    end(1, lost ? "its script could not be loaded" : event.message);
  };
  post({ op: "running" });
}

/**
 * Return the script of a classic worker that runs a node: its script assigns to undeclared variables. It finds its files
 * as if it was the script of the worker, and other scripts only where the policy of the page allows it.
 * @param {string} address of the node's script
 */
function scriptOf(address) {
  const script = JSON.stringify(address);
  // The address of a blob: has no folder.
  const whole = address.startsWith("blob:") ? "name" : `new URL(name, ${script}).href`;
  return `var Module = { locateFile: (name) => ${whole} };
((load) => {
  (${confine})(${JSON.stringify(siteFolder)});
  self.importScripts = (...names) => load(...names.map((name) => ${whole}));
})(importScripts);
importScripts(${script});`;
}

let flushing = false;

/** Send the lines of one task to the page together. */
function flushSoon() {
  if (flushing) return;
  flushing = true;
  setTimeout(() => {
    flushing = false;
    printer.flush();
  });
}

/** @param {number} code @param {string} error */
function end(code, error) {
  worker?.terminate();
  script = undefined;
  printer.flush();
  post({ op: "exit", code, error });
}
