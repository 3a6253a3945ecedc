// @ts-check
// The recorder of a bag: which topics, how much so far, and the recordings that this browser keeps.

import { isHidden, isShown } from "../../graphNames.js";
import { Recording } from "../../bag/recording.js";
import { folderOfPage, freshName } from "../../bag/store.js";
import { arrange, button, create, enable, setNote, setText, toggle } from "../../ui/elements.js";
import { say } from "../../ui/words.js";
import { follow, TOPIC } from "./actions.js";
import { Recordings } from "./recordings.js";
import { clockText, countText, sizeText } from "./texts.js";

/** @import { Source } from "../../bag/orders.js" */
/** @import { Ros } from "../../protocol.js" */
/** @import { Options } from "../bag.js" */

export class RecorderView {
  #ros;
  #options;
  /** @type {Recording | undefined} */
  #recording;
  /** Topics that the visitor leaves out. @type {Set<string>} */
  #left = new Set();
  /** @type {Map<string, HTMLElement>} */
  #choices = new Map();
  #hidden = false;
  #record;
  #stop = button(say("Stop"), "ros-stop", () => this.#recording?.stop());
  #filled = create("progress", "ros-bag-filled");
  #note = create("p", "ros-note");
  #list = create("div", "ros-bag-choices");
  #summary = create("summary", "", say("Topics"));
  #topics = create("details", "ros-bag-topics", this.#summary, this.#list);
  #recordings;
  #flush = () => this.#recording?.flush();
  #unfollow = () => {};
  #follow = () => this.#offer();
  element;

  /** @param {Ros} ros @param {Options} options @param {(source: Source, name: string) => void} play */
  constructor(ros, options, play) {
    this.#ros = ros;
    this.#options = options;
    this.#hidden = options.hidden ?? false;
    this.#recordings = new Recordings(ros, play);
    const { ask } = options;
    this.#record = button(ask ? say("Agree and record") : say("Record"), "ros-bag-record", () => this.#start());
    const title = create("div", "ros-node", create("span", "ros-title", say("Recorder")));
    const bar = create("div", "ros-bar", title, create("div", "ros-controls", this.#record, this.#stop));
    this.#note.setAttribute("role", "status");
    this.#filled.setAttribute("aria-label", say("Size of the recording"));
    this.#filled.hidden = true;
    const given = options.record && create("p", "ros-bag-given", options.record.join(", "));
    const asked = ask ? [consent(ask)] : [];
    this.element = create("section", "ros-bag-recorder", bar, ...asked, given ?? this.#topics, this.#filled, this.#note, this.#recordings.element);
    this.element.setAttribute("aria-label", say("Recorder"));
    addEventListener("pagehide", this.#flush);
    document.addEventListener("visibilitychange", this.#flush);
    ros.graph.addEventListener("change", this.#follow);
    this.#offer();
    this.#show();
  }

  /** List what this browser keeps. */
  begin() {
    this.#recordings.begin();
  }

  close() {
    removeEventListener("pagehide", this.#flush);
    document.removeEventListener("visibilitychange", this.#flush);
    this.#ros.graph.removeEventListener("change", this.#follow);
    this.#recording?.stop();
    this.#unfollow();
  }

  #start() {
    const { record, limit = 1000, ask } = this.#options;
    const recording = new Recording(this.#ros, folderOfPage(), freshName(), {
      topics: record ? [...record, ...(ask ? [TOPIC] : [])] : undefined, hidden: this.#hidden, exclude: [...this.#left], limit: limit * 1e6, compress: true,
    });
    this.#recording = recording;
    if (ask) this.#unfollow = follow(this.#ros, this.element);
    recording.addEventListener("grow", () => this.#show());
    recording.addEventListener("end", () => this.#end(recording));
    this.#show();
  }

  /** @param {Recording} recording */
  #end(recording) {
    this.#recording = undefined;
    this.#unfollow();
    this.#unfollow = () => {};
    this.#show();
    const { reason, count, size } = recording;
    setNote(this.#note, reason || say("Recorded: {}, {}", countText(count), sizeText(size)), Boolean(reason));
    this.#recordings.add(recording);
  }

  #show() {
    const recording = this.#recording;
    enable([[this.#record, !recording], [this.#stop, Boolean(recording)]]);
    this.#filled.hidden = !recording;
    if (!recording) return;
    const { size, limit, count, topics, began, kept } = recording;
    this.#filled.max = limit;
    this.#filled.value = size;
    const text = say("Recording {} of at most {}: {} on {} topics, {}",
      sizeText(size), sizeText(limit), countText(count), topics, clockText((Date.now() - began) / 1000).slice(0, -2));
    const warning = say("This browser keeps it in memory only: save it before you close the page.");
    setNote(this.#note, kept ? text : `${text}. ${warning}`);
  }

  /** Offer the topics of the graph; all are recorded, and new ones, too, unless the visitor leaves them out. */
  #offer() {
    const all = toggle(say("Hidden topics, too, such as events of services"), (on) => {
      this.#hidden = on;
      this.#offer();
    });
    const box = all.querySelector("input");
    if (box) box.checked = this.#hidden;
    const hidden = this.#choices.get("") ?? all;
    this.#choices.set("", hidden);
    const names = this.#ros.graph.topics()
      .filter(({ name, publishers }) => publishers.length > 0 && (isShown(name) || (this.#hidden && isHidden(name))))
      .map(({ name }) => name);
    const shown = names.map((name) => {
      const known = this.#choices.get(name);
      if (known) return known;
      const choice = toggle(name, (on) => {
        if (on) this.#left.delete(name);
        else this.#left.add(name);
        this.#offer();
      });
      const checkbox = choice.querySelector("input");
      if (checkbox) checkbox.checked = true;
      this.#choices.set(name, choice);
      return choice;
    });
    arrange(this.#list, [...shown, hidden]);
    setText(this.#summary, this.#left.size === 0 ? say("All topics") : say("All topics but {}", [...this.#left].join(", ")));
  }
}

/** What the visitor is asked, and what agreeing means. @param {string} ask */
function consent(ask) {
  const about = say("If you agree, these topics and what you press and enter on this page are recorded. Nothing is sent: the recording stays in this browser until you save or delete it.");
  return create("div", "ros-bag-ask", create("p", "", ask), create("p", "", about));
}
