// @ts-check
// The player of a bag: its buttons, and a timeline with the messages of each topic.

import { sourceAt } from "../../bag/address.js";
import { Playback } from "../../bag/playback.js";
import { button, create, enable, setNote, setText, toggle } from "../../ui/elements.js";
import { say } from "../../ui/words.js";
import { clockText, countText, sizeText } from "./texts.js";
import { Timeline } from "./timeline.js";

/** @import { Source } from "../../bag/orders.js" */
/** @import { Ros } from "../../protocol.js" */
/** @import { Options } from "../bag.js" */

const RATES = [0.1, 0.25, 0.5, 1, 2, 5, 10];

export class PlayerView {
  #ros;
  #options;
  /** @type {Playback | undefined} */
  #playback;
  /** Whether the bag of the site was asked for. */
  #begun = false;
  #autostart;
  #title = create("span", "ros-name");
  #about = create("span", "ros-type");
  #play = button(say("Play"), "ros-start", () => this.#press());
  #step = button(say("Step"), "ros-step", () => this.#playback?.step());
  #loop = toggle(say("Loop"), (on) => this.#playback?.setLoop(on));
  #rate = create("select", "");
  #time = create("span", "ros-bag-time");
  #note = create("p", "ros-note");
  #hint = create("p", "ros-bag-hint");
  #pick = create("input", "ros-bag-file");
  #timeline = new Timeline((time) => this.#playback?.seek(time), (id, on) => this.#playback?.choose(id, on));
  #controls;
  element;

  /** @param {HTMLElement} panel where files can be dropped @param {Ros} ros @param {Options} options @param {boolean} shown before a bag is opened */
  constructor(panel, ros, options, shown) {
    this.#ros = ros;
    this.#options = options;
    this.#autostart = options.autostart ?? false;
    const open = button(say("Open file…"), "ros-open", () => this.#pick.click());
    const title = create("div", "ros-node", this.#title, this.#about);
    const bar = create("div", "ros-bar", title, create("div", "ros-controls", open));
    this.#pick.type = "file";
    this.#pick.accept = ".mcap";
    this.#pick.hidden = true;
    this.#pick.setAttribute("aria-label", say("Open file…"));
    this.#pick.addEventListener("change", () => this.#choose(this.#pick.files?.[0]));
    this.#controls = create("div", "ros-controls ros-bag-controls", this.#play, this.#step, this.#loop, this.#rates(), this.#time);
    this.#note.setAttribute("role", "status");
    this.element = create("section", "ros-bag-player", bar, this.#pick, this.#controls, this.#timeline.element, this.#hint, this.#note);
    this.element.setAttribute("aria-label", say("Player"));
    this.element.hidden = !shown;
    this.#dropOn(panel);
    setText(this.#title, say("Bag"));
    setText(this.#hint, say("Open a bag, or drop one here: a .mcap file, as 'ros2 bag record' writes it. It stays on this device."));
    this.#controls.hidden = true;
  }

  #rates() {
    const given = this.#options.rate ?? 1;
    const all = [...new Set([...RATES, given])].sort((a, b) => a - b);
    this.#rate.replaceChildren(...all.map((rate) => new Option(`${rate}×`, String(rate))));
    this.#rate.value = String(given);
    this.#rate.setAttribute("aria-label", say("Speed"));
    this.#rate.addEventListener("change", () => this.#playback?.setRate(Number(this.#rate.value)));
    return this.#rate;
  }

  /** @param {HTMLElement} panel */
  #dropOn(panel) {
    panel.addEventListener("dragover", (event) => {
      if (!event.dataTransfer?.types.includes("Files")) return;
      event.preventDefault();
      panel.classList.add("ros-dropping");
    });
    panel.addEventListener("dragleave", () => panel.classList.remove("ros-dropping"));
    panel.addEventListener("drop", (event) => {
      panel.classList.remove("ros-dropping");
      const file = event.dataTransfer?.files[0];
      if (!file) return;
      event.preventDefault();
      this.#choose(file);
    });
  }

  /** Load the bag of the site, once. */
  async begin() {
    const { file } = this.#options;
    if (this.#begun || !file) return;
    this.#begun = true;
    // Of the name in the site, its digest is left out.
    const name = decodeURIComponent(file.split("/").at(-1) ?? "").replace(/\.[0-9a-f]{10}(\.mcap)$/, "$1");
    this.open(await sourceAt(file), name);
  }

  /** @param {File | undefined} file */
  #choose(file) {
    this.#pick.value = "";
    if (!file) return;
    this.#begun = true;
    this.#autostart = false;
    this.open({ blob: file }, file.name);
  }

  /** Open a bag in place of the present one. @param {Source} source @param {string} name */
  open(source, name) {
    this.close();
    this.element.hidden = false;
    setText(this.#title, name);
    setText(this.#about, "");
    setNote(this.#note, say("Opening…"));
    this.#hint.hidden = true;
    this.#controls.hidden = true;
    const { remap, exclude, clock } = this.#options;
    const playback = new Playback(this.#ros, source, {
      remap: remap ?? {}, exclude: exclude ?? [], clock: clock ?? false,
      loop: this.#loop.querySelector("input")?.checked || this.#options.loop, rate: Number(this.#rate.value),
    });
    this.#playback = playback;
    playback.addEventListener("open", () => this.#show(playback));
    playback.addEventListener("marks", () => this.#timeline.mark(playback.marks));
    playback.addEventListener("state", () => this.#follow(playback));
    playback.addEventListener("fail", () => {
      if (!playback.summary) this.#hint.hidden = false;
      setNote(this.#note, playback.failure, true);
      this.#follow(playback);
    });
  }

  /** @param {Playback} playback */
  #show(playback) {
    const { summary } = playback;
    if (!summary) return;
    const { start, duration, count, size, tracks, notes } = summary;
    const when = new Date(start).toLocaleString(document.documentElement.lang || undefined);
    setText(this.#about, [when, clockText(duration), countText(count), sizeText(size)].join(" · "));
    const box = this.#loop.querySelector("input");
    if (box) box.checked ||= this.#options.loop ?? false;
    const left = new Set(tracks.filter(({ topic }) => this.#options.exclude?.includes(topic)).map(({ id }) => id));
    this.#timeline.show(summary, playback.refused, left);
    this.#controls.hidden = false;
    setNote(this.#note, notes.slice(0, 3).map(({ text, values }) => say(text, ...values)).join(" "), notes.length > 0);
    this.#follow(playback);
    if (this.#autostart) playback.play();
  }

  /** @param {Playback} playback */
  #follow({ state, summary, failure }) {
    const { time, playing, waiting } = state;
    setText(this.#play, playing ? say("Pause") : say("Play"));
    this.#play.className = playing ? "ros-bag-pause" : "ros-start";
    enable([[this.#play, Boolean(summary) && !(failure && !summary)], [this.#step, Boolean(summary)]]);
    setText(this.#time, `${clockText(time)} / ${clockText(summary?.duration ?? 0)}${waiting ? ` · ${say("loading")}` : ""}`);
    this.#timeline.at(time);
  }

  #press() {
    if (this.#playback?.state.playing) this.#playback.pause();
    else this.#playback?.play();
  }

  /** Take the bag out of the graph. */
  close() {
    this.#playback?.close();
    this.#playback = undefined;
    this.#timeline.clear();
  }
}
