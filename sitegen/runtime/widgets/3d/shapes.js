// @ts-check
// Shapes that several displays draw: arrows and axes, as many as there are in one object, and their removal.

import {
  Color, ConeGeometry, CylinderGeometry, InstancedMesh, Matrix4, MeshLambertMaterial, Quaternion, Vector3,
} from "../../vendor/three.js";

const X = new Vector3(1, 0, 0);
const Y = new Vector3(0, 1, 0);
const Z = new Vector3(0, 0, 1);
// Red, green and blue for x, y and z, as everywhere in ROS.
const AXES = /** @type {const} */ ([[X, 0xff3b3b], [Y, 0x3bd43b], [Z, 0x4d7dff]]);
const SIDES = 12;

/** Cylinders and cones with a colour each, between points: one object, however many there are. */
class Rods {
  object;
  #count = 0;
  #matrix = new Matrix4();
  #turn = new Quaternion();
  #root;
  #geometry;

  /** @param {any} root @param {any} geometry of length 1 along y, with its middle at 0 @param {number} capacity */
  constructor(root, geometry, capacity = 16) {
    this.#root = root;
    this.#geometry = geometry;
    this.object = this.#create(capacity);
  }

  /** Begin again with none. */
  begin() {
    this.#count = 0;
  }

  /**
   * @param {InstanceType<typeof Vector3>} from @param {InstanceType<typeof Vector3>} along from there to the other end
   * @param {number} width @param {any} color
   */
  add(from, along, width, color) {
    if (this.#count === this.object.instanceMatrix.count) this.#grow();
    const length = along.length();
    this.#turn.setFromUnitVectors(Y, length ? along.clone().divideScalar(length) : Y);
    this.#matrix.compose(from.clone().addScaledVector(along, 0.5), this.#turn, new Vector3(width, length, width));
    this.object.setMatrixAt(this.#count, this.#matrix);
    this.object.setColorAt(this.#count, color);
    this.#count++;
  }

  /** Show those that were added. @param {number} [opacity] */
  end(opacity = 1) {
    this.object.count = this.#count;
    this.object.instanceMatrix.needsUpdate = true;
    if (this.object.instanceColor) this.object.instanceColor.needsUpdate = true;
    this.object.material.opacity = opacity;
    this.object.material.transparent = opacity < 1;
    // Else it would be hidden when the first of them are out of view.
    this.object.boundingSphere = null;
    this.object.boundingBox = null;
  }

  /** @param {number} capacity */
  #create(capacity) {
    const object = new InstancedMesh(this.#geometry, new MeshLambertMaterial(), capacity);
    object.frustumCulled = false;
    object.count = 0;
    this.#root.add(object);
    return object;
  }

  #grow() {
    const old = this.object;
    this.object = this.#create(this.#count * 2);
    const matrix = new Matrix4();
    const color = new Color();
    for (let index = 0; index < this.#count; index++) {
      old.getMatrixAt(index, matrix);
      old.getColorAt(index, color);
      this.object.setMatrixAt(index, matrix);
      this.object.setColorAt(index, color);
    }
    old.removeFromParent();
    old.dispose();
  }
}

/** Arrows: a shaft and a head each. */
export class Arrows {
  #shafts;
  #heads;

  /** @param {any} root */
  constructor(root) {
    this.#shafts = new Rods(root, new CylinderGeometry(0.5, 0.5, 1, SIDES));
    this.#heads = new Rods(root, new ConeGeometry(0.5, 1, SIDES));
  }

  begin() {
    this.#shafts.begin();
    this.#heads.begin();
  }

  /**
   * @param {InstanceType<typeof Vector3>} from @param {InstanceType<typeof Vector3>} along to the tip
   * @param {{shaft: number, head: number, length: number}} size diameters of the shaft and the head, and the length of
   *   the head
   * @param {any} color
   */
  add(from, along, { shaft, head, length }, color) {
    const whole = along.length();
    if (!whole) return;
    const body = along.clone().multiplyScalar(Math.max(0, whole - length) / whole);
    const tip = along.clone().multiplyScalar(Math.min(length, whole) / whole);
    this.#shafts.add(from, body, shaft, color);
    this.#heads.add(from.clone().add(body), tip, head, color);
  }

  /** @param {number} [opacity] */
  end(opacity) {
    this.#shafts.end(opacity);
    this.#heads.end(opacity);
  }
}

/** The axes of frames. */
export class Axes {
  #rods;

  /** @param {any} root */
  constructor(root) {
    this.#rods = new Rods(root, new CylinderGeometry(0.5, 0.5, 1, SIDES));
  }

  begin() {
    this.#rods.begin();
  }

  /**
   * @param {InstanceType<typeof Vector3>} position @param {InstanceType<typeof Quaternion>} rotation
   * @param {number} length @param {number} width @param {any} [only] the color of all three instead of their own
   */
  add(position, rotation, length, width, only) {
    for (const [axis, color] of AXES) {
      const along = axis.clone().applyQuaternion(rotation).multiplyScalar(length);
      this.#rods.add(position, along, width, only ?? new Color(color));
    }
  }

  /** @param {number} [opacity] */
  end(opacity) {
    this.#rods.end(opacity);
  }
}

/** Remove all that a group shows, and free its memory. @param {any} group */
export function dispose(group) {
  for (const child of [...group.children]) {
    child.traverse((/** @type {any} */ each) => {
      each.geometry?.dispose();
      for (const material of [each.material ?? []].flat()) {
        material.map?.dispose();
        material.dispose();
      }
      if (each.isInstancedMesh) each.dispose();
    });
    child.removeFromParent();
  }
}
