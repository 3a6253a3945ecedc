// @ts-check
// The worker of a program that came as text, such as a cell: a module that imports "sitegen", as scripts of pages do.

import { BUDGETS } from "../../budgets.js";
import { Participant } from "../../participant/participant.js";
import { place, siteFolder } from "../../place.js";
import { confine } from "../confine.js";
import { Printer } from "../printer.js";
import { printed } from "./console.js";
import { OwnNode } from "./ownNode.js";
import { Pending } from "./pending.js";
import { textOf } from "./thrown.js";
import { WorkerGraph } from "./workerGraph.js";

/** @import { Endpoint, FromWorker, MessageType, ModuleImport, Ros, ToWorker } from "../../protocol.js" */

confine(siteFolder);

/** @param {FromWorker} message */
const post = (message) => postMessage(message);
const printer = new Printer(post);
const pending = new Pending((busy) => post({ op: "answer", text: busy ? "busy" : "idle" }));
/** @type {Participant | undefined} */
let participant;
/** @type {WorkerGraph | undefined} */
let graph;

/** @param {MessageEvent<ToWorker>} event */
onmessage = ({ data }) => {
  if (data.op === "evaluate") {
    evaluate(data);
  } else if (data.op === "stop") {
    end(0);
  } else {
    participant?.receive(data);
    if (data.op === "graph") graph?.changed();
  }
};

/** @param {Extract<ToWorker, {op: "evaluate"}>} program */
async function evaluate({ id, name, program: { text, imports, interfaces } }) {
  let address = "";
  const tell = (/** @type {unknown} */ error) => printer.print("fatal", textOf(error, address));
  try {
    address = URL.createObjectURL(new Blob(linked(text, imports), { type: "text/javascript" }));
    const own = new Participant(id, (message) => {
      post(message);
      if (message.op === "create" && receives(message.endpoint)) pending.add(message.endpoint.id);
      else if (message.op === "destroy") pending.delete(message.id);
      if (message.op === "create" || message.op === "destroy") graph?.changed();
    }, false, BUDGETS.frame);
    participant = own;
    graph = new WorkerGraph(own, pending);
    const types = await definitions(place(interfaces));
    while (!own.look()) await own.wait(-1);
    Object.assign(globalThis, { [Symbol.for("sitegen.ros")]: rosOf(`/_${name}`, own, graph, types) });
    printed((severity, line) => printer.print(severity, line));
    pending.watch();
    // What a callback throws ends it, but not the program.
    addEventListener("error", (event) => {
      event.preventDefault();
      tell(event.error ?? event.message);
    });
    addEventListener("unhandledrejection", (event) => {
      event.preventDefault();
      tell(event.reason);
    });
    post({ op: "running" });
    await import(address);
    pending.evaluated();
  } catch (error) {
    tell(error);
    end(1);
  }
}

/**
 * What the module "sitegen" finds.
 * @param {string} name of the program's hidden node @param {Participant} own @param {WorkerGraph} known
 * @param {Record<string, MessageType>} types
 */
function rosOf(name, own, known, types) {
  const node = new OwnNode(own, name, types);
  return /** @type {Partial<Ros>} */ ({
    own: name,
    get nodes() {
      throw new Error("a cell cannot start or stop programs; scripts of the page can");
    },
    graph: known,
    types,
    subscribe: node.subscribe.bind(node),
    subscribeBytes: node.subscribeBytes.bind(node),
    advertise: node.advertise.bind(node),
    call: node.call.bind(node),
    serve: node.serve.bind(node),
    node: (other) => new OwnNode(own, other, types),
  });
}

/** Whether something may come to an endpoint. @param {Endpoint} endpoint */
function receives({ kind }) {
  return kind !== "node" && kind !== "publisher";
}

/**
 * Return the pieces of a module that names the addresses of what it imports.
 * @param {string} text @param {ModuleImport[]} imports
 */
function linked(text, imports) {
  let end = 0;
  const pieces = imports.flatMap(({ from, to, file }) => {
    const before = text.slice(end, from);
    end = to;
    return [before, JSON.stringify(place(file))];
  });
  return [...pieces, text.slice(end)];
}

/** @param {string} address @returns {Promise<Record<string, MessageType>>} */
async function definitions(address) {
  const response = await fetch(address);
  if (!response.ok) throw new Error(`${address} could not be loaded (${response.status})`);
  return response.json();
}

/** @param {number} code */
function end(code) {
  participant?.finish();
  printer.flush();
  post({ op: "exit", code, error: "" });
}
