// @ts-check
// One terminal: the screen of xterm, the input line, and the shell behind it.

import { css, FitAddon, Terminal } from "../vendor/xterm.js";
import { adoptStyle } from "../ui/adoptedStyle.js";
import { say } from "../ui/words.js";
import { BUILTINS, describe } from "./shell/builtins.js";
import { FILTERS } from "./shell/filters.js";
import { complete } from "./line/complete.js";
import { InputLine } from "./line/inputLine.js";
import { ROS2 } from "./ros2/ros2.js";
import { isFinished, Shell } from "./shell/shell.js";
import { styled } from "./shell/style.js";

/** @import { Ros } from "../protocol.js" */
/** @import { Bags } from "./bags.js" */
/** @import { Interfaces } from "./interfaces.js" */
/** @import { History } from "./line/history.js" */
/** @import { Style } from "./shell/style.js" */

// Output that xterm has not parsed yet, in characters; with more, commands wait.
const WAITING = 100_000;
const SCROLLBACK = 5000;
const PROMPT = "$ ";
const CONTINUED = "> ";
const [INTERRUPT, SUSPEND] = ["\x03", "\x1a"];

let styles = 0;
let removeStyle = () => {};

export class Session {
  #element;
  #ros;
  #history;
  #terminal;
  #fit = new FitAddon();
  #line;
  #waiting = 0;
  /** Keys that came while a command ran. */
  #early = "";
  /** Gets the keys while a program reads them. @type {((data: string) => void) | undefined} */
  #keys;
  #busy = false;
  /** The lines of an unfinished command. */
  #begun = "";
  #escaped = false;
  /** Whether the last output ended its line. */
  #fresh = true;
  /** @type {(() => void) | undefined} */
  #resume;
  #control = false;
  /** Called when the letter after `holdControl` was typed. */
  released = () => {};
  shell;

  /**
   * @param {HTMLElement} element an empty one @param {Ros} ros
   * @param {{files: Map<string, string>, bags: Bags, interfaces: Interfaces, history: History,
   *   colours: Record<string, string>, size: number}} options `size` is that of letters, in px
   */
  constructor(element, ros, { files, bags, interfaces, history, colours, size }) {
    this.#element = element;
    this.#ros = ros;
    this.#history = history;
    if (!styles++) removeStyle = adoptStyle(css);
    this.#terminal = new Terminal({
      cursorBlink: !matchMedia("(prefers-reduced-motion: reduce)").matches, fontFamily: getComputedStyle(element).fontFamily,
      fontSize: size, lineHeight: 1.2, scrollback: SCROLLBACK, theme: colours, convertEol: false, macOptionIsMeta: true,
    });
    this.#terminal.loadAddon(this.#fit);
    this.#terminal.open(element);
    this.#line = new InputLine((text) => this.#terminal.write(text), () => this.#terminal.cols);
    const screen = {
      columns: () => this.#terminal.cols,
      write: this.#write.bind(this),
      rows: () => this.#terminal.rows,
      clear: () => this.#terminal.write("\x1b[2J\x1b[3J\x1b[H"),
      eraseLine: () => this.#put("\r\x1b[K"),
      keys: (/** @type {(data: string) => void} */ type) => {
        this.#keys = type;
        return () => {
          if (this.#keys === type) this.#keys = undefined;
        };
      },
    };
    const programs = new Map([ROS2, ...BUILTINS, ...FILTERS].map((one) => [one.name, one]));
    this.shell = new Shell(ros, screen, programs, files, bags, interfaces);
    this.shell.history = history.lines;
    this.#terminal.onData((data) => this.#receive(this.#modified(data)));
    this.#terminal.onResize(() => this.#line.redraw());
    this.#terminal.attachCustomKeyEventHandler((event) => this.#handle(event));
    this.fit();
    this.#put(styled(`${say("Try {}, or {} for more. Tab completes.", "ros2 node list", "help")}\n`, "faint"));
    this.#prompt();
  }

  /** Run a line as if it had been typed. @param {string} text */
  enter(text) {
    if (this.#busy) this.#early += `${text}\r`;
    else this.#receive(`${text}\r`);
  }

  /** Press a key, by what a terminal sends for it. @param {string} data */
  press(data) {
    this.#receive(data);
    this.focus();
  }

  /** Let the next letter be typed with Ctrl, for keyboards that lack it, or not. @param {boolean} on */
  holdControl(on) {
    this.#control = on;
    this.focus();
  }

  focus() {
    this.#terminal.focus();
  }

  /** Fit the rows and columns to the element. */
  fit() {
    if (this.#terminal.element?.offsetParent) this.#fit.fit();
  }

  /** @param {Record<string, string>} colours */
  paint(colours) {
    this.#terminal.options.theme = colours;
  }

  /** Let screen readers read the output, or not. @param {boolean} on */
  readAloud(on) {
    this.#terminal.options.screenReaderMode = on;
  }

  close() {
    this.shell.close();
    this.#resume?.();
    this.#terminal.dispose();
    if (!--styles) removeStyle();
  }

  /** The text of the screen and of what was scrolled away, for copying. */
  get text() {
    const { active } = this.#terminal.buffer;
    return Array.from({ length: active.length }, (_, row) => active.getLine(row)?.translateToString(true) ?? "").join("\n");
  }

  /** @param {string} text @param {Style} [style] */
  async #write(text, style) {
    if (!text) return;
    const shown = styled(text, style);
    if (this.#busy) this.#put(shown);
    else this.#line.aside(shown.endsWith("\n") ? shown : `${shown}\r\n`, (data) => this.#put(data));
    this.#fresh = text.endsWith("\n");
    while (this.#waiting > WAITING) {
      await /** @type {Promise<void>} */ (new Promise((resolve) => {
        this.#resume = resolve;
      }));
    }
  }

  /** @param {string} data */
  #put(data) {
    this.#waiting += data.length;
    this.#terminal.write(data, () => {
      this.#waiting -= data.length;
      if (this.#waiting <= WAITING) this.#resume?.();
    });
  }

  /** @param {string} data */
  #modified(data) {
    if (!this.#control) return data;
    this.#control = false;
    this.released();
    return /^[@-_a-z]$/.test(data) ? String.fromCharCode(data.toUpperCase().charCodeAt(0) & 31) : data;
  }

  #prompt() {
    if (!this.#fresh) this.#put("\r\n");
    this.#fresh = true;
    for (const job of this.shell.takeEnded()) this.#put(styled(describe(job)));
    this.#line.begin(this.#begun ? CONTINUED : PROMPT);
  }

  /** @param {string} data what the keyboard sends */
  #receive(data) {
    if (data === SUSPEND && this.#busy) {
      this.#suspend();
      return;
    }
    if (this.#keys) {
      this.#keys(data);
      return;
    }
    if (!this.#busy) {
      this.#feed(data);
      return;
    }
    // Ctrl-C goes to the running command, and drops what was typed ahead.
    const at = data.lastIndexOf(INTERRUPT);
    if (at >= 0 && this.shell.interrupt()) {
      this.#put("^C\r\n");
      this.#early = data.slice(at + 1);
    } else if (this.#early.length < 100_000) {
      this.#early += data;
    }
  }

  /** Ctrl-Z: stop the command, and keep its keys until it goes on. */
  #suspend() {
    const job = this.shell.suspend();
    if (!job) return;
    this.#put(`^Z\r\n${styled(describe(job))}`);
    this.#fresh = true;
    const keys = this.#keys;
    this.#keys = undefined;
    job.suspended?.then(() => {
      if (!job.background) this.#keys ??= keys;
    });
  }

  /** Edit the line by keys, until one of them runs a command. @param {string} data */
  #feed(data) {
    let rest = data;
    while (rest && !this.#busy) rest = this.#type(rest);
    this.#early = rest + this.#early;
  }

  /** @param {string} data @returns {string} the rest, after a key that ended the line */
  #type(data) {
    return this.#line.type(data, {
      enter: (text) => this.#run(text),
      interrupt: () => {
        this.#begun = "";
        this.shell.status = 130;
        this.#put("^C\r\n");
        this.#prompt();
      },
      older: (text) => this.#history.recall(-1, text),
      newer: (text) => this.#history.recall(1, text),
      find: (text, skipped) => this.#history.find(text, skipped),
      complete: (before) => this.#complete(before),
      clear: () => this.#terminal.write("\x1b[2J\x1b[3J\x1b[H"),
    });
  }

  /** @param {string} text the line */
  async #run(text) {
    this.#put("\r\n");
    const whole = this.#begun ? `${this.#begun}\n${text}` : text;
    if (!isFinished(whole)) {
      this.#begun = whole;
      this.#prompt();
      return;
    }
    this.#begun = "";
    this.#history.add(whole);
    this.#become(true);
    try {
      await this.shell.run(whole);
    } catch (error) {
      console.error(error);
    }
    this.#become(false);
    this.#prompt();
    const early = this.#early;
    this.#early = "";
    if (early) this.#feed(early);
  }

  /** @param {boolean} busy */
  #become(busy) {
    this.#busy = busy;
    this.#element.ariaBusy = String(busy);
  }

  /** @param {string} before the cursor */
  async #complete(before) {
    const { start, words } = await complete(before, this.#ros, this.shell);
    if (this.#busy || this.#line.before !== before || !words.length) return;
    const typed = before.slice(start);
    const common = words.reduce(commonStart);
    if (words.length === 1) this.#line.insert(`${common.slice(typed.length)}${/[/.=]$/.test(common) ? "" : " "}`);
    else if (common.length > typed.length) this.#line.insert(common.slice(typed.length));
    else this.#line.aside(styled(inColumns(words, this.#terminal.cols)), (data) => this.#put(data));
  }

  /** Keys that are not the terminal's. @param {KeyboardEvent} event */
  #handle(event) {
    const { key, ctrlKey, shiftKey, type, altKey, metaKey } = event;
    if (type !== "keydown") return true;
    const leaves = this.#escaped && key === "Tab";
    this.#escaped = key === "Escape";
    // Esc, then Tab leaves the terminal for the next control.
    if (leaves || metaKey) return false;
    const copies = ctrlKey && !altKey && key.toLowerCase() === "c" && (shiftKey || this.#terminal.hasSelection());
    if (copies) {
      event.preventDefault();
      navigator.clipboard?.writeText(this.#terminal.getSelection()).catch(() => {});
      this.#terminal.clearSelection();
      return false;
    }
    // The browser pastes, and xterm takes it from there.
    return !(ctrlKey && !altKey && key.toLowerCase() === "v");
  }
}

/** @param {string} a @param {string} b */
function commonStart(a, b) {
  let length = 0;
  while (length < a.length && a[length] === b[length]) length++;
  return a.slice(0, length);
}

// More are not listed.
const LISTED = 200;

/** @param {string[]} words @param {number} columns */
function inColumns(words, columns) {
  const shown = words.slice(0, LISTED);
  const width = Math.max(...shown.map(({ length }) => length)) + 2;
  const count = Math.max(1, Math.floor(columns / width));
  const rows = Math.ceil(shown.length / count);
  const lines = Array.from({ length: rows }, (_, row) =>
    shown.filter((__, index) => index % rows === row).map((word) => word.padEnd(width)).join("").trimEnd());
  return `${lines.join("\n")}\n${words.length > LISTED ? `… ${words.length - LISTED} more\n` : ""}`;
}
