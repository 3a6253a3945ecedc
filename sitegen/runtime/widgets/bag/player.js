// @ts-check
// The player of a bag: its buttons, a timeline with the messages of each topic, and the part that is played.

import { sourceAt } from "../../bag/address.js";
import { isChosen } from "../../bag/choice.js";
import { partOf } from "../../bag/cutting.js";
import { Playback } from "../../bag/playback.js";
import { download } from "../../ui/download.js";
import { button, create, enable, setNote, setText, toggle } from "../../ui/elements.js";
import { say } from "../../ui/words.js";
import { partIn, PartView, rounded, within } from "./part.js";
import { clockText, countText, plainName, sizeText } from "./texts.js";
import { Timeline } from "./timeline.js";

/** @import { Part, Source } from "../../bag/orders.js" */
/** @import { Ros, Shared } from "../../protocol.js" */
/** @import { Options } from "../bag.js" */

// What links keep of the bag of the site: seconds, and two of them such as "2-4.5".
const SHAPE = /** @type {const} */ ({ time: "number", part: "string" });
const RATES = [0.1, 0.25, 0.5, 1, 2, 5, 10];

export class PlayerView {
  #ros;
  #options;
  /** @type {Playback | undefined} */
  #playback;
  /** @type {Source | undefined} */
  #source;
  /** Whether the bag of the site was asked for, and whether it is the one that is open. */
  #begun = false;
  #own = false;
  /** Topics that the visitor leaves out. @type {Set<number>} */
  #left = new Set();
  /** What a shared link says of the bag of the site. @type {Shared} */
  #linked = {};
  #odd = () => {};
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
  #timeline = new Timeline((time) => this.#playback?.seek(time), (id, on) => this.#select(id, on));
  #part;
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
    this.#part = new PartView((part) => this.#restrict(part), (part) => this.#save(part));
    this.element = create("section", "ros-bag-player", bar, this.#pick, this.#controls, this.#timeline.element, this.#part.element, this.#hint, this.#note);
    this.element.setAttribute("aria-label", say("Player"));
    this.element.hidden = !shown;
    this.#dropOn(panel);
    setText(this.#title, say("Bag"));
    setText(this.#hint, say("Open a bag, or drop one here: a .mcap file, as 'ros2 bag record' writes it. It stays on this device."));
    this.#controls.hidden = true;
    this.#part.element.hidden = true;
  }

  /** Make the time and the part of the bag of the site part of shared links. @param {{id: string}} panel */
  keep(panel) {
    this.#ros.keep(panel, SHAPE, () => this.#shared(), (state, odd) => {
      this.#linked = state;
      this.#odd = odd;
    });
  }

  #shared() {
    const { summary, state } = this.#playback ?? {};
    if (!this.#own || !summary) return this.#linked;
    const { from, to = summary.duration } = this.#part.part;
    const given = this.#given(summary.duration);
    const part = from === given.from && to === given.to ? "" : `${from}-${to}`;
    return { time: rounded(state?.time ?? 0, summary.duration), part };
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
    this.#open(await sourceAt(file), name, true);
  }

  /** @param {File | undefined} file */
  #choose(file) {
    this.#pick.value = "";
    if (!file) return;
    this.#begun = true;
    this.open({ blob: file }, file.name);
  }

  /** Open a bag in place of the present one. @param {Source} source @param {string} name */
  open(source, name) {
    this.#autostart = false;
    this.#open(source, name, false);
  }

  /** @param {Source} source @param {string} name @param {boolean} own whether it is the bag of the site */
  #open(source, name, own) {
    this.close();
    this.#own = own;
    this.#source = source;
    this.element.hidden = false;
    setText(this.#title, name);
    setText(this.#about, "");
    setNote(this.#note, say("Opening…"));
    this.#hint.hidden = true;
    this.#controls.hidden = true;
    this.#part.element.hidden = true;
    const { remap, clock } = this.#options;
    const playback = new Playback(this.#ros, source, {
      ...this.#choice, remap: remap ?? {}, clock: clock ?? false,
      loop: this.#loop.querySelector("input")?.checked || this.#options.loop, rate: Number(this.#rate.value),
    });
    this.#playback = playback;
    playback.addEventListener("open", () => this.#show(playback));
    playback.addEventListener("note", () => setNote(this.#note, playback.note, true));
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
    this.#left = new Set(tracks.filter(({ topic }) => !isChosen(topic, this.#choice)).map(({ id }) => id));
    this.#timeline.show(summary, playback, this.#left);
    this.#controls.hidden = false;
    this.#part.element.hidden = duration === 0;
    this.#begin(playback, duration);
    const said = notes.slice(0, 3).map(({ text, values }) => say(text, ...values));
    if (this.#own && this.#options.from && this.#options.from >= duration) said.push(say("The bag ends before the part that this page names."));
    setNote(this.#note, said.join(" "), said.length > 0);
    this.#follow(playback);
    if (this.#autostart) playback.play();
  }

  /** Go to the part and the moment that the site or the link names. @param {Playback} playback @param {number} duration */
  #begin(playback, duration) {
    const { time, part: text } = this.#own ? this.#linked : {};
    this.#linked = {};
    const part = text === undefined ? this.#given(duration) : partIn(text, duration);
    if (!part || time < 0 || time > duration) this.#odd();
    const { from, to } = part ?? this.#given(duration);
    this.#part.show(duration, { from, to });
    if (from > 0 || to < duration) this.#restrict(this.#part.part);
    if (time >= 0 && time <= duration) playback.seek(time);
  }

  /** Return the part that the site names, as far as the bag has it; otherwise the whole bag. @param {number} duration */
  #given(duration) {
    const { from = 0, to = duration } = this.#own ? this.#options : {};
    return within({ from, to }, duration) ?? { from: 0, to: duration };
  }

  /** Which topics the author wants to be played. */
  get #choice() {
    const { topics, exclude } = this.#options;
    return { ...(topics && { topics }), exclude: exclude ?? [] };
  }

  /** @param {number} id @param {boolean} on */
  #select(id, on) {
    if (on) this.#left.delete(id);
    else this.#left.add(id);
    this.#playback?.choose(id, on);
  }

  /** @param {Part} part */
  #restrict(part) {
    this.#playback?.setPart(part);
    this.#timeline.limit(part);
  }

  /** @param {Part} part */
  async #save(part) {
    const [source, duration] = [this.#source, this.#playback?.summary?.duration];
    if (!source || duration === undefined) return;
    const [from, to] = [part.from, part.to ?? duration].map((time) => time.toFixed(1));
    const name = `${plainName(this.#title.textContent ?? "")}_${from}-${to}.mcap`;
    setNote(this.#note, say("Saving {}…", name));
    try {
      const { content, notes } = await partOf(this.#ros, source, part, [...this.#left]);
      download(content, name);
      setNote(this.#note, [say("Saved {}, {}", name, sizeText(content.size)), ...notes].join(". "), notes.length > 0);
    } catch (error) {
      setNote(this.#note, error instanceof Error ? error.message : String(error), true);
    }
  }

  /** @param {Playback} playback */
  #follow({ state, summary, failure }) {
    const { time, playing, waiting } = state;
    setText(this.#play, playing ? say("Pause") : say("Play"));
    this.#play.className = playing ? "ros-bag-pause" : "ros-start";
    enable([[this.#play, Boolean(summary) && !(failure && !summary)], [this.#step, Boolean(summary)]]);
    setText(this.#time, `${clockText(time)} / ${clockText(summary?.duration ?? 0)}${waiting ? ` · ${say("loading")}` : ""}`);
    this.#timeline.at(time);
    this.#part.at(time);
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
