// What crosses the borders of the page: page.json, messages between page and workers, data frames.

/**
 * page.json, written by the generator; every path in it is relative to page.json itself.
 * @typedef {{nodes: Record<string, NodeEntry>, widgets: WidgetEntry[],
 *   types?: Record<string, MessageType>, isolate?: string}} PageEntry with types where a widget takes part in the
 *   graph, and with the site's service worker where that is to isolate the page
 * @typedef {{
 *   package: string, executable: string, arguments: string[], autostart: boolean,
 *   builds?: Partial<Record<Engine, Program>>, python?: PythonEntry,
 *   ros2wasm?: Ros2wasmEntry,
 * }} NodeEntry with one of the last three
 * @typedef {{script: string, wasm: string, lines?: string}} Program `lines` tell where it is in its sources:
 *   see Lines in workers/cpp/stackTrace.js
 * @typedef {{bundles: string[], size: number, module: string, attribute: string, own: string[],
 *   group?: string}} PythonEntry a Python node: archives to unpack in its interpreter, how much it loads with
 *   them (bytes), and what it calls; without `attribute` the place of a program. `own` are the modules that
 *   it does not share with the other nodes of its `group`, which have the same interpreter
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
 *   keep(element: {id: string}, shape: Record<string, "string" | "boolean" | "object">,
 *     read: () => Shared, restore: (state: Shared, odd: () => void) => void): void,
 *   link(): string,
 * }} Ros where `keep` lets links carry what a widget shows: `read` gives it, what is empty stays out;
 *   `restore` is called at once with what the link of this visit says, of it only what has the `shape`,
 *   and calls `odd` for values that mean nothing; `link` is the fragment of a link to the page as it is
 * @typedef {Record<string, any>} Shared plain values by names of the widget
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
 *   endpoints(): (Endpoint & {program: string, missed: number})[],
 *   topics(): {name: string, types: string[], publishers: string[], subscriptions: string[],
 *     missed: number, mismatches: Mismatch[]}[],
 *   services(): {name: string, types: string[], servers: string[], clients: string[]}[],
 * }} GraphView
 * @typedef {{publisher: string, subscription: string, policy: Policy}} Mismatch nodes that do not hear each
 *   other, for this reason
 *
 * A message type, by its name ("std_msgs/msg/String", "std_srvs/srv/SetBool_Request"). A field's
 * type is written as in a .msg file, nested types with their whole name: "float64[3]",
 * "string<=10[<=5]", "geometry_msgs/msg/Point[]".
 * @typedef {{fields: {name: string, type: string, default?: any}[],
 *   constants: {name: string, type: string, value: any}[]}} MessageType
 *
 * A program of the page. It emits `state` when `state` changed, `lines` (CustomEvent, detail: Line[])
 * when it printed, `clear` when its consoles should be emptied. `since` is when its state began (ms
 * since 1970), `memory` what its WebAssembly has (bytes, 0 if not known). It takes what is typed, and emits
 * `reading` when `keyboard` changed, which says how it reads. A prompt emits `ready` (detail: whether a line goes
 * on) and `words` (detail: {text, words}). `interrupt` is Ctrl-C.
 * From its next start on, a Python node runs with the text that it was given by `edit` for an installed file.
 * While it loads much, it emits `progress` (detail: {loaded, total}, bytes).
 * @typedef {EventTarget & {
 *   name: string, state: NodeState, since: number, package: string, executable: string,
 *   memory: number, keyboard: Keyboard | undefined,
 *   start(): void, stop(): void, clear(): void,
 *   type(typed: Typed): void, interrupt(): void,
 *   edit(place: string, text: string | undefined): void, restart(): void,
 * }} NodeHandle
 * @typedef {"stopped" | "starting" | "running" | "stopping" | "failed"} NodeState
 *
 * One line of a console; log lines have the severity of ROS, printed ones the stream's name.
 * @typedef {{severity: Severity, text: string}} Line
 * @typedef {"debug" | "info" | "warn" | "error" | "fatal" | "stdout" | "stderr" | "typed"} Severity
 */

/**
 * An endpoint of the graph as its participant announces it; `id` is unique in that participant.
 * @typedef {{id: number, kind: EndpointKind, node: string, name: string, type: string, qos: Qos}} Endpoint
 * @typedef {(typeof KINDS)[number]} EndpointKind
 *
 * Quality of service, what a publisher offers and a subscription asks for. The last `depth` messages
 * are kept, or all. `deadline` is the longest time between messages, `lifespan` how long one is worth
 * having, `lease` how long a publisher counts as alive that must say so itself if `manual`; in ms.
 * @typedef {{depth: number, reliable: boolean, transientLocal: boolean, keepAll: boolean,
 *   deadline: number, lifespan: number, manual: boolean, lease: number}} Qos
 * @typedef {"RELIABILITY" | "LIVELINESS" | "DEADLINE" | "DURABILITY" | "TYPE"} Policy
 */

export const KINDS = /** @type {const} */ (["node", "publisher", "subscription", "service", "client"]);

/** What ROS 2 gives who does not ask for more. @type {Qos} */
export const DEFAULT_QOS = Object.freeze({
  depth: 10, reliable: true, transientLocal: false, keepAll: false,
  deadline: Infinity, lifespan: Infinity, manual: false, lease: Infinity,
});

/**
 * An endpoint of the graph as all its participants know it: `name` is unique in the page.
 * @typedef {{name: number, endpoint: Endpoint}} Neighbour
 */

/**
 * Worker to page; `missed` are the messages of a subscription that its program was too slow for. Who looks
 * is told of the graph from then on; who asks to `settle` is told when others know of what it announced before.
 * A program that begins to read the keyboard says so. A prompt is ready for a line, which may go on what was typed (`more`),
 * and answers with the words that a text may become.
 * @typedef {{op: "running"}
 *   | {op: "create", endpoint: Endpoint}
 *   | {op: "destroy", id: number}
 *   | {op: "missed", id: number, count: number}
 *   | {op: "complain", peer: number, text: string}
 *   | {op: "look"}
 *   | {op: "settle"}
 *   | {op: "lines", lines: Line[]}
 *   | {op: "progress", loaded: number, total: number}
 *   | {op: "memory", bytes: number}
 *   | {op: "reading", keyboard: Keyboard}
 *   | {op: "ready", more: boolean}
 *   | {op: "words", text: string, words: string[]}
 *   | {op: "exit", code: number, error: string}} FromWorker
 */

/**
 * Page to worker. `match` and `unmatch` name an endpoint of the worker (`local`) and one of `peer`, whose
 * quality of service is `qos`. Endpoints of one worker find each other there. `graph` says who came and
 * went elsewhere since the last time; the first says who is there.
 * @typedef {{op: "load", script: string}
 *   | {op: "start", id: number, engine: Engine, module: WebAssembly.Module, name: string,
 *     arguments: string[], lines?: string}
 *   | {op: "join"}
 *   | Interpret
 *   | {op: "adopt", id: number, name: string, program: Ros2wasmEntry}
 *   | {op: "link", peer: number, port: MessagePort}
 *   | {op: "unlink", peer: number}
 *   | {op: "match", local: number, peer: number, remote: number, qos: Qos}
 *   | {op: "unmatch", local: number, peer: number, remote: number}
 *   | {op: "incompatible", local: number, policy: Policy}
 *   | {op: "settled"}
 *   | {op: "graph", come: {peer: number, endpoint: Endpoint}[], gone: {peer: number, id: number}[]}
 *   | Typed
 *   | {op: "stop"}} ToWorker
 *
 * With `join`, a worker of Python gets a port through which one more node talks with it, until it leaves.
 * @typedef {{op: "interpret", id: number, name: string, program: PythonEntry, arguments: string[],
 *   edits: Record<string, string>, byte?: Uint8Array}} Interpret a node, with the files that its visitor changed,
 *   by their places, and a byte by which the page interrupts what its worker does
 *
 * What a visitor types: at a prompt a line, or the beginning of a word; elsewhere keys, as a terminal writes
 * them, of which none are the end of what is read.
 * @typedef {{op: "line" | "complete" | "keys", text: string}} Typed
 *
 * How a program set its terminal: it gets whole lines, and they are shown or (a password) hidden; or each key
 * at once, of which Ctrl-C is an interrupt or (raw) one like others.
 * @typedef {"lines" | "hidden" | "keys" | "raw"} Keyboard
 */

/**
 * Worker to worker, beside frames: what a reader has taken, so that its writer may send more; and that a
 * writer lives though it sends nothing. Both by the ids that they have in their workers.
 * @typedef {{op: "credit", writer: number, reader: number, records: number, bytes: number}
 *   | {op: "alive", writer: number, reader: number}} FromPeer
 */

/** Whether an endpoint is one that messages or requests go out from. @param {Endpoint} endpoint */
export function sends({ kind }) {
  return kind === "publisher" || kind === "client";
}

/**
 * The policy of which a sender offers less than a receiver asks for, or "". Of several, the one that ROS 2
 * names.
 * @param {Endpoint} sender @param {Endpoint} receiver @returns {Policy | ""}
 */
export function incompatibility({ type: sent, qos: offered }, { type: wanted, qos: requested }) {
  if (sent !== wanted) return "TYPE";
  if (requested.reliable && !offered.reliable) return "RELIABILITY";
  if ((requested.manual && !offered.manual) || requested.lease < offered.lease) return "LIVELINESS";
  if (requested.deadline < offered.deadline) return "DEADLINE";
  if (requested.transientLocal && !offered.transientLocal) return "DURABILITY";
  return "";
}

/** The name that an endpoint of a worker has in the whole page. @param {number} worker @param {number} id */
export function pageId(worker, id) {
  return worker * 2 ** 32 + id;
}

/** Worker and id of an endpoint. @param {number} name */
export function fromPageId(name) {
  return { peer: Math.floor(name / 2 ** 32), id: name % 2 ** 32 };
}

/**
 * Messages travel from worker to worker in frames: an ArrayBuffer of records, each a head and the
 * message's CDR bytes, padded to 8. All numbers are little-endian, as WebAssembly has them.
 *
 *   0  uint32   reader      id of the endpoint it is for, in the worker that receives
 *   4  uint32   writer      id of the endpoint it is from, in the worker that sends
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
 * Write the head of a record at `offset` of a frame.
 * @param {Uint8Array} frame @param {number} offset @param {Head} head @param {number} size of the message
 */
export function writeHead(frame, offset, head, size) {
  const view = new DataView(frame.buffer, frame.byteOffset + offset, HEAD_SIZE);
  view.setUint32(0, head.reader, true);
  view.setUint32(4, head.writer, true);
  view.setUint32(8, head.sequence, true);
  view.setUint32(12, size, true);
  view.setFloat64(16, head.timestamp, true);
}

/**
 * Hand out the records of a frame in order; the messages are views on the frame. Returns how many bytes
 * at the end are no records: none, unless whoever made the frame was wrong.
 * @param {ArrayBuffer} frame @param {(head: Head, message: Uint8Array) => void} deliver
 */
export function readRecords(frame, deliver) {
  const view = new DataView(frame);
  let at = 0;
  while (at + HEAD_SIZE <= frame.byteLength) {
    const size = view.getUint32(at + 12, true);
    if (at + HEAD_SIZE + size > frame.byteLength) break;
    const head = {
      reader: view.getUint32(at, true),
      writer: view.getUint32(at + 4, true),
      sequence: view.getUint32(at + 8, true),
      timestamp: view.getFloat64(at + 16, true),
    };
    deliver(head, new Uint8Array(frame, at + HEAD_SIZE, size));
    at += recordSize(size);
  }
  return Math.max(0, frame.byteLength - at);
}

// Asking the browser once is enough, and half of the cost of a time stamp.
const ORIGIN = performance.timeOrigin;

/** Milliseconds since 1970 with fractions, comparable between the workers of a page. */
export function now() {
  return ORIGIN + performance.now();
}
