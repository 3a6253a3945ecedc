// @ts-check
// A form to publish messages on a topic, once or repeatedly.

import { isShown } from "../graphNames.js";
import { FormSlot } from "../messages/formSlot.js";
import { create, setNote, setText } from "../ui/elements.js";
import { whileNear } from "../ui/looking.js";
import { say } from "../ui/words.js";
import { Repeat } from "./publish/repeat.js";

/** @import { Publisher, Ros, Shared } from "../protocol.js" */

/**
 * Show the form for `topic`, or for one that the visitor chooses. `type` is necessary if no node uses the topic yet.
 * @param {HTMLElement} element
 * @param {Ros} ros
 * @param {{topic?: string | null, type?: string | null}} options
 * @returns {() => void} unmount
 */
export function mount(element, ros, { topic, type }) {
  const panel = new PublishPanel(ros, topic ?? "", type ?? "");
  element.replaceChildren(...panel.elements);
  ros.keep(element, { topic: "string", message: "object", rate: "string" }, () => panel.read(), (state, odd) => {
    panel.restore(state, odd);
  });
  const unlook = whileNear(element, () => {
    const look = () => panel.look();
    look();
    ros.graph.addEventListener("change", look);
    return () => ros.graph.removeEventListener("change", look);
  });
  return () => {
    unlook();
    panel.close();
    element.replaceChildren();
  };
}

class PublishPanel {
  #ros;
  #fixed;
  #declared;
  #topic;
  /** The topic and type of the form. */
  #shown = { topic: "", type: "" };
  /** @type {Publisher | undefined} */
  #publisher;
  /** How many messages were published with this form. */
  #count = 0;

  #choice = create("select", "");
  #title = create("span", "ros-name");
  #kind = create("span", "ros-type");
  #message;
  #once = create("button", "ros-send", say("Publish once"));
  #repeat = new Repeat(() => this.#send(), (error) => setNote(this.#note, error, true));
  #note = create("p", "ros-note");
  #form;
  #hint = create("p", "ros-hint");
  elements;

  /** @param {Ros} ros @param {string} fixed topic, or "" @param {string} declared type, or "" */
  constructor(ros, fixed, declared) {
    this.#ros = ros;
    this.#fixed = fixed;
    this.#declared = declared;
    this.#topic = fixed;
    this.#message = new FormSlot(ros.types);
    this.#note.setAttribute("role", "status");
    const controls = create("div", "ros-controls", this.#once, this.#repeat.button, this.#repeat.rateLabel);
    this.#form = create("form", "ros-call", this.#message.element, controls, this.#note);
    this.#form.noValidate = true;
    this.#form.addEventListener("submit", (event) => {
      event.preventDefault();
      this.#send();
    });
    this.elements = [this.#createBar(), this.#form, this.#hint];
  }

  #createBar() {
    if (this.#fixed) return create("div", "ros-bar", create("div", "ros-node", this.#title, this.#kind));
    this.#choice.setAttribute("aria-label", say("topic"));
    this.#choice.addEventListener("change", () => {
      this.#topic = this.#choice.value;
      this.look();
    });
    const heading = create("div", "ros-node", create("span", "ros-title", say("Publish")));
    return create("div", "ros-bar", heading, this.#choice);
  }

  /** Return what a link carries of the panel. */
  read() {
    return { topic: this.#fixed ? "" : this.#topic, message: this.#message.typed(), rate: this.#repeat.rate };
  }

  /** @param {Shared} state as `read` returned it @param {() => void} odd called if the message does not fit */
  restore({ topic, message, rate }, odd) {
    // A link chooses among what the visitor could choose.
    if (topic && (this.#fixed || !isShown(topic))) {
      odd();
      return;
    }
    if (topic) this.#topic = topic;
    this.#message.fill(message, odd);
    this.#repeat.rate = rate;
  }

  /** Follow changes of the graph. */
  look() {
    if (!this.#fixed) this.#topic = offer(this.#choice, this.#ros, this.#topic);
    const topic = this.#topic;
    // Keep the form of a topic that is gone: the visitor may publish the same message when it returns.
    const type = this.#findType() || (topic === this.#shown.topic ? this.#shown.type : "");
    if (topic !== this.#shown.topic || type !== this.#shown.type) {
      this.#shown = { topic, type };
      this.#build();
    }
    setText(this.#title, topic);
    setText(this.#kind, type);
    this.#form.hidden = !type;
    this.#once.disabled = !this.#message.filled;
    this.#repeat.button.disabled = !this.#message.filled;
    this.#hint.hidden = Boolean(type);
    setText(this.#hint, topic
      ? say("No node uses {} now, so its type is unknown. Start a node that uses it.", topic)
      : say("No topics to publish on. They appear when nodes start."));
  }

  /** Stop publishing. */
  close() {
    this.#repeat.stop();
    this.#publisher?.close();
    this.#publisher = undefined;
  }

  #findType() {
    if (this.#declared) return this.#declared;
    const types = this.#ros.graph.topics().find(({ name }) => name === this.#topic)?.types ?? [];
    return types.find((type) => this.#ros.types[type]) ?? types[0] ?? "";
  }

  #build() {
    this.close();
    this.#count = 0;
    setNote(this.#note, "");
    try {
      this.#message.show(this.#shown.type);
    } catch (error) {
      const reason = error instanceof Error ? error.message : error;
      setNote(this.#note, say("Publishing is not possible here: {}", reason), true);
    }
  }

  /** Publish the message in the form; return false if it is invalid. */
  #send() {
    const message = this.#message.read();
    if (!message) {
      setNote(this.#note, say("Not published: {}", say("correct the marked fields")), true);
      return false;
    }
    try {
      this.#publisher ??= this.#ros.advertise(this.#topic, this.#shown.type);
      this.#publisher.publish(message);
    } catch (error) {
      const reason = error instanceof Error ? error.message : error;
      setNote(this.#note, say("Not published: {}", reason), true);
      return false;
    }
    this.#count += 1;
    setNote(this.#note, this.#count === 1 ? say("1 message published") : say("{} messages published", this.#count));
    return true;
  }
}

/**
 * Offer the topics whose types the page knows, and return the chosen one.
 * @param {HTMLSelectElement} choice @param {Ros} ros @param {string} chosen
 */
function offer(choice, ros, chosen) {
  const names = ros.graph.topics()
    .filter(({ name, types }) => isShown(name) && types.some((type) => ros.types[type]))
    .map(({ name }) => name);
  if (chosen && !names.includes(chosen)) names.push(chosen);
  if (names.join() !== [...choice.options].map(({ value }) => value).join()) {
    choice.replaceChildren(...names.map((name) => new Option(name)));
  }
  choice.hidden = names.length === 0;
  choice.value = chosen || (names[0] ?? "");
  return choice.value;
}
