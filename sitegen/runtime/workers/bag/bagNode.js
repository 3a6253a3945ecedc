// @ts-check
// The worker of a bag: a player, a recorder, what cuts a part out of one, or what mends recordings that were interrupted.

import { Participant } from "../../participant/participant.js";
import { saidOf } from "../../bag/orders.js";
import { cut } from "./cut.js";
import { mend } from "./files.js";
import { Player } from "./player.js";
import { reasonOf, Recorder } from "./recorder.js";

/** @import { FromWorker, ToWorker } from "../../protocol.js" */

/** @param {any} message @param {Transferable[]} [transfer] */
const tell = (message, transfer = []) => postMessage(/** @type {FromWorker} */ ({ op: "tell", message }), transfer);
/** @type {Participant | undefined} */
let participant;
/** @type {Player | undefined} */
let player;
/** @type {Recorder | undefined} */
let recorder;

/** @param {MessageEvent<ToWorker>} event */
onmessage = ({ data }) => {
  if (data.op === "enter") participant = new Participant(data.id, (message) => postMessage(message));
  else if (data.op === "tell" && participant) receive(participant, data.message);
  else participant?.receive(data);
};

/** @param {Participant} graph @param {any} message an order */
async function receive(graph, message) {
  try {
    if (message.op === "mend") tell({ op: "mended", names: await mend(message.folder) });
    else if (message.op === "cut") tell({ op: "cut", ...(await cut(message)) });
    else if (message.op === "open") await (player = new Player(graph, tell)).open(message.source);
    else if (message.op === "record") await (recorder = new Recorder(graph, tell)).begin(message);
    else if (recorder) await recorder.receive(message);
    else await player?.receive(message);
  } catch (error) {
    tell({ op: "failed", said: recorder ? reasonOf(error) : saidOf(error) });
  }
}
