// @ts-check
// Read the messages of a bag before they are due, within limits of memory.

/** @import { Message } from "../../bag/chunk.js" */

const MOST = { bytes: 16 * 1024 * 1024, messages: 5000 };

export class Ahead {
  #messages;
  #arrived;
  /** @type {Message[]} */
  #queue = [];
  #first = 0;
  #bytes = 0;
  #closed = false;
  /** @type {(() => void) | undefined} */
  #room;
  /** Whether there are no more messages to read. */
  ended = false;
  /** Why not all could be read. @type {unknown} */
  failure;

  /** @param {AsyncGenerator<Message>} messages @param {() => void} arrived called when there are more, or no more */
  constructor(messages, arrived) {
    this.#messages = messages;
    this.#arrived = arrived;
    this.#fill();
  }

  /** The next message, if it is here. */
  peek() {
    return this.#queue[this.#first];
  }

  /** Remove the next message and return it. */
  shift() {
    const message = this.#queue[this.#first];
    if (!message) return undefined;
    this.#bytes -= message.data.length;
    this.#first += 1;
    if (this.#first * 2 >= this.#queue.length) {
      this.#queue.splice(0, this.#first);
      this.#first = 0;
    }
    if (!this.#full) this.#room?.();
    return message;
  }

  /** Wait for the next message and remove it; undefined if there is none. @returns {Promise<Message | undefined>} */
  async next() {
    while (!this.peek() && !this.ended && !this.#closed) {
      await new Promise((resolve) => setTimeout(resolve, 5));
    }
    if (!this.peek() && this.failure) throw this.failure;
    return this.shift();
  }

  close() {
    this.#closed = true;
    this.#room?.();
  }

  get #full() {
    return this.#bytes > MOST.bytes || this.#queue.length - this.#first > MOST.messages;
  }

  async #fill() {
    try {
      for await (const message of this.#messages) {
        if (this.#closed) return;
        const woken = this.#queue.length === this.#first;
        // A copy, because the whole chunk would stay in memory as long as one of its messages does.
        this.#queue.push({ ...message, data: message.data.slice() });
        this.#bytes += message.data.length;
        if (woken) this.#arrived();
        while (this.#full && !this.#closed) {
          await new Promise((resolve) => (this.#room = () => resolve(undefined)));
        }
      }
    } catch (error) {
      this.failure = error;
    }
    this.ended = true;
    if (!this.#closed) this.#arrived();
  }
}
