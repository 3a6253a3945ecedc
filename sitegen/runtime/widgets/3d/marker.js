// @ts-check
// Draw a visualization_msgs/msg/Marker.

import {
  BoxGeometry, BufferAttribute, BufferGeometry, Color, CylinderGeometry, DoubleSide, InstancedBufferAttribute,
  InstancedMesh, Matrix4, Mesh, MeshLambertMaterial, SphereGeometry, SRGBColorSpace, Vector3,
} from "../../vendor/three.js";
import { say } from "../../ui/words.js";
import { createLabel } from "./label.js";
import { Lines, finite, segments } from "./lines.js";
import { loadMesh } from "./meshes.js";
import { createPoints } from "./points.js";
import { Arrows } from "./shapes.js";
import { shade } from "./light.js";

/** @typedef {{resource(url: string): string, redraw(): void, say(text: string): void}} Help */

/** More points than these are not drawn, of one marker or of all. */
export const MOST_POINTS = 1_000_000;
// The sides and rings of spheres, by how many there are: all together must be drawn in a frame.
const ROUND = /** @type {const} */ ([[10_000, 12, 8], [100_000, 8, 4], [Infinity, 4, 2]]);
const X = new Vector3(1, 0, 0);

/**
 * Draw a marker into the group of its pose. Throws an Error if it cannot be drawn.
 * @param {any} group @param {any} marker @param {Help} help
 */
export function drawMarker(group, marker, help) {
  const draw = DRAWN[marker.type];
  if (!draw) throw new Error(say("unknown type {}", marker.type));
  const { scale, color: { r, g, b, a } } = marker;
  if (!finite([scale.x, scale.y, scale.z])) throw new Error(say("its scale is not finite"));
  if (!finite([r, g, b, a])) throw new Error(say("its color is not finite"));
  if (marker.points.length > MOST_POINTS) throw new Error(say("it has more than {} points", MOST_POINTS));
  const points = pointsOf(marker);
  if (!finite(points)) throw new Error(say("its points are not finite"));
  draw(group, marker, points, help);
  shade(group);
}

/**
 * By the number of the type; the points are x, y and z of each.
 * @type {Record<number, (group: any, marker: any, points: Float32Array, help: Help) => void>}
 */
const DRAWN = {
  0: drawArrow,
  1: (group, marker) => drawShape(group, marker, new BoxGeometry()),
  2: (group, marker) => drawShape(group, marker, new SphereGeometry(0.5, 32, 16)),
  3: (group, marker) => drawShape(group, marker, new CylinderGeometry(0.5, 0.5, 1, 32).rotateX(Math.PI / 2)),
  4: (group, marker, points) => drawLines(group, marker, segments(points), (index) => (index >> 1) + (index & 1)),
  5: (group, marker, points) => drawLines(group, marker, whole(points, 2), (index) => index),
  6: (group, marker, points) => drawList(group, marker, points, new BoxGeometry()),
  7: (group, marker, points) => drawList(group, marker, points, sphere(points.length / 3)),
  8: drawPoints,
  9: drawText,
  10: drawMesh,
  11: drawTriangles,
  12: drawArrowStrip,
};

/** @param {any} marker */
function pointsOf({ points }) {
  const found = new Float32Array(points.length * 3);
  let at = 0;
  for (const { x, y, z } of points) {
    found[at++] = x;
    found[at++] = y;
    found[at++] = z;
  }
  return found;
}

/** Return the points without those that make no whole pair or triangle. @param {Float32Array} points @param {number} size */
function whole(points, size) {
  return points.subarray(0, points.length - (points.length % (3 * size)));
}

/** Return a sphere of which so many can be drawn. @param {number} count */
function sphere(count) {
  const [, sides = 4, rings = 2] = ROUND.find(([most]) => count <= most) ?? [];
  return new SphereGeometry(0.5, sides, rings);
}

/** @param {Float32Array} points @param {number} index */
function vectorAt(points, index) {
  return new Vector3().fromArray(points, index * 3);
}

/** Return a colour as it is computed with. @param {{r: number, g: number, b: number}} color */
function color({ r, g, b }) {
  return new Color().setRGB(r || 0, g || 0, b || 0, SRGBColorSpace);
}

/** Return the colours of the points, three numbers each; undefined if they have none of their own. @param {any} marker @param {number} count @param {(index: number) => number} [point] */
function colorsOf({ colors, points }, count, point = (index) => index) {
  if (!colors.length || colors.length < points.length) return undefined;
  const found = new Float32Array(count * 3);
  for (let index = 0; index < count; index++) color(colors[point(index)] ?? colors[0]).toArray(found, index * 3);
  return found;
}

/** @param {any} marker */
function opacityOf({ color: { a }, colors }) {
  const alpha = colors.length ? (colors[0].a ?? 1) : a;
  return Number.isFinite(alpha) ? Math.max(0, Math.min(1, alpha)) : 1;
}

/** @param {any} marker */
function material(marker) {
  const opacity = Math.max(0, Math.min(1, marker.color.a));
  return new MeshLambertMaterial({ color: color(marker.color), opacity, transparent: opacity < 1, side: DoubleSide });
}

/** @param {any} group @param {any} marker @param {any} geometry */
function drawShape(group, marker, geometry) {
  const mesh = new Mesh(geometry, material(marker));
  mesh.scale.set(marker.scale.x, marker.scale.y, marker.scale.z);
  group.add(mesh);
}

/** @param {any} group @param {any} marker @param {Float32Array} points @param {any} geometry */
function drawList(group, marker, points, geometry) {
  const count = points.length / 3;
  const own = colorsOf(marker, count);
  const look = material(marker);
  if (own) {
    look.color = new Color(0xffffff);
    look.opacity = opacityOf(marker);
    look.transparent = look.opacity < 1;
  }
  const mesh = new InstancedMesh(geometry, look, count);
  const matrix = new Matrix4().makeScale(marker.scale.x, marker.scale.y, marker.scale.z);
  for (let index = 0; index < count; index++) mesh.setMatrixAt(index, matrix.setPosition(vectorAt(points, index)));
  if (own) mesh.instanceColor = new InstancedBufferAttribute(own, 3);
  group.add(mesh);
}

/** @param {any} group @param {any} marker @param {Float32Array} ends @param {(index: number) => number} point */
function drawLines(group, marker, ends, point) {
  const colors = colorsOf(marker, ends.length / 3, point);
  new Lines(group).show(ends, { color: color(marker.color), colors, width: marker.scale.x, opacity: opacityOf(marker) });
}

/** @param {any} group @param {any} marker @param {Float32Array} points */
function drawPoints(group, marker, points) {
  const colors = colorsOf(marker, points.length / 3);
  const cloud = createPoints(points, colors);
  cloud.style({ size: marker.scale.x, color: color(marker.color), opacity: opacityOf(marker) });
  group.add(cloud.points);
}

/** @param {any} group @param {any} marker */
function drawText(group, marker) {
  if (!marker.text) return;
  const { z } = marker.scale;
  group.add(createLabel(marker.text, z, { color: color(marker.color), opacity: Math.min(1, marker.color.a) }));
}

/** @param {any} group @param {any} marker @param {Float32Array} points */
function drawTriangles(group, marker, points) {
  const corners = whole(points, 3);
  const count = corners.length / 3;
  const geometry = new BufferGeometry();
  geometry.setAttribute("position", new BufferAttribute(corners, 3));
  // A colour for each point, or for each triangle.
  const byTriangle = marker.colors.length > 0 && marker.colors.length === count / 3;
  const given = byTriangle ? { ...marker, points: marker.colors } : marker;
  const colors = colorsOf(given, count, (index) => (byTriangle ? Math.floor(index / 3) : index));
  if (colors) geometry.setAttribute("color", new BufferAttribute(colors, 3));
  geometry.computeVertexNormals();
  const look = material(marker);
  if (colors) {
    look.vertexColors = true;
    look.color = new Color(0xffffff);
    look.opacity = opacityOf(marker);
    look.transparent = look.opacity < 1;
  }
  const mesh = new Mesh(geometry, look);
  mesh.scale.set(marker.scale.x, marker.scale.y, marker.scale.z);
  group.add(mesh);
}

/**
 * An arrow between two points, with the diameters of its shaft and head and the length of the head as its scale; or
 * along x, with its length, width and height as its scale.
 * @param {any} group @param {any} marker @param {Float32Array} points
 */
function drawArrow(group, marker, points) {
  const { scale } = marker;
  const arrows = new Arrows(group);
  arrows.begin();
  if (points.length >= 6) {
    const from = vectorAt(points, 0);
    const along = vectorAt(points, 1).sub(from);
    arrows.add(from, along, { shaft: scale.x, head: scale.y, length: scale.z || along.length() * 0.23 }, color(marker.color));
  } else {
    const size = { shaft: scale.y * 0.5, head: scale.y, length: scale.x * 0.23 };
    arrows.add(new Vector3(), X.clone().multiplyScalar(scale.x), size, color(marker.color));
  }
  arrows.end(Math.min(1, marker.color.a));
}

/** @param {any} group @param {any} marker @param {Float32Array} points */
function drawArrowStrip(group, marker, points) {
  const { scale } = marker;
  const arrows = new Arrows(group);
  arrows.begin();
  for (let index = 1; index < points.length / 3; index++) {
    const from = vectorAt(points, index - 1);
    const along = vectorAt(points, index).sub(from);
    const length = scale.z || along.length() * 0.23;
    arrows.add(from, along, { shaft: scale.x, head: scale.y, length }, color(marker.color));
  }
  arrows.end(Math.min(1, marker.color.a));
}

/** @param {any} group @param {any} marker @param {Float32Array} _points @param {Help} help */
function drawMesh(group, marker, _points, help) {
  loadMesh(marker.mesh_resource, help.resource).then((mesh) => {
    const own = marker.mesh_use_embedded_materials && !/\.stl$/i.test(marker.mesh_resource);
    mesh.traverse((/** @type {any} */ each) => {
      if (each.isMesh && !own) each.material = material(marker);
    });
    mesh.scale.set(marker.scale.x, marker.scale.y, marker.scale.z);
    group.add(mesh);
    shade(group);
    help.redraw();
  }, (error) => {
    help.say(error.message);
    help.redraw();
  });
}
