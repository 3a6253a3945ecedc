// Written by `sitegen types`: what a panel of this site can use. `sitegen serve` writes it again when that changes.
//
// In a panel:  /** @type {import("./ros").Mount} */
//              export const mount = (element, ros, options) => { … };

/**
 * Show the panel in `element`, which is empty. `options` are those in site.yaml.
 *
 * Return a function that removes what the page does not know, such as timers; it is called when the panel is removed.
 * Subscriptions and publishers end by themselves.
 */
export type Mount<Options = Record<string, any>> = (
  element: HTMLElement, ros: Ros, options: Options,
) => void | (() => void) | Promise<void | (() => void)>;

/** The ROS graph of the page. */
export interface Ros {
  /**
   * Call `callback` with each message of a topic while the panel is visible, or, with `always`, as long as it exists.
   * Return a function that ends the subscription.
   */
  subscribe<Type extends keyof Messages>(topic: string, type: Type,
    callback: (message: Messages[Type], info: MessageInfo) => void,
    qos?: Partial<Qos> & { always?: boolean }): () => void;
  /** Create a publisher. Missing fields of messages are zero. */
  advertise<Type extends keyof Messages>(topic: string, type: Type, qos?: Partial<Qos>): Publisher<Messages[Type]>;
  /** Call a service. It rejects if no server is there, or none answers within `timeout` ms (5000). */
  call<Type extends keyof Services>(service: string, type: Type, request: Sent<Services[Type]["request"]>,
    timeout?: number): Promise<Services[Type]["response"]>;
  /**
   * Make the state of the panel part of shared links. `shape` names its keys and their types; `read` returns the state,
   * and `restore` is called at once if the visitor came by such a link. It calls `odd` for values that it cannot use.
   */
  keep(shape: Record<string, "string" | "boolean" | "number" | "object">, read: () => Record<string, any>,
    restore: (state: Record<string, any>, odd: () => void) => void): void;
  /** Call `callback` after changes of the graph. Return a function that ends that. */
  watch(callback: () => void): () => void;
  /** Call `begin` when the panel becomes visible, and what it returns when it no longer is. */
  whileSeen(begin: () => void | (() => void)): () => void;
  /** Aborted when the panel is removed; give it to `addEventListener` and `fetch`. */
  signal: AbortSignal;
  /** The nodes of the page, by the names in site.yaml. */
  nodes: Map<string, NodeHandle>;
  graph: Graph;
  /** The definitions of messages, by name. Constants and defaults of 64 bits are decimal texts. */
  types: Record<string, {
    fields: { name: string, type: string, default?: any }[],
    constants: { name: string, type: string, value: any }[],
  }>;
}

export interface Graph extends EventTarget {
  nodes(): string[];
  topics(): { name: string, types: string[], publishers: string[], subscriptions: string[] }[];
  services(): { name: string, types: string[], servers: string[], clients: string[] }[];
}

/** A node of the page. Emits `state` after changes of its state, and `lines` for its output. */
export interface NodeHandle extends EventTarget {
  name: string;
  state: "stopped" | "starting" | "running" | "stopping" | "failed";
  start(): void;
  stop(): void;
}

export interface Publisher<Message> {
  publish(message: Sent<Message>): void;
  close(): void;
}

/** Size in bytes, and the times of sending and arrival in ms since 1970. */
export interface MessageInfo {
  size: number;
  sequence: number;
  timestamp: number;
  received: number;
}

/** Quality of service; times are in ms. */
export interface Qos {
  depth: number;
  reliable: boolean;
  transientLocal: boolean;
  keepAll: boolean;
  deadline: number;
  lifespan: number;
  /** Whether a publisher asserts its liveliness itself, and how long that lasts. */
  manual: boolean;
  lease: number;
}

/** A message to send: fields may be missing, and arrays of numbers may be plain ones. */
export type Sent<Type> =
  Type extends BigInt64Array | BigUint64Array ? Type | bigint[]
  : Type extends { BYTES_PER_ELEMENT: number } ? Type | number[]
  : Type extends (infer One)[] ? Sent<One>[]
  : Type extends object ? { [Field in keyof Type]?: Sent<Type[Field]> }
  : Type;
