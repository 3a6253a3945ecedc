// @ts-check
// A WebSocket to the graph of the page, for clients of rosbridge that bring their own decoder: texts in JSON, and bytes
// in CBOR.

import { pageRos } from "../client/page.js";
import { place } from "../place.js";
import { Session } from "./session.js";

const [CONNECTING, OPEN, CLOSING, CLOSED] = [0, 1, 2, 3];

export class RosbridgeSocket extends EventTarget {
  static CONNECTING = CONNECTING;
  static OPEN = OPEN;
  static CLOSING = CLOSING;
  static CLOSED = CLOSED;
  CONNECTING = CONNECTING;
  OPEN = OPEN;
  CLOSING = CLOSING;
  CLOSED = CLOSED;
  readyState = CONNECTING;
  bufferedAmount = 0;
  extensions = "";
  protocol = "";
  /** @type {"blob" | "arraybuffer"} */
  binaryType = "blob";
  /** @type {((event: Event) => void) | null} */
  onopen = null;
  /** @type {((event: MessageEvent) => void) | null} */
  onmessage = null;
  /** @type {((event: CloseEvent) => void) | null} */
  onclose = null;
  /** @type {((event: Event) => void) | null} */
  onerror = null;
  /** @type {Session | undefined} */
  #session;

  /** @param {string} [url] which means nothing */
  constructor(url = "page:") {
    super();
    this.url = url;
    setTimeout(() => this.#open());
  }

  /** @param {string | ArrayBuffer | ArrayBufferView | Blob} data */
  send(data) {
    if (this.readyState === CONNECTING) throw new DOMException("the connection is not open yet", "InvalidStateError");
    if (typeof data === "string") this.#session?.receive(data);
    else this.#session?.status("error", "messages to the page are texts in JSON");
  }

  /** @param {number} [code] @param {string} [reason] */
  close(code = 1000, reason = "") {
    if (this.readyState >= CLOSING) return;
    this.readyState = CLOSING;
    this.#session?.close();
    setTimeout(() => {
      this.readyState = CLOSED;
      this.#emit(new CloseEvent("close", { code, reason, wasClean: true }));
    });
  }

  async #open() {
    // Most programs need no encoders, whose libraries are large.
    /** @type {typeof import("./encoding.js")} */
    const { framesOf } = await import(place("rosbridge/encoding.js"));
    if (this.readyState !== CONNECTING) return;
    this.#session = new Session(pageRos(), (sent) => {
      for (const frame of framesOf(sent)) {
        const data = typeof frame === "string" || this.binaryType === "arraybuffer" ? frame : new Blob([frame]);
        queueMicrotask(() => {
          if (this.readyState === OPEN) this.#emit(new MessageEvent("message", { data }));
        });
      }
    });
    this.readyState = OPEN;
    this.#emit(new Event("open"));
  }

  /** @param {Event} event */
  #emit(event) {
    const handler = /** @type {any} */ (this)[`on${event.type}`];
    if (typeof handler === "function") handler.call(this, event);
    this.dispatchEvent(event);
  }
}
