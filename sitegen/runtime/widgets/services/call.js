// @ts-check
// The form to call a service, and the response.

import { toYaml } from "../../messages/yaml.js";
import { FormSlot } from "../../messages/formSlot.js";
import { create, setNote, setText } from "../../ui/elements.js";
import { say } from "../../ui/words.js";

/** @import { Ros } from "../../protocol.js" */

// Give up waiting for a response after this time (ms).
const TIMEOUT = 5000;

export class Call {
  #ros;
  #title = create("span", "ros-name");
  #kind = create("span", "ros-type");
  #bar = create("div", "ros-bar", create("div", "ros-node", this.#title, this.#kind));
  request;
  #send = create("button", "ros-send", say("Call"));
  #note = create("p", "ros-note");
  #answer = create("pre", "ros-answer");
  #form;
  #hint = create("p", "ros-hint", say("Choose a service to call it"));
  element;

  #service = "";
  #type = "";
  /** Service and type of the form. */
  #shown = "";
  /** Counts calls: only the response to the last one is shown. */
  #calls = 0;

  /** @param {Ros} ros */
  constructor(ros) {
    this.#ros = ros;
    this.request = new FormSlot(ros.types);
    this.#note.setAttribute("role", "status");
    this.#answer.tabIndex = 0;
    this.#date("present");
    const controls = create("div", "ros-controls", this.#send);
    this.#form = create("form", "ros-call", this.request.element, controls, this.#note, this.#answer);
    this.#form.noValidate = true;
    this.#form.addEventListener("submit", (event) => {
      event.preventDefault();
      this.#call();
    });
    this.element = create("div", "ros-detail", this.#bar, this.#form, this.#hint);
  }

  /** Show the form of a service. @param {string} service @param {string} type or "" @param {number} servers */
  show(service, type, servers) {
    // Keep the form of a service that is gone: the visitor may call it with the same request when it returns.
    if (type || service !== this.#service) this.#type = type;
    this.#service = service;
    if (this.#shown !== `${service} ${this.#type}`) {
      this.#shown = `${service} ${this.#type}`;
      this.#build();
    }
    setText(this.#title, service);
    setText(this.#kind, this.#type);
    this.#bar.hidden = !service;
    this.#form.hidden = !service || !this.#type;
    this.#send.disabled = !this.request.filled;
    this.#send.classList.toggle("ros-idle", servers === 0);
    this.#hint.hidden = !this.#form.hidden;
    const missing = say("No server for {} now. Start the node that provides it.", service);
    setText(this.#hint, service ? missing : say("Choose a service to call it"));
  }

  #build() {
    this.#calls += 1;
    this.#answer.textContent = "";
    setNote(this.#note, "");
    try {
      this.request.show(this.#type && `${this.#type}_Request`, this.#service);
    } catch (error) {
      const reason = error instanceof Error ? error.message : error;
      setNote(this.#note, say("This service cannot be called from here: {}", reason), true);
    }
  }

  /** Say which call the response belongs to. @param {"present" | "previous"} call */
  #date(call) {
    const previous = call === "previous";
    this.#answer.classList.toggle("ros-previous", previous);
    this.#answer.setAttribute("aria-label", previous ? say("previous response") : say("response"));
  }

  async #call() {
    const request = this.request.read();
    // Until the next response, the last one is not what the form asks for.
    this.#date("previous");
    const mine = ++this.#calls;
    if (!request) {
      setNote(this.#note, say("Not called: correct the marked fields"), true);
      return;
    }
    const [service, type] = [this.#service, this.#type];
    setNote(this.#note, say("Waiting for the response…"));
    const begun = performance.now();
    try {
      const response = await this.#ros.call(service, type, request, TIMEOUT);
      if (mine !== this.#calls) return;
      this.#answer.textContent = toYaml(response, `${type}_Response`, this.#ros.types);
      this.#date("present");
      setNote(this.#note, say("{} responded in {} ms", service, (performance.now() - begun).toFixed(1)));
    } catch (error) {
      if (mine === this.#calls) setNote(this.#note, error instanceof Error ? error.message : String(error), true);
    }
  }
}
