// @ts-check
// A JavaScript cell of a page: a module that a visitor edits and runs, in a worker of its own, and what it prints.

import { imports, JAVASCRIPT } from "../ui/javascriptSyntax.js";
import { say } from "../ui/words.js";
import { CellView } from "./cell/view.js";

/** @import { JavascriptEntry, Line, ModuleImport, NodeHandle, Ros } from "../protocol.js" */

/** The modules that cells can import, by name: their files in the runtime. @typedef {Record<string, string>} Modules */

/** @typedef {"none" | "starting" | "running" | "done" | "failed" | "stopped"} State */
/** As cells of Python look. @type {Partial<Record<State, string>>} */
const LOOKS = { done: "ok", failed: "error" };
// As workers/javascript/thrown.js writes it.
const LINE = /^ {4}at line (\d+)$/m;

/**
 * @param {HTMLElement} element
 * @param {Ros} ros
 * @param {{text: string, number: number, interfaces: string, modules: Modules}} options `number` counts the cells of
 *   the page, and `interfaces` is the file of all definitions
 * @returns {() => void} unmount
 */
export function mount(element, ros, { text, number, interfaces, modules }) {
  const address = interfaces.startsWith("sitegen:") ? interfaces : new URL(interfaces, document.baseURI).href;
  const cell = new Cell(element, ros, text, number, (now) => ({
    text: now, imports: resolved(now, modules), interfaces: address,
  }));
  return () => {
    cell.close();
    element.replaceChildren();
  };
}

class Cell {
  #ros;
  #number;
  #programOf;
  /** The program that runs now. @type {NodeHandle | undefined} */
  #program;
  /** @type {State} */
  #state = "none";
  /** Whether it has changed since it ran. */
  #changed = false;
  /** The number of runs. */
  #turn = 0;
  #closing = new AbortController();
  #view;

  /**
   * @param {HTMLElement} element @param {Ros} ros @param {string} text @param {number} number
   * @param {(text: string) => JavascriptEntry} programOf throws an Error for a text that cannot run
   */
  constructor(element, ros, text, number, programOf) {
    this.#ros = ros;
    this.#number = number;
    this.#programOf = programOf;
    const source = {
      text, language: JAVASCRIPT, label: say("JavaScript cell {}", number),
      runs: say("Run JavaScript cell {}", number), stops: say("Stop JavaScript cell {}", number),
    };
    this.#view = new CellView(element, ros, source, {
      run: () => this.#run(), stop: () => this.#program?.stop(),
      changed: () => {
        this.#changed = true;
        this.#show(this.#state);
      },
    });
  }

  close() {
    this.#turn += 1;
    this.#end();
    this.#view.close();
  }

  async #run() {
    const turn = ++this.#turn;
    this.#view.begin();
    this.#view.mark(0);
    this.#view.output.clear();
    this.#changed = false;
    const { text } = this.#view;
    this.#show("starting");
    // What it has in the graph is gone before it comes anew.
    await this.#end();
    if (turn !== this.#turn) return;
    try {
      const entry = { package: "sitegen", executable: "javascript", arguments: [], autostart: false, foreign: true };
      this.#listen(this.#ros.run({ ...entry, javascript: this.#programOf(text) }, { name: `cell${this.#number}` }));
    } catch (error) {
      this.#view.output.add({ kind: "error", text: error instanceof Error ? error.message : String(error) });
      this.#show("failed");
    }
  }

  /** @param {NodeHandle} program */
  #listen(program) {
    this.#program = program;
    this.#closing = new AbortController();
    const { signal } = this.#closing;
    program.addEventListener("lines", (event) => {
      const lines = /** @type {CustomEvent<Line[]>} */ (event).detail;
      this.#view.output.lines(lines);
      const wrong = LINE.exec(lines.map(({ text }) => text).join("\n"));
      if (wrong && !this.#changed) this.#view.mark(Number(wrong[1]));
    }, { signal });
    program.addEventListener("answer", (event) => {
      this.#show(/** @type {CustomEvent<{text: string}>} */ (event).detail.text === "busy" ? "running" : "done");
    }, { signal });
    program.addEventListener("state", () => {
      const { state } = program;
      if (state === "failed" || state === "stopped") this.#program = undefined;
      if (state === "running" || state === "failed" || state === "stopped") this.#show(state);
    }, { signal });
  }

  /** End what still runs, and resolve when it has ended. */
  #end() {
    const program = this.#program;
    this.#closing.abort();
    this.#program = undefined;
    return new Promise((resolve) => {
      if (!program) {
        resolve(undefined);
        return;
      }
      program.addEventListener("state", () => {
        if (program.state === "stopped" || program.state === "failed") resolve(undefined);
      });
      program.stop();
    });
  }

  /** @param {State} state */
  #show(state) {
    this.#state = state;
    const text = {
      none: () => say("not run"),
      starting: () => say("starting"),
      running: () => say("running"),
      done: () => say("done"),
      failed: () => say("failed"),
      stopped: () => say("stopped"),
    }[state]();
    const outdated = this.#changed && state !== "starting" && state !== "running" && state !== "none";
    if (outdated) this.#view.show("stale", say("outdated"), say("This cell has changed since; run it again"));
    else this.#view.show(LOOKS[state] ?? state, text, "", state === "running");
  }
}

/** Return what a text imports. @param {string} text @param {Modules} modules @returns {ModuleImport[]} */
function resolved(text, modules) {
  return imports(text).map(({ from, to, name }) => {
    const file = Object.hasOwn(modules, name) && modules[name];
    if (!file) throw new Error(say("cells cannot import '{}'; they can import {}", name, Object.keys(modules).join(", ")));
    return { from, to, file };
  });
}
