// @ts-check
// Points: squares with a size in metres that face the camera.

import { BufferAttribute, BufferGeometry, Points, PointsMaterial } from "../../vendor/three.js";

/**
 * Return points as one object. `style` changes their colour, size (m) and opacity.
 * @param {Float32Array} positions x, y and z of each, in metres
 * @param {Float32Array | undefined} colors r, g and b of each (linear, 0 to 1), if they differ
 */
export function createPoints(positions, colors) {
  const geometry = new BufferGeometry();
  geometry.setAttribute("position", new BufferAttribute(positions, 3));
  if (colors) geometry.setAttribute("color", new BufferAttribute(colors, 3));
  const material = new PointsMaterial({ vertexColors: Boolean(colors) });
  const points = new Points(geometry, material);
  points.frustumCulled = false;
  let metres = 1;
  // Sizes are in metres for a camera with perspective, and in pixels for one without.
  points.onBeforeRender = (renderer, _scene, camera) => {
    const flat = /** @type {any} */ (camera);
    const height = renderer.domElement.height / renderer.getPixelRatio();
    material.size = flat.isOrthographicCamera ? (metres * flat.zoom * height) / (flat.top - flat.bottom) : metres;
  };
  return {
    points,
    /** @param {{color: any, size: number, opacity: number}} look */
    style({ color, size, opacity }) {
      metres = size;
      if (!colors) material.color = color;
      material.opacity = opacity;
      material.transparent = opacity < 1;
    },
    close() {
      points.removeFromParent();
      geometry.dispose();
      material.dispose();
    },
  };
}
