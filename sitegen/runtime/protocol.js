// What crosses the borders of the page: page.json, messages between page and workers, data frames.

/**
 * page.json, written by the generator; every path in it is relative to page.json itself.
 * @typedef {{nodes: Record<string, NodeEntry>, widgets: WidgetEntry[]}} PageEntry
 * @typedef {{
 *   package: string, executable: string, arguments: string[], autostart: boolean,
 *   builds: Partial<Record<Engine, {script: string, wasm: string}>>,
 * }} NodeEntry
 * @typedef {{kind: string, element: string, target: string, options: Record<string, any>}} WidgetEntry
 * @typedef {"jspi" | "asyncify"} Engine how a compiled node waits
 */

/**
 * What a widget is given: the nodes of the page by name.
 * @typedef {{nodes: Map<string, NodeHandle>}} Ros
 *
 * A node of the page. It emits `state` when `state` changed, `lines` (CustomEvent, detail: Line[])
 * when it printed, `clear` when its consoles should be emptied.
 * @typedef {EventTarget & {
 *   name: string, state: NodeState,
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
 * @typedef {"node" | "publisher" | "subscription"} EndpointKind
 * @typedef {{depth: number, reliable: boolean, transientLocal: boolean, keepAll: boolean}} Qos
 */

/**
 * Worker to page.
 * @typedef {{op: "running"}
 *   | {op: "create", endpoint: Endpoint}
 *   | {op: "destroy", id: number}
 *   | {op: "lines", lines: Line[]}
 *   | {op: "exit", code: number, error: string}} FromWorker
 */

/**
 * Page to worker. `match` and `unmatch` name an endpoint of the worker (`local`) and one of `peer`;
 * `peer` is the worker's own id when both live in it.
 * @typedef {{op: "start", id: number, engine: Engine, script: string, module: WebAssembly.Module,
 *     name: string, arguments: string[]}
 *   | {op: "link", peer: number, port: MessagePort}
 *   | {op: "unlink", peer: number}
 *   | {op: "match", local: number, peer: number, remote: number}
 *   | {op: "unmatch", local: number, peer: number, remote: number}
 *   | {op: "stop"}} ToWorker
 */
