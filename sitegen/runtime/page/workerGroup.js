// @ts-check
// Start workers, for one node or for a group of Python nodes that share an interpreter.

import { sharedByte } from "../interrupt.js";
import { startWorker } from "../worker.js";

/** @import { ToWorker } from "../protocol.js" */

export class WorkerGroups {
  /** By name. @type {Map<string, {worker: Worker, byte?: Uint8Array, members: Set<Member>}>} */
  #groups = new Map();

  /**
   * Add a node to the worker of a group.
   * @param {string} group @param {string} file of the worker @param {string} name of the node
   */
  join(group, file, name) {
    const known = this.#groups.get(group);
    const started = known ?? { worker: startWorker(file, group), byte: sharedByte(), members: new Set() };
    const { worker, byte, members } = started;
    const { port1, port2 } = new MessageChannel();
    const member = new Member(name, port1, byte, (stuck) => {
      members.delete(member);
      if (!stuck && members.size > 0) return;
      worker.terminate();
      if (this.#groups.get(group)?.worker === worker) this.#groups.delete(group);
      for (const other of [...members]) other.lose(`it shared its interpreter with ${name}, which had to be terminated`);
    });
    if (!known) {
      this.#groups.set(group, started);
      worker.onerror = (event) => {
        event.preventDefault();
        this.#groups.delete(group);
        for (const each of [...members]) each.lose(event.message);
      };
    }
    members.add(member);
    worker.postMessage(/** @type {ToWorker} */ ({ op: "join" }), [port2]);
    return member;
  }
}

/** A node's port to a shared worker, with the interface of a worker. */
export class Member {
  #port;
  #end;
  /** @type {((event: {message: string, preventDefault(): void}) => void) | null} */
  onerror = null;

  /**
   * @param {string} name @param {MessagePort} port
   * @param {Uint8Array | undefined} byte by which the page interrupts the worker
   * @param {(stuck: boolean) => void} end called when the node has ended, or is stuck
   */
  constructor(name, port, byte, end) {
    this.name = name;
    this.byte = byte;
    this.#port = port;
    this.#end = end;
  }

  /** @param {((event: MessageEvent) => void) | null} listen */
  set onmessage(listen) {
    this.#port.onmessage = listen;
  }

  /** @param {ToWorker} message @param {Transferable[]} [transfer] */
  postMessage(message, transfer = []) {
    this.#port.postMessage(message, transfer);
  }

  /** End the node; the others go on. */
  leave() {
    this.#port.close();
    this.#end(false);
  }

  /** Terminate the worker with all its nodes. */
  terminate() {
    this.#port.close();
    this.#end(true);
  }

  /** Report that the worker is gone. @param {string} message */
  lose(message) {
    this.onerror?.({ message, preventDefault() {} });
  }
}
