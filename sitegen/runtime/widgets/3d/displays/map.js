// @ts-check
// An occupancy grid, with its updates.

import {
  DataTexture, DoubleSide, Group, Mesh, MeshBasicMaterial, NearestFilter, PlaneGeometry, SRGBColorSpace,
} from "../../../vendor/three.js";
import { say } from "../../../ui/words.js";
import { poseOf } from "../../tf/pose.js";
import { dispose } from "../shapes.js";
import { put } from "../shown.js";

/** @import { Kind } from "../shown.js" */

const GRID = "nav_msgs/msg/OccupancyGrid";
const UPDATE = "map_msgs/msg/OccupancyGridUpdate";
// Cells on a side: what all graphics cards can draw.
const LARGEST = 8192;

/** @type {Kind} */
export const kind = {
  title: say("Map"),
  types: [GRID],
  defaults: { topic: "/map", alpha: 0.7, scheme: "map" },
  choices: { scheme: ["map", "costmap", "raw"] },

  create({ root, ros, redraw, say: tell }, options) {
    /** @type {Sheet | undefined} */
    let sheet;
    /** @type {(() => void) | undefined} */
    let unsubscribe;
    const clear = () => {
      dispose(root);
      sheet = undefined;
    };
    const update = (/** @type {any} */ part) => {
      if (!sheet) return;
      tell(sheet.update(part, options) ? "" : say("an update lies outside of the map"));
      redraw();
    };
    const listen = () => {
      // Nodes that send updates bring their type, perhaps later.
      if (ros.types[UPDATE]) unsubscribe ??= ros.subscribe(`${options.topic}_updates`, UPDATE, update);
    };
    return {
      begin: listen,
      end() {
        unsubscribe?.();
        unsubscribe = undefined;
      },
      // A map is where its frame is now, however old it is.
      frameOf: ({ header }) => ({ ...header, stamp: { sec: 0, nanosec: 0 } }),
      receive(message) {
        clear();
        sheet = new Sheet(message);
        sheet.style(options);
        root.add(sheet.place);
        listen();
      },
      set: () => sheet?.style(options),
      clear,
      close: clear,
    };
  },
};

/** The cells of a map, as a picture on the floor. */
class Sheet {
  place = new Group();
  /** @type {number} */
  #width;
  /** @type {number} */
  #height;
  #cells;
  /** The colours of the cells, which the texture has. */
  #pixels;
  /** Whether the graphics card needs all of them. */
  #whole = true;
  #texture;
  #material;

  /** Throws an Error if it cannot be shown. @param {any} map */
  constructor({ info: { width, height, resolution, origin }, data }) {
    if (data.length !== width * height) {
      throw new Error(say("{} × {} cells need {} values, but the message has {}", width, height, width * height, data.length));
    }
    if (!data.length) throw new Error(say("the map is empty"));
    if (Math.max(width, height) > LARGEST) throw new Error(say("the map is larger than {} × {} cells", LARGEST, LARGEST));
    [this.#width, this.#height] = [width, height];
    this.#cells = Uint8Array.from(data, (cell) => cell & 255);
    const bytes = new Uint8Array(width * height * 4);
    this.#pixels = new Uint32Array(bytes.buffer);
    this.#texture = new DataTexture(bytes, width, height);
    this.#texture.colorSpace = SRGBColorSpace;
    this.#texture.magFilter = NearestFilter;
    this.#texture.onUpdate = () => {
      this.#whole = false;
    };
    this.#material = new MeshBasicMaterial({ map: this.#texture, transparent: true, side: DoubleSide, depthWrite: false });
    const mesh = new Mesh(new PlaneGeometry(width * resolution, height * resolution), this.#material);
    // Below the shadows on the floor.
    mesh.renderOrder = -2;
    mesh.position.set((width * resolution) / 2, (height * resolution) / 2, 0);
    put(this.place, poseOf(origin));
    this.place.add(mesh);
  }

  /**
   * Take the new cells of a part, and return whether that is inside.
   * @param {any} part @param {Record<string, any>} options
   */
  update({ x, y, width, height, data }, { scheme }) {
    if (x < 0 || y < 0 || x + width > this.#width || y + height > this.#height || data.length < width * height) return false;
    const cells = new Uint8Array(data.buffer, data.byteOffset, data.byteLength);
    const palette = paletteOf(scheme);
    for (let row = 0; row < height; row++) {
      const start = (y + row) * this.#width + x;
      this.#cells.set(cells.subarray(row * width, (row + 1) * width), start);
      this.#paint(palette, start, start + width);
      if (!this.#whole) this.#texture.addUpdateRange(start * 4, width * 4);
    }
    // Those of a map that is not shown would wait without an end.
    if (this.#texture.updateRanges.length > this.#height) this.#sendWhole();
    this.#texture.needsUpdate = true;
    return true;
  }

  /** @param {Record<string, any>} options */
  style({ alpha, scheme }) {
    this.#material.opacity = alpha;
    this.#paint(paletteOf(scheme), 0, this.#cells.length);
    this.#sendWhole();
    this.#texture.needsUpdate = true;
  }

  #sendWhole() {
    this.#whole = true;
    this.#texture.clearUpdateRanges();
  }

  /** @param {Uint32Array} palette @param {number} start @param {number} end */
  #paint(palette, start, end) {
    for (let index = start; index < end; index++) this.#pixels[index] = palette[this.#cells[index] ?? 0] ?? 0;
  }
}

/** Return the colour of each value of a cell, as bytes of red, green, blue and alpha. @param {string} scheme */
function paletteOf(scheme) {
  const palette = new Uint8Array(256 * 4);
  for (let cell = 0; cell < 256; cell++) palette.set(COLORS[scheme]?.(cell) ?? [0, 0, 0, 0], cell * 4);
  return new Uint32Array(palette.buffer);
}

/** The colours of cells: 0 is free, 100 occupied, 255 (or -1) unknown. @type {Record<string, (cell: number) => number[]>} */
const COLORS = {
  map(cell) {
    if (cell <= 100) return Array(3).fill(255 - Math.round(cell * 2.55)).concat(255);
    return cell === 255 ? [112, 137, 134, 255] : [0, 255, 0, 255];
  },
  costmap(cell) {
    if (cell === 0) return [0, 0, 0, 0];
    if (cell < 99) return [Math.round(cell * 2.55), 0, 255 - Math.round(cell * 2.55), 255];
    if (cell === 99) return [0, 255, 255, 255];
    if (cell === 100) return [255, 0, 255, 255];
    return cell === 255 ? [112, 137, 134, 255] : [0, 255, 0, 255];
  },
  raw: (cell) => [cell, cell, cell, 255],
};
