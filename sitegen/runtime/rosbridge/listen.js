// @ts-check
// Clients in other pages, which talk to this one through a port, if site.yaml allows their origin.

import { pageRos } from "../client/page.js";
import { LONGEST_ID, MOST_CLIENTS } from "./limits.js";
import { Session } from "./session.js";

const OP = "sitegen-connect";
// How often it is looked whether the page of a client is still there (ms).
const LOOK = 5000;

/** Serve the pages of these origins. @param {string[]} origins @returns {() => void} stop */
export function listen(origins) {
  /** Of each window, the ids of its requests. @type {WeakMap<object, Set<string>>} */
  const known = new WeakMap();
  const warned = new Set();
  /** @type {Set<() => void>} */
  const clients = new Set();
  const hear = (/** @type {MessageEvent} */ event) => {
    const { data, origin, ports: [port], source } = event;
    if (data?.op !== OP || !port || !source) return;
    if (!origins.includes(origin)) {
      // Another page may ask as often as it likes.
      if (!warned.has(origin) && warned.size < MOST_CLIENTS) {
        warned.add(origin);
        console.warn(`a page of ${origin} wanted to use this page; 'messages_from' in site.yaml does not name it`);
      }
      port.postMessage({ op: "refused", reason: `this page takes no messages from ${origin}` });
      port.close();
      return;
    }
    const { id } = data;
    const asked = known.get(source) ?? new Set();
    known.set(source, asked);
    // A client asks again until it gets an answer.
    if (typeof id !== "string" || id.length > LONGEST_ID || asked.has(id)) return;
    if (clients.size >= MOST_CLIENTS) {
      port.postMessage({ op: "refused", reason: "this page has too many clients" });
      port.close();
      return;
    }
    asked.add(id);
    const end = serve(port, /** @type {any} */ (source), () => {
      clients.delete(end);
      asked.delete(id);
    });
    clients.add(end);
  };
  const stop = () => {
    for (const end of [...clients]) end();
  };
  addEventListener("message", hear);
  // The client connects again when the page is back.
  addEventListener("pagehide", stop);
  return () => {
    removeEventListener("message", hear);
    removeEventListener("pagehide", stop);
    stop();
  };
}

/** @param {MessagePort} port @param {{closed?: boolean}} source @param {() => void} ended @returns {() => void} end */
function serve(port, source, ended) {
  const session = new Session(pageRos(), ({ message }) => port.postMessage({ op: "message", message }));
  const end = () => {
    clearInterval(timer);
    session.close();
    // Not all browsers tell that a port is closed.
    port.postMessage({ op: "close" });
    port.close();
    ended();
  };
  const timer = setInterval(() => {
    if (source.closed) end();
  }, LOOK);
  port.addEventListener("message", ({ data }) => {
    if (data?.op === "message") session.receive(data.message);
    else if (data?.op === "close") end();
  });
  // Where browsers tell it, the other side is gone.
  port.addEventListener("close", end);
  port.start();
  port.postMessage({ op: "open" });
  return end;
}
