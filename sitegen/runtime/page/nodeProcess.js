// @ts-check
// A node of the page, and the worker that runs it between Start and Stop.

import { interrupt, sharedByte } from "../interrupt.js";
import { startWorker } from "../worker.js";
import { compile } from "./compile.js";
import { Guard } from "./guard.js";
import { originOf } from "./names.js";
import { starting } from "./starting.js";

/** @import { Keyboard, Line, NodeEntry, NodeState, Severity, ToWorker, Typed } from "../protocol.js" */
/** @import { Graph } from "./graph.js" */
/** @import { Start } from "./starting.js" */
/** @import { Member, WorkerGroups } from "./workerGroup.js" */

// A program that has not ended this time (ms) after Stop is terminated.
const GRACE = 1000;
// The worker of a program that has ended is terminated after this time (ms), because in Firefox the last messages of a
// terminated worker are lost.
const LINGER = 250;

export class NodeProcess extends EventTarget {
  #entry;
  #base;
  #graph;
  #ready;
  #mounted;
  /** @type {NodeState} */
  #state = "stopped";
  /** @type {Promise<WebAssembly.Module> | undefined} */
  #module;
  #groups;
  /**
   * The present worker, its id in the graph, and the guard of its budgets.
   * @type {{worker: Worker | Member, id: number, byte?: Uint8Array, guard: Guard} | undefined}
   */
  #run;
  #startAgain = false;
  /** Events to dispatch once the widgets are mounted. @type {Event[] | undefined} */
  #early = [];
  /** The files of a Python node that the visitor has changed, by path. @type {Record<string, string>} */
  #edits = {};
  /** Those that the visitor chose. @type {string[] | undefined} */
  #arguments;
  /** The exit code of the last run; undefined if it was terminated, or still runs. @type {number | undefined} */
  code = undefined;
  /** @type {ReturnType<typeof setTimeout> | undefined} */
  #grace;

  /**
   * @param {string} name
   * @param {NodeEntry} entry
   * @param {string} base the address that the paths of the entry are relative to
   * @param {Graph} graph
   * @param {{ready: Promise<void>, mounted: Promise<void>}} times when programs may run, and when widgets are mounted
   * @param {WorkerGroups} groups workers that several nodes share
   */
  constructor(name, entry, base, graph, { ready, mounted }, groups) {
    super();
    this.name = name;
    /** The time of the last change of state, in ms since 1970. */
    this.since = Date.now();
    /** The size of its WebAssembly memory in bytes; 0 if unknown. */
    this.memory = 0;
    /** Whether the one who started it tells its exit code. */
    this.quiet = false;
    /** How it reads its standard input; undefined if it does not. @type {Keyboard | undefined} */
    this.keyboard = undefined;
    this.#entry = entry;
    this.#base = base;
    this.#graph = graph;
    this.#ready = ready;
    this.#mounted = mounted;
    this.#groups = groups;
    mounted.then(() => this.#tellEarly());
    // What starts with the page says so then.
    if (entry.fault && !entry.autostart) this.#fail(`did not build: ${entry.fault}`);
  }

  get state() {
    return this.#state;
  }

  get package() {
    return this.#entry.package;
  }

  get executable() {
    return this.#entry.executable;
  }

  get needs() {
    return this.#entry.needs ?? [];
  }

  /** What page.json says of it. */
  get entry() {
    return this.#entry;
  }

  /** Whether it takes arguments. */
  get configurable() {
    return Boolean(this.#entry.builds || this.#entry.python);
  }

  /** The arguments of its next start. */
  get arguments() {
    return this.#arguments ?? this.#entry.arguments;
  }

  /** Use other arguments from the next start on; undefined restores its own. @param {string[] | undefined} words */
  override(words) {
    this.#arguments = words;
  }

  /** Start the program, or start it again as soon as it has stopped. */
  start() {
    if (this.#state === "stopping") this.#startAgain = true;
    if (this.#run) return;
    if (this.#entry.fault) {
      this.#fail(`did not build: ${this.#entry.fault}`);
      return;
    }
    this.code = undefined;
    this.#setState("starting");
    const start = starting({
      name: this.name, entry: this.#entry, base: this.#base, arguments: this.arguments,
      // Until then, an editor may restore the visitor's changes.
      edits: () => this.#mounted.then(() => this.#edits),
      compile: (url) => (this.#module ??= compile(url)),
    });
    if (typeof start !== "string") {
      this.#launch(start);
    } else {
      this.#print("fatal", `${this.name}: ${start}`);
      this.#setState("failed");
    }
  }

  /**
   * Replace the text of a file from the next start on; undefined restores it.
   * @param {string} place @param {string | undefined} text
   */
  edit(place, text) {
    const { [place]: _, ...others } = this.#edits;
    this.#edits = text === undefined ? others : { ...others, [place]: text };
  }

  /** Ask the interpreter of a running Python node for syntax errors. @param {string} text */
  check(text) {
    if (this.#run && this.#state === "running") this.#run.worker.postMessage({ op: "check", text });
  }

  /** Stop the program if it runs, then start it. */
  restart() {
    this.stop();
    this.start();
  }

  /** Send input to the program. @param {Typed} typed */
  type(typed) {
    if (!this.#run) return;
    const shown = typed.op === "line" || (typed.op === "keys" && typed.text && this.keyboard === "lines");
    if (shown) this.#print("typed", typed.text.replace(/\n$/, ""));
    this.#run.worker.postMessage(typed);
  }

  /** Send Ctrl-C to the program. */
  interrupt() {
    if (!this.#run) return;
    // In this order: the worker clears the byte when it has the message, and a byte set after that would be left over.
    interrupt(this.#run.byte);
    this.#run.worker.postMessage({ op: "stop" });
  }

  /** Send Ctrl-C to the program, and terminate it if it does not end. */
  stop() {
    this.#startAgain = false;
    if (this.#state === "starting") {
      this.#end("stopped");
    } else if (this.#state === "running" && this.#run) {
      this.#setState("stopping");
      this.interrupt();
      this.#grace = setTimeout(() => {
        this.#print("warn", `${this.name}: did not end within a second and was terminated`);
        this.#end("stopped", "stuck");
      }, GRACE);
    }
  }

  /** Replace the program, and restart it if it runs. @param {NodeEntry} entry */
  replace(entry) {
    const running = this.#state === "starting" || this.#state === "running";
    this.#entry = entry;
    this.#module = undefined;
    if (running) this.restart();
  }

  /** Empty its consoles. */
  clear() {
    this.dispatchEvent(new Event("clear"));
  }

  /** Start a worker and, when programs may run, let it run the program. @param {Start} start */
  async #launch({ worker: file, group, prepare }) {
    const worker = group ? this.#groups.join(group, file, this.name) : startWorker(file, this.name);
    const post = (/** @type {ToWorker} */ message, /** @type {Transferable[]} */ transfer = []) =>
      worker.postMessage(message, transfer);
    const complain = (/** @type {string} */ text) => this.#print("warn", `${this.name}: ${text}`);
    const id = this.#graph.join(post, this.name, complain, originOf(this.#entry));
    const byte = worker instanceof Worker ? sharedByte() : worker.byte;
    const guard = new Guard(complain, (reason) => this.#run === run && this.#fail(reason, "stuck"));
    const run = { worker, id, byte, guard };
    this.#run = run;
    worker.onmessage = (/** @type {MessageEvent} */ event) => this.#receive(id, event.data);
    worker.onerror = (/** @type {{message: string, preventDefault(): void}} */ event) => {
      event.preventDefault();
      const unloaded = "its worker could not be loaded; check the connection to the site, then start again";
      if (this.#run === run) this.#fail(event.message || unloaded);
    };
    try {
      const [message] = await Promise.all([prepare(id, post, byte), this.#ready]);
      if (this.#run === run) post(message); // else it was stopped in the meantime
    } catch (error) {
      this.#module = undefined;
      if (this.#run === run) this.#fail(error instanceof Error ? error.message : String(error));
    }
  }

  /** @param {number} id @param {unknown} report */
  #receive(id, report) {
    if (this.#run?.id !== id) return; // sent before it was terminated
    const { guard } = this.#run;
    const message = guard.admit(report);
    if (!message) return;
    switch (message.op) {
      case "running":
        if (this.#state === "starting") this.#setState("running");
        break;
      case "lines":
        this.#emitLines(message.lines);
        break;
      case "progress":
        this.dispatchEvent(new CustomEvent("progress", { detail: message }));
        break;
      case "memory":
        this.memory = message.bytes;
        break;
      case "reading":
        this.keyboard = message.keyboard;
        this.#tell(new Event("reading"));
        break;
      case "ready":
        this.dispatchEvent(new CustomEvent("ready", { detail: message.more }));
        break;
      case "answer":
      case "words":
      case "checked":
        this.dispatchEvent(new CustomEvent(message.op, { detail: message }));
        break;
      case "exit":
        this.code = message.error && !message.code ? 1 : message.code;
        if (message.error) {
          this.#fail(message.error);
        } else if (message.code !== 0 && this.quiet) {
          this.#end("failed");
        } else if (message.code !== 0 && (this.#state !== "stopping" || this.#entry.python)) {
          this.#fail(`exited with code ${message.code}`);
        } else {
          // When the visitor has stopped it, main() may return what it likes. In Python, another code than 0 is mostly
          // that of an exception.
          if (message.code !== 0) this.#print("info", `${this.name}: exited with code ${message.code}`);
          this.#end("stopped", "by itself");
        }
        break;
      default:
        guard.spend(this.#graph.receive(id, message));
    }
  }

  /** @param {string} error @param {"early" | "stuck"} [how] the program ended */
  #fail(error, how) {
    this.#print("fatal", `${this.name}: ${error}`);
    console.error(`${this.name}: ${error}`);
    this.#end("failed", how);
  }

  /** @param {NodeState} state @param {"early" | "by itself" | "stuck"} [how] the program ended */
  #end(state, how = "early") {
    clearTimeout(this.#grace);
    const run = this.#run;
    this.#run = undefined;
    if (run) {
      run.guard.finish();
      if (how === "by itself") setTimeout(() => dismiss(run.worker), LINGER);
      else if (how === "stuck") run.worker.terminate();
      else dismiss(run.worker);
      this.#graph.leave(run.id);
    }
    this.#setState(state);
    if (this.#startAgain) {
      this.#startAgain = false;
      this.start();
    }
  }

  /** @param {Severity} severity @param {string} text */
  #print(severity, text) {
    this.#emitLines([{ severity, text }]);
  }

  /** @param {Line[]} lines */
  #emitLines(lines) {
    this.#tell(new CustomEvent("lines", { detail: lines }));
  }

  /** Dispatch an event when the widgets are mounted. @param {Event} event */
  #tell(event) {
    if (this.#early) this.#early.push(event);
    else this.dispatchEvent(event);
  }

  #tellEarly() {
    const events = this.#early ?? [];
    this.#early = undefined;
    for (const event of events) this.dispatchEvent(event);
  }

  /** @param {NodeState} state */
  #setState(state) {
    this.#state = state;
    this.since = Date.now();
    if (state !== "running" && state !== "stopping") {
      this.memory = 0;
      this.keyboard = undefined;
    }
    this.dispatchEvent(new Event("state"));
  }
}

/** End a worker; that of a group goes on for its other nodes. @param {Worker | Member} worker */
function dismiss(worker) {
  if (worker instanceof Worker) worker.terminate();
  else worker.leave();
}
