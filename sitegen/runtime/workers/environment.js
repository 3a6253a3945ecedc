// @ts-check
// The environment variables that a launch file sets for a node. Loaded by nodes that have any.

/** @import { Severity } from "../protocol.js" */
/** @typedef {[function_: string, file: string, line: number]} Where the place in the source; C++ does not tell it */
/** @typedef {(severity: Severity, logger: string, text: string, time: string, where?: Where) => string} Format */

/** What Emscripten gives every program. */
const USUAL = { USER: "web_user", LOGNAME: "web_user", HOME: "/home/web_user", PATH: "/", PWD: "/", LANG: "C.UTF-8" };
const TOKEN = /\{(\w+)\}/g;
/** @type {Record<string, string>} */
const ESCAPES = { a: "\x07", b: "\b", n: "\n", r: "\r", t: "\t", x1b: "\x1b" };

/**
 * Return the functions of WASI by which a compiled program reads its environment.
 * @param {Record<string, string>} variables
 * @param {() => ArrayBuffer} heap returns the memory of the program
 */
export function imports(variables, heap) {
  const all = Object.entries({ ...USUAL, ...variables });
  const texts = all.map(([name, value]) => new TextEncoder().encode(`${name}=${value}\0`));
  return {
    /** @param {number} count @param {number} size the addresses of the results */
    environ_sizes_get(count, size) {
      const words = new Uint32Array(heap());
      words[count / 4] = texts.length;
      words[size / 4] = texts.reduce((sum, text) => sum + text.length, 0);
      return 0;
    },
    /** @param {number} pointers @param {number} at the addresses of the results */
    environ_get(pointers, at) {
      const words = new Uint32Array(heap());
      for (const [index, text] of texts.entries()) {
        words[pointers / 4 + index] = at;
        new Uint8Array(heap()).set(text, at);
        at += text.length;
      }
      return 0;
    },
  };
}

/**
 * Return how log messages become lines, in the format of RCUTILS_CONSOLE_OUTPUT_FORMAT if there is one. Their time is
 * in seconds since 1970, with nine decimal places.
 * @param {Record<string, string>} variables @returns {Format | undefined}
 */
export function logFormat({ RCUTILS_CONSOLE_OUTPUT_FORMAT: format }) {
  if (!format) return undefined;
  const plain = format.replace(/\\([abnrt]|x1b)/g, (escape, name) => ESCAPES[name] ?? escape);
  return (severity, logger, text, time, where) => {
    /** @type {Record<string, string>} */
    const values = {
      severity: severity.toUpperCase(),
      name: logger,
      message: text,
      time,
      time_as_nanoseconds: time.replace(".", ""),
      date_time_with_ms: local(Number(time) * 1000),
      function_name: where?.[0] ?? "",
      file_name: where?.[1] ?? "",
      line_number: where ? String(where[2]) : "",
    };
    return plain.replace(TOKEN, (token, name) => (Object.hasOwn(values, name) ? String(values[name]) : token));
  };
}

/** The date and time at this place. @param {number} stamp ms since 1970 */
function local(stamp) {
  const shifted = new Date(stamp - new Date(stamp).getTimezoneOffset() * 60_000);
  return shifted.toISOString().replace("T", " ").replace("Z", "");
}
