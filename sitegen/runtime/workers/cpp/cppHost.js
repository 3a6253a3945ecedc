// @ts-check
// The host functions of clients/cpp/include/rclcpp/detail/host.h, which a compiled program calls by the glue in
// clients/cpp/src/platform/host.js. `heap` is a view of the whole memory, created for each call.

import { KINDS, now } from "../../protocol.js";
import { filterHost } from "./filterHost.js";
import { encodeGraph, readQos, readText, writeEvent, writeInfo } from "./layout.js";
import { programHost } from "./programHost.js";

/** @import { EventKind } from "../../participant/status.js" */
/** @import { Participant } from "../../participant/participant.js" */
/** @import { Printer } from "../printer.js" */

/** As host.h numbers them. @type {EventKind[]} */
const EVENTS = ["deadline", "liveliness", "incompatible", "matched", "lost", "type"];

/**
 * @param {Participant} participant
 * @param {Printer} printer
 * @param {string[]} args the command line, beginning with the program's name
 * @param {(error: string, stack: string) => void} fail called with the text of an exception that left main(),
 *   and the stack where it was thrown, if known
 * @param {(error: unknown) => void} ended called with what a suspended program threw
 * @param {(bytes: number) => void} grown called with the size of the memory when it has changed
 */
export function cppHost(participant, printer, args, fail, ended, grown) {
  const noteSize = sizeReport(grown);
  return {
    ...endpointHost(participant, noteSize),
    ...messageHost(participant, noteSize),
    ...filterHost(participant),
    ...graphHost(participant),
    ...programHost(printer, args, fail),
    /** @param {number} milliseconds */
    wait(milliseconds) {
      printer.flush();
      return participant.wait(milliseconds);
    },
    wake: () => participant.wake(),
    now,
    ended,
  };
}

/** @param {Participant} participant @param {(heap: Uint8Array) => void} noteSize */
function endpointHost(participant, noteSize) {
  return {
    /**
     * @param {Uint8Array} heap @param {number} kind @param {number} node @param {number} name
     * @param {number} type @param {number} qos
     */
    create(heap, kind, node, name, type, qos) {
      noteSize(heap);
      const [nodeName, topic, typeName] = [readText(heap, node), readText(heap, name), readText(heap, type)];
      return participant.create(KINDS[kind] ?? "node", nodeName, topic, typeName, readQos(heap, qos));
    },
    /** @param {number} id */
    destroy: (id) => participant.destroy(id),
    /** ros_gid of host.h, which the glue of compiled programs calls by an older name. @param {number} id */
    name: (id) => participant.gid(id),
    /** @param {number} id */
    matched: (id) => participant.matched(id),
    /** @param {number} id */
    behind: (id) => Number(participant.behind(id)),
    /** @param {number} id */
    assert: (id) => participant.assertLiveliness(id),
    events: () => participant.events,
    /** @param {Uint8Array} heap @param {number} id @param {number} kind @param {number} to */
    takeEvent(heap, id, kind, to) {
      const event = participant.takeEvent(id, EVENTS[kind] ?? "deadline");
      if (!event) return 0;
      writeEvent(heap, to, event);
      return 1;
    },
  };
}

/** @param {Participant} participant @param {(heap: Uint8Array) => void} noteSize */
function messageHost(participant, noteSize) {
  return {
    /** @param {Uint8Array} heap @param {number} id @param {number} data @param {number} size */
    publish: (heap, id, data, size) => Number(participant.publish(id, heap.subarray(data, data + size))),
    /** @param {Uint8Array} heap @param {number} id @param {number} data @param {number} size */
    request: (heap, id, data, size) => participant.request(id, heap.subarray(data, data + size)),
    /**
     * @param {Uint8Array} heap @param {number} id @param {number} client @param {number} sequence
     * @param {number} data @param {number} size
     */
    respond(heap, id, client, sequence, data, size) {
      // WebAssembly passes unsigned numbers as signed ones: those of the upper half arrive negative.
      participant.respond(id, client, sequence >>> 0, heap.subarray(data, data + size));
    },
    /** @param {Uint8Array} heap @param {number} id @param {number} info */
    next(heap, id, info) {
      noteSize(heap);
      const message = participant.next(id);
      if (!message) return -1;
      writeInfo(heap, info, message);
      return message.message.length;
    },
    /** @param {Uint8Array} heap @param {number} id @param {number} to */
    take(heap, id, to) {
      const message = participant.take(id);
      if (message && to) heap.set(message.message, to);
    },
  };
}

/** @param {Participant} participant */
function graphHost(participant) {
  let graph = new Uint8Array();
  return {
    changes() {
      participant.look();
      return participant.changes;
    },
    look() {
      const neighbours = participant.look();
      if (!neighbours) return -1;
      graph = encodeGraph(neighbours);
      return graph.length;
    },
    /** @param {Uint8Array} heap @param {number} to */
    read: (heap, to) => heap.set(graph, to),
  };
}

/** Report the size of the memory whenever it has changed. @param {(bytes: number) => void} grown */
function sizeReport(grown) {
  let known = 0;
  return (/** @type {Uint8Array} */ heap) => {
    if (heap.length === known) return;
    known = heap.length;
    grown(known);
  };
}
