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

  create({ root, ros, redraw }, options) {
    const floor = new Group();
    root.add(floor);
    /** @type {{width: number, height: number, cells: Uint8Array, texture: any} | undefined} */
    let shown;
    let unsubscribe = () => {};

    const paint = () => {
      if (!shown) return;
      const palette = paletteOf(options.scheme);
      const { cells, texture } = shown;
      const pixels = new Uint32Array(texture.image.data.buffer);
      for (let index = 0; index < cells.length; index++) pixels[index] = palette[cells[index] ?? 0] ?? 0;
      texture.needsUpdate = true;
    };
    const update = (/** @type {any} */ { x, y, width, height, data }) => {
      if (!shown || x < 0 || y < 0 || x + width > shown.width || y + height > shown.height) return;
      const cells = new Uint8Array(data.buffer, data.byteOffset, data.byteLength);
      for (let row = 0; row < height; row++) {
        shown.cells.set(cells.subarray(row * width, (row + 1) * width), (y + row) * shown.width + x);
      }
      paint();
      redraw();
    };
    return {
      frameOf: ({ header }) => ({ ...header, stamp: { sec: 0, nanosec: 0 } }),
      receive({ info: { width, height, resolution, origin }, data }) {
        dispose(floor);
        shown = undefined;
        if (data.length !== width * height) {
          throw new Error(say("{} × {} cells need {} values, but the message has {}", width, height, width * height, data.length));
        }
        if (!data.length) throw new Error(say("the map is empty"));
        if (Math.max(width, height) > LARGEST) throw new Error(say("the map is larger than {} × {} cells", LARGEST, LARGEST));
        const texture = new DataTexture(new Uint8Array(width * height * 4), width, height);
        texture.colorSpace = SRGBColorSpace;
        texture.magFilter = NearestFilter;
        shown = { width, height, cells: Uint8Array.from(data, (cell) => cell & 255), texture };
        paint();
        const material = new MeshBasicMaterial({
          map: texture, transparent: true, opacity: options.alpha, side: DoubleSide, depthWrite: false,
        });
        const mesh = new Mesh(new PlaneGeometry(width * resolution, height * resolution), material);
        mesh.position.set((width * resolution) / 2, (height * resolution) / 2, 0);
        const place = new Group();
        put(place, poseOf(origin));
        place.add(mesh);
        floor.add(place);
        unsubscribe();
        const topic = `${options.topic}_updates`;
        const sent = ros.graph.topics().some(({ name, types }) => name === topic && types.includes(UPDATE));
        unsubscribe = sent && ros.types[UPDATE] ? ros.subscribe(topic, UPDATE, update) : () => {};
      },
      set({ alpha }) {
        floor.traverse((/** @type {any} */ { material }) => {
          if (material) material.opacity = alpha;
        });
        paint();
      },
      clear() {
        dispose(floor);
        shown = undefined;
      },
      close() {
        unsubscribe();
        dispose(floor);
      },
    };
  },
};

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
