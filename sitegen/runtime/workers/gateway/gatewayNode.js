// @ts-check
// The worker of a connection to a gateway: remote nodes take part in the page's graph, and its nodes in theirs.

import { Participant } from "../../participant/participant.js";
import { Connection } from "./connection.js";

/** @import { FromWorker, ToWorker } from "../../protocol.js" */
/** @import { FromGateway, ToGateway } from "../../gateway/orders.js" */

/** @param {FromGateway} message */
const tell = (message) => postMessage(/** @type {FromWorker} */ ({ op: "tell", message }));
/** @type {Participant | undefined} */
let participant;
/** @type {Connection | undefined} */
let connection;

/** @param {MessageEvent<ToWorker>} event */
onmessage = ({ data }) => {
  if (data.op === "enter") {
    participant = new Participant(data.id, (message) => postMessage(message), true);
    run(participant);
  } else if (data.op === "tell" && participant) {
    obey(participant, data.message);
  } else {
    participant?.receive(data);
  }
};

/** @param {Participant} graph @param {ToGateway} order */
function obey(graph, order) {
  if (order.op === "types") {
    connection?.describe(order.types);
    return;
  }
  connection?.close();
  connection = order.op === "connect" ? new Connection(graph, order, tell) : undefined;
  if (!connection) tell({ op: "state", state: "off" });
}

/** Exchange what has come, as long as the worker lives. @param {Participant} graph */
async function run(graph) {
  for (;;) {
    await graph.wait(-1);
    connection?.turn();
  }
}
