// @ts-check
// Decompress the chunks of bags, within limits; compress those of recordings.

import { place } from "../place.js";
import { create, program } from "../vendor/lz4.js";
import { unzstd } from "../vendor/mcap.js";
import { Fault } from "./orders.js";

/** The largest chunk that is read, compressed or not, in bytes. */
export const LARGEST_CHUNK = 256 * 1024 * 1024;

// Fast enough for 100 MB/s, and a third smaller than LZ4.
const LEVEL = 1;

/** @param {Uint8Array} bytes @param {bigint} size */
function bounded(bytes, size) {
  if (size > LARGEST_CHUNK || bytes.length > LARGEST_CHUNK) {
    throw new Fault("This bag has chunks of more than {} MB, which the page does not read.", LARGEST_CHUNK / 1024 / 1024);
  }
  return Number(size);
}

/** @type {ReturnType<typeof load> | undefined} */
let loaded;

/** Return what decompresses chunks, by the name of the compression. It throws where a chunk is damaged. */
export function decompressors() {
  return (loaded ??= load());
}

async function load() {
  const lz4 = await loadLz4();
  return {
    lz4: (/** @type {Uint8Array} */ bytes, /** @type {bigint} */ size) => lz4(bytes, bounded(bytes, size)),
    zstd: (/** @type {Uint8Array} */ bytes, /** @type {bigint} */ size) => {
      const target = new Uint8Array(bounded(bytes, size));
      // More than the target holds is an error, or comes in an array of its own.
      const found = unzstd(bytes, target);
      if (found.length !== target.length) throw new RangeError("not of the size that was stated");
      return found;
    },
  };
}

/** @returns {Promise<(bytes: Uint8Array, size: number) => Uint8Array>} */
async function loadLz4() {
  const lz4 = await create({
    instantiateWasm(/** @type {WebAssembly.Imports} */ imports, /** @type {(instance: WebAssembly.Instance) => void} */ done) {
      WebAssembly.instantiate(bytesOf(program), imports).then(({ instance }) => done(instance));
      return {};
    },
  });
  let context = 0;
  return (bytes, size) => {
    context ||= lz4._createDecompressionContext();
    const [source, target] = [lz4._malloc(bytes.length), lz4._malloc(size)];
    try {
      if (!source || (!target && size)) throw new Fault("There is not enough memory for this bag.");
      lz4.HEAPU8.set(bytes, source);
      const found = lz4._decompressFrame(context, target, size, source, bytes.length);
      if (found !== size) {
        context = 0; // one that has met damaged data may not be used again
        throw new RangeError("not of the size that was stated");
      }
      return lz4.HEAPU8.slice(target, target + size);
    } finally {
      lz4._free(source);
      lz4._free(target);
    }
  };
}

/** Load what compresses chunks; it is larger than everything else, and only recorders need it. */
export async function loadCompressor() {
  const { compress, init, program: zstd } = await import(place("bag/zstd.js"));
  await init(bytesOf(zstd));
  return (/** @type {Uint8Array} */ bytes) => {
    const found = compress(bytes, LEVEL);
    return found.length < bytes.length
      ? { compression: "zstd", records: found }
      : { compression: "", records: bytes };
  };
}

/** @param {string} base64 @returns {Uint8Array<ArrayBuffer>} */
function bytesOf(base64) {
  return Uint8Array.from(atob(base64), (character) => character.charCodeAt(0));
}
