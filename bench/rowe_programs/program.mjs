// Measure rowe in JavaScript: `serve`, or `play PORT TURNS`, which prints a delay (ms) and a rate (/s).
import { WebSocket } from "ws";

import { openLocalEndpoint } from "../../sitegen/clients/rowe/node.js";
import { openRemoteEndpoint } from "../../sitegen/clients/rowe/rowe.js";

const BATCH = 1000;

async function serve() {
  const { endpoint, port } = await openLocalEndpoint();
  console.log(port);
  for await (const message of endpoint) if (message.messageId) endpoint.asyncReply(message, message.body);
}

async function play(port, turns) {
  const endpoint = openRemoteEndpoint("127.0.0.1", port, { WebSocket });
  const body = { topic: "speed", x: 0.25, text: "x".repeat(60) };
  const delays = [];
  for (let turn = 0; turn < turns + 50; turn += 1) {
    const begun = performance.now();
    await endpoint.invoke(body);
    delays.push(performance.now() - begun);
  }
  const batches = Math.max(1, Math.floor(turns / 50));
  const begun = performance.now();
  for (let batch = 0; batch < batches; batch += 1) {
    for (let count = 0; count < BATCH; count += 1) endpoint.asyncSend(body);
    await endpoint.invoke(body, 60);
  }
  const rate = (batches * (BATCH + 1)) / ((performance.now() - begun) / 1000);
  const sorted = delays.slice(50).sort((a, b) => a - b);
  console.log(JSON.stringify([sorted[Math.floor(sorted.length / 2)], rate]));
  endpoint.close();
}

if (process.argv[2] === "serve") await serve();
else await play(Number(process.argv[3]), Number(process.argv[4]));
