// @ts-check
// The bytes of a bag: of a file, or of an address, by ranges where its server knows them.

import { LARGEST_CHUNK } from "./compression.js";
import { Fault } from "./orders.js";

/** @typedef {{size(): Promise<bigint>, read(offset: bigint, length: bigint): Promise<Uint8Array>}} Readable */

// What is requested at a time, and how much of it is kept, in bytes and blocks.
const BLOCK = 1024 * 1024;
const KEPT = 24;
// The largest file that is loaded as a whole, where a server has no ranges, in bytes.
const WHOLE = 512 * 1024 * 1024;

/** @param {Blob} blob @returns {Readable} */
export function fromBlob(blob) {
  return {
    size: async () => BigInt(blob.size),
    async read(offset, length) {
      check(offset, length, blob.size);
      return new Uint8Array(await blob.slice(Number(offset), Number(offset + length)).arrayBuffer());
    },
  };
}

/** Ask the server of `url` for its first bytes, and for the others when they are needed. @param {string} url */
export async function fromUrl(url) {
  const response = await load(url, 0, BLOCK);
  const total = Number(/\/(\d+)$/.exec(response.headers.get("content-range") ?? "")?.[1]);
  if (response.status !== 206 || !Number.isSafeInteger(total)) return fromBlob(await whole(response));
  return new Ranges(url, total, new Uint8Array(await response.arrayBuffer()));
}

class Ranges {
  #url;
  #total;
  /** Blocks by number, those used last at the end. @type {Map<number, Promise<Uint8Array>>} */
  #blocks = new Map();

  /** @param {string} url @param {number} total @param {Uint8Array} first block */
  constructor(url, total, first) {
    this.#url = url;
    this.#total = total;
    this.#blocks.set(0, Promise.resolve(first));
  }

  async size() {
    return BigInt(this.#total);
  }

  /** @param {bigint} offset @param {bigint} length */
  async read(offset, length) {
    check(offset, length, this.#total);
    const [begin, end] = [Number(offset), Number(offset + length)];
    const target = new Uint8Array(end - begin);
    const [first, last] = [Math.floor(begin / BLOCK), Math.floor(Math.max(begin, end - 1) / BLOCK)];
    const numbers = Array.from({ length: last - first + 1 }, (_, index) => first + index);
    this.#request(numbers);
    for (const number of numbers) {
      const block = await /** @type {Promise<Uint8Array>} */ (this.#blocks.get(number));
      const at = number * BLOCK;
      target.set(block.subarray(Math.max(0, begin - at), Math.min(BLOCK, end - at)), Math.max(0, at - begin));
    }
    this.#forget();
    return target;
  }

  /** Request what is missing of these blocks, neighbours at once. @param {number[]} numbers */
  #request(numbers) {
    for (let index = 0; index < numbers.length; index++) {
      const number = numbers[index] ?? 0;
      const known = this.#blocks.get(number);
      if (known) {
        this.#blocks.delete(number);
        this.#blocks.set(number, known);
        continue;
      }
      let count = 1;
      while (index + count < numbers.length && !this.#blocks.has(number + count)) count += 1;
      const loaded = this.#load(number * BLOCK, count * BLOCK);
      for (let one = 0; one < count; one++) {
        const [from, to] = [one * BLOCK, (one + 1) * BLOCK];
        // Of a large part, a few blocks are kept, and not all of it for them.
        const block = loaded.then((bytes) => (count > KEPT ? bytes.slice(from, to) : bytes.subarray(from, to)));
        // What could not be loaded is requested again.
        block.catch(() => this.#blocks.delete(number + one));
        this.#blocks.set(number + one, block);
      }
      index += count - 1;
    }
  }

  /** @param {number} begin @param {number} length */
  async #load(begin, length) {
    const response = await load(this.#url, begin, Math.min(length, this.#total - begin));
    const bytes = new Uint8Array(await response.arrayBuffer());
    if (response.status !== 206 || bytes.length !== Math.min(length, this.#total - begin)) {
      throw new Fault("The server no longer sends parts of this bag; reload the page.");
    }
    return bytes;
  }

  #forget() {
    for (const number of this.#blocks.keys()) {
      if (this.#blocks.size <= KEPT) return;
      this.#blocks.delete(number);
    }
  }
}

/** @param {string} url @param {number} begin @param {number} length */
async function load(url, begin, length) {
  /** @type {Response} */
  let response;
  try {
    response = await fetch(url, { headers: { Range: `bytes=${begin}-${begin + length - 1}` } });
  } catch {
    throw new Fault("The bag could not be loaded; check the connection to the site.");
  }
  if (!response.ok) throw new Fault("The bag could not be loaded ({}).", response.status);
  return response;
}

/** Load a file as a whole. @param {Response} response */
async function whole(response) {
  const parts = [];
  let size = 0;
  const reader = response.body?.getReader();
  for (let part; reader && !(part = await reader.read()).done;) {
    size += part.value.length;
    if (size > WHOLE) {
      await reader.cancel();
      throw new Fault("This server sends no parts of files, and the bag has more than {} MB.", WHOLE / 1024 / 1024);
    }
    parts.push(part.value);
  }
  return new Blob(parts);
}

/** @param {bigint} offset @param {bigint} length @param {number} size of the file */
function check(offset, length, size) {
  if (offset < 0n || length < 0n || offset + length > BigInt(size)) {
    throw new Fault("This bag is damaged: its index names bytes that it does not have.");
  }
  if (length > LARGEST_CHUNK) {
    throw new Fault("This bag has chunks of more than {} MB, which the page does not read.", LARGEST_CHUNK / 1024 / 1024);
  }
}
