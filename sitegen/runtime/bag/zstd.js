// @ts-check
// What compresses the chunks of recordings, in a bundle of its own.

export { compress, init, program } from "../vendor/zstd.js";
