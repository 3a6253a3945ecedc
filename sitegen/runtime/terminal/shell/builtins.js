// @ts-check
// The commands of the shell itself.

import { download } from "../../ui/download.js";
import { Failure, Interrupt, pause, VARIABLES } from "./shell.js";
import { DIFFERENCES } from "./differences.js";

/** @import { Io, Job, Program } from "./shell.js" */

/** @type {Program[]} */
export const BUILTINS = [
  { name: "bg", about: "let a stopped job go on in the background: bg %1", run: (io) => background(io) },
  { name: "cat", about: "print files, or what comes through a pipe", run: cat },
  { name: "clear", about: "empty the screen", run: async (io) => io.shell.clear() },
  { name: "echo", about: "print words", run: echo },
  { name: "env", about: "list the variables", run: environment },
  { name: "false", about: "fail", run: async () => 1 },
  { name: "fg", about: "bring a job to the foreground: fg %1", run: (io) => foreground(io) },
  { name: "help", about: "list the commands, and what differs from a real shell", run: help },
  { name: "history", about: "list the lines that were entered", run: history },
  { name: "jobs", about: "list what runs in the background", run: jobs },
  { name: "kill", about: "interrupt a job: kill %1", run: kill },
  { name: "ls", about: "list the files of this tab, and recordings", run: list },
  { name: "printenv", about: "list the variables, or print one", run: environment },
  { name: "pwd", about: "print the folder, of which there is one", run: (io) => io.out("/\n") },
  { name: "rm", about: "remove files and recordings", run: remove },
  { name: "save", about: "save files and recordings on your device", run: save },
  { name: "sleep", about: "wait some seconds", run: sleep },
  { name: "true", about: "succeed", run: async () => 0 },
  { name: "wait", about: "wait for the jobs in the background", run: waitForJobs },
];

/** @param {Io} io */
async function cat({ words, shell, input, signal, out }) {
  if (!words.length && input) {
    for await (const line of input.lines(signal)) await out(`${line}\n`);
    return;
  }
  if (!words.length) throw new Failure("cat: name a file");
  for (const name of words) {
    try {
      await out(shell.readFile(name));
    } catch (error) {
      throw error instanceof Failure ? new Failure(`cat: ${error.message}`) : error;
    }
  }
}

/** @param {Io} io */
async function echo({ words, out }) {
  const plain = words[0] === "-n";
  await out(words.slice(plain ? 1 : 0).join(" ") + (plain ? "" : "\n"));
}

/** @param {Io} io */
async function help({ shell, out }) {
  await out("ros2 works as in a terminal on your computer, with the nodes of this page. `ros2 -h` lists its commands.\n\n");
  const programs = [...shell.programs.values()].sort((one, other) => (one.name < other.name ? -1 : 1));
  const width = Math.max(...programs.map(({ name }) => name.length));
  for (const { name, about } of programs) await out(`  ${name.padEnd(width)}  ${about}\n`);
  await out("\nTab completes, Ctrl-C interrupts, & runs in the background, ↑ brings back. Different from a real shell:\n");
  for (const one of DIFFERENCES) await out(`  - ${one}\n`);
}

/** @param {Io} io */
async function history({ shell, out }) {
  for (const [index, line] of shell.history.entries()) await out(`${String(index + 1).padStart(5)}  ${line}\n`);
}

/** @param {Io} io */
async function jobs({ shell, out }) {
  for (const job of [...shell.jobs.values()].filter(({ background }) => background)) {
    await out(describe(job));
    if (job.status !== undefined) shell.jobs.delete(job.id);
  }
}

/** How `jobs` shows a job. @param {Job} job */
export function describe({ id, text, status, suspended }) {
  const state = suspended ? "Stopped" : status === undefined ? "Running" : status === 0 ? "Done" : `Exit ${status}`;
  return `[${id}]  ${state.padEnd(24)}${text}\n`;
}

/** @param {Io} io @returns {Promise<number>} */
async function foreground({ words, shell, out, signal }) {
  const job = find(shell, words[0], "fg");
  await out(`${job.text}\n`);
  const stop = () => job.stop.abort(signal.reason);
  signal.addEventListener("abort", stop);
  const status = await shell.bring(job);
  signal.removeEventListener("abort", stop);
  if (job.status !== undefined) shell.jobs.delete(job.id);
  return status;
}

/** @param {Io} io */
async function background({ words, shell, out }) {
  const job = find(shell, words[0], "bg");
  job.resume();
  await out(`[${job.id}]  ${job.text} &\n`);
}

/** @param {Io} io */
async function environment({ words: [name], out }) {
  if (name !== undefined && !Object.hasOwn(VARIABLES, name)) return 1;
  for (const [key, value] of Object.entries(VARIABLES)) {
    if (name === undefined) await out(`${key}=${value}\n`);
    else if (name === key) await out(`${value}\n`);
  }
  return 0;
}

/** @param {Io} io */
async function kill({ words, shell }) {
  const names = words.filter((word) => !word.startsWith("-"));
  if (!names.length) throw new Failure("kill: usage: kill %job", 2);
  for (const name of names) find(shell, name, "kill").stop.abort(new Interrupt());
}

/** @param {import("./shell.js").Shell} shell @param {string | undefined} name @param {string} who asks */
function find(shell, name, who) {
  const background = [...shell.jobs.values()].filter((job) => job.background && job.status === undefined);
  const job = name ? background.find(({ id }) => String(id) === name.replace(/^%/, "")) : background.at(-1);
  if (!job) throw new Failure(`${who}: ${name ?? "current"}: no such job`);
  return job;
}

/** @param {Io} io */
async function list({ shell, out }) {
  for (const name of [...shell.files.keys(), ...(await shell.bags.recordings())].sort()) await out(`${name}\n`);
}

/** @param {Io} io */
async function remove({ words, shell }) {
  for (const name of words) {
    if (shell.files.delete(name) || (await shell.bags.remove(name))) continue;
    throw new Failure(`rm: cannot remove '${name}': No such file or directory`);
  }
}

/** @param {Io} io */
async function save({ words, shell }) {
  if (!words.length) throw new Failure("save: name a file");
  for (const name of words) {
    const text = shell.files.get(name);
    const file = text === undefined ? await shell.bags.file(name) : new Blob([text], { type: "text/plain" });
    if (!file) throw new Failure(`save: ${name}: No such file or directory`);
    download(file, name);
  }
}

/** @param {Io} io */
async function sleep({ words, signal }) {
  const times = words.map((word) => /^(\d+\.?\d*|\.\d+)([smh]?)$/.exec(word));
  if (!words.length) throw new Failure("sleep: missing operand");
  const wrong = words[times.indexOf(null)];
  if (wrong !== undefined) throw new Failure(`sleep: invalid time interval '${wrong}'`);
  const units = { s: 1, m: 60, h: 3600 };
  const seconds = times.reduce((sum, time) => sum + Number(time?.[1]) * (units[/** @type {"s"} */ (time?.[2])] ?? 1), 0);
  await pause(Math.min(seconds * 1000, 2 ** 31 - 1), signal);
}

/** @param {Io} io */
async function waitForJobs({ shell, signal }) {
  const ended = Promise.all([...shell.jobs.values()].filter(({ background }) => background).map((job) => job.ended));
  const aborted = new Promise((_, reject) => signal.addEventListener("abort", () => reject(signal.reason), { once: true }));
  await Promise.race([ended, aborted]);
}
