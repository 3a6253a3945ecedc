// @ts-check
// ros2 topic echo: print the messages of a topic.

import { Codec } from "../../../messages/codec.js";
import { isMessage, parseFieldType } from "../../../messages/fieldType.js";
import { csv, yaml } from "../format.js";
import { FLOAT, INT } from "../../args/parse.js";
import { Failure } from "../../shell/shell.js";
import { bytesRepr, text } from "../python.js";
import { absolute, checkName, DISCOVERY, fittingQos, flag, fullType, option, Pace, QOS_OPTIONS, qosOf } from "../verb.js";

/** @import { MessageInfo, Ros } from "../../../protocol.js" */
/** @import { Io } from "../../shell/shell.js" */
/** @import { Verb } from "../verb.js" */

// Messages that wait to be printed; of a fast topic, the oldest are dropped.
const WAITING = 500;

/** @type {Verb} */
export const echo = {
  name: "echo",
  about: "Output messages from a topic",
  args: [
    ...DISCOVERY,
    { name: "topic_name", help: "Name of the ROS topic to listen to (e.g. '/chatter')", complete: "topic" },
    { name: "message_type", count: "?", help: "Type of the ROS message (e.g. 'std_msgs/msg/String')", complete: "message" },
    ...QOS_OPTIONS,
    flag("csv", ["--csv"], "Output all recursive fields separated by commas (e.g. for plotting). If --include-message-info is also passed, the following fields are prepended: source_timestamp, received_timestamp, publication_sequence_number, reception_sequence_number."),
    option("field", ["--field"], "Echo a selected field of a message. Use '.' to select sub-fields. For example, to echo the position field of a nav_msgs/msg/Odometry message: 'ros2 topic echo /odom --field pose.pose.position'", { complete: "field" }),
    flag("full_length", ["-f", "--full-length"], "Output all elements for arrays, bytes, and string with a length > '--truncate-length', by default they are truncated after '--truncate-length' elements with '...'"),
    option("truncate_length", ["-l", "--truncate-length"], "The length to truncate arrays, bytes, and string to (default: 128)", { type: INT, initial: 128 }),
    flag("no_arr", ["--no-arr"], "Don't print array fields of messages"),
    flag("no_str", ["--no-str"], "Don't print string fields of messages"),
    flag("flow_style", ["--flow-style"], "Print collections in the block style (not available with csv format)"),
    flag("no_lost_messages", ["--no-lost-messages"], "Don't report when a message is lost"),
    flag("raw", ["--raw"], "Echo the raw binary representation"),
    flag("once", ["--once"], "Print the first message received and then exit."),
    option("timeout", ["--timeout"], "Set a timeout in seconds", { metavar: "TIMEOUT", type: FLOAT }),
    flag("info", ["--include-message-info"], "Shows the associated message info."),
    flag("clear", ["--clear"], "Clear screen before printing next message"),
  ],
  async run(io, args) {
    checkName(args.topic_name, "topic");
    const topic = absolute(args.topic_name);
    const type = await typeOf(io, topic, args.message_type);
    const path = args.field ? fieldAt(io.ros, type, args.field) : undefined;
    await new Echo(io, args, topic, type, path).run();
  },
};

/** Return the type of a topic. @param {Io} io @param {string} topic @param {string | undefined} given */
async function typeOf(io, topic, given) {
  const { ros, err } = io;
  const known = () => ros.graph.topics().find(({ name }) => name === topic)?.types ?? [];
  if (given) {
    const type = fullType(given, "msg");
    if (!ros.types[type]) throw new Failure(`The message type '${given}' is invalid`);
    return type;
  }
  const [type, ...others] = known();
  if (!type) {
    await err(`WARNING: topic [${topic}] does not appear to be published yet\n`);
    throw new Failure("Could not determine the type for the passed topic");
  }
  if (others.length) {
    const all = [type, ...others].map((one) => `'${one}'`).join(", ");
    throw new Failure(`Cannot echo topic '${topic}', as it contains more than one type: [${all}]`);
  }
  if (!ros.types[type]) throw new Failure(`The message type '${type}' is invalid`);
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

class Echo {
  #io;
  #args;
  #type;
  #topic;
  #path;
  #codec;
  /** @type {{bytes: Uint8Array, info: MessageInfo}[]} */
  #waiting = [];
  #wake = () => {};
  #lost = 0;
  #toldLost = 0;
  #received = 0;

  /**
   * @param {Io} io @param {any} args @param {string} topic @param {string} type
   * @param {{steps: (string | number)[], type: string} | undefined} path
   */
  constructor(io, args, topic, type, path) {
    this.#io = io;
    this.#args = args;
    this.#topic = topic;
    this.#type = type;
    this.#path = path;
    this.#codec = new Codec(io.ros.types);
  }

  async run() {
    const { ros, signal } = this.#io;
    const qos = qosOf(this.#args, { ...fittingQos(ros, this.#topic), depth: 100 });
    const end = ros.subscribeBytes(this.#topic, this.#type, (bytes, info) => {
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
      if (this.#args.clear) this.#io.shell.clear();
      await this.#io.out(this.#format(next));
      if (this.#args.once) return;
    }
  }

  async #tellLost() {
    const change = this.#lost - this.#toldLost;
    this.#toldLost = this.#lost;
    await this.#io.out(`A message was lost!!!\n\ttotal count change:${change}\n\ttotal count: ${this.#lost}---\n`);
  }

  /** @param {{bytes: Uint8Array, info: MessageInfo}} message */
  #format({ bytes, info }) {
    const { types } = this.#io.ros;
    const args = this.#args;
    const facts = args.info ? this.#facts(info) : undefined;
    const head = facts && !args.csv ? `${facts.map(([name, value]) => `${name}: ${value}`).join("\n")}\n---\n` : "";
    if (args.raw) return `${head}${bytesRepr(bytes)}\n---\n`;
    const message = this.#codec.read(this.#type, bytes);
    let [value, type] = [message, this.#type];
    if (this.#path) {
      for (const step of this.#path.steps) value = value?.[step];
      type = this.#path.type;
      if (value === undefined) throw new Failure(`Invalid field '${args.field}': list index out of range`);
    }
    const { base, array } = parseFieldType(type);
    if (array || !isMessage(base)) return `${head}${text(value, type, types)}\n---\n`;
    const form = { limit: args.full_length ? Infinity : args.truncate_length, noArrays: args.no_arr, noTexts: args.no_str, flow: args.flow_style };
    if (!args.csv) return `${head}${yaml(value, base, types, form)}---\n`;
    const before = facts?.map(([, fact]) => `${fact},`).join("") ?? "";
    return `${before}${csv(value, base, types, form)}\n`;
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
