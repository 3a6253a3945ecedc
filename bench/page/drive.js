// @ts-check
// Runs a node of the page, or the same between two bare workers, and returns the numbers that come
// out of it: milliseconds.

import { ros } from "../runtime/rosMain.js";

// Nothing here takes a tenth of this time (ms).
const LIMIT = 60_000;

/** Start a node, wait for its end. @param {string} name @returns {Promise<number[]>} what it printed */
export function runNode(name) {
  const node = ros.nodes.get(name);
  if (!node) throw new Error(`no node '${name}'`);
  /** @type {string[]} */
  const lines = [];
  const listening = new AbortController();
  const { signal } = listening;
  return new Promise((resolve, reject) => {
    node.addEventListener("lines", (event) => {
      const { detail } = /** @type {CustomEvent<{text: string}[]>} */ (event);
      for (const { text } of detail) lines.push(text);
    }, { signal });
    node.addEventListener("state", () => {
      if (node.state === "stopped") resolve(lines.map(Number));
      if (node.state === "failed") reject(new Error(lines.at(-1)));
    }, { signal });
    setTimeout(() => reject(new Error(`'${name}' does not end`)), LIMIT);
    node.start();
  }).finally(() => listening.abort());
}

export const { nodes } = ros;
/** @type {Map<string, string[]>} */
const lines = new Map();

/** Start nodes and wait until they run. @param {string[]} names */
export async function start(names) {
  await Promise.all(names.map((name) => become(name, "running", (node) => node.start())));
}

/** @param {string[]} names */
export async function stop(names) {
  await Promise.all(names.map((name) => become(name, "stopped", (node) => node.stop())));
}

/** Keep what a node will print. @param {string} name */
export function keepLines(name) {
  /** @type {string[]} */
  const kept = [];
  lines.set(name, kept);
  nodes.get(name)?.addEventListener("lines", (event) => {
    const { detail } = /** @type {CustomEvent<{text: string}[]>} */ (event);
    for (const { text } of detail) kept.push(text);
  });
}

/** Wait until a node has printed. @param {string} name */
export async function keptSome(name) {
  const end = performance.now() + LIMIT;
  while (kept(name).length === 0) {
    if (performance.now() > end) throw new Error(`'${name}' prints nothing`);
    await new Promise((resolve) => setTimeout(resolve, 50));
  }
}

/** @param {string} name */
export function kept(name) {
  return lines.get(name) ?? [];
}

/**
 * Act on a node and wait for a state, which it may have reached before.
 * @param {string} name @param {string} state @param {(node: any) => void} act @returns {Promise<void>}
 */
function become(name, state, act) {
  const node = nodes.get(name);
  if (!node) throw new Error(`no node '${name}'`);
  const listening = new AbortController();
  return new Promise((resolve, reject) => {
    const look = () => {
      if (node.state === state) resolve();
      if (node.state === "failed") reject(new Error(`'${name}' failed`));
    };
    node.addEventListener("state", look, { signal: listening.signal });
    act(node);
    look();
    setTimeout(() => reject(new Error(`'${name}' is ${node.state}, not ${state}`)), LIMIT);
  }).finally(() => listening.abort());
}

/**
 * @param {"ping" | "burst"} task
 * @param {number} size bytes in a message
 * @param {number} count rounds, or messages
 * @returns {Promise<number[]>}
 */
export async function runBare(task, size, count) {
  const sender = new Worker(new URL("sender.js", import.meta.url), { type: "module" });
  const receiver = new Worker(new URL("receiver.js", import.meta.url), { type: "module" });
  const { port1, port2 } = new MessageChannel();
  receiver.postMessage({ task, port: port1 }, [port1]);
  sender.postMessage({ task, size, count, port: port2 }, [port2]);
  const { data } = await new Promise((resolve, reject) => {
    sender.onmessage = resolve;
    sender.onerror = receiver.onerror = reject;
    setTimeout(() => reject(new Error(`the bare ${task} does not end`)), LIMIT);
  });
  sender.terminate();
  receiver.terminate();
  return data;
}

/** Keep the main thread busy, `milliseconds` of every frame. @param {number} milliseconds */
export function beBusy(milliseconds) {
  let frame = 0;
  const work = () => {
    const end = performance.now() + milliseconds;
    while (performance.now() < end);
    frame = requestAnimationFrame(work);
  };
  work();
  return () => cancelAnimationFrame(frame);
}
