// @ts-check
// Synchronous calls from a blocked worker to another one, whose answers are written to shared memory.
//
//   0  int32  state   of the answer, one of the constants below
//   4  int32  text    size of the answer as JSON
//   8  int32  bytes   size of the Uint8Array in the answer, of which there is at most one
//   12 text and bytes

/**
 * @typedef {{memory: SharedArrayBuffer} | {call: string, args: any[], told: boolean}} FromCaller memory for answers,
 *   larger than before; or a call, whose caller does not wait for the answer if it is only `told`
 */

const HEAD = 12;
const FIRST_SIZE = 64 * 1024;
const WAITING = 0;
const ANSWERED = 1;
const NO_ROOM = 2;
const FAILED = 3;

export class Caller {
  #post;
  #memory = new SharedArrayBuffer(FIRST_SIZE);

  /** @param {(message: FromCaller) => void} post to the worker that answers */
  constructor(post) {
    this.#post = post;
    post({ memory: this.#memory });
  }

  /** Call a function without waiting for it. @param {string} call @param {any[]} args */
  tell(call, args) {
    this.#post({ call, args, told: true });
  }

  /** Call a function and block until it returns. @param {string} call @param {any[]} args @returns {any} */
  ask(call, args) {
    this.#wait({ call, args, told: false });
    let head = new Int32Array(this.#memory, 0, 3);
    if (head[0] === NO_ROOM) {
      this.#memory = new SharedArrayBuffer(HEAD + Number(head[1]) + Number(head[2]));
      this.#wait({ memory: this.#memory });
      head = new Int32Array(this.#memory, 0, 3);
    }
    const [state, text = 0, size = 0] = head;
    if (!text) return undefined;
    // Copy, because decoders do not accept shared memory and the next answer overwrites this one.
    const json = new TextDecoder().decode(new Uint8Array(this.#memory, HEAD, text).slice());
    const bytes = new Uint8Array(this.#memory, HEAD + text, size).slice();
    const value = JSON.parse(json, (_, part) => read(part, bytes));
    if (state === FAILED) throw new Error(value);
    return value;
  }

  /** @param {FromCaller} message */
  #wait(message) {
    const state = new Int32Array(this.#memory, 0, 1);
    Atomics.store(state, 0, WAITING);
    this.#post(message);
    Atomics.wait(state, 0, WAITING);
  }
}

export class Answers {
  #functions;
  /** @type {SharedArrayBuffer | undefined} */
  #memory;
  /** @type {[state: number, text: Uint8Array, bytes: Uint8Array] | undefined} an answer that was too large */
  #rest;

  /** @param {Record<string, (...args: any[]) => any>} functions by name */
  constructor(functions) {
    this.#functions = functions;
  }

  /** @param {FromCaller} message */
  async take(message) {
    if ("memory" in message) {
      this.#memory = message.memory;
      if (this.#rest) this.#write(...this.#rest);
      return;
    }
    const { call, args, told } = message;
    try {
      const value = await this.#functions[call]?.(...args);
      if (!told) this.#answer(ANSWERED, value);
    } catch (error) {
      if (told) throw error;
      this.#answer(FAILED, String(error));
    }
  }

  /** @param {number} state @param {any} value */
  #answer(state, value) {
    let bytes = new Uint8Array();
    const json = JSON.stringify(value, (_, part) => {
      if (part instanceof Uint8Array) bytes = /** @type {Uint8Array<ArrayBuffer>} */ (part);
      return written(part);
    });
    this.#write(state, new TextEncoder().encode(json ?? ""), bytes);
  }

  /** @param {number} state @param {Uint8Array} text @param {Uint8Array} bytes */
  #write(state, text, bytes) {
    if (!this.#memory) return;
    const room = HEAD + text.length + bytes.length <= this.#memory.byteLength;
    this.#rest = room ? undefined : [state, text, bytes];
    if (room) {
      const place = new Uint8Array(this.#memory, HEAD);
      place.set(text);
      place.set(bytes, text.length);
    }
    const head = new Int32Array(this.#memory, 0, 3);
    head[1] = text.length;
    head[2] = bytes.length;
    Atomics.store(head, 0, room ? state : NO_ROOM);
    Atomics.notify(head, 0);
  }
}

/** Replace a value that JSON cannot represent. @param {any} part */
function written(part) {
  if (part instanceof Uint8Array) return { is: "bytes" };
  return part === Infinity ? { is: "infinity" } : part;
}

/** @param {any} part @param {Uint8Array} bytes */
function read(part, bytes) {
  if (part?.is === "bytes") return bytes;
  return part?.is === "infinity" ? Infinity : part;
}
