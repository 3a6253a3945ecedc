// @ts-check
// What the page itself has published comes back from a topic to which it subscribes, and is left out.

// rosbridge does not tell who sent a message. One that has not come back after this time (ms) never will.
const LONGEST = 5000;
// Of one topic.
const MOST = 1000;

export class Echoes {
  /** When each message was sent, the first one first, by what stands for its bytes. @type {Map<string, number[]>} */
  #sent = new Map();

  /** @param {Uint8Array} message that the page has sent, as the codec writes it */
  add(message) {
    const since = performance.now() - LONGEST;
    // The order is that of the first sending.
    for (const [key, times] of this.#sent) {
      if (this.#sent.size < MOST && (times.at(-1) ?? 0) > since) break;
      this.#sent.delete(key);
    }
    const key = digest(message);
    this.#sent.set(key, [...(this.#sent.get(key) ?? []), performance.now()].slice(-MOST));
  }

  /** Whether a message is one that the page has sent; each is so once. @param {Uint8Array} message */
  take(message) {
    if (this.#sent.size === 0) return false;
    const key = digest(message);
    const times = this.#sent.get(key)?.filter((time) => time > performance.now() - LONGEST) ?? [];
    const found = times.shift() !== undefined;
    if (times.length > 0) this.#sent.set(key, times);
    else this.#sent.delete(key);
    return found;
  }
}

/** Return a text that other bytes hardly have: their number, and FNV-1a of them. @param {Uint8Array} bytes */
function digest(bytes) {
  let hash = 0x811c9dc5;
  for (const byte of bytes) hash = Math.imul(hash ^ byte, 0x01000193);
  return `${bytes.length} ${hash}`;
}
