// @ts-check
// sort, uniq, tee and less.

import { Failure } from "./shell.js";

/** @import { Io } from "./shell.js" */

// The most lines that sort keeps.
const MOST = 1_000_000;

/** @param {Io} io @param {any} args @param {AsyncIterable<string>} lines */
export async function sort({ out }, { reverse, numeric, unique }, lines) {
  /** @type {string[]} */
  const found = [];
  for await (const line of lines) {
    if (found.push(line) > MOST) throw new Failure(`sort: more than ${MOST} lines`);
  }
  const number = (/** @type {string} */ line) => parseFloat(line) || 0;
  const plain = (/** @type {string} */ one, /** @type {string} */ other) => (one < other ? -1 : Number(one > other));
  found.sort((one, other) => (numeric ? number(one) - number(other) : 0) || plain(one, other));
  if (reverse) found.reverse();
  for (const [index, line] of found.entries()) if (!unique || line !== found[index - 1]) await out(`${line}\n`);
}

/** @param {Io} io @param {any} args @param {AsyncIterable<string>} lines */
export async function uniq({ out }, { counted, repeated, single }, lines) {
  let [last, count] = ["", 0];
  const tell = async () => {
    if (!count || (repeated && count < 2) || (single && count > 1)) return;
    await out(`${counted ? `${String(count).padStart(7)} ` : ""}${last}\n`);
  };
  for await (const line of lines) {
    if (count && line === last) {
      count++;
      continue;
    }
    await tell();
    [last, count] = [line, 1];
  }
  await tell();
}

/** @param {Io} io @param {any} args @param {AsyncIterable<string>} lines */
export async function tee({ out, shell }, { file: files, append }, lines) {
  for (const file of files) shell.writeFile(file, "", append);
  for await (const line of lines) {
    for (const file of files) shell.writeFile(file, `${line}\n`, true);
    await out(`${line}\n`);
  }
}

/** A text page by page. The terminal itself scrolls back. @param {Io} io @param {any} _ @param {AsyncIterable<string>} lines */
export async function less({ out, shell, keys, toScreen, signal }, _, lines) {
  if (!keys || !toScreen) {
    for await (const line of lines) await out(`${line}\n`);
    return;
  }
  let typed = "";
  let wake = () => {};
  const end = keys((data) => {
    typed += data;
    wake();
  });
  signal.addEventListener("abort", () => wake(), { once: true });
  try {
    let left = shell.rows - 1;
    for await (const line of lines) {
      while (left <= 0) {
        await out(":", "bold");
        while (!typed && !signal.aborted) {
          await /** @type {Promise<void>} */ (new Promise((resolve) => {
            wake = resolve;
          }));
        }
        shell.eraseLine();
        if (signal.aborted || /^[qQ\x03]/.test(typed)) return;
        left = /^[\r\nj]|^\x1b\[B/.test(typed) ? 1 : /^[ fd]|^\x1b\[6~/.test(typed) ? shell.rows - 1 : 0;
        typed = "";
      }
      await out(`${line}\n`);
      left--;
    }
  } finally {
    end();
  }
}
