// @ts-check
// The worker of Python nodes: load Python and the packages, call the entry points, report the end of each node. A node
// with a worker of its own communicates through it; nodes of a group have a port each.

import { engine } from "../../engine.js";
import { heard } from "../../interrupt.js";
import { siteFolder } from "../../place.js";
import { startWorker } from "../../worker.js";
import { confine } from "../confine.js";
import { Participant } from "../../participant/participant.js";
import { Answers } from "./calls.js";
import { Printer } from "../printer.js";
import { beginReading } from "./contents.js";
import { Python, describe } from "./python.js";
import { pythonHost } from "./pythonHost.js";
import { answersOf } from "./remoteParticipant.js";

/** @import { FromWorker, Interpret, ToWorker, Typed } from "../../protocol.js" */
/** @typedef {{postMessage(message: FromWorker): void, onmessage: ((event: MessageEvent) => any) | null}} Way */

// Without JSPI, Python blocks while it waits, in a worker of its own.
const stacks = engine === "jspi";
const still = stacks ? undefined : startWorker("python/pythonSync", self.name);
confine(siteFolder);
// Load Python while the page is still mounting its widgets.
const python = stacks ? new Python() : undefined;

serve(/** @type {Way} */ (/** @type {unknown} */ (self)));

/** Run the node that `way`, to the page, requests. @param {Way} way */
function serve(way) {
  const post = (/** @type {FromWorker} */ message) => way.postMessage(message);
  const printer = new Printer(post);
  /** @type {Participant | undefined} */
  let participant;
  /** @type {Uint8Array | undefined} */
  let byte;
  /** @type {Typed[]} */
  const typed = [];

  /** @param {MessageEvent<ToWorker>} event */
  way.onmessage = ({ data, ports }) => {
    if (data.op === "join" && ports[0]) {
      serve(ports[0]);
    } else if (data.op === "interpret") {
      participant = new Participant(data.id, post);
      byte = data.byte;
      if (still) watch(still, data, new Answers(answersOf(participant, typed)), post, end);
      else run(data, participant).catch((error) => end(1, describe(error)));
    } else if (data.op === "line" || data.op === "complete" || data.op === "ask" || data.op === "keys") {
      typed.push(data);
      participant?.wake();
    } else if (data.op === "check") {
      // Without stacks, Python is busy in its own worker until the program ends.
      python?.check(data.text).then(post);
    } else {
      participant?.receive(data);
      if (data.op === "stop" && stacks) heard(byte);
    }
  };

  /** @param {Interpret} node @param {Participant} graph */
  async function run(node, graph) {
    await python?.prepare(node, printer, post);
    const host = pythonHost(graph, printer, () => typed.shift(), post, (error) => end(1, describe(error)));
    end(await python?.run(node, Object.assign(host, { file: beginReading })) ?? 1, "");
  }

  /** @param {number} code @param {string} error */
  function end(code, error) {
    printer.flush();
    participant?.finish();
    post({ op: "exit", code, error });
  }
}

/**
 * Run a node in a blocking worker, with its participant here.
 * @param {Worker} worker @param {Interpret} node @param {Answers} answers to its calls
 * @param {(message: FromWorker) => void} post @param {(code: number, error: string) => void} end
 */
function watch(worker, node, answers, post, end) {
  worker.onmessage = ({ data }) => {
    if (data.op === "exit") end(data.code, data.error);
    else if ("op" in data) post(data);
    else answers.take(data).catch((error) => end(1, describe(error)));
  };
  worker.onerror = (event) => {
    event.preventDefault();
    end(1, event.message);
  };
  worker.postMessage(node);
}
