// @ts-check
// The worker of a node that the ROS2WASM project compiled: the script runs in a worker of its own, as it
// is, and this one speaks for it in the graph.

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
/** What runs the script. @type {Worker | undefined} */
let worker;

/** @param {MessageEvent<ToWorker>} event */
onmessage = (event) => {
  if (event.data.op === "adopt") {
    run(event.data);
  } else if (event.data.op === "stop") {
    end(0, ""); // scripts know no signals
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
  // As a classic script, which these are: they assign to variables that they do not declare.
  const own = new Worker(program.script, { name });
  worker = own;
  const answer = (/** @type {{topic: string, message: string}} */ message) => own.postMessage(message);
  script = new Script(graph, name, program, answer, printer, complaints);
  own.onmessage = ({ data }) => {
    script?.receive(data);
    flushSoon();
  };
  own.onerror = (event) => {
    event.preventDefault();
    end(1, event.message || "its script could not be loaded");
  };
  post({ op: "running" });
}

let flushing = false;

/** Lines that come together go to the page together. */
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
