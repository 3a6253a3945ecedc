// @ts-check
// ros2 topic echo: print the messages of a topic.

import { Codec } from "../../../messages/codec.js";
import { isMessage, parseFieldType } from "../../../messages/fieldType.js";
import { csv, yaml } from "../format.js";
import { expression } from "./expression.js";
import { POSITIVE_FLOAT, UNSIGNED_INT } from "../../args/types.js";
import { Failure } from "../../shell/shell.js";
import { bytesRepr, text } from "../python.js";
import { qosOptions, subscriptionQos } from "../qos.js";
import { absolute, checkName, DISCOVERY, flag, fullType, isType, option, Pace } from "../verb.js";

/** @import { MessageInfo, Ros } from "../../../protocol.js" */
/** @import { Io } from "../../shell/shell.js" */
/** @import { Verb } from "../verb.js" */

// Messages that wait to be printed; of a fast topic, the oldest are dropped.
const WAITING = 500;

/** How messages are printed. */
export const FORM_OPTIONS = [
  flag("full_length", ["--full-length", "-f"], "Output all elements for arrays, bytes, and string with a length > '--truncate-length', by default they are truncated after '--truncate-length' elements with '...''"),
  option("truncate_length", ["--truncate-length", "-l"], "The length to truncate arrays, bytes, and string to (default: 128)", { type: UNSIGNED_INT, initial: 128 }),
  flag("no_arr", ["--no-arr"], "Don't print array fields of messages"),
  flag("no_str", ["--no-str"], "Don't print string fields of messages"),
  flag("flow_style", ["--flow-style"], "Print collections in the block style (not available with csv format)"),
];

/** @type {Verb} */
export const echo = {
  name: "echo",
  about: "Output messages from a topic",
  args: [
    ...DISCOVERY,
    { name: "topic_name", help: "Name of the ROS topic to listen to (e.g. '/chatter')", complete: "topic" },
    { name: "message_type", count: "?", help: "Type of the ROS message (e.g. 'std_msgs/msg/String')", complete: "message" },
    ...qosOptions("subscribe", "sensor_data"),
    flag("csv", ["--csv"], "Output all recursive fields separated by commas (e.g. for plotting). If --include-message-info is also passed, the following fields are prepended: source_timestamp, received_timestamp, publication_sequence_number, reception_sequence_number."),
    option("field", ["--field"], "Echo a selected field of a message. Use '.' to select sub-fields. For example, to echo the position field of a nav_msgs/msg/Odometry message: 'ros2 topic echo /odom --field pose.pose.position'", { complete: "field" }),
    ...FORM_OPTIONS,
    flag("no_lost_messages", ["--no-lost-messages"], "Don't report when a message is lost"),
    flag("raw", ["--raw"], "Echo the raw binary representation"),
    option("filter_expr", ["--filter"], "Python expression to filter messages that are printed. Expression can use Python builtins as well as m (the message)."),
    flag("once", ["--once"], "Print the first message received and then exit."),
    option("timeout", ["--timeout"], "Set a timeout in seconds for waiting", { metavar: "N", type: POSITIVE_FLOAT }),
    flag("info", ["--include-message-info", "-i"], "Shows the associated message info."),
    flag("clear", ["--clear", "-c"], "Clear screen before printing next message"),
    option("node_name", ["-n", "--node-name"], "The name of the echoing node; by default, will be a hidden node name"),
  ],
  async run(io, args) {
    checkName(args.topic_name, "topic");
    const field = args.field?.split(".").filter(Boolean).join(".");
    if (field === "") throw new Failure(`Invalid field value '${args.field}'`);
    const filter = args.filter_expr === undefined ? undefined : expression(args.filter_expr);
    const topic = absolute(args.topic_name);
    const type = await typeOf(io, args.topic_name, args.message_type);
    const path = field ? fieldAt(io.ros, type, field) : undefined;
    await new Echo(io, args, { topic, type, path, filter }).run();
  },
};

/** Return the type of a topic. @param {Io} io @param {string} name of the topic @param {string | undefined} given */
async function typeOf({ ros, out }, name, given) {
  if (given) {
    const type = fullType(given, "msg");
    if (!isType(ros, type)) throw new Failure("The passed message type is invalid");
    return type;
  }
  const found = typeOfTopic(ros, name);
  if (found) return found;
  await out(`WARNING: topic [${name}] does not appear to be published yet\n`);
  throw new Failure("Could not determine the type for the passed topic");
}

/** Return the type of a topic, "" if there is no such topic. @param {Ros} ros @param {string} name */
export function typeOfTopic(ros, name) {
  const topic = absolute(name);
  const types = ros.graph.topics().find((one) => one.name === topic)?.types ?? [];
  if (types.length > 1) throw new Failure(`Cannot echo topic '${name}', as it contains more than one type: [${types.join(", ")}]`);
  const [type = ""] = types;
  if (type && !isType(ros, type)) throw new Failure(`The message type '${type}' is invalid`);
  return type;
}

/** @param {Ros} ros @param {string} type @param {string} path @returns {{steps: (string | number)[], type: string}} */
function fieldAt(ros, type, path) {
  /** @type {(string | number)[]} */
  const steps = [];
  let here = type;
  for (const part of path.split(".")) {
    const [, name = "", index] = /^(\w+)(?:\[(\d+)\])?$/.exec(part) ?? [];
    const { base, array } = parseFieldType(here);
    const field = !array && isMessage(base) ? ros.types[base]?.fields.find((one) => one.name === name) : undefined;
    if (!field) throw new Failure(`Invalid field '${path}': '${base.split("/").at(-1)}' object has no attribute '${name || part}'`);
    steps.push(name);
    here = field.type;
    if (index !== undefined) {
      steps.push(Number(index));
      here = parseFieldType(here).base;
    }
  }
  return { steps, type: here };
}

/**
 * What is printed of which topic. `path` leads to a field, `filter` tells whether a value is printed, and `named`
 * changes the YAML.
 * @typedef {{topic: string, type: string, path?: {steps: (string | number)[], type: string},
 *   filter?(value: any, type: string, types: Ros["types"]): boolean, named?(text: string): string}} Source
 */

/** The messages of a topic on their way to the screen. */
export class Echo {
  #io;
  #args;
  #source;
  #codec;
  /** @type {{bytes: Uint8Array, info: MessageInfo}[]} */
  #waiting = [];
  #wake = () => {};
  #lost = 0;
  #toldLost = 0;
  #received = 0;

  /** @param {Io} io @param {any} args @param {Source} source */
  constructor(io, args, source) {
    this.#io = io;
    this.#args = args;
    this.#source = source;
    this.#codec = new Codec(io.ros.types);
  }

  async run() {
    const { ros, signal } = this.#io;
    const { topic, type } = this.#source;
    const qos = await subscriptionQos(this.#io, this.#args, topic);
    // Without a name, it is the page's own hidden node.
    const own = this.#args.node_name ? ros.node(absolute(this.#args.node_name)) : undefined;
    const end = (own ?? ros).subscribeBytes(topic, type, (bytes, info) => {
      // The bytes are those of a frame, which is gone later.
      this.#waiting.push({ bytes: bytes.slice(), info });
      if (this.#waiting.length > WAITING) {
        this.#waiting.shift();
        this.#lost++;
      }
      this.#wake();
    }, qos);
    const timer = new AbortController();
    const { timeout } = this.#args;
    const late = timeout === undefined ? undefined : setTimeout(() => timer.abort(new Late()), timeout * 1000);
    try {
      await this.#loop(AbortSignal.any([signal, timer.signal]));
    } catch (error) {
      if (!(error instanceof Late)) throw error;
    } finally {
      clearTimeout(late);
      end();
      own?.leave();
    }
  }

  /** @param {AbortSignal} signal */
  async #loop(signal) {
    const pace = new Pace();
    const end = () => this.#wake();
    signal.addEventListener("abort", end);
    for (;;) {
      await pace.wait(signal);
      const next = this.#waiting.shift();
      if (!next) {
        await /** @type {Promise<void>} */ (new Promise((resolve) => {
          this.#wake = resolve;
        }));
        continue;
      }
      if (this.#lost > this.#toldLost && !this.#args.no_lost_messages) await this.#tellLost();
      const text = this.#format(next);
      if (text === undefined) continue;
      if (this.#args.clear) this.#io.shell.clear();
      await this.#io.out(text);
      if (this.#args.once) return;
    }
  }

  async #tellLost() {
    const change = this.#lost - this.#toldLost;
    this.#toldLost = this.#lost;
    await this.#io.out(`A message was lost!!!\n\ttotal count change:${change}\n\ttotal count: ${this.#lost}---\n`);
  }

  /** Return what is printed; undefined if the filter leaves it out. @param {{bytes: Uint8Array, info: MessageInfo}} message */
  #format({ bytes, info }) {
    const { types } = this.#io.ros;
    const args = this.#args;
    const { path, filter, named = String } = this.#source;
    let { type } = this.#source;
    let value = this.#codec.read(type, bytes);
    if (path) {
      for (const step of path.steps) value = value?.[step];
      type = path.type;
      if (value === undefined) throw new Failure(`Invalid field '${args.field}': list index out of range`);
    }
    if (filter && !filter(value, type, types)) return undefined;
    const facts = args.info ? this.#facts(info) : undefined;
    const { base, array } = parseFieldType(type);
    if (args.raw || array || !isMessage(base)) {
      const dict = facts?.map(([name, fact]) => `'${name}': ${fact}`).join(", ");
      const head = dict ? `---Got new message, message info:---\n{${dict}}\n---Message data:---\n` : "";
      return `${head}${args.raw ? bytesRepr(bytes) : text(value, type, types)}\n---\n`;
    }
    const form = { limit: args.full_length ? Infinity : args.truncate_length, noArrays: args.no_arr, noTexts: args.no_str, flow: args.flow_style };
    if (args.csv) return `${facts?.map(([, fact]) => `${fact},`).join("") ?? ""}${csv(value, base, types, form)}\n`;
    // YAML of Python is sorted.
    const head = facts?.map(([name, fact]) => `${name}: ${fact}\n`).sort().join("");
    return `${head ? `${head}---\n` : ""}${named(yaml(value, base, types, form))}---\n`;
  }

  /** @param {MessageInfo} info @returns {[string, string | number][]} */
  #facts({ timestamp, received, sequence }) {
    const nanoseconds = (/** @type {number} */ time) => String(BigInt(Math.round(time * 1000)) * 1000n);
    return [
      ["source_timestamp", nanoseconds(timestamp)], ["received_timestamp", nanoseconds(received)],
      ["publication_sequence_number", sequence], ["reception_sequence_number", ++this.#received],
    ];
  }
}

class Late extends Error {}
