// @ts-check
// Let programs that connect to the address of a rosbridge server, and know nothing else, use the graph of the page.

import { RosbridgeSocket } from "./socket.js";

/**
 * From now on, `new WebSocket(url)` in this page connects to its graph. Others are as before.
 * @param {string} [url] @returns {() => void} undo
 */
export function serveWebSocket(url = "ws://localhost:9090") {
  const { href } = new URL(url);
  const before = globalThis.WebSocket;
  /** @type {typeof WebSocket} */
  const own = new Proxy(before, {
    construct: (target, given, made) => (hrefOf(given[0]) === href ? new RosbridgeSocket(href)
      : Reflect.construct(target, given, made === own ? target : made)),
  });
  globalThis.WebSocket = own;
  return () => {
    if (globalThis.WebSocket === own) globalThis.WebSocket = before;
  };
}

/** @param {unknown} url */
function hrefOf(url) {
  try {
    return new URL(String(url)).href;
  } catch {
    return "";
  }
}
