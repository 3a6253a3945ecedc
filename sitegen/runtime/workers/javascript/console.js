// @ts-check
// The console of a program: what it prints stands below its text, and in the tools of the browser.

import { formatWithOptions, inspect } from "../../vendor/inspect.js";

/** @import { Severity } from "../../protocol.js" */

/** @type {Record<string, Severity>} */
const SEVERITIES = { log: "stdout", info: "info", debug: "debug", warn: "warn", error: "error", trace: "stderr" };
// Longer arrays and texts are cut.
const LIMITS = { maxArrayLength: 100, maxStringLength: 10_000 };

/**
 * Let the functions of `console` call `print`, too.
 * @param {(severity: Severity, line: string) => void} print
 */
export function printed(print) {
  /** @type {any} */
  const own = console;
  let indent = "";
  /** @type {Map<string, number>} */
  const counts = new Map();
  /** @type {Map<string, number>} */
  const times = new Map();
  const write = (/** @type {Severity} */ severity, /** @type {string} */ text) => {
    for (const line of text.split("\n")) print(severity, indent + line);
  };
  const also = (/** @type {string} */ name, /** @type {(...values: any[]) => void} */ act) => {
    const usual = own[name]?.bind(own);
    own[name] = (/** @type {any[]} */ ...values) => {
      usual?.(...values);
      act(...values);
    };
  };
  for (const [name, severity] of Object.entries(SEVERITIES)) also(name, (...values) => write(severity, formatted(values)));
  also("dir", (value) => write("stdout", inspect(value, LIMITS)));
  also("table", (value) => write("stdout", inspect(value, LIMITS)));
  also("assert", (right, ...values) => {
    if (!right) write("error", formatted(["Assertion failed", ...values]));
  });
  also("count", (label = "default") => {
    counts.set(label, (counts.get(label) ?? 0) + 1);
    write("stdout", `${label}: ${counts.get(label)}`);
  });
  also("countReset", (label = "default") => counts.delete(label));
  also("time", (label = "default") => times.set(label, performance.now()));
  for (const name of ["timeLog", "timeEnd"]) {
    also(name, (label = "default", ...values) => {
      const since = times.get(label);
      if (since === undefined) return;
      write("stdout", formatted([`${label}: ${(performance.now() - since).toFixed(1)} ms`, ...values]));
      if (name === "timeEnd") times.delete(label);
    });
  }
  for (const name of ["group", "groupCollapsed"]) {
    also(name, (...values) => {
      if (values.length) write("stdout", formatted(values));
      indent += "  ";
    });
  }
  also("groupEnd", () => {
    indent = indent.slice(2);
  });
}

/** @param {any[]} values as console.log takes them */
function formatted(values) {
  return formatWithOptions(LIMITS, ...values);
}
