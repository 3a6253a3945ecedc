// @ts-check
// The camera of the visitor's device.

import { create } from "../../ui/elements.js";
import { say } from "../../ui/words.js";

/** What is said about errors of getUserMedia, by their names. @type {Record<string, string>} */
const FAULTS = {
  NotAllowedError: say("Access to the camera was refused. Allow it in the settings of your browser for this page, then start again."),
  SecurityError: say("The browser does not allow cameras here. Open this page in its own tab, not embedded in another page."),
  NotFoundError: say("No camera was found. Connect one, then start again."),
  NotReadableError: say("The camera does not respond. Another program may be using it."),
};

export class Device {
  /** The latest image. */
  canvas = create("canvas", "");
  #video = create("video", "");
  #width;
  #ended;
  /** @type {MediaStream | undefined} */
  #stream;
  /** Differs for each time that it is switched on. */
  #turn = 0;

  /** @param {number} width of an image (px) @param {(reason: string) => void} ended called when the camera is gone */
  constructor(width, ended) {
    this.#width = width;
    this.#ended = ended;
    this.#video.muted = true;
    this.#video.playsInline = true;
  }

  get working() {
    return this.#stream !== undefined;
  }

  /** Switch the camera on. Resolves with why that is not possible, or "". @returns {Promise<string>} */
  async open() {
    if (!navigator.mediaDevices?.getUserMedia) {
      return say("Browsers allow cameras only on https:// pages and on this computer. Open this page at such an address.");
    }
    const turn = ++this.#turn;
    try {
      const stream = await navigator.mediaDevices.getUserMedia({ video: { width: { ideal: this.#width } } });
      if (turn !== this.#turn || document.visibilityState === "hidden") {
        for (const track of stream.getTracks()) track.stop();
        return "";
      }
      this.#stream = stream;
      stream.getVideoTracks()[0]?.addEventListener("ended", () => this.#ended(say("The camera was disconnected.")));
      this.#video.srcObject = stream;
      await this.#video.play();
      return "";
    } catch (error) {
      // It was closed while it opened.
      if (turn !== this.#turn) return "";
      this.close();
      const { name, message } = error instanceof Error ? error : { name: "", message: String(error) };
      return FAULTS[name] ?? say("The camera cannot be used: {}", message);
    }
  }

  close() {
    this.#turn++;
    for (const track of this.#stream?.getTracks() ?? []) track.stop();
    this.#stream = undefined;
    this.#video.srcObject = null;
  }

  /** Draw what the camera sees now on the canvas; return false if there is nothing yet. */
  draw() {
    const { videoWidth, videoHeight } = this.#video;
    if (!videoWidth || !videoHeight) return false;
    const height = Math.max(Math.round((this.#width * videoHeight) / videoWidth), 1);
    if (this.canvas.width !== this.#width) this.canvas.width = this.#width;
    if (this.canvas.height !== height) this.canvas.height = height;
    this.canvas.getContext("2d", { willReadFrequently: true })?.drawImage(this.#video, 0, 0, this.#width, height);
    return true;
  }
}
