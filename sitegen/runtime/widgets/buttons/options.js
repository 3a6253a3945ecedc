// @ts-check
// How a node starts next: a form for its parameters, remaps and arguments. Loaded when a visitor opens it.

import { button, create, setText } from "../../ui/elements.js";
import { say } from "../../ui/words.js";
import { tokens } from "../../terminal/shell/parse.js";

/** @import { NodeHandle } from "../../protocol.js" */
/**
 * @typedef {[string, string][]} Pairs
 * @typedef {{parameters: Pairs, remaps: Pairs, words: string}} Options names and values, as typed
 */

// Links may be written by anyone.
const MOST_ROWS = 50;
const LONGEST = 2000;

export class OptionsForm {
  #node;
  #changed;
  #own;
  #parameters;
  #remaps;
  #words = create("input", "");
  #command = create("code", "ros-command");
  #fault = create("p", "ros-fault");
  element;

  /** @param {NodeHandle} node @param {(options: Options | undefined) => void} changed undefined if there are none */
  constructor(node, changed) {
    this.#node = node;
    this.#changed = changed;
    this.#own = node.arguments;
    const change = () => this.#apply();
    this.#parameters = new Rows(say("Parameters"), [say("parameter"), say("value")], change);
    this.#remaps = new Rows(say("Remaps"), [say("from"), say("to")], change);
    this.#words.setAttribute("aria-label", say("Arguments"));
    this.#words.spellcheck = false;
    this.#words.maxLength = LONGEST;
    this.#words.addEventListener("input", change);
    this.#fault.setAttribute("role", "status");
    const reset = button(say("Reset"), "", () => this.set({}));
    const restart = button(say("Start with these"), "ros-start", () => {
      if (this.#apply()) node.restart();
    });
    this.element = create("div", "ros-options",
      create("p", "ros-hint-text", say("These apply when {} starts next.", node.name)),
      this.#parameters.element, this.#remaps.element,
      create("label", "ros-words", say("Arguments"), this.#words),
      this.#fault,
      create("p", "ros-as", say("As a command:"), " ", this.#command),
      create("div", "ros-controls", restart, reset));
    this.set({});
  }

  /** Show options, which may come from a link. Return whether all of them are valid. @param {any} options */
  set({ parameters = [], remaps = [], words = "" }) {
    const valid = isPairs(parameters) && isPairs(remaps) && typeof words === "string" && words.length <= LONGEST;
    this.#parameters.set(isPairs(parameters) ? parameters : []);
    this.#remaps.set(isPairs(remaps) ? remaps : []);
    this.#words.value = typeof words === "string" ? words.slice(0, LONGEST) : "";
    this.#apply();
    return valid;
  }

  /** Give the node its arguments; return whether they are valid. */
  #apply() {
    const options = { parameters: this.#parameters.read(), remaps: this.#remaps.read(), words: this.#words.value.trim() };
    const given = options.parameters.length + options.remaps.length + options.words.length > 0;
    let words;
    try {
      words = wordsOf(options);
    } catch (error) {
      setText(this.#fault, error instanceof Error ? error.message : String(error));
      return false;
    }
    setText(this.#fault, "");
    const whole = joined(this.#own, words);
    this.#node.override(given ? whole : undefined);
    setText(this.#command, ["ros2 run", this.#node.package, this.#node.executable, ...whole.map(quoted)].join(" "));
    this.#changed(given ? options : undefined);
    return true;
  }
}

/** Rows of two fields each; the last one is empty, for another pair. */
class Rows {
  #names;
  #change;
  #list = create("div", "ros-rows");
  element;

  /** @param {string} title @param {[string, string]} names of the fields @param {() => void} change */
  constructor(title, names, change) {
    this.#names = names;
    this.#change = change;
    this.element = create("fieldset", "ros-nested", create("legend", "", title), this.#list);
  }

  /** @param {Pairs} pairs */
  set(pairs) {
    this.#list.replaceChildren();
    for (const pair of [...pairs, /** @type {[string, string]} */ (["", ""])]) this.#add(pair);
  }

  /** @returns {Pairs} */
  read() {
    return [...this.#list.children].map((row) => {
      const [name, value] = [...row.querySelectorAll("input")].map((input) => input.value.trim());
      return /** @type {[string, string]} */ ([name ?? "", value ?? ""]);
    }).filter(([name]) => name);
  }

  /** @param {[string, string]} pair */
  #add(pair) {
    const fields = pair.map((value, index) => {
      const field = create("input", "");
      field.value = value;
      field.placeholder = this.#names[index] ?? "";
      field.setAttribute("aria-label", this.#names[index] ?? "");
      field.spellcheck = false;
      field.setAttribute("autocapitalize", "off");
      field.maxLength = LONGEST;
      field.addEventListener("input", () => {
        const rows = this.#list.children;
        if (row === rows[rows.length - 1] && field.value && rows.length < MOST_ROWS) this.#add(["", ""]);
        this.#change();
      });
      return field;
    });
    const row = create("div", "ros-row-pair", ...fields);
    this.#list.append(row);
  }
}

/** The words that options add to a command line. Throws an Error for an open quote. @param {Options} options */
function wordsOf({ parameters, remaps, words }) {
  let typed;
  try {
    typed = tokens(words).map((token) => (token.kind === "word"
      ? token.word.map((piece) => (typeof piece === "string" ? piece : `$${piece.variable}`)).join("") : token.text));
  } catch {
    throw new Error(say("close every quote"));
  }
  const ros = [...parameters.flatMap(([name, value]) => ["-p", `${name}:=${value}`]),
    ...remaps.flatMap(([from, to]) => ["-r", `${from}:=${to}`])];
  return { typed, ros };
}

/** Join the site's own arguments of a node and those of a visitor. @param {string[]} own @param {{typed: string[], ros: string[]}} words */
function joined(own, { typed, ros }) {
  const at = own.indexOf("--ros-args");
  const before = at < 0 ? [...own, ...typed] : [...own.slice(0, at), ...typed, ...own.slice(at)];
  // Of several values, the last one counts; a remap of the visitor's must come first.
  const remaps = ros.flatMap((word, index) => (word === "-r" ? ["-r", ros[index + 1] ?? ""] : []));
  const parameters = ros.flatMap((word, index) => (word === "-p" ? ["-p", ros[index + 1] ?? ""] : []));
  if (!ros.length) return before;
  const start = before.indexOf("--ros-args");
  if (start < 0) return [...before, "--ros-args", ...remaps, ...parameters];
  const section = before.slice(start + 1);
  const end = section.indexOf("--");
  const inside = end < 0 ? section : section.slice(0, end);
  return [...before.slice(0, start), "--ros-args", ...remaps, ...inside, ...parameters, ...(end < 0 ? [] : section.slice(end))];
}

/** @param {string} word */
function quoted(word) {
  return /^[\w@%+=:,./~^-]+$/.test(word) ? word : `'${word.replaceAll("'", "'\\''")}'`;
}

/** @param {any} value @returns {value is Pairs} */
function isPairs(value) {
  return Array.isArray(value) && value.length <= MOST_ROWS && value.every((pair) =>
    Array.isArray(pair) && pair.length === 2 && pair.every((text) => typeof text === "string" && text.length <= LONGEST));
}
