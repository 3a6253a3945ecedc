// @ts-check
// The recordings of this page that the browser keeps: play, save, delete.

import { packed } from "../../bag/metadata.js";
import { Playback } from "../../bag/playback.js";
import { folderOfPage, listed, mended, removed } from "../../bag/store.js";
import { download } from "../../ui/download.js";
import { button, create, setNote } from "../../ui/elements.js";
import { say } from "../../ui/words.js";
import { sizeText } from "./texts.js";

/** @import { Source } from "../../bag/orders.js" */
/** @import { Recording } from "../../bag/recording.js" */
/** @import { Ros } from "../../protocol.js" */
/** @typedef {{name: string, file: Blob, source: Source, recovered: boolean}} Entry */

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
    const title = create("div", "ros-node", create("span", "ros-name", name), create("span", "ros-type", about));
    const play = button(say("Open"), "", () => this.#play(source, name));
    const save = button(say("Save"), "ros-save", () => download(file, name));
    const folder = button(say("Save as folder"), "ros-save-folder", () => this.#saveFolder(source, file, name));
    folder.title = say("A tar file with the folder of 'ros2 bag'");
    const remove = button(say("Delete"), "ros-delete", () => this.#remove(name, remove));
    for (const each of [play, save, folder, remove]) each.setAttribute("aria-label", `${each.textContent} ${name}`);
    return create("li", "ros-bag-entry", title, create("div", "ros-controls", play, save, folder, remove));
  }

  /** @param {Source} source @param {Blob} file @param {string} name */
  #saveFolder(source, file, name) {
    // Only to read what is in it: none of its topics gets into the graph.
    const reader = new Playback(this.#ros, source, {}, false);
    reader.addEventListener("open", () => {
      reader.close();
      const folder = name.replace(/\.mcap$/, "");
      if (reader.summary) download(packed(file, folder, reader.summary), `${folder}.tar`);
    });
    reader.addEventListener("fail", () => {
      reader.close();
      setNote(this.#note, reader.failure, true);
    });
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
