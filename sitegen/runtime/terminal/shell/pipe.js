// @ts-check
// What connects two commands: a text of bounded length. A writer waits while it is full, and is told when the reader
// is gone.

// A writer waits when the pipe has so many characters.
const CAPACITY = 65_536;

/** The reader of a pipe has ended, so its writers end, too. */
export class Broken extends Error {}

export class Pipe {
  /** @type {string[]} */
  #parts = [];
  #size = 0;
  #ended = false;
  #closed = new AbortController();
  /** Called when the state has changed. @type {(() => void)[]} */
  #waiting = [];

  /** Aborts when the reader is gone. */
  get closed() {
    return this.#closed.signal;
  }

  /** Append a text; wait while the pipe is full. @param {string} text */
  async write(text) {
    if (this.#closed.signal.aborted) throw new Broken("broken pipe");
    this.#parts.push(text);
    this.#size += text.length;
    this.#wake();
    while (this.#size > CAPACITY && !this.#closed.signal.aborted) await this.#change();
    if (this.#closed.signal.aborted) throw new Broken("broken pipe");
  }

  /** Nothing more will be written. */
  end() {
    this.#ended = true;
    this.#wake();
  }

  /** Nothing more will be read. */
  close() {
    this.#parts = [];
    this.#size = 0;
    this.#closed.abort(new Broken("broken pipe"));
    this.#wake();
  }

  /**
   * Yield each line, without its end.
   * @param {AbortSignal} signal
   */
  async *lines(signal) {
    let rest = "";
    for (;;) {
      const part = await this.#read(signal);
      if (part === undefined) break;
      const lines = (rest + part).split("\n");
      rest = lines.pop() ?? "";
      yield* lines;
      // A line without an end would grow without an end.
      if (rest.length > CAPACITY) {
        yield rest;
        rest = "";
      }
    }
    if (rest) yield rest;
  }

  /** Return what is there, waiting for more; undefined at the end. @param {AbortSignal} signal */
  async #read(signal) {
    const wake = () => this.#wake();
    signal.addEventListener("abort", wake);
    while (this.#parts.length === 0 && !this.#ended && !signal.aborted) await this.#change();
    signal.removeEventListener("abort", wake);
    if (signal.aborted) throw signal.reason;
    if (this.#parts.length === 0) return undefined;
    const text = this.#parts.join("");
    this.#parts = [];
    this.#size = 0;
    this.#wake();
    return text;
  }

  #change() {
    return /** @type {Promise<void>} */ (new Promise((resolve) => this.#waiting.push(resolve)));
  }

  #wake() {
    for (const resume of this.#waiting.splice(0)) resume();
  }
}
