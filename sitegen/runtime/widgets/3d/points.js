// @ts-check
// Points: squares with a size in metres that face the camera.

import { BufferAttribute, BufferGeometry, Color, Points, PointsMaterial } from "../../vendor/three.js";

/**
 * Return points as one object. `style` changes their colour, size (m) and opacity; `move` shows other points instead.
 * @param {Float32Array} positions x, y and z of each, in metres
 * @param {Float32Array | undefined} colors r, g and b of each (linear, 0 to 1), if they differ
 */
export function createPoints(positions, colors) {
  const material = new PointsMaterial({ vertexColors: Boolean(colors) });
  const points = new Points(geometryOf(positions, colors), material);
  let color = material.color;
  points.frustumCulled = false;
  let metres = 1;
  points.onBeforeRender = (renderer, _scene, camera) => {
    // The part of half the view's height that a metre takes, with perspective at a distance of 1 m. There, three.js
    // multiplies by half the height itself.
    const [, , , , , part = 1] = camera.projectionMatrix.elements;
    const half = renderer.domElement.height / renderer.getPixelRatio() / 2;
    material.size = metres * part * (/** @type {any} */ (camera).isOrthographicCamera ? half : 1);
  };
  return {
    points,
    /**
     * The material stays: a new one for each message would be compiled each time.
     * @param {Float32Array} positions @param {Float32Array | undefined} colors
     */
    move(positions, colors) {
      const { geometry } = points;
      const fits = geometry.getAttribute("position").array.length === positions.length
        && Boolean(colors) === material.vertexColors;
      if (fits) {
        replace(geometry.getAttribute("position"), positions);
        if (colors) replace(geometry.getAttribute("color"), colors);
        geometry.boundingSphere = null;
        geometry.boundingBox = null;
        return;
      }
      points.geometry = geometryOf(positions, colors);
      geometry.dispose();
      if (material.vertexColors !== Boolean(colors)) material.needsUpdate = true;
      material.vertexColors = Boolean(colors);
      material.color = colors ? new Color(0xffffff) : color;
    },
    /** @param {{color: any, size: number, opacity: number}} look */
    style(look) {
      const { size, opacity } = look;
      metres = size;
      ({ color } = look);
      if (!material.vertexColors) material.color = color;
      material.opacity = opacity;
      material.transparent = opacity < 1;
    },
    close() {
      points.removeFromParent();
      points.geometry.dispose();
      material.dispose();
    },
  };
}

/** @param {Float32Array} positions @param {Float32Array | undefined} colors */
function geometryOf(positions, colors) {
  const geometry = new BufferGeometry();
  geometry.setAttribute("position", new BufferAttribute(positions, 3));
  if (colors) geometry.setAttribute("color", new BufferAttribute(colors, 3));
  return geometry;
}

/** @param {any} attribute @param {Float32Array} values as many as it has */
function replace(attribute, values) {
  attribute.array = values;
  attribute.needsUpdate = true;
}
