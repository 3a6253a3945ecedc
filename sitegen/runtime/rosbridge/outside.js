// @ts-check
// For pages of other origins: a transport of roslib 2 to the graph of a page of this site, in a frame or a window. This
// file needs no other; copy it, or import it from the site.

/** @typedef {"open" | "close" | "error" | "message"} Kind */

// How often the page is asked until it answers, and for how long (ms): it may still be loading. Then, how often it is
// looked whether it is still there.
const [AGAIN, PATIENCE, LOOK] = [250, 60_000, 1000];

class Transport {
  /** @type {Record<Kind, Set<(event: any) => void>>} */
  #listeners = { open: new Set(), close: new Set(), error: new Set(), message: new Set() };
  /** @type {"connecting" | "open" | "closed"} */
  #state = "connecting";
  /** @type {MessagePort | undefined} */
  #port;
  #id = crypto.getRandomValues(new Uint32Array(4)).join("-");
  /** @type {ReturnType<typeof setInterval> | undefined} */
  #timer;
  /** @type {Window | undefined} */
  #target;
  #ended = new AbortController();

  /** @param {Window} target @param {string} origin */
  connect(target, origin) {
    const until = Date.now() + PATIENCE;
    const ask = () => {
      // A page that isolates itself looks like this, too.
      if (target.closed) this.#end(new Error(`the window of ${origin} is closed, or isolated from other pages`));
      else if (Date.now() <= until) this.#ask(target, origin);
      else this.#end(new Error(`no answer from ${origin}; does its site.yaml name ${location.origin}?`));
    };
    this.#timer = setInterval(ask, AGAIN);
    this.#target = target;
    // The other page may outlive this one.
    addEventListener("pagehide", () => this.#end(), { signal: this.#ended.signal });
    ask();
  }

  /** @param {Kind} kind @param {(event: any) => void} listener */
  on(kind, listener) {
    this.#listeners[kind]?.add(listener);
    return this;
  }

  /** @param {Kind} kind @param {(event: any) => void} listener */
  off(kind, listener) {
    this.#listeners[kind]?.delete(listener);
    return this;
  }

  /** @param {any} message */
  send(message) {
    if (this.#state !== "open") throw new Error("the connection is not open");
    this.#port?.postMessage({ op: "message", message });
  }

  close() {
    this.#end();
  }

  isConnecting() {
    return this.#state === "connecting";
  }

  isOpen() {
    return this.#state === "open";
  }

  isClosing() {
    return false;
  }

  isClosed() {
    return this.#state === "closed";
  }

  /** @param {Window} target @param {string} origin */
  #ask(target, origin) {
    const { port1, port2 } = new MessageChannel();
    port1.onmessage = ({ data }) => this.#hear(port1, data);
    // The browser delivers it only if the page in the window is of this origin.
    target.postMessage({ op: "sitegen-connect", id: this.#id }, origin, [port2]);
  }

  /** @param {MessagePort} port @param {any} data */
  #hear(port, data) {
    if (this.#state === "connecting" && data.op === "open") {
      clearInterval(this.#timer);
      this.#port = port;
      this.#state = "open";
      // Not all browsers tell that the other side is gone.
      port.addEventListener("close", () => this.#end());
      this.#timer = setInterval(() => this.#target?.closed && this.#end(), LOOK);
      this.#emit("open", new Event("open"));
    } else if (this.#state === "connecting" && data.op === "refused") {
      this.#end(new Error(data.reason));
    } else if (this.#port === port && data.op === "message") {
      this.#emit("message", data.message);
    } else if (this.#port === port && data.op === "close") {
      this.#end();
    }
  }

  /** @param {Error} [error] */
  #end(error) {
    if (this.#state === "closed") return;
    this.#state = "closed";
    clearInterval(this.#timer);
    this.#ended.abort();
    this.#port?.postMessage({ op: "close" });
    this.#port?.close();
    setTimeout(() => {
      if (error) this.#emit("error", error);
      this.#emit("close", new Event("close"));
    });
  }

  /** @param {Kind} kind @param {any} event */
  #emit(kind, event) {
    for (const listener of [...this.#listeners[kind]]) listener(event);
  }
}

/**
 * Return a `transportFactory` of roslib 2 for the page in a window, such as `frame.contentWindow`: give it to `new Ros()`,
 * then `connect("page:")`. The page's site.yaml has to name this page's origin.
 * @param {Window | null} target null if the browser has not opened one @param {string} origin of the page in it
 */
export function transportTo(target, origin) {
  return async () => {
    if (!target) throw new Error("there is no window; browsers open one only when the visitor clicks");
    const transport = new Transport();
    // roslib listens only after it has got the transport.
    setTimeout(() => transport.connect(target, origin));
    return transport;
  };
}
