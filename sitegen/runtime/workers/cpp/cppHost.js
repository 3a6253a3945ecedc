// @ts-check
// The host functions of clients/cpp/include/rclcpp/detail/host.h, between WebAssembly's memory and
// the worker's participant. `heap` is a view on that memory, fresh with every call.

import { place } from "../../place.js";
import { KINDS, now } from "../../protocol.js";

/** @import { Neighbour, Policy, Qos, Severity } from "../../protocol.js" */
/** @import { EventKind } from "../../participant/status.js" */
/** @import { Participant } from "../../participant/participant.js" */
/** @import { Printer } from "../printer.js" */

const RELIABLE = 1;
const TRANSIENT_LOCAL = 2;
const KEEP_ALL = 4;
const MANUAL = 8;
/** Size of a ros_entry. */
const ENTRY = 48;
/** So many exceptions may be on their way. */
const REMEMBERED = 100;
/** @type {EventKind[]} */
const EVENTS = ["deadline", "liveliness", "incompatible", "matched", "lost", "type"];
/** As rmw numbers them. @type {Partial<Record<Policy, number>>} */
const POLICIES = { DURABILITY: 2, DEADLINE: 4, LIVELINESS: 8, RELIABILITY: 16 };
/** @type {Record<number, Severity>} */
const SEVERITIES = { 10: "debug", 20: "info", 30: "warn", 40: "error", 50: "fatal" };

/**
 * @param {Participant} participant
 * @param {Printer} printer
 * @param {string[]} args the command line, the program's name first
 * @param {(error: string, stack: string) => void} fail called with the text of an exception that left main(),
 *   and with the stack where it was thrown, if that is known
 * @param {(error: unknown) => void} ended called with what a suspended program ended by
 * @param {(bytes: number) => void} grown called with the size of its memory when that changed
 */
export function cppHost(participant, printer, args, fail, ended, grown) {
  const decoder = new TextDecoder();
  const words = args.map((word) => new TextEncoder().encode(word));

  /** @param {Uint8Array} heap @param {number} pointer */
  const text = (heap, pointer) => decoder.decode(heap.subarray(pointer, heap.indexOf(0, pointer)));

  /** @type {typeof import("../../messages/filter/contentFilter.js") | undefined} */
  let filters;
  /** Why they could not be loaded. @type {unknown} */
  let lack;
  /** Where exceptions were thrown, by their addresses: of programs built with --debug. @type {Map<number, string>} */
  const thrown = new Map();
  let blamed = "";
  let known = 0;
  let described = new Uint8Array();
  /** @param {Uint8Array} heap */
  const noteSize = (heap) => {
    if (heap.length === known) return;
    known = heap.length;
    grown(known);
  };

  return {
    /**
     * @param {Uint8Array} heap @param {number} kind @param {number} node @param {number} name
     * @param {number} type @param {number} qos
     */
    create(heap, kind, node, name, type, qos) {
      noteSize(heap);
      return participant.create(
        KINDS[kind] ?? "node", text(heap, node), text(heap, name), text(heap, type), readQos(heap, qos));
    },
    /** @param {number} id */
    destroy: (id) => participant.destroy(id),
    /** @param {number} id */
    name: (id) => participant.nameOf(id),
    /** @param {Uint8Array} heap @param {number} id @param {number} data @param {number} size */
    publish: (heap, id, data, size) => Number(participant.publish(id, heap.subarray(data, data + size))),
    /**
     * @param {Uint8Array} heap @param {number} id @param {number} definition @param {number} expression
     * @param {number} parameters @param {number} count @param {number} to @param {number} capacity
     */
    filter(heap, id, definition, expression, parameters, count, to, capacity) {
      const given = [];
      for (let at = parameters; given.length < count; at = heap.indexOf(0, at) + 1) given.push(text(heap, at));
      try {
        const rule = text(heap, expression);
        if (rule && !filters) {
          // Few programs have filters: the others need not load what makes them.
          if (lack) throw lack;
          import(place("messages/filter/contentFilter.js")).then(
            (module) => { filters = module; },
            (error) => { lack = error; },
          ).finally(() => participant.wake());
          return -1;
        }
        participant.filter(id, rule ? filters?.contentFilter(text(heap, definition), rule, given) : undefined);
        return 0;
      } catch (error) {
        const why = new TextEncoder().encode(/** @type {Error} */ (error).message).subarray(0, capacity);
        heap.set(why, to);
        return why.length;
      }
    },
    /** @param {number} id */
    behind: (id) => Number(participant.behind(id)),
    /** @param {number} id */
    assert: (id) => participant.assertLiveliness(id),
    events: () => participant.events,
    /** @param {Uint8Array} heap @param {number} id @param {number} kind @param {number} to */
    takeEvent(heap, id, kind, to) {
      const event = participant.takeEvent(id, EVENTS[kind] ?? "deadline");
      if (!event) return 0;
      const { total, totalChange, current, currentChange, policy } = event;
      const number = policy && policy !== "TYPE" ? POLICIES[policy] ?? 0 : 0;
      new Int32Array(heap.buffer, to, 5).set([total, totalChange, current, currentChange, number]);
      return 1;
    },
    /** @param {Uint8Array} heap @param {number} id @param {number} data @param {number} size */
    request: (heap, id, data, size) => participant.request(id, heap.subarray(data, data + size)),
    /**
     * @param {Uint8Array} heap @param {number} id @param {number} client @param {number} sequence
     * @param {number} data @param {number} size
     */
    respond(heap, id, client, sequence, data, size) {
      // WebAssembly has no unsigned numbers: those of the upper half arrive negative.
      participant.respond(id, client, sequence >>> 0, heap.subarray(data, data + size));
    },
    /** @param {number} id */
    matched: (id) => participant.matched(id),
    /** @param {Uint8Array} heap @param {number} id @param {number} info */
    next(heap, id, info) {
      noteSize(heap);
      const sample = participant.next(id);
      if (!sample) return -1;
      const view = new DataView(heap.buffer, info);
      view.setFloat64(0, sample.timestamp, true);
      view.setFloat64(8, sample.received, true);
      view.setFloat64(16, sample.writer, true);
      view.setUint32(24, sample.sequence, true);
      return sample.message.length;
    },
    /** @param {Uint8Array} heap @param {number} id @param {number} to */
    take(heap, id, to) {
      const sample = participant.take(id);
      if (sample && to) heap.set(sample.message, to);
    },
    changes() {
      participant.look();
      return participant.changes;
    },
    look() {
      const neighbours = participant.look();
      if (!neighbours) return -1;
      described = describe(neighbours);
      return described.length;
    },
    /** @param {Uint8Array} heap @param {number} to */
    read: (heap, to) => heap.set(described, to),
    /** @param {number} milliseconds */
    wait(milliseconds) {
      printer.flush();
      return participant.wait(milliseconds);
    },
    wake: () => participant.wake(),
    now,
    /**
     * @param {Uint8Array} heap @param {number} severity @param {number} logger @param {number} line
     * @param {number} [stamp] missing in programs compiled by an older sitegen
     */
    log(heap, severity, logger, line, stamp = now()) {
      printer.log(SEVERITIES[severity] ?? "info", text(heap, logger), text(heap, line), stamp);
    },
    /** @param {Uint8Array} heap @param {number} index @param {number} to @param {number} capacity */
    argument(heap, index, to, capacity) {
      const word = words[index];
      if (!word) return -1;
      if (to) heap.set(word.subarray(0, capacity), to);
      return word.length;
    },
    /** @param {Uint8Array} heap @param {number} message */
    fail: (heap, message) => fail(text(heap, message), blamed),
    /** @param {number} exception its address */
    thrown(exception) {
      thrown.delete(exception);
      thrown.set(exception, new Error().stack ?? "");
      for (const oldest of thrown.keys()) {
        if (thrown.size <= REMEMBERED) break;
        thrown.delete(oldest);
      }
    },
    /** @param {number} exception */
    blame(exception) {
      blamed = thrown.get(exception) ?? "";
    },
    ended,
  };
}

/** As host.h has it: a ros_entry for each, with its texts behind it. @param {Neighbour[]} neighbours */
function describe(neighbours) {
  const encoder = new TextEncoder();
  const all = neighbours.map(({ name, endpoint }) => {
    const texts = encoder.encode(`${endpoint.node}\0${endpoint.name}\0${endpoint.type}\0`);
    return { name, endpoint, texts, size: Math.ceil((ENTRY + texts.length) / 8) * 8 };
  });
  const bytes = new Uint8Array(all.reduce((sum, { size }) => sum + size, 0));
  const view = new DataView(bytes.buffer);
  let at = 0;
  for (const { name, endpoint, texts, size } of all) {
    view.setFloat64(at, name, true);
    if (endpoint.qos) writeQos(view, at + 8, endpoint.qos);
    view.setInt32(at + 40, KINDS.indexOf(endpoint.kind), true);
    view.setInt32(at + 44, size, true);
    bytes.set(texts, at + ENTRY);
    at += size;
  }
  return bytes;
}

/** @param {DataView} view @param {number} at @param {Qos} qos */
function writeQos(view, at, qos) {
  view.setFloat64(at, qos.deadline, true);
  view.setFloat64(at + 8, qos.lifespan, true);
  view.setFloat64(at + 16, qos.lease, true);
  view.setInt32(at + 24, qos.depth, true);
  const flags = (qos.reliable ? RELIABLE : 0) | (qos.transientLocal ? TRANSIENT_LOCAL : 0) |
    (qos.keepAll ? KEEP_ALL : 0) | (qos.manual ? MANUAL : 0);
  view.setInt32(at + 28, flags, true);
}

/** @param {Uint8Array} heap @param {number} pointer to a ros_qos */
function readQos(heap, pointer) {
  const view = new DataView(heap.buffer, pointer);
  const flags = view.getInt32(28, true);
  return {
    deadline: view.getFloat64(0, true),
    lifespan: view.getFloat64(8, true),
    lease: view.getFloat64(16, true),
    depth: view.getInt32(24, true),
    reliable: (flags & RELIABLE) !== 0,
    transientLocal: (flags & TRANSIENT_LOCAL) !== 0,
    keepAll: (flags & KEEP_ALL) !== 0,
    manual: (flags & MANUAL) !== 0,
  };
}
