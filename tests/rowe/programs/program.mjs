// A program with rowe in JavaScript: `serve PORT`, or `play PORT`, which prints what it found.
import { once } from "node:events";
import { setTimeout as sleep } from "node:timers/promises";

import { WebSocket } from "ws";

import { openLocalEndpoint } from "../../../sitegen/clients/rowe/node.js";
import { Endpoint, openRemoteEndpoint } from "../../../sitegen/clients/rowe/rowe.js";

const show = (name, value) => console.log(JSON.stringify([name, value]));

async function serve(wanted) {
  const { endpoint, port } = await openLocalEndpoint(wanted);
  console.log(port);
  for await (const message of endpoint) {
    const { body, peer: to } = message;
    if (body.do === "add") await endpoint.reply(message, { sum: body.a + body.b });
    else if (body.do === "count") {
      for (let number = 0; number < body.count; number += 1) endpoint.asyncSend({ number }, Infinity, { to });
      endpoint.asyncReply(message, { done: true });
    } else if (body.do === "ask") {
      try {
        const answer = await endpoint.invoke({ number: 20 }, 5, { to });
        await endpoint.send({ got: answer.body.number }, Infinity, { to });
      } catch (error) {
        console.log(error.message.includes("left") ? "gone" : error.message);
      }
    } else if (body.do === "rest") await sleep(body.seconds * 1000);
    else if (body.do === "broadcast") await endpoint.reply(message, { peers: endpoint.broadcast({ news: 1 }).length });
    else if (body.do !== "ignore") {
      try {
        endpoint.asyncSend(body, Infinity, { to });
      } catch (error) {
        // A peer that does not read loses its echoes.
        if (!error.message.includes("full")) throw error;
      }
    }
  }
}

async function play(port) {
  const endpoint = openRemoteEndpoint("127.0.0.1", port, { WebSocket });
  const taken = async () => (await endpoint.receive(20)).body;
  show("sum", (await endpoint.invoke({ do: "add", a: 38, b: 4 })).body.sum);

  await endpoint.invoke({ do: "count", count: 100 });
  let order = true;
  for (let number = 0; number < 100; number += 1) order &&= (await taken()).number === number;
  show("order", order);

  await endpoint.invoke({ do: "ignore" }, 0.2).catch((error) => show("silence", error.message.includes("no reply") && "timeout"));

  await endpoint.send({ do: "ask" });
  const request = await endpoint.receive(5);
  await endpoint.reply(request, { number: request.body.number + 1 });
  show("asked", (await taken()).got);

  await endpoint.send({ do: "rest", seconds: 0.5 });
  await endpoint.send({ echo: 1 }, 0.2);
  await endpoint.send({ echo: 2 });
  show("expired", (await taken()).echo);

  await endpoint.send({ text: "ü€😀\n", deep: [[{ a: null }]], number: -0.5, flag: true }, 5);
  show("echo", await taken());

  const { peers } = (await endpoint.invoke({ do: "broadcast" })).body;
  show("broadcast", [peers, (await taken()).news]);

  const ask = async (a) => {
    let right = 0;
    for (let b = 0; b < 25; b += 1) right += (await endpoint.invoke({ do: "add", a, b })).body.sum === a + b;
    return right;
  };
  const found = await Promise.all([0, 100, 200, 300].map(ask));
  show("threads", found.reduce((a, b) => a + b));

  const alone = new Endpoint({ WebSocket });
  show("discarded", await alone.send({}, 0.2));
  alone.close();

  console.log("leave");
  await once(process.stdin, "data");
  await endpoint
    .invoke({ do: "ignore" }, 0.5)
    .catch((error) => show("vanished", error.message.includes("no reply") && "timeout"));
  endpoint.asyncSend({ echo: 3 });
  console.log("return");
  show("returned", (await taken()).echo);
  endpoint.close();
  process.stdin.destroy();
}

await { serve, play }[process.argv[2]](Number(process.argv[3]));
