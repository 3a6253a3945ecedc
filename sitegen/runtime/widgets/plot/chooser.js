// @ts-check
// A field to add a series to a plot. It offers the numbers in the messages of the topics that exist now.

import { isShown } from "../../graphNames.js";
import { numericFields, parsePath } from "../../messages/path.js";
import { button, create } from "../../ui/elements.js";
import { say } from "../../ui/words.js";

/** @import { Ros } from "../../protocol.js" */

// The number of paths offered, and for one topic.
const MOST = 400;
const PER_TOPIC = 80;
let lastId = 0;

export class Chooser {
  element;
  #ros;
  #input = create("input", "");
  #list = create("datalist", "");
  #fault = create("p", "ros-fault");
  #offered = "";

  /** @param {Ros} ros @param {(path: string) => string} add returns why it cannot be added, or "" */
  constructor(ros, add) {
    this.#ros = ros;
    const id = `ros-paths-${++lastId}`;
    this.#list.id = id;
    this.#fault.id = `${id}-fault`;
    this.#fault.setAttribute("role", "status");
    this.#input.setAttribute("list", id);
    this.#input.setAttribute("aria-label", say("message path of a new curve"));
    this.#input.setAttribute("aria-describedby", this.#fault.id);
    this.#input.placeholder = "/topic.field";
    this.#input.spellcheck = false;
    this.#input.autocomplete = "off";
    this.#input.autocapitalize = "off";
    this.#input.addEventListener("input", () => this.#tell(""));
    const submit = button(say("Add"), "ros-add", () => {});
    submit.type = "submit";
    const row = create("div", "ros-controls", this.#input, submit);
    const form = create("form", "ros-chooser", row, this.#list, this.#fault);
    form.noValidate = true;
    form.addEventListener("submit", (event) => {
      event.preventDefault();
      this.#submit(add);
    });
    this.element = form;
  }

  /** Follow changes of the graph. */
  look() {
    const topics = this.#ros.graph.topics().filter(({ name }) => isShown(name));
    const key = JSON.stringify(topics.map(({ name, types }) => [name, types]));
    if (key === this.#offered) return;
    this.#offered = key;
    const paths = topics.flatMap(({ name, types }) => {
      const type = types.find((one) => this.#ros.types[one]) ?? "";
      return numericFields(type, this.#ros.types, PER_TOPIC).map((field) => `${name}${field}`);
    });
    this.#list.replaceChildren(...paths.slice(0, MOST).map((path) => {
      const option = create("option", "");
      option.value = path;
      return option;
    }));
  }

  /** @param {(path: string) => string} add */
  #submit(add) {
    const text = this.#input.value.trim();
    if (!text) {
      this.#tell(say("Enter a message path, such as {}", "/odom.pose.pose.position.x"));
      return;
    }
    try {
      parsePath(text);
    } catch (error) {
      this.#tell(error instanceof Error ? error.message : String(error));
      return;
    }
    const fault = add(text);
    this.#tell(fault);
    if (!fault) this.#input.value = "";
  }

  /** @param {string} text what is wrong, or "" */
  #tell(text) {
    this.#fault.textContent = text;
    if (text) this.#input.setAttribute("aria-invalid", "true");
    else this.#input.removeAttribute("aria-invalid");
  }
}
