// @ts-check
// A participant of the graph in another worker, for a program that stands still while it waits: what is asked
// here is answered there, where ports and timers go on.

import { heard } from "../interrupt.js";

/** @import { Participant } from "../participant/participant.js" */
/** @import { Typed } from "../protocol.js" */
/** @import { Caller } from "./calls.js" */
/** @import { Hosted } from "./pythonHost.js" */

const ASKED = /** @type {const} */ ([
  "create", "publish", "behind", "request", "matched", "has", "take", "look", "nameOf", "takeEvent",
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
  const named = [...ASKED, ...TOLD, /** @type {const} */ ("wait")].map((name) => [name, participant[name].bind(participant)]);
  return { ...Object.fromEntries(named), events: () => participant.events, typed: () => typed.shift() };
}
