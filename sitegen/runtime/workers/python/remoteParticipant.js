// @ts-check
// The participant of a program that blocks its worker while it waits. It lives in another worker, where ports and
// timers continue to work, and is called synchronously.

import { heard } from "../../interrupt.js";
import { contentOf } from "./contents.js";

/** @import { Participant } from "../../participant/participant.js" */
/** @import { Typed } from "../../protocol.js" */
/** @import { Caller } from "./calls.js" */
/** @import { Hosted } from "./pythonHost.js" */

const ASKED = /** @type {const} */ ([
  "create", "publish", "behind", "request", "matched", "has", "filled", "take", "look", "gid", "takeEvent",
]);
const TOLD = /** @type {const} */ (["destroy", "assertLiveliness", "respond", "wake"]);

/**
 * Return a participant that calls the one in another worker.
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

/** Return the functions that it calls. @param {Participant} participant @param {Typed[]} typed */
export function answersOf(participant, typed) {
  /** @type {[string, Function][]} */
  const named = [...ASKED, ...TOLD].map((name) => [name, participant[name].bind(participant)]);
  let seen = participant.wakes;
  /** @param {number} milliseconds */
  const wait = async (milliseconds) => {
    // Do not wait if something has happened since the last wait: the program may have checked before that.
    const signal = await participant.wait(participant.wakes === seen ? milliseconds : 0);
    seen = participant.wakes;
    return signal;
  };
  return { ...Object.fromEntries(named), wait, file: contentOf, events: () => participant.events, typed: () => typed.shift() };
}
