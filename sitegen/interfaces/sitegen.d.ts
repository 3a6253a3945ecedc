// Written by `sitegen types`: the modules that scripts and panels of this site can import. `sitegen serve` writes it
// again when they change.

declare module "sitegen" {
  type Messages = import("./ros").Messages;
  type Services = import("./ros").Services;
  type Actions = import("./ros").Actions;
  type Time = { sec: number, nanosec: number };
  type Sent<Type> = import("./ros").Sent<Type>;
  type MessageInfo = import("./ros").MessageInfo;
  /** Of a type that the page has a definition of; `any` for others. */
  type Of<Known, Type> = Type extends keyof Known ? Known[Type] : any;

  export type QosProfile = "default" | "system_default" | "best_available" | "sensor_data" | "services_default" |
    "parameters" | "parameter_events" | "action_status_default";
  /** The name of a profile, or policies: with the names of this API, where times are in ms, or with those of ROS. */
  export type Qos = QosProfile | Partial<import("./ros").Qos> & {
    profile?: QosProfile;
    history?: "keep_last" | "keep_all";
    reliability?: "reliable" | "best_effort" | "best_available";
    durability?: "transient_local" | "volatile" | "best_available";
    liveliness?: "automatic" | "manual_by_topic";
  };

  /** The page's own node in the graph, which is hidden. */
  export const ros: PageNode;

  /** A node that a script has made; `ros` is one, too, but for its parameters. */
  export interface Node extends PageNode {
    /**
     * Declare a parameter, which others can see and set. It throws if the value does not fit. A whole number is an integer,
     * unless `type`, or a limit with a fraction, makes it a double.
     */
    declare<Value extends Parameter>(name: string, value: Value, options?: ParameterOptions<Widened<Value>>):
      Declared<Widened<Value>>;
    declare(name: string, value: undefined, options: ParameterOptions<any>): Declared<any>;
    /** The parameters that this node has declared, by name. */
    readonly declared: ReadonlyMap<string, Declared<any>>;
  }

  type Widened<Value> = Value extends boolean ? boolean : Value extends number | bigint ? number | bigint :
    Value extends string ? string : Value;

  export interface ParameterOptions<Value> {
    type?: "bool" | "integer" | "double" | "string" | "byte_array" | "bool_array" | "integer_array" | "double_array" |
      "string_array";
    description?: string;
    /** What else holds for its values, in words. */
    constraints?: string;
    readOnly?: boolean;
    /** Whether its type may change. */
    dynamic?: boolean;
    min?: number | bigint;
    max?: number | bigint;
    step?: number | bigint;
    /** Return true, or why the parameter does not take a value. */
    accept?: (value: Value) => boolean | string;
  }

  /** A declared parameter. Emits `change` when it has another value. */
  export interface Declared<Value> extends EventTarget {
    readonly name: string;
    /** Setting it throws if the parameter does not take the value. */
    value: Value;
    changes(options?: StreamOptions): Stream<Value>;
    undeclare(): void;
  }

  /** Lines on /rosout, which the console of the browser shows, too. */
  export interface Log {
    /** The lowest severity that is logged, "info" at first. */
    level: "debug" | "info" | "warn" | "error" | "fatal";
    debug(text: unknown): void;
    info(text: unknown): void;
    warn(text: unknown): void;
    error(text: unknown): void;
    fatal(text: unknown): void;
  }

  export interface PageNode {
    /** Empty for the page's own node. */
    readonly name: string;
    /** The definitions of all interfaces, by name. */
    readonly types: import("./ros").Ros["types"];
    /** The programs of the page, by their names in site.yaml. */
    readonly programs: Map<string, import("./ros").NodeHandle>;
    readonly tf: Tf;
    readonly log: Log;
    /** The time of ROS: that on /clock if use_sim_time is set, or, for `ros`, while it is published. */
    now(): Time;
    /** Call `callback` each `period` ms in the time of ROS, until the function that this returns is called. */
    timer(period: number, callback: (time: Time) => void, options?: SignalOptions): () => void;
    /** Iterate over the time, each `period` ms. */
    ticks(period: number, options?: SignalOptions): Stream<Time>;
    /** Resolve after `ms` in the time of ROS. */
    sleep(ms: number, options?: SignalOptions): Promise<void>;
    /**
     * A topic; without a type, it has that of the graph. Relative names are in the namespace of this node, and "~" stands
     * for its name.
     */
    topic<Type extends string>(name: string, type?: Type, qos?: Qos): Topic<Of<Messages, Type>>;
    service<Type extends string>(name: string, type?: Type): Service<
      Of<Services, Type> extends { request: infer Request } ? Request : any,
      Of<Services, Type> extends { response: infer Response } ? Response : any>;
    action<Type extends string>(name: string, type?: Type): Action<
      Of<Actions, Type> extends { goal: infer Request } ? Request : any,
      Of<Actions, Type> extends { feedback: infer Feedback } ? Feedback : any,
      Of<Actions, Type> extends { result: infer Result } ? Result : any>;
    /** The parameters of a node. */
    parameters(node: string): Parameters;
    nodes(): string[];
    topics(): ReturnType<import("./ros").Graph["topics"]>;
    services(): ReturnType<import("./ros").Graph["services"]>;
    actions(): { name: string, types: string[], servers: string[] }[];
    /** What comes into the graph and leaves it, beginning with what is there. */
    events(options?: StreamOptions): Stream<GraphEvent>;
    /**
     * Another node of the page, with a log and parameters of its own. `parameters` has values for those that it declares,
     * instead of their defaults; `signal` closes it.
     */
    node(name: string, options?: SignalOptions & { parameters?: Record<string, Parameter> }): Node;
    /** Leave the graph and end all streams; the page's own node stays. */
    close(): void;
  }

  export interface GraphEvent {
    change: "come" | "gone";
    kind: "node" | "publisher" | "subscription" | "service" | "client";
    node: string;
    name: string;
    type: string;
  }

  /** Of what a loop has not come to yet, the newest `most` are kept; `signal` ends the stream. */
  export interface StreamOptions {
    most?: number;
    signal?: AbortSignal;
  }
  export interface Stream<Value> extends AsyncIterableIterator<Value> {}
  export interface SignalOptions {
    signal?: AbortSignal;
  }
  /** `timeout` in ms. */
  export interface WaitOptions {
    timeout?: number;
    signal?: AbortSignal;
  }

  export interface Topic<Message> {
    readonly name: string;
    /** As given, or as the graph has it; "" if neither. */
    readonly type: string;
    [Symbol.asyncIterator](): Stream<Message>;
    messages(options?: StreamOptions & { qos?: Qos }): Stream<Message>;
    next(options?: SignalOptions): Promise<Message>;
    /** Call `callback` with each message, until the function that this returns is called, or `signal` aborts. */
    subscribe(callback: (message: Message, info: MessageInfo) => void, options?: SignalOptions & { qos?: Qos }):
      () => void;
    /** Publish a message; missing fields are zero. It throws if a field or a value does not fit the type. */
    publish(message: Sent<Message>): void;
    /** Announce the publisher before its first message. */
    advertise(options?: SignalOptions): void;
    unadvertise(): void;
  }

  export interface Service<Request, Response> {
    readonly name: string;
    readonly type: string;
    /** Whether a node serves it now. */
    readonly available: boolean;
    wait(options?: WaitOptions): Promise<void>;
    /** Call it when there is a server. `timeout` is 5000 by default. */
    call(request?: Sent<Request>, options?: WaitOptions): Promise<Response>;
    /**
     * Serve it, until the function that this returns is called. If `answer` throws, or its response does not fit the type,
     * the client gets no response.
     */
    serve(answer: (request: Request) => Sent<Response> | Promise<Sent<Response>>, options?: SignalOptions): () => void;
  }

  export interface Action<Request, Feedback, Result> {
    readonly name: string;
    readonly type: string;
    readonly available: boolean;
    wait(options?: WaitOptions): Promise<void>;
    /** Send a goal when there is a server. Aborting `signal` later cancels the goal. */
    send(request?: Sent<Request>, options?: WaitOptions): Promise<Goal<Feedback, Result>>;
    /**
     * Serve it: `execute` returns the result, or is an async generator that yields feedback and returns the result. A goal
     * whose `signal` was aborted is canceled, one that throws or sends what does not fit the type is aborted.
     */
    serve(
      execute: (task: Task<Request, Feedback>) => Sent<Result> | Promise<Sent<Result>> |
        AsyncGenerator<Sent<Feedback>, Sent<Result>>,
      options?: SignalOptions & {
        accept?: (request: Request) => boolean, cancel?: (task: Task<Request, Feedback>) => boolean,
      },
    ): () => void;
  }

  export type GoalState = "sending" | "accepted" | "executing" | "canceling" | "succeeded" | "canceled" | "aborted" |
    "rejected" | "lost" | "unknown";

  export interface Goal<Feedback, Result> {
    readonly id: string;
    readonly state: GoalState;
    feedback(options?: StreamOptions): Stream<Feedback>;
    /** It rejects with a GoalError if the goal does not succeed. */
    result(options?: SignalOptions): Promise<Result>;
    /** It rejects if the server refuses. */
    cancel(options?: SignalOptions): Promise<void>;
  }

  export class GoalError extends Error {
    readonly state: GoalState;
    /** What the server sent, if anything. */
    readonly result: any;
  }

  export interface Task<Request, Feedback> {
    readonly id: string;
    readonly request: Request;
    /** Aborted when the goal is to be canceled. */
    readonly signal: AbortSignal;
    publish(feedback: Sent<Feedback>): void;
  }

  export type Parameter = boolean | number | bigint | string | Uint8Array | boolean[] | (number | bigint)[] | string[];

  /** The parameters of another node. `timeout` is 5000 by default, for the node and for its answer. */
  export interface Parameters {
    readonly node: string;
    names(options?: WaitOptions): Promise<string[]>;
    get(name: string, options?: WaitOptions): Promise<Parameter | undefined>;
    all(options?: WaitOptions): Promise<Record<string, Parameter | undefined>>;
    /** It rejects with the reason if the node refuses. */
    set(name: string, value: Parameter, options?: WaitOptions): Promise<void>;
    /** Set several together. */
    set(values: Record<string, Parameter>, options?: WaitOptions): Promise<void>;
    describe(name: string, options?: WaitOptions): Promise<Of<Messages, "rcl_interfaces/msg/ParameterDescriptor">>;
    changes(options?: StreamOptions): Stream<{ name: string, value: Parameter | undefined }>;
  }

  export interface Transform {
    translation: { x: number, y: number, z: number };
    rotation: { x: number, y: number, z: number, w: number };
  }

  /** Emits `change` after transforms have come. */
  export interface Tf extends EventTarget {
    frames(): string[];
    /** Where the frame `source` is in the frame `target`, if that is known now. */
    latest(target: string, source: string): Transform | undefined;
    /** The same, as soon as it is known; at a `time` in s or as in a header, interpolated. */
    lookup(target: string, source: string, options?: WaitOptions & { time?: number | { sec: number, nanosec: number } }):
      Promise<Transform>;
    follow(target: string, source: string, options?: { signal?: AbortSignal }): Stream<Transform>;
  }
}

declare module "sitegen/rosbridge" {
  /** The `transportFactory` of roslib 2: `new Ros({ transportFactory })`, then `connect("page:")`. */
  export function transportFactory(url?: string): Promise<any>;
  /** Let `new WebSocket(url)` of this page connect to its graph; returns what undoes that. */
  export function serveWebSocket(url?: string): () => void;
  /** A WebSocket whose server is the graph of the page. */
  export class RosbridgeSocket extends WebSocket {
    constructor(url?: string);
  }
}
