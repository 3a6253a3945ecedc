// @ts-check
// The visitor's own camera, which publishes images after a click.

import { button, create, enable, setNote, setText } from "../ui/elements.js";
import { say } from "../ui/words.js";
import { Device } from "./camera/device.js";
import { headerOf, infoOf, rawOf } from "./camera/messages.js";

/** @import { Publisher, Ros } from "../protocol.js" */

/**
 * @typedef {{topic: string, info?: string | null, compressed?: boolean, width?: number, rate?: number,
 *   frame?: string}} Options
 */

const RAW = "sensor_msgs/msg/Image";
const COMPRESSED = "sensor_msgs/msg/CompressedImage";
const INFO = "sensor_msgs/msg/CameraInfo";
const QUALITY = 0.8;

/**
 * Publish images of the camera on `topic`.
 * @param {HTMLElement} element
 * @param {Ros} ros
 * @param {Options} options
 * @returns {() => void} unmount
 */
export function mount(element, ros, options) {
  const panel = new CameraPanel(element, ros, options);
  element.replaceChildren(...panel.elements);
  const hide = () => {
    if (document.visibilityState === "hidden") panel.stop(say("Stopped because the page was hidden."));
  };
  document.addEventListener("visibilitychange", hide);
  return () => {
    document.removeEventListener("visibilitychange", hide);
    panel.stop();
    element.replaceChildren();
  };
}

class CameraPanel {
  #panel;
  #ros;
  #options;
  #type;
  #device;
  /** @type {Publisher[]} */
  #publishers = [];
  #timer = 0;
  #count = 0;
  /** Whether the last image is still being compressed. */
  #busy = false;
  #start = button(say("Start camera"), "ros-start", () => this.#begin());
  #stop = button(say("Stop"), "ros-stop", () => this.stop());
  #about = create("span", "ros-type");
  #note = create("p", "ros-note");
  #hint = create("p", "ros-hint");
  elements;

  /** @param {HTMLElement} panel @param {Ros} ros @param {Options} options */
  constructor(panel, ros, options) {
    this.#panel = panel;
    this.#ros = ros;
    this.#options = options;
    this.#type = options.compressed ? COMPRESSED : RAW;
    this.#device = new Device(options.width ?? 320, (reason) => this.stop(reason));
    const title = create("div", "ros-node", create("span", "ros-name", options.topic), this.#about);
    const bar = create("div", "ros-bar", title, create("div", "ros-controls", this.#start, this.#stop));
    this.#note.setAttribute("role", "status");
    this.#device.canvas.setAttribute("role", "img");
    this.#device.canvas.setAttribute("aria-label", say("Your camera"));
    this.elements = [bar, create("div", "ros-lens", this.#device.canvas, this.#hint), this.#note];
    setText(this.#about, this.#type);
    setText(this.#hint, this.#known
      ? say("Your camera is off. Its images stay on this page.")
      : say("No node of this page uses {}, so the page cannot publish it. Add a node that subscribes to it.", this.#type));
    this.#show();
  }

  /** Switch the camera off. @param {string} [reason] what the visitor is told */
  stop(reason = "") {
    const { working } = this.#device;
    // Also while it waits for the visitor's permission.
    this.#device.close();
    if (!working) return;
    clearInterval(this.#timer);
    for (const publisher of this.#publishers) publisher.close();
    this.#publishers = [];
    setNote(this.#note, reason);
    this.#show();
  }

  get #known() {
    return this.#type in this.#ros.types;
  }

  async #begin() {
    setNote(this.#note, say("Waiting for the camera…"));
    this.#start.disabled = true;
    const fault = await this.#device.open();
    this.#show();
    if (fault || !this.#device.working) {
      setNote(this.#note, fault, true);
      return;
    }
    this.#count = 0;
    const { topic, info, rate = 10 } = this.#options;
    this.#publishers = [this.#ros.advertise(topic, this.#type)];
    if (INFO in this.#ros.types) {
      const beside = `${topic.slice(0, topic.lastIndexOf("/"))}/camera_info`;
      this.#publishers.push(this.#ros.advertise(info || beside, INFO));
    }
    this.#timer = setInterval(() => this.#take(), 1000 / rate);
  }

  /** Publish an image. */
  #take() {
    // In a tab that is not selected, or in closed details.
    if (this.#panel.getClientRects().length === 0) {
      this.stop(say("Stopped because the panel was hidden."));
      return;
    }
    if (this.#busy || !this.#device.draw()) return;
    const header = headerOf(this.#options.frame ?? "camera");
    const { canvas } = this.#device;
    if (!this.#options.compressed) {
      this.#publish(rawOf(header, canvas), header);
      return;
    }
    this.#busy = true;
    canvas.toBlob(async (blob) => {
      const data = blob && new Uint8Array(await blob.arrayBuffer());
      this.#busy = false;
      if (data && this.#device.working) this.#publish({ header, format: "jpeg", data }, header);
    }, "image/jpeg", QUALITY);
  }

  /** @param {any} message @param {any} header */
  #publish(message, header) {
    const [images, infos] = this.#publishers;
    const { canvas } = this.#device;
    try {
      images?.publish(message);
      infos?.publish(infoOf(header, canvas));
    } catch (error) {
      // A node that is too slow gets the next one.
      setNote(this.#note, error instanceof Error ? error.message : String(error), true);
      return;
    }
    this.#count += 1;
    const size = `${canvas.width} × ${canvas.height}`;
    setText(this.#about, `${this.#type}, ${size}`);
    setNote(this.#note, this.#count === 1 ? say("1 image published") : say("{} images published", this.#count));
  }

  #show() {
    const { working } = this.#device;
    enable([[this.#start, !working && this.#known], [this.#stop, working]]);
    this.#hint.hidden = working;
    this.#device.canvas.hidden = !working;
  }
}
