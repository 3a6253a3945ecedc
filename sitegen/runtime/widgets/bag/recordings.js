// @ts-check
// The recordings of this page that the browser keeps: play, save, rename, delete.

import { packed } from "../../bag/metadata.js";
import { Playback } from "../../bag/playback.js";
import { folderOfPage, listed, mended, removed, renamed, renames } from "../../bag/store.js";
import { download } from "../../ui/download.js";
import { button, create, setNote } from "../../ui/elements.js";
import { say } from "../../ui/words.js";
import { plainName, sizeText, SUFFIX } from "./texts.js";

/** @import { Source } from "../../bag/orders.js" */
/** @import { Recording } from "../../bag/recording.js" */
/** @import { Ros } from "../../protocol.js" */
/** @typedef {{name: string, file: Blob, source: Source, recovered: boolean}} Entry */

// What all systems accept as the name of a file.
const NAME = /^[\p{L}\p{N}_][\p{L}\p{N} ._()+-]{0,99}$/u;

export class Recordings {
  #ros;
  #play;
  #begun = false;
  /** Recordings that are only in memory. @type {Entry[]} */
  #loose = [];
  /** Those that were interrupted, and are complete again. @type {Set<string>} */
  #recovered = new Set();
  #list = create("ul", "ros-bag-list");
  #note = create("p", "ros-note");
  element = create("div", "ros-bag-recordings", this.#list, this.#note);

  /** @param {Ros} ros @param {(source: Source, name: string) => void} play */
  constructor(ros, play) {
    this.#ros = ros;
    this.#play = play;
    this.#note.setAttribute("role", "status");
    this.#list.setAttribute("aria-label", say("Recordings"));
  }

  /** List the recordings, once. They can be used when those that were interrupted are complete. */
  async begin() {
    if (this.#begun) return;
    this.#begun = true;
    await this.#look();
    // Most visitors have none, and need no worker.
    if (this.#list.children.length === 0) return;
    // Until then their files change, and one that is saved would be damaged.
    this.#list.inert = true;
    const names = await mended(this.#ros);
    this.#recovered = new Set(names);
    if (names.length > 0) {
      setNote(this.#note, say("A recording that was interrupted is complete again: {}", names.join(", ")));
    }
    await this.#look();
    this.#list.inert = false;
  }

  /** @param {Recording} recording that has ended */
  async add({ name, blob }) {
    if (blob) this.#loose.unshift({ name, file: blob, source: { blob }, recovered: false });
    await this.#look();
  }

  async #look() {
    const files = (await listed()) ?? [];
    const kept = files.map((file) => ({
      name: file.name, file, source: { stored: file.name, folder: folderOfPage() },
      recovered: this.#recovered.has(file.name),
    }));
    this.#list.replaceChildren(...[...this.#loose, ...kept].map((entry) => this.#row(entry)));
  }

  /** @param {Entry} entry */
  #row({ name, file, source, recovered }) {
    const about = [sizeText(file.size), ...(recovered ? [say("recovered")] : [])].join(" · ");
    const shown = create("span", "ros-name", name);
    const title = create("div", "ros-node", shown, create("span", "ros-type", about));
    const play = button(say("Open"), "", () => this.#play(source, name));
    const save = button(say("Save"), "ros-save", () => download(file, name));
    const folder = button(say("Save as folder"), "ros-save-folder", () => this.#saveFolder(source, file, name));
    folder.title = say("A tar file with the folder of 'ros2 bag'");
    const rename = button(say("Rename"), "ros-rename", () => this.#ask(name, shown));
    const remove = button(say("Delete"), "ros-delete", () => this.#remove(name, remove));
    const buttons = [play, save, folder, ...(renames || "blob" in source ? [rename] : []), remove];
    for (const each of buttons) each.setAttribute("aria-label", `${each.textContent} ${name}`);
    return create("li", "ros-bag-entry", title, create("div", "ros-controls", ...buttons));
  }

  /** @param {Source} source @param {Blob} file @param {string} name */
  #saveFolder(source, file, name) {
    // Only to read what is in it: none of its topics gets into the graph.
    const reader = new Playback(this.#ros, source, {}, false);
    reader.addEventListener("open", () => {
      reader.close();
      const folder = plainName(name);
      if (reader.summary) download(packed(file, folder, reader.summary), `${folder}.tar`);
    });
    reader.addEventListener("fail", () => {
      reader.close();
      setNote(this.#note, reader.failure, true);
    });
  }

  /** Put a field for another name in place of the name. @param {string} name @param {HTMLElement} shown */
  #ask(name, shown) {
    const input = create("input", "ros-bag-name");
    input.value = plainName(name);
    input.setAttribute("aria-label", say("Name of the recording"));
    let done = false;
    const end = async (/** @type {string} */ how) => {
      if (done) return;
      done = true;
      const other = how === "Escape" ? name : `${plainName(input.value.trim())}${SUFFIX}`;
      const wrong = other === name ? "" : await this.#rename(name, other);
      setNote(this.#note, wrong, Boolean(wrong));
      if (wrong && how === "Enter") {
        done = false;
        return;
      }
      await this.#look();
      // The keyboard goes on where it was; a pointer is elsewhere already.
      const label = `${say("Rename")} ${wrong ? name : other}`;
      const buttons = [...this.#list.querySelectorAll("button")];
      if (how !== "blur") buttons.find((one) => one.getAttribute("aria-label") === label)?.focus();
    };
    input.addEventListener("blur", () => end("blur"));
    input.addEventListener("keydown", ({ key }) => {
      if (key === "Enter" || key === "Escape") end(key);
    });
    shown.replaceChildren(input);
    input.select();
  }

  /** Rename a recording and return "", or why that is not possible. @param {string} name @param {string} other */
  async #rename(name, other) {
    if (!NAME.test(plainName(other))) {
      return say("A name begins with a letter or digit and has letters, digits, spaces and . _ - + ( ).");
    }
    const taken = [...this.#loose, ...((await listed()) ?? [])].some((one) => one.name.toLowerCase() === other.toLowerCase());
    if (taken) return say("Another recording has this name.");
    const loose = this.#loose.find((entry) => entry.name === name);
    if (loose) loose.name = other;
    else {
      try {
        await renamed(name, other);
      } catch (error) {
        return error instanceof Error ? error.message : String(error);
      }
      if (this.#recovered.delete(name)) this.#recovered.add(other);
    }
    return "";
  }

  /** Delete a recording at the second press. @param {string} name @param {HTMLButtonElement} pressed */
  async #remove(name, pressed) {
    if (pressed.dataset["sure"] === undefined) {
      pressed.dataset["sure"] = "";
      pressed.textContent = say("Really delete?");
      return;
    }
    const loose = this.#loose.findIndex((entry) => entry.name === name);
    if (loose >= 0) this.#loose.splice(loose, 1);
    else await removed(name).catch((error) => setNote(this.#note, String(error?.message ?? error), true));
    await this.#look();
  }
}
