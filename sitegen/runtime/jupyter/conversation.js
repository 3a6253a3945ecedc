// @ts-check
// What a kernel of JupyterLab and its node say to each other: requests, answers and output, as JSON;
// clients/python/rclpy_backend/notebook.py is the other side.

/** @import { Line, NodeHandle } from "../protocol.js" */

/**
 * The methods of a kernel that show output in its notebooks.
 * @typedef {Record<"stream" | "publishExecuteResult" | "displayData" | "updateDisplayData" | "clearOutput"
 *   | "inputRequest", (content: object) => void> & {dispose(): void}} Shows
 *
 * @typedef {{op: string, id?: number, content?: any, name?: "stdout" | "stderr", text?: string, data?: any,
 *   metadata?: any, transient?: any, count?: number, wait?: boolean, prompt?: string, hidden?: boolean}} Answer
 */

// Lines of these severities are shown as output; the others as errors, on red.
const CALM = ["debug", "info", "stdout"];

export class Conversation {
  #node;
  #shows;
  #listening = new AbortController();
  /** By the numbers of the requests that are not answered yet. @type {Map<number, (content: any) => void>} */
  #asked = new Map();
  #last = 0;
  /** What the node said when it failed. */
  #fault = "";
  /** @type {(value?: undefined) => void} */
  #begin = () => {};
  /** @type {(error: Error) => void} */
  #fail = () => {};
  /** Settles when Python runs, or has failed to. @type {Promise<undefined>} */
  ready = new Promise((resolve, reject) => {
    this.#begin = resolve;
    this.#fail = reject;
  });

  /** @param {NodeHandle} node @param {Shows} shows the kernel, which goes away with its document */
  constructor(node, shows) {
    this.#node = node;
    this.#shows = shows;
    this.ready.catch(() => {}); // reported by JupyterLab
    const { signal } = this.#listening;
    node.addEventListener("answer", (event) => {
      this.#take(JSON.parse(/** @type {CustomEvent<{text: string}>} */ (event).detail.text));
    }, { signal });
    node.addEventListener("lines", (event) => {
      this.#print(/** @type {CustomEvent<Line[]>} */ (event).detail);
    }, { signal });
    node.addEventListener("state", () => {
      if (node.state === "stopped" || node.state === "failed") {
        this.#answerAll(this.#fault || "the kernel has ended; restart it");
      }
    }, { signal });
    addEventListener("pagehide", () => shows.dispose(), { signal });
  }

  /**
   * Send a request when Python runs, and return its answer.
   * @param {string} op @param {object} content @returns {Promise<any>}
   */
  async ask(op, content) {
    await this.ready;
    const id = ++this.#last;
    return new Promise((resolve) => {
      this.#asked.set(id, resolve);
      this.#send({ op, id, ...content });
    });
  }

  /** Give input() its line. @param {string} text */
  reply(text) {
    this.#send({ op: "reply", text });
  }

  /** Send Ctrl-C to the running cell. */
  interrupt() {
    this.#node.interrupt();
  }

  /** End the node. */
  end() {
    this.#listening.abort();
    // Stop alone is an interrupt, which does not end a kernel.
    this.#send({ op: "end" });
    this.#node.stop();
    this.#answerAll("the kernel was shut down");
  }

  /** @param {object} request */
  #send(request) {
    this.#node.type({ op: "ask", text: JSON.stringify(request) });
  }

  /** Show what the node printed past IPython, such as log messages. @param {Line[]} lines */
  #print(lines) {
    for (const { severity, text } of lines) {
      if (severity === "fatal") this.#fault = text;
      this.#shows.stream({ name: CALM.includes(severity) ? "stdout" : "stderr", text: `${text}\n` });
    }
  }

  /** @param {Answer} answer */
  #take({ op, id = 0, content, name, text, data, metadata, transient, count, wait, prompt, hidden }) {
    const shows = this.#shows;
    switch (op) {
      case "ready":
        // The files of the notebooks' folder; the lab is beside them.
        this.#send({ op: "at", address: new URL("../files/", location.href).href });
        return this.#begin();
      case "done":
        this.#asked.get(id)?.(content);
        this.#asked.delete(id);
        break;
      case "stream":
        return shows.stream({ name, text });
      case "result":
        return shows.publishExecuteResult({ execution_count: count, data, metadata });
      case "display":
        return shows.displayData({ data, metadata, transient });
      case "update":
        return shows.updateDisplayData({ data, metadata, transient });
      case "clear":
        return shows.clearOutput({ wait });
      case "input":
        return shows.inputRequest({ prompt, password: hidden });
    }
  }

  /** Answer all requests: the node has ended. @param {string} why */
  #answerAll(why) {
    this.#fail(new Error(why));
    for (const answer of this.#asked.values()) {
      answer({ status: "error", ename: "KernelEnded", evalue: why, traceback: [why] });
    }
    this.#asked.clear();
  }
}
