// @ts-check
// The form to send goals of an action, above the goals.

import { ActionClient } from "../../messages/actionClient.js";
import { FormSlot } from "../../messages/formSlot.js";
import { create, setNote, setText } from "../../ui/elements.js";
import { say } from "../../ui/words.js";
import { GoalList } from "./goals.js";

/** @import { Ros } from "../../protocol.js" */

export class Sender {
  #ros;
  #title = create("span", "ros-name");
  #kind = create("span", "ros-type");
  #bar = create("div", "ros-bar", create("div", "ros-node", this.#title, this.#kind));
  request;
  #send = create("button", "ros-send", say("Send goal"));
  #note = create("p", "ros-note");
  #form;
  #goals = create("div", "ros-goals");
  #hint = create("p", "ros-hint");
  element;

  #action = "";
  #type = "";
  /** Action and type of the form. */
  #shown = "";
  /** @type {ActionClient | undefined} */
  #client;
  /** @type {GoalList | undefined} */
  #list;
  #unwatch = () => {};
  #watching = false;

  /** @param {Ros} ros */
  constructor(ros) {
    this.#ros = ros;
    this.request = new FormSlot(ros.types);
    this.#note.setAttribute("role", "status");
    const controls = create("div", "ros-controls", this.#send);
    this.#form = create("form", "ros-call", this.request.element, controls, this.#note, this.#goals);
    this.#form.noValidate = true;
    this.#form.addEventListener("submit", (event) => {
      event.preventDefault();
      const goal = this.request.read();
      if (goal) this.#client?.send(goal);
      else setNote(this.#note, say("Not sent: correct the marked fields"), true);
    });
    this.element = create("div", "ros-detail", this.#bar, this.#form, this.#hint);
  }

  /**
   * Show the form of an action, and follow its goals while it is `seen`.
   * @param {string} action @param {string} type or "" @param {number} servers @param {boolean} seen
   */
  show(action, type, servers, seen) {
    // Keep the form and the goals of an action whose server is gone.
    if (type || action !== this.#action) this.#type = type;
    this.#action = action;
    if (this.#shown !== `${action} ${this.#type}`) {
      this.#shown = `${action} ${this.#type}`;
      this.#build();
    }
    if (seen && this.#client && !this.#watching) {
      this.#watching = true;
      this.#unwatch = this.#client.watch();
    }
    setText(this.#title, action);
    setText(this.#kind, this.#type);
    this.#bar.hidden = !action;
    this.#form.hidden = !action || !this.#type;
    this.#send.disabled = !this.#client;
    this.#send.classList.toggle("ros-idle", servers === 0);
    this.#hint.hidden = !this.#form.hidden;
    const missing = say("No server for {} now. Start the node that provides it.", action);
    setText(this.#hint, action ? missing : say("Choose an action to send it a goal"));
  }

  /** Stop following goals; results of those that were sent still come. */
  rest() {
    this.#unwatch();
    this.#unwatch = () => {};
    this.#watching = false;
  }

  close() {
    this.rest();
    this.#list?.close();
    this.#client?.close();
    this.#client = undefined;
  }

  #build() {
    this.close();
    this.#goals.replaceChildren();
    setNote(this.#note, "");
    const { types } = this.#ros;
    try {
      this.request.show(this.#type && `${this.#type}_Goal`, this.#action);
      if (!this.#type) return;
      const client = new ActionClient(this.#ros, this.#action, this.#type);
      if (client.missing) {
        throw new Error(say("this page has no definition of {}; start a node that uses it", client.missing));
      }
      this.#client = client;
      this.#list = new GoalList(client, this.#type, types, (text, wrong) => setNote(this.#note, text, wrong));
      this.#goals.append(this.#list.element);
    } catch (error) {
      const reason = error instanceof Error ? error.message : error;
      setNote(this.#note, say("Goals of this action cannot be sent from here: {}", reason), true);
    }
  }
}
