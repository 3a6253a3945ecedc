// @ts-check
// rowe in Node: endpoints that accept connections, with the package ws.

// @ts-expect-error ws has no types of its own.
import { WebSocket, WebSocketServer } from "ws";

import { Endpoint } from "./rowe.js";

const LONGEST = 2 ** 20;
// ms between pings, by which lost connections are noticed.
const HEARTBEAT = 15_000;

/**
 * Resolve with an endpoint that accepts connections, and its port: the one given, or a free one.
 * @param {number} [port] @param {string} [host]
 */
export async function openLocalEndpoint(port = 0, host = "127.0.0.1") {
  const endpoint = new Endpoint({ WebSocket });
  const server = new WebSocketServer({ port, host, maxPayload: LONGEST, perMessageDeflate: false });
  await new Promise((resolve, reject) => server.once("listening", resolve).once("error", reject));
  let number = 0;
  server.on("connection", (/** @type {any} */ socket, /** @type {any} */ request) => {
    // Clients may ask for what is not a URL, such as "//".
    const query = new URLSearchParams(String(request.url).split("?")[1]);
    const asked = query.get("name")?.slice(0, 100);
    number += 1;
    const name = asked || `${request.socket.remoteAddress}:${number}`;
    keepAlive(socket);
    endpoint.accept(socket, endpoint.knows(name) ? `${name}:${number}` : name);
  });
  endpoint.closing = () => server.close();
  return { endpoint, port: server.address().port };
}

/** End a connection whose other side does not answer. @param {any} socket */
function keepAlive(socket) {
  let answered = true;
  socket.on("pong", () => (answered = true));
  const timer = setInterval(() => {
    if (!answered) socket.terminate();
    answered = false;
    socket.ping();
  }, HEARTBEAT);
  socket.on("close", () => clearInterval(timer));
}
