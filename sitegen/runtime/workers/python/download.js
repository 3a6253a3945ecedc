// @ts-check
// Download files for a worker, with progress reports and readable errors.

import { place } from "../../place.js";

/** @import { FromWorker } from "../../protocol.js" */

// The time between progress reports (ms).
const PAUSE = 200;
// The browser's function, which is replaced while Pyodide's loader runs.
const browsers = globalThis.fetch;

export class Download {
  /** The receivers of reports. @type {Set<(message: FromWorker) => void>} */
  #posts = new Set();
  #loaded = 0;
  #total = 0;
  #lastPost = 0;
  /** @type {(error: Error) => void} */
  #fail = () => {};
  /** Rejects with the first error. @type {Promise<never>} */
  failed = new Promise((_, reject) => {
    this.#fail = reject;
  });

  constructor() {
    this.failed.catch(() => {}); // reported when a node starts
  }

  /**
   * Begin to report progress.
   * @param {number} total bytes, not compressed @param {(message: FromWorker) => void} post
   */
  expect(total, post) {
    this.#total = Math.max(this.#total, total);
    this.#posts.add(post);
    this.#tell(true);
  }

  /** Stop reporting progress. @param {(message: FromWorker) => void} post */
  forget(post) {
    this.#posts.delete(post);
  }

  /**
   * Replace fetch(). The response is the browser's own, so that it can cache compiled WebAssembly.
   * @param {RequestInfo | URL} input @param {RequestInit} [init] @returns {Promise<Response>}
   */
  fetch = async (input, init) => {
    // In a page that is a single file, what has a name there has another address.
    const url = new URL(place(input instanceof Request ? input.url : String(input)));
    const response = await browsers(input instanceof Request ? input : url, init).catch(() => this.lack(url));
    if (!response.ok) this.lack(url, response.status);
    this.#count(response.clone()).catch(() => this.lack(url)).catch(() => {});
    return response;
  };

  /** @param {URL} url @param {number} [status] of the response, if there was one @returns {never} */
  lack(url, status) {
    this.#giveUp(
      status
        ? `${nameOf(url)} could not be loaded: the server answered ${status}; reload the page, the site may have changed`
        : `${nameOf(url)} could not be loaded; check the connection to the site, then start again`,
    );
  }

  /** @param {string} reason @returns {never} */
  #giveUp(reason) {
    const error = new Error(reason);
    this.#fail(error);
    throw error;
  }

  /**
   * Find out why a module could not be imported, which browsers do not report, and throw an Error.
   * @param {URL} url @returns {Promise<never>}
   */
  async lackModule(url) {
    const response = await browsers(url, { method: "HEAD" }).catch(() => undefined);
    const type = response?.headers.get("content-type") ?? "no media type";
    if (!response?.ok || /^(text|application)\/(x-)?javascript\b/.test(type)) this.lack(url, response?.ok ? 0 : response?.status);
    const how = `the server sends it with ${type} instead of text/javascript`;
    this.#giveUp(`${nameOf(url)} could not be loaded: ${how}; correct the server's media types`);
  }

  /** @param {Response} response */
  async #count({ body }) {
    const reader = body?.getReader();
    for (let part = await reader?.read(); part?.value; part = await reader?.read()) {
      this.#loaded += part.value.length;
      this.#tell(this.#loaded >= this.#total);
    }
  }

  /** @param {boolean} now whether to ignore the time since the last report */
  #tell(now) {
    if (!this.#total || (!now && performance.now() - this.#lastPost < PAUSE)) return;
    this.#lastPost = performance.now();
    const loaded = Math.min(this.#loaded, this.#total);
    for (const post of this.#posts) post({ op: "progress", loaded, total: this.#total });
  }
}

/** Return the name of a file. @param {URL} url */
function nameOf({ pathname }) {
  return pathname.slice(pathname.lastIndexOf("/") + 1);
}
