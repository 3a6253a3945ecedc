// @ts-check
// The parameters of nodes, in forms.

import { toFile } from "../messages/parameters/file.js";
import { list, nodesOf, set } from "../messages/parameters/node.js";
import { parse, textOf } from "../messages/parameters/value.js";
import { place } from "../place.js";
import { download } from "../ui/download.js";
import { arrange, button, create, setNote } from "../ui/elements.js";
import { whileNear } from "../ui/looking.js";
import { say } from "../ui/words.js";
import { Row } from "./parameters/row.js";

/** @import { Ros } from "../protocol.js" */
/** @import { Parameter } from "../messages/parameters/node.js" */

const EVENT = "rcl_interfaces/msg/ParameterEvent";
const SERVICES = ["ListParameters", "GetParameters", "DescribeParameters", "SetParametersAtomically"];
const NONE = say("No node with parameters runs now.");

/**
 * Show the parameters of all nodes, or only of those in `show`.
 * @param {HTMLElement} element
 * @param {Ros} ros
 * @param {{show?: string[] | null}} options full names
 * @returns {() => void} unmount
 */
export function mount(element, ros, { show }) {
  const title = create("span", "ros-title", say("Parameters"));
  const nodes = create("div", "ros-parameter-nodes");
  const hint = create("p", "ros-parameter-hint", NONE);
  element.replaceChildren(create("div", "ros-bar", title), nodes, hint);
  const missing = SERVICES.map((name) => `rcl_interfaces/srv/${name}_Request`).find((type) => !ros.types[type]);
  if (missing) {
    setNote(hint, say("no node on this page uses {}", missing.replace("_Request", "")), true);
    return () => element.replaceChildren();
  }
  /** @type {Map<string, NodeForm>} */
  const forms = new Map();
  const look = () => {
    const names = nodesOf(ros).filter((name) => !show || show.includes(name));
    for (const name of forms.keys()) if (!names.includes(name)) forms.delete(name);
    for (const name of names) if (!forms.has(name)) forms.set(name, new NodeForm(ros, name, names.length === 1));
    arrange(nodes, names.map((name) => /** @type {NodeForm} */ (forms.get(name)).element));
    hint.hidden = names.length > 0;
  };
  const unlook = whileNear(element, () => {
    ros.graph.addEventListener("change", look);
    const unsubscribe = ros.types[EVENT]
      ? ros.subscribe("/parameter_events", EVENT, (event) => forms.get(event.node)?.hear(event), { depth: 100 }) : () => {};
    look();
    for (const form of forms.values()) form.read();
    return () => {
      ros.graph.removeEventListener("change", look);
      unsubscribe();
    };
  });
  return () => {
    unlook();
    element.replaceChildren();
  };
}

class NodeForm {
  #ros;
  #name;
  #rows = create("div", "ros-parameter-list");
  #note = create("p", "ros-parameter-hint");
  /** @type {Parameter[]} */
  #parameters = [];
  /** @type {Map<string, Row>} */
  #row = new Map();
  /** @type {Promise<void> | undefined} */
  #reading;
  /** Whether something changed while the parameters were read. */
  #stale = false;
  element;

  /** @param {Ros} ros @param {string} name of the node @param {boolean} open */
  constructor(ros, name, open) {
    this.#ros = ros;
    this.#name = name;
    const pick = create("input", "");
    pick.type = "file";
    pick.accept = ".yaml,.yml";
    pick.hidden = true;
    pick.addEventListener("change", async () => {
      const [file] = pick.files ?? [];
      if (file) await this.#load(await file.text());
      pick.value = "";
    });
    const save = button(say("Save"), "", () =>
      download(new Blob([toFile(name, this.#parameters)], { type: "text/yaml" }), `${name.split("/").at(-1)}.yaml`));
    const load = button(say("Load"), "", () => pick.click());
    save.title = say("Save as YAML, for --params-file");
    load.title = say("Set what a YAML file says");
    const controls = create("div", "ros-controls", save, load, pick);
    this.element = create("details", "ros-parameter-node", create("summary", "", name), this.#rows, this.#note, controls);
    this.element.open = open;
    this.#note.setAttribute("role", "status");
    // Asked for when somebody looks.
    this.element.addEventListener("toggle", () => this.read());
    this.read();
  }

  /** Ask the node for its parameters, if they are shown. */
  async read() {
    this.#stale = true;
    if (!this.element.open) return;
    this.#reading ??= this.#ask().finally(() => {
      this.#reading = undefined;
    });
    await this.#reading;
  }

  async #ask() {
    try {
      while (this.#stale) {
        this.#stale = false;
        this.#parameters = await list(this.#ros, this.#name);
      }
      this.#draw();
      this.#tell(this.#parameters.length ? "" : say("This node has no parameters."));
    } catch (error) {
      this.#tell(error instanceof Error ? error.message : String(error), true);
    }
  }

  /** Show what others have changed. @param {any} event a ParameterEvent */
  hear({ new_parameters: fresh, changed_parameters: changed, deleted_parameters: deleted }) {
    if (fresh.length || deleted.length || this.#reading) {
      this.read();
      return;
    }
    for (const { name, value } of changed) this.#row.get(name)?.show(value);
  }

  #draw() {
    const former = this.#row;
    this.#row = new Map(this.#parameters.map((parameter) => {
      const { name } = parameter;
      const row = former.get(name);
      row?.describe(parameter);
      return [name, row ?? new Row(parameter, (value) => set(this.#ros, this.#name, [{ name, value }]))];
    }));
    arrange(this.#rows, [...this.#row.values()].map(({ element }) => element));
  }

  /** Set what a file says: all of it, or nothing if something is wrong. @param {string} text */
  async #load(text) {
    /** @type {string[]} */
    const faults = [];
    try {
      /** @type {typeof import("../messages/parameters/fileReader.js")} */
      const { fromFile } = await import(place("messages/parameters/fileReader.js"));
      const changed = [];
      for (const [name, given] of fromFile(text, this.#name)) {
        const value = this.#valueOf(name, given, faults);
        if (value) changed.push({ name, value });
      }
      const reason = faults.length || !changed.length ? "" : await set(this.#ros, this.#name, changed);
      if (reason) faults.push(reason);
    } catch (error) {
      faults.push(error instanceof Error ? error.message : String(error));
    }
    await this.read();
    const told = faults.length ? [say("Nothing was set:"), ...faults] : [say("All values were set.")];
    this.#tell(told.join("\n"), faults.length > 0);
  }

  /**
   * Return the value that a file gives to a parameter; undefined if that has it already, or if something is wrong.
   * @param {string} name @param {string} given @param {string[]} faults
   */
  #valueOf(name, given, faults) {
    try {
      const parameter = this.#parameters.find((each) => each.name === name);
      if (!parameter) throw new Error(say("the node has no such parameter"));
      const value = parse(given, parameter.value.type);
      return textOf(value) === textOf(parameter.value) ? undefined : value;
    } catch (error) {
      faults.push(`${name}: ${error instanceof Error ? error.message : String(error)}`);
      return undefined;
    }
  }

  /** @param {string} text @param {boolean} [wrong] */
  #tell(text, wrong = false) {
    setNote(this.#note, text, wrong);
    this.#note.hidden = !text;
  }
}
