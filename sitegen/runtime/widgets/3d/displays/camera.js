// @ts-check
// The image of a camera, on the pyramid that it sees.

import {
  BufferAttribute, BufferGeometry, CanvasTexture, Color, DoubleSide, Group, Mesh, MeshBasicMaterial, SRGBColorSpace,
} from "../../../vendor/three.js";
import { place } from "../../../place.js";
import { say } from "../../../ui/words.js";
import { Lines } from "../lines.js";
import { dispose } from "../shapes.js";

/** @import { Context, Kind } from "../shown.js" */

const RAW = "sensor_msgs/msg/Image";
const COMPRESSED = "sensor_msgs/msg/CompressedImage";
const INFO = "sensor_msgs/msg/CameraInfo";
const AUTOMATIC = { low: NaN, high: NaN };

/** @type {Kind} */
export const kind = {
  title: say("Camera"),
  types: [RAW, COMPRESSED],
  defaults: { topic: "/image_raw", info: "", distance: 1, color: "#ffd36a", alpha: 1 },

  create(context, options) {
    const camera = new Camera(context, options);
    return {
      begin: () => camera.begin(),
      end: () => camera.end(),
      frameOf: ({ header }) => header,
      receive: (message, type) => camera.receive(message, type),
      update: () => camera.update(),
      set: () => camera.set(),
      clear: () => camera.clear(),
      close: () => camera.close(),
    };
  },
};

/** The topic of the CameraInfo that belongs to a topic of images, as image_transport names it. @param {string} topic */
export function infoOf(topic) {
  return `${topic.replace(/\/(compressed|compressedDepth)$/, "").replace(/\/[^/]*$/, "")}/camera_info`;
}

class Camera {
  #context;
  #options;
  #unsubscribe = () => {};
  /** @type {any} */
  #info;
  /** The newest image, which is not drawn yet. @type {{message: any, type: string} | undefined} */
  #newest;
  #decoding = false;
  #canvas = document.createElement("canvas");
  /** @type {InstanceType<typeof CanvasTexture> | undefined} */
  #texture;
  #pyramid = new Group();
  /** @type {any} */
  #sheet;

  /** @param {Context} context @param {Record<string, any>} options */
  constructor(context, options) {
    this.#context = context;
    this.#options = options;
    context.root.add(this.#pyramid);
  }

  get #topic() {
    return String(this.#options.info || infoOf(this.#options.topic));
  }

  begin() {
    const { ros } = this.#context;
    if (!ros.types[INFO]) return;
    this.#unsubscribe = ros.subscribe(this.#topic, INFO, (info) => {
      const same = this.#info && ["width", "height"].every((key) => this.#info[key] === info[key])
        && this.#info.k.every((/** @type {number} */ one, /** @type {number} */ index) => one === info.k[index]);
      this.#info = info;
      if (!same) this.#shape();
    }, { depth: 1 });
  }

  end() {
    this.#unsubscribe();
    this.#unsubscribe = () => {};
  }

  /** @param {any} message @param {string} type */
  receive(message, type) {
    this.#newest = { message, type };
  }

  /** Draw the newest image; called before each frame. */
  update() {
    if (!this.#newest || this.#decoding) return;
    if (!this.#sheet) this.#shape();
    if (!this.#info) {
      this.#context.say(say("no CameraInfo on {}", this.#topic));
      return;
    }
    const { message, type } = this.#newest;
    this.#newest = undefined;
    this.#decoding = true;
    this.#decode(message, type).then((image) => this.#paint(image), (error) => this.#context.say(error.message))
      .finally(() => {
        this.#decoding = false;
        if (this.#newest) this.#context.redraw();
      });
  }

  set() {
    this.#shape();
  }

  clear() {
    this.#newest = undefined;
    this.#info = undefined;
    this.#erase();
  }

  close() {
    this.end();
    this.clear();
  }

  /** @param {any} message @param {string} type @returns {Promise<ImageData | ImageBitmap>} */
  async #decode(message, type) {
    if (type === COMPRESSED) return createImageBitmap(new Blob([message.data]));
    // Few views have a camera.
    /** @type {typeof import("../../image/decode.js")} */
    const { decode } = await import(place("widgets/image/decode.js"));
    const { data } = decode(message, AUTOMATIC);
    return new ImageData(data, message.width, message.height);
  }

  /** @param {ImageData | ImageBitmap} image */
  #paint(image) {
    if (this.#canvas.width !== image.width || this.#canvas.height !== image.height) {
      [this.#canvas.width, this.#canvas.height] = [image.width, image.height];
      // The size of a texture cannot change.
      this.#texture?.dispose();
      this.#texture = undefined;
    }
    const context = /** @type {CanvasRenderingContext2D} */ (this.#canvas.getContext("2d"));
    if (image instanceof ImageData) context.putImageData(image, 0, 0);
    else context.drawImage(image, 0, 0);
    if (!this.#texture) {
      this.#texture = new CanvasTexture(this.#canvas);
      this.#texture.colorSpace = SRGBColorSpace;
    }
    this.#texture.needsUpdate = true;
    if (this.#sheet && this.#sheet.material.map !== this.#texture) {
      this.#sheet.material.map = this.#texture;
      this.#sheet.material.needsUpdate = true;
    }
    if (this.#sheet) this.#sheet.visible = true;
    const { say: tell } = this.#context;
    tell("");
    this.#context.redraw();
  }

  /** Draw the pyramid, and a sheet for the image at its end. */
  #shape() {
    this.#erase();
    if (!this.#info) return;
    const { k, width, height } = this.#info;
    const [fx, , cx, , fy, cy] = k;
    const { distance, alpha, color } = this.#options;
    if (!(fx > 0 && fy > 0 && width > 0 && height > 0 && distance > 0)) {
      this.#context.say(say("the CameraInfo on {} has no focal length", this.#topic));
      return;
    }
    // Optical frames look along z, with x to the right and y down.
    const corner = (/** @type {number} */ u, /** @type {number} */ v) =>
      [((u - cx) / fx) * distance, ((v - cy) / fy) * distance, distance];
    const corners = [corner(0, 0), corner(width, 0), corner(width, height), corner(0, height)];
    const geometry = new BufferGeometry();
    geometry.setAttribute("position", new BufferAttribute(new Float32Array(corners.flat()), 3));
    geometry.setAttribute("uv", new BufferAttribute(new Float32Array([0, 1, 1, 1, 1, 0, 0, 0]), 2));
    geometry.setIndex([0, 1, 2, 0, 2, 3]);
    const look = { map: this.#texture ?? null, side: DoubleSide, opacity: alpha, transparent: alpha < 1 };
    this.#sheet = new Mesh(geometry, new MeshBasicMaterial(look));
    this.#sheet.visible = Boolean(this.#texture);
    this.#pyramid.add(this.#sheet);
    const [a, b, c, d] = /** @type {[number[], number[], number[], number[]]} */ (corners);
    const eye = [0, 0, 0];
    const edges = [[eye, a], [eye, b], [eye, c], [eye, d], [a, b], [b, c], [c, d], [d, a]];
    const ends = new Float32Array(edges.flat(2));
    new Lines(this.#pyramid).show(ends, { color: new Color(color) });
    this.#context.redraw();
  }

  #erase() {
    // The texture is used again.
    if (this.#sheet) this.#sheet.material.map = null;
    dispose(this.#pyramid);
    this.#sheet = undefined;
  }
}
