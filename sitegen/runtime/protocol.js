// What crosses the borders of the page: page.json, messages between page and workers, data frames.

/**
 * page.json, written by the generator; every path in it is relative to page.json itself.
 * @typedef {{nodes: Record<string, NodeEntry>, widgets: WidgetEntry[],
 *   types?: Record<string, MessageType>}} PageEntry with types where a widget takes part in the graph
 * @typedef {{
 *   package: string, executable: string, arguments: string[], autostart: boolean,
 *   builds?: Partial<Record<Engine, {script: string, wasm: string}>>, ros2wasm?: Ros2wasmEntry,
 * }} NodeEntry with one of the last two
 * @typedef {{script: string, topics: Record<string, string>, types: Record<string, MessageType>}} Ros2wasmEntry
 *   a node that the ROS2WASM project compiled: its worker script, what its topics and services carry,
 *   and the definitions of these
 * @typedef {{kind: string, element: string, target: string, options: Record<string, any>}} WidgetEntry
 * @typedef {"jspi" | "asyncify"} Engine how a compiled node waits
 */

/**
 * What a widget is given: the page's ROS.
 * @typedef {{
 *   nodes: Map<string, NodeHandle>,
 *   graph: GraphView,
 *   types: Record<string, MessageType>,
 *   subscribe(topic: string, type: string, callback: (message: any, info: MessageInfo) => void,
 *     qos?: Partial<Qos>): () => void,
 *   subscribeBytes(topic: string, type: string,
 *     callback: (message: Uint8Array, info: MessageInfo) => void, qos?: Partial<Qos>): () => void,
 *   advertise(topic: string, type: string, qos?: Partial<Qos>): Publisher,
 *   call(service: string, type: string, request: any, timeout?: number): Promise<any>,
 * }} Ros
 *
 * Messages are plain objects with the field names of ROS. 64-bit integers are BigInt, sequences of
 * numbers are typed arrays, all else is what JSON has.
 * @typedef {{publish(message: any): void, close(): void}} Publisher
 * @typedef {{size: number, sequence: number, timestamp: number, received: number}} MessageInfo
 *   bytes, number of this writer's message, and the times (ms since 1970) it was sent and arrived
 *
 * Who is in the graph; emits `change` after changes, those of one moment together. The `program` of an
 * endpoint is the name of its NodeHandle, empty for the page's own.
 * @typedef {EventTarget & {
 *   nodes(): string[],
 *   endpoints(): (Endpoint & {program: string})[],
 *   topics(): {name: string, types: string[], publishers: string[], subscriptions: string[]}[],
 *   services(): {name: string, types: string[], servers: string[], clients: string[]}[],
 * }} GraphView
 *
 * A message type, by its name ("std_msgs/msg/String", "std_srvs/srv/SetBool_Request"). A field's
 * type is written as in a .msg file, nested types with their whole name: "float64[3]",
 * "string<=10[<=5]", "geometry_msgs/msg/Point[]".
 * @typedef {{fields: {name: string, type: string, default?: any}[],
 *   constants: {name: string, type: string, value: any}[]}} MessageType
 *
 * A program of the page. It emits `state` when `state` changed, `lines` (CustomEvent, detail: Line[])
 * when it printed, `clear` when its consoles should be emptied. `since` is when its state began (ms
 * since 1970), `memory` what its WebAssembly has (bytes, 0 if not known).
 * @typedef {EventTarget & {
 *   name: string, state: NodeState, since: number, package: string, executable: string,
 *   memory: number,
 *   start(): void, stop(): void, clear(): void,
 * }} NodeHandle
 * @typedef {"stopped" | "starting" | "running" | "stopping" | "failed"} NodeState
 *
 * One line of a console; log lines have the severity of ROS, printed ones the stream's name.
 * @typedef {{severity: Severity, text: string}} Line
 * @typedef {"debug" | "info" | "warn" | "error" | "fatal" | "stdout" | "stderr"} Severity
 */

/**
 * An endpoint of the graph as its participant announces it; `id` is unique in that participant.
 * @typedef {{id: number, kind: EndpointKind, node: string, name: string, type: string, qos: Qos}} Endpoint
 * @typedef {"node" | "publisher" | "subscription" | "service" | "client"} EndpointKind
 * @typedef {{depth: number, reliable: boolean, transientLocal: boolean, keepAll: boolean}} Qos
 */

/**
 * Worker to page.
 * @typedef {{op: "running"}
 *   | {op: "create", endpoint: Endpoint}
 *   | {op: "destroy", id: number}
 *   | {op: "lines", lines: Line[]}
 *   | {op: "memory", bytes: number}
 *   | {op: "exit", code: number, error: string}} FromWorker
 */

/**
 * Page to worker. `match` and `unmatch` name an endpoint of the worker (`local`) and one of `peer`;
 * a `durable` match is one of transient local endpoints, and begins with what the publisher keeps.
 * Endpoints of one worker find each other there.
 * @typedef {{op: "load", script: string}
 *   | {op: "start", id: number, engine: Engine, module: WebAssembly.Module, name: string,
 *     arguments: string[]}
 *   | {op: "adopt", id: number, name: string, program: Ros2wasmEntry}
 *   | {op: "link", peer: number, port: MessagePort}
 *   | {op: "unlink", peer: number}
 *   | {op: "match", local: number, peer: number, remote: number, durable: boolean}
 *   | {op: "unmatch", local: number, peer: number, remote: number}
 *   | {op: "incompatible", local: number, policy: string}
 *   | {op: "stop"}} ToWorker
 */

/** Whether an endpoint is one that messages or requests go out from. @param {Endpoint} endpoint */
export function sends({ kind }) {
  return kind === "publisher" || kind === "client";
}

/**
 * The policy of which a sender offers less than a receiver asks for, or "".
 * @param {Endpoint} sender @param {Endpoint} receiver
 */
export function incompatibility({ qos: offered }, { qos: requested }) {
  if (requested.reliable && !offered.reliable) return "RELIABILITY_QOS_POLICY";
  if (requested.transientLocal && !offered.transientLocal) return "DURABILITY_QOS_POLICY";
  return "";
}

/** The name that an endpoint of a worker has in the whole page. @param {number} worker @param {number} id */
export function pageId(worker, id) {
  return worker * 0x10000 + id;
}

/** Worker and id of an endpoint. @param {number} name */
export function fromPageId(name) {
  return { peer: Math.floor(name / 0x10000), id: name % 0x10000 };
}

/**
 * Messages travel from worker to worker in frames: an ArrayBuffer of records, each a head and the
 * message's CDR bytes, padded to 8. All numbers are little-endian, as WebAssembly has them.
 *
 *   0  uint32   reader      id of the endpoint it is for, in the worker that receives
 *   4  uint32   writer      the endpoint it is from, unique in the page
 *   8  uint32   sequence    of this writer, from 1; a response has that of its request
 *   12 uint32   size        of the message in bytes
 *   16 float64  timestamp   when it was sent, ms since 1970
 * @typedef {{reader: number, writer: number, sequence: number, timestamp: number}} Head
 */
export const HEAD_SIZE = 24;

/** Bytes that a record with a message of `size` bytes takes in a frame. @param {number} size */
export function recordSize(size) {
  return HEAD_SIZE + ((size + 7) & ~7);
}

/**
 * Write a record at `offset` of a frame.
 * @param {Uint8Array} frame @param {number} offset @param {Head} head @param {Uint8Array} message
 */
export function writeRecord(frame, offset, head, message) {
  const view = new DataView(frame.buffer, frame.byteOffset + offset, HEAD_SIZE);
  view.setUint32(0, head.reader, true);
  view.setUint32(4, head.writer, true);
  view.setUint32(8, head.sequence, true);
  view.setUint32(12, message.length, true);
  view.setFloat64(16, head.timestamp, true);
  frame.set(message, offset + HEAD_SIZE);
}

/**
 * The records of a frame in order. The messages are views on the frame.
 * @param {ArrayBuffer} frame @returns {Generator<Head & {message: Uint8Array}>}
 */
export function* readRecords(frame) {
  const view = new DataView(frame);
  for (let at = 0; at + HEAD_SIZE <= frame.byteLength;) {
    const size = view.getUint32(at + 12, true);
    yield {
      reader: view.getUint32(at, true),
      writer: view.getUint32(at + 4, true),
      sequence: view.getUint32(at + 8, true),
      timestamp: view.getFloat64(at + 16, true),
      message: new Uint8Array(frame, at + HEAD_SIZE, size),
    };
    at += recordSize(size);
  }
}

// Asking the browser once is enough, and half of the cost of a time stamp.
const ORIGIN = performance.timeOrigin;

/** Milliseconds since 1970 with fractions, comparable between the workers of a page. */
export function now() {
  return ORIGIN + performance.now();
}
