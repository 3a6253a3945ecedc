// @ts-check
// The images of a topic: only the newest is decoded, in a frame of the screen.

import { TopicReader } from "../../messages/topicReader.js";
import { say } from "../../ui/words.js";
import { decode, Decoder } from "./decode.js";
import { decodeInSlices } from "./slices.js";

/** @import { Ros } from "../../protocol.js" */
/** @import { Image, Range } from "./decode.js" */

export const RAW = "sensor_msgs/msg/Image";
export const COMPRESSED = "sensor_msgs/msg/CompressedImage";
// Images are large, and only the newest counts.
const DEPTH = 2;
// Larger images (pixels) are decoded in several frames: those of a Bayer pattern take 100 ns for each pixel.
const LARGE = 2 ** 17;

/**
 * @typedef {{image: ImageData | ImageBitmap | HTMLCanvasElement, encoding: string, low: number, high: number}} Picture
 *   `low` and `high` are the range of depth, NaN if there is none
 */

export class ImageSource {
  #ros;
  #reader;
  #show;
  /** @type {any} */
  #newest;
  #frame = 0;
  #decoding = false;
  /** Whether to decode again: the range has changed meanwhile, or there is a newer image. */
  #again = false;
  #closed = false;
  /** @type {Range} */
  range = { low: NaN, high: NaN };

  /**
   * @param {Ros} ros @param {string} topic
   * @param {(picture: Picture | undefined, fault: string) => void} show an image, or what is wrong with it
   */
  constructor(ros, topic, show) {
    this.#ros = ros;
    this.#show = show;
    this.#reader = new TopicReader(ros, topic, (message) => {
      this.#newest = message;
      this.redraw();
    }, DEPTH);
  }

  get topic() {
    return this.#reader.topic;
  }

  /** Follow changes of the graph. @param {boolean} wanted */
  look(wanted) {
    this.#closed = !wanted;
    const topic = this.#ros.graph.topics().find(({ name }) => name === this.topic);
    const shown = topic?.types.some((type) => type === RAW || type === COMPRESSED) ?? false;
    this.#reader.look(wanted && shown);
    if (!wanted) {
      cancelAnimationFrame(this.#frame);
      this.#frame = 0;
    }
  }

  /** Why there are no images, in a sentence. */
  describeSilence() {
    const { topic, type } = this.#reader;
    if (!topic) return say("No topics with images now. They appear when nodes start.");
    if (type && type !== RAW && type !== COMPRESSED) {
      return say("{} has the type {}; images are {} or {}", topic, type, RAW, COMPRESSED);
    }
    return this.#reader.describeSilence();
  }

  /** Decode the newest image again, in another range. */
  redraw() {
    if (this.#newest && !this.#closed) this.#frame ||= requestAnimationFrame(() => this.#draw());
  }

  async #draw() {
    this.#frame = 0;
    this.#again = this.#decoding;
    if (this.#decoding) return;
    this.#decoding = true;
    const message = this.#newest;
    let picture;
    let fault = "";
    try {
      if (this.#reader.type === COMPRESSED) picture = await decompress(message);
      // What is not awaited is shown in this frame.
      else if (message.width * message.height > LARGE) picture = await this.#decodeLarge(message);
      else picture = this.#decode(message);
    } catch (error) {
      fault = error instanceof Error ? error.message : String(error);
    }
    this.#decoding = false;
    if (!this.#closed) this.#show(picture, fault);
    if (picture?.image instanceof ImageBitmap) picture.image.close();
    if (this.#again) this.redraw();
  }

  /** @param {Image} message @returns {Picture} */
  #decode(message) {
    const { data, low, high } = decode(message, this.range);
    return { image: new ImageData(data, message.width, message.height), encoding: message.encoding, low, high };
  }

  /** @param {Image} message @returns {Promise<Picture | undefined>} */
  async #decodeLarge(message) {
    const { width, height, encoding } = message;
    const decoder = new Decoder(message, this.range);
    const image = await decodeInSlices(decoder, width, height, () => !this.#closed);
    return image && { image, encoding, ...decoder.range };
  }
}

/** @param {{format: string, data: Uint8Array<ArrayBuffer>}} message @returns {Promise<Picture>} */
async function decompress({ format, data }) {
  if (format.includes("compressedDepth")) {
    throw new Error(say("Compressed depth images are not supported; publish them as {}", RAW));
  }
  try {
    const image = await createImageBitmap(new Blob([data]));
    return { image, encoding: format, low: NaN, high: NaN };
  } catch {
    throw new Error(say("The browser cannot decode this image; its format is '{}'", format.slice(0, 40)));
  }
}
