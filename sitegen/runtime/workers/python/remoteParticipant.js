// @ts-check
// A participant of the graph in another worker, for a program that stands still while it waits: what is asked
// here is answered there, where ports and timers go on.

import { heard } from "../../interrupt.js";

/** @import { Participant } from "../../participant/participant.js" */
/** @import { Typed } from "../../protocol.js" */
/** @import { Caller } from "./calls.js" */
/** @import { Hosted } from "./pythonHost.js" */

const ASKED = /** @type {const} */ ([
  "create", "publish", "behind", "request", "matched", "has", "filled", "take", "look", "nameOf", "takeEvent",
]);
const TOLD = /** @type {const} */ (["destroy", "assertLiveliness", "respond", "wake"]);

/**
 * A participant that asks another worker.
 * @param {Caller} caller @param {Uint8Array | undefined} byte by which the page interrupts @returns {Hosted}
 */
export function remoteParticipant(caller, byte) {
  const asked = ASKED.map((name) => [name, (/** @type {any[]} */ ...args) => caller.ask(name, args)]);
  const told = TOLD.map((name) => [name, (/** @type {any[]} */ ...args) => caller.tell(name, args)]);
  return {
    ...Object.fromEntries([...asked, ...told]),
    get events() {
      return caller.ask("events", []);
    },
    /** @param {number} milliseconds */
    wait(milliseconds) {
      const signal = caller.ask("wait", [milliseconds]);
      if (signal) heard(byte);
      return signal;
    },
  };
}

/** What it asks for. @param {Participant} participant @param {Typed[]} typed */
export function answersOf(participant, typed) {
  /** @type {[string, Function][]} */
  const named = [...ASKED, ...TOLD].map((name) => [name, participant[name].bind(participant)]);
  let seen = participant.wakes;
  /** @param {number} milliseconds */
  const wait = async (milliseconds) => {
    // Things happen here between two questions, too: the program looked before, and would wait for what is there.
    const signal = await participant.wait(participant.wakes === seen ? milliseconds : 0);
    seen = participant.wakes;
    return signal;
  };
  return { ...Object.fromEntries(named), wait, events: () => participant.events, typed: () => typed.shift() };
}
