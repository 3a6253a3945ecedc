// The types of page.json, of the messages between page and workers, and of the frames between workers.

/**
 * page.json, written by the generator; every path in it is relative to page.json itself.
 * @typedef {{nodes: Record<string, NodeEntry>, widgets: WidgetEntry[],
 *   types?: Record<string, MessageType>, startFromLinks?: string[], isolate?: string,
 *   launch?: Launch, scripts?: {file: string, module: string}[], interfaces?: string,
 *   texts?: string, messagesFrom?: string[]}} PageEntry `types` if a widget or a script
 *   takes part in the graph; `interfaces` are the definitions of all others, `texts` the files that define them, and
 *   `messagesFrom` the origins of pages that may use the graph; shared links start the nodes in `startFromLinks` without asking;
 *   `isolate` is the site's service worker, if that isolates the page
 * @typedef {{package: string, file: string, nodes: string[], first?: string[], handlers?: LaunchHandler[],
 *   asked?: string[], arguments?: LaunchArgument[],
 *   again?: {reader: string, files: string, path: string, given: Record<string, string>,
 *   environment: Record<string, string>}}} Launch the launch file that
 *   starts these nodes, and those in `first` at once if not all of them; those in `asked` only start when the visitor
 *   says so. What reads it `again` is in two archives; `given` are the arguments that the author gives,
 *   and `environment` the variables
 * @typedef {{name: string, default?: string, description?: string, choices?: string[]}} LaunchArgument
 * @typedef {{on: LaunchEvent, effects: LaunchEffect[], most?: number}} LaunchHandler what a launch file does at an event,
 *   up to `most` times; see model/launch.py, which has the meaning of all fields
 * @typedef {{kind: "launched" | "time" | "started" | "exited" | "ended" | "state" | "shutdown", nodes?: string[],
 *   after?: number, ros_time?: boolean, transition?: string, start_state?: string, goal_state?: string}} LaunchEvent
 * @typedef {{kind: "start" | "stop" | "shutdown" | "transition" | "log" | "handle", nodes?: string[], text?: string,
 *   level?: string, ids?: number[], handler?: LaunchHandler}} LaunchEffect
 * @typedef {{
 *   package: string, executable: string, arguments: string[], environment?: Record<string, string>,
 *   autostart: boolean, later?: boolean, needs?: string[], share?: string,
 *   builds?: Partial<Record<Engine, Program>>, python?: PythonEntry,
 *   ros2wasm?: Ros2wasmEntry, javascript?: JavascriptEntry, foreign?: boolean, fault?: string,
 * }} NodeEntry with one of `builds`, `python`, `ros2wasm`, `javascript` and `fault`, which says why there is no program;
 *   `foreign` if it is from an archive, or runs code of visitors or of links; `needs` names nodes without which it only
 *   waits, and with `later` the launch file starts it by itself; `share` lists the files of packages that a compiled
 *   program can open: see Listing in workers/cpp/packageFiles.js
 * @typedef {{script: string, wasm: string, lines?: string}} Program `lines` maps the program to its sources:
 *   see Lines in workers/cpp/stackTrace.js
 * @typedef {{bundles: string[], size: number, module: string, attribute: string, own: string[],
 *   group?: string}} PythonEntry a Python node: archives to unpack, the size of the download with them (bytes), and
 *   the function to call; without `attribute`, `module` is the path of a script. The nodes of a `group` share an
 *   interpreter, but not their `own` modules
 * @typedef {{script: string, topics: Record<string, string>, types: Record<string, MessageType>}} Ros2wasmEntry
 *   a node that the ROS2WASM project compiled: its worker script, the types of its topics and services, and the
 *   definitions of these types
 * @typedef {{text: string, imports: ModuleImport[], interfaces: string}} JavascriptEntry a program in JavaScript, which
 *   came as text, such as a cell: a module, what it imports, and the address of the definitions of all interfaces
 * @typedef {{from: number, to: number, file: string}} ModuleImport what a text names from one place to another, quotes
 *   included: a file of the runtime. They are in the order of the text
 * @typedef {{kind: string, element: string, target: string, options: Record<string, any>}} WidgetEntry
 * @typedef {"jspi" | "asyncify"} Engine how a compiled node is suspended
 */

/**
 * The ROS API of the page, for widgets and for scripts of the page.
 * @typedef {{
 *   own?: string,
 *   nodes: Map<string, NodeHandle>,
 *   graph: GraphView,
 *   types: Record<string, MessageType>,
 *   launch?: Launch,
 *   subscribe(topic: string, type: string, callback: (message: any, info: MessageInfo) => void,
 *     qos?: Partial<Qos>): () => void,
 *   subscribeBytes(topic: string, type: string,
 *     callback: (message: Uint8Array, info: MessageInfo) => void, qos?: Partial<Qos>): () => void,
 *   advertise(topic: string, type: string, qos?: Partial<Qos>): Publisher,
 *   call(service: string, type: string, request: any, timeout?: number, signal?: AbortSignal): Promise<any>,
 *   serve(service: string, type: string, answer: (request: any) => any): () => void,
 *   node(name: string): PageNode,
 *   keep(element: {id: string}, shape: Record<string, "string" | "boolean" | "number" | "object">,
 *     read: () => Shared, restore: (state: Shared, odd: () => void) => void | Promise<void>): void,
 *   link(): string,
 *   run(program: string | {package: string, executable: string} | NodeEntry & {javascript: object},
 *     options?: {arguments?: string[], name?: string, environment?: Record<string, string>}): NodeHandle,
 *   join(file: string, told: (message: any) => void, failed: (error: string) => void): Companion,
 * }} Ros `own` is the name of the hidden node, if it is not the page's. `run` starts a program of the page once more, as
 *   a new process, which is gone when it ends; `program` is the name of a node, its package and executable, or an entry
 *   that is a text. `join` starts a worker of the runtime that takes part in the graph, and calls `told` with what it
 *   tells the page. `keep` makes the state of a widget part of shared links. `read`
 *   returns that state; empty values are left out. If the visitor came by a shared link, `restore` is called immediately
 *   with the values that have the `shape`; it calls `odd` for values that it cannot use. `link` returns the fragment of
 *   a link to the present state
 * @typedef {Pick<Ros, "types" | "subscribe" | "subscribeBytes" | "advertise" | "call" | "serve"> &
 *   {read(type: string, bytes: Uint8Array): any, leave(): void}} PageNode another node of the page in the graph; what it
 *   has there is gone when it leaves
 * @typedef {Record<string, any>} Shared the state of a widget, as JSON
 *
 * Messages are plain objects with the field names of ROS. 64-bit integers are BigInt, arrays of numbers are typed
 * arrays, and all other values are as in JSON.
 * @typedef {{publish(message: any): void, close(): void}} Publisher
 * @typedef {{size: number, sequence: number, timestamp: number, received: number, writer: number}} MessageInfo
 *   size in bytes, sequence number of the writer, the times of sending and arrival (ms since 1970), and the gid of the
 *   writer
 *
 * A worker that is part of the page, such as the player of a bag.
 * @typedef {{tell(message: any, transfer?: Transferable[]): void, leave(): void}} Companion
 *
 * The ROS graph. Emits `change` once after all changes of one task. The `program` of an endpoint is the name of its
 * NodeHandle, empty for the page's own endpoints.
 * @typedef {EventTarget & {
 *   nodes(): string[],
 *   endpoints(): (Endpoint & {gid: number, program: string, missed: number})[],
 *   topics(): {name: string, types: string[], publishers: string[], subscriptions: string[],
 *     missed: number, mismatches: Mismatch[]}[],
 *   services(): {name: string, types: string[], servers: string[], clients: string[]}[],
 * }} GraphView
 * @typedef {{publisher: string, subscription: string, policy: Policy}} Mismatch nodes whose endpoints are
 *   incompatible, and the reason
 *
 * The definition of a message type ("std_msgs/msg/String", "std_srvs/srv/SetBool_Request"). The types of fields are
 * written as in .msg files, with the full names of nested types: "float64[3]", "string<=10[<=5]",
 * "geometry_msgs/msg/Point[]"; a `byte` is an "uint8" with `octet`. Defaults and constants are as in JSON; 64-bit
 * integers are decimal texts.
 * @typedef {{fields: {name: string, type: string, octet?: boolean, default?: any}[],
 *   constants: {name: string, type: string, value: any}[]}} MessageType
 *
 * A program of the page. `arguments` are those of its next start, which `override` replaces if the program is
 * `configurable`. `code` is the exit code of its last run (undefined if it was terminated), `since` the time of its last
 * change of state (ms since 1970), and `memory` the size of its WebAssembly memory (bytes, 0 if unknown). `keyboard` says
 * how it reads its standard input, `needs` names the nodes without which it only waits, `type` sends it input, and
 * `interrupt` is Ctrl-C. `edit` replaces the text of an installed file of a Python node from its next start on; `check`
 * asks the interpreter of a running one for syntax errors.
 *
 * Events: `state` and `reading` after changes of `state` and `keyboard`; `lines` (detail: Line[]) for output; `clear`
 * when its consoles must be cleared; `progress` (detail: {loaded, total}, bytes) during long downloads; `checked`
 * (detail: Checked) after `check`. A prompt also emits `ready` (detail: whether the next line continues the last) and
 * `words` (detail: {text, words}, completions); the kernel of a notebook emits `answer` (detail: {text}, in JSON).
 * @typedef {EventTarget & {
 *   name: string, state: NodeState, since: number, package: string, executable: string,
 *   memory: number, keyboard: Keyboard | undefined, needs: string[], arguments: string[],
 *   configurable: boolean, code: number | undefined,
 *   start(): void, stop(): void, clear(): void,
 *   type(typed: Typed): void, interrupt(): void,
 *   override(words: string[] | undefined): void,
 *   edit(place: string, text: string | undefined): void, restart(): void, check(text: string): void,
 * }} NodeHandle
 * @typedef {"stopped" | "starting" | "running" | "stopping" | "failed"} NodeState
 *
 * A line of a console, with the severity of a log message or the name of the stream.
 * @typedef {{severity: Severity, text: string}} Line
 * @typedef {"debug" | "info" | "warn" | "error" | "fatal" | "stdout" | "stderr" | "typed"} Severity
 */

/**
 * An endpoint of the graph, as its participant announces it. Its `id` is unique in that participant.
 * @typedef {{id: number, kind: EndpointKind, node: string, name: string, type: string, qos: Qos}} Endpoint
 * @typedef {(typeof KINDS)[number]} EndpointKind
 *
 * The quality of service that a publisher offers or a subscription requests. The history is the last `depth` messages,
 * or all with `keepAll`. `deadline` is the longest time between messages, `lifespan` the time after which a message
 * expires, and `lease` that of liveliness, which the publisher must assert itself if it is `manual`. Times are in ms.
 * @typedef {{depth: number, reliable: boolean, transientLocal: boolean, keepAll: boolean,
 *   deadline: number, lifespan: number, manual: boolean, lease: number}} Qos
 * @typedef {"RELIABILITY" | "LIVELINESS" | "DEADLINE" | "DURABILITY" | "TYPE"} Policy
 */

export const KINDS = /** @type {const} */ (["node", "publisher", "subscription", "service", "client"]);

/** The default profile of ROS 2. @type {Qos} */
export const DEFAULT_QOS = Object.freeze({
  depth: 10, reliable: true, transientLocal: false, keepAll: false,
  deadline: Infinity, lifespan: Infinity, manual: false, lease: Infinity,
});

/** That of /rosout: latecomers receive the latest lines. */
export const ROSOUT_QOS = { depth: 1000, reliable: true, transientLocal: true };

/**
 * An endpoint of the graph as all participants know it; its `gid` is unique in the page.
 * @typedef {{gid: number, endpoint: Endpoint}} Neighbour
 */

/**
 * From worker to page. docs/protocol.md explains each message.
 * @typedef {{op: "running"}
 *   | {op: "create", endpoint: Endpoint}
 *   | {op: "destroy", id: number}
 *   | {op: "missed", id: number, count: number}
 *   | {op: "complain", peer: number, what: Refusal, count: number}
 *   | {op: "look"}
 *   | {op: "settle"}
 *   | {op: "lines", lines: Line[]}
 *   | {op: "progress", loaded: number, total: number}
 *   | {op: "memory", bytes: number}
 *   | {op: "reading", keyboard: Keyboard}
 *   | {op: "ready", more: boolean}
 *   | {op: "answer", text: string}
 *   | {op: "words", text: string, words: string[]}
 *   | {op: "checked"} & Checked
 *   | {op: "tell", message: any}
 *   | {op: "exit", code: number, error: string}} FromWorker
 *
 * The first syntax error in a source text, as Python describes it. The line is 0 if there is none.
 * @typedef {{text: string, line: number, error: string}} Checked
 */

/**
 * What a worker refuses to take from another one; see REFUSALS in page/reports.js.
 * @typedef {"frame" | "large" | "unmatched" | "overrun" | "response" | "news"} Refusal
 */

/**
 * From page to worker. docs/protocol.md explains each message.
 * @typedef {{op: "load", script: string}
 *   | {op: "start", id: number, engine: Engine, module: WebAssembly.Module, name: string,
 *     arguments: string[], environment?: Record<string, string>, lines?: string, share?: string}
 *   | {op: "join"}
 *   | Interpret
 *   | {op: "adopt", id: number, name: string, program: Ros2wasmEntry}
 *   | {op: "evaluate", id: number, name: string, program: JavascriptEntry}
 *   | {op: "link", peer: number, port: MessagePort}
 *   | {op: "unlink", peer: number}
 *   | {op: "match", local: number, peer: number, remote: number, qos: Qos}
 *   | {op: "unmatch", local: number, peer: number, remote: number}
 *   | {op: "incompatible", local: number, policy: Policy}
 *   | {op: "settled"}
 *   | {op: "graph", come: {peer: number, endpoint: Endpoint}[], gone: {peer: number, id: number}[]}
 *   | Typed
 *   | {op: "check", text: string}
 *   | {op: "enter", id: number}
 *   | {op: "tell", message: any}
 *   | {op: "stop"}} ToWorker
 *
 * @typedef {{op: "interpret", id: number, name: string, program: PythonEntry, arguments: string[],
 *   environment?: Record<string, string>,
 *   edits: Record<string, string>, byte?: Uint8Array}} Interpret run a Python node. `edits` are the files that the
 *   visitor has changed, by path; with `byte`, in shared memory, the page interrupts the program
 *
 * Input of the visitor: at a prompt, a line or a text to complete; to a notebook's kernel, a request in JSON; elsewhere
 * keys, as the characters that a terminal sends. Empty keys are the end of the input.
 * @typedef {{op: "line" | "complete" | "ask" | "keys", text: string}} Typed
 *
 * How a program has configured its terminal: for whole lines, echoed or `hidden`, or for single keys. Ctrl-C is an
 * interrupt, except with `raw`, where it is a key like others.
 * @typedef {"lines" | "hidden" | "keys" | "raw"} Keyboard
 */

/**
 * From worker to worker, besides frames: a reader gives credits for what it took, and a publisher asserts its
 * liveliness. `writer` and `reader` are ids of endpoints in their own workers.
 * @typedef {{op: "credit", writer: number, reader: number, records: number, bytes: number}
 *   | {op: "alive", writer: number, reader: number}} FromPeer
 */

/** Whether an endpoint sends messages or requests. @param {Endpoint} endpoint */
export function sends({ kind }) {
  return kind === "publisher" || kind === "client";
}

/**
 * Return the first policy that makes a sender and a receiver incompatible, in the order of ROS 2, or "".
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

/** Return the gid of an endpoint, from its id in its worker. @param {number} worker @param {number} id */
export function gidOf(worker, id) {
  return worker * 2 ** 32 + id;
}

/** Return the worker of an endpoint, and its id there. @param {number} gid */
export function splitGid(gid) {
  return { peer: Math.floor(gid / 2 ** 32), id: gid % 2 ** 32 };
}

/**
 * Messages travel from worker to worker in frames. A frame is an ArrayBuffer of records; a record is a head and the
 * message in CDR, padded to a multiple of 8 bytes. All numbers are little-endian, as in WebAssembly.
 *
 *   0  uint32   reader      id of the receiving endpoint, in its worker
 *   4  uint32   writer      id of the sending endpoint, in its worker
 *   8  uint32   sequence    of this writer, from 1; in a response, of the request
 *   12 uint32   size        of the message in bytes
 *   16 float64  timestamp   of sending, ms since 1970
 * @typedef {{reader: number, writer: number, sequence: number, timestamp: number}} Head
 */
export const HEAD_SIZE = 24;

/** Return the size of a record, for a message of `size` bytes. @param {number} size */
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

/** Whether a frame is exactly one record. @param {ArrayBuffer} frame */
export function isRecord(frame) {
  const size = HEAD_SIZE + new DataView(frame).getUint32(12, true);
  return frame.byteLength >= size && frame.byteLength - size < 8;
}

/**
 * Call `deliver` for each record of a frame, in order, with a message that is a view of the frame. Return the number of
 * bytes after the last valid record, 0 if the frame is valid.
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

// Read only once, because that is half of the cost of a time stamp.
const ORIGIN = performance.timeOrigin;

/** Return the time in ms since 1970, with fractions, comparable between the workers of a page. */
export function now() {
  return ORIGIN + performance.now();
}
