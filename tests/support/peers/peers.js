// A graph of workers that do what the test says, for scenes that need real ones.

import { Graph } from "./runtime/page/graph.js";

export const graph = new Graph();
export const complaints = [];
let asked = 0;

/** Start a worker. `ask` has it do a command of peer.js and resolves with what that returns. */
export function start(name = "peer") {
  const worker = new Worker("peer.js", { type: "module" });
  const answers = new Map();
  const post = (message, transfer) => worker.postMessage(message, transfer);
  const id = graph.join(post, name, (text) => complaints.push(text));
  worker.onmessage = ({ data }) => {
    if (data.op) graph.receive(id, data);
    if (data.number) answers.get(data.number)?.(data.answer);
    answers.delete(data.number);
  };
  const ask = (command, details = {}) => new Promise((resolve) => {
    const number = ++asked;
    answers.set(number, resolve);
    worker.postMessage({ command, number, ...details });
  });
  worker.onerror = ({ message }) => {
    for (const answer of answers.values()) answer(Promise.reject(new Error(message)));
  };
  ask("start", { id });
  return {
    id,
    ask,
    worker,
    /** End it at once, whatever it does. */
    kill() {
      worker.terminate();
      graph.leave(id);
    },
  };
}

// How long anything may take (ms).
const LIMIT = 60_000;

/** Ask until it is true. */
export async function until(condition) {
  const end = performance.now() + LIMIT;
  while (!(await condition())) {
    if (performance.now() > end) throw new Error(`never: ${condition}`);
    await new Promise((resolve) => setTimeout(resolve, 10));
  }
}

/** Numbers from 0 to 1 that look random and are the same for the same seed. */
export function random(seed) {
  let state = seed >>> 0;
  return () => {
    state = (state + 0x6d2b79f5) >>> 0;
    let mixed = Math.imul(state ^ (state >>> 15), 1 | state);
    mixed = (mixed + Math.imul(mixed ^ (mixed >>> 7), 61 | mixed)) ^ mixed;
    return ((mixed ^ (mixed >>> 14)) >>> 0) / 2 ** 32;
  };
}
