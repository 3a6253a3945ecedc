// @ts-check
// A bag as `ros2 bag` keeps it: a folder with a metadata.yaml, packed as a tar file.

/** @import { Summary } from "./orders.js" */

const BLOCK = 512;

/**
 * Return the folder of a bag as a tar file. Its content is not read into memory.
 * @param {Blob} file @param {string} name of the folder @param {Summary} summary
 */
export function packed(file, name, summary) {
  const text = new TextEncoder().encode(metadata(`${name}_0.mcap`, summary));
  const parts = [
    entry(`${name}/metadata.yaml`, text.length), text, padding(text.length),
    entry(`${name}/${name}_0.mcap`, file.size), file, padding(file.size),
    new Uint8Array(2 * BLOCK),
  ];
  return new Blob(parts, { type: "application/x-tar" });
}

/** @param {string} file @param {Summary} summary */
function metadata(file, { start, duration, count, tracks }) {
  const nanoseconds = Math.round(duration * 1e9);
  const begin = `${Math.floor(start)}${String(Math.round((start % 1) * 1e6)).padStart(6, "0")}`;
  const topics = tracks.map(({ topic, type, count: own, qos }) => `    - topic_metadata:
        name: ${topic}
        type: ${type}
        serialization_format: cdr
        offered_qos_profiles: ${JSON.stringify(qos)}
      message_count: ${own}`);
  return `rosbag2_bagfile_information:
  version: 5
  storage_identifier: mcap
  duration:
    nanoseconds: ${nanoseconds}
  starting_time:
    nanoseconds_since_epoch: ${begin}
  message_count: ${count}
  topics_with_message_count:${topics.length ? `\n${topics.join("\n")}` : " []"}
  compression_format: ""
  compression_mode: ""
  relative_file_paths:
    - ${file}
  files:
    - path: ${file}
      starting_time:
        nanoseconds_since_epoch: ${begin}
      duration:
        nanoseconds: ${nanoseconds}
      message_count: ${count}
`;
}

/** Return the head of a file in a tar file. @param {string} path @param {number} size */
function entry(path, size) {
  const head = new Uint8Array(BLOCK);
  const write = (/** @type {number} */ at, /** @type {string} */ text) => head.set(new TextEncoder().encode(text), at);
  // Octal digits have room for 8 GB.
  const octal = (/** @type {number} */ number, /** @type {number} */ digits) => number.toString(8).padStart(digits, "0");
  write(0, path);
  write(100, "0000644\0");
  write(108, "0000000\0");
  write(116, "0000000\0");
  write(124, `${octal(size, 11)}\0`);
  write(136, `${octal(Math.floor(Date.now() / 1000), 11)}\0`);
  write(148, "        ");
  write(156, "0");
  write(257, "ustar\x0000");
  const sum = head.reduce((total, byte) => total + byte, 0);
  write(148, `${octal(sum, 6)}\0 `);
  return head;
}

/** @param {number} size */
function padding(size) {
  return new Uint8Array((BLOCK - (size % BLOCK)) % BLOCK);
}
