// @ts-check
// The light of a scene, and the shadows that it casts where the camera looks.

import { DirectionalLight, HemisphereLight, Vector3 } from "../../vendor/three.js";

/** @import { Camera, Scene } from "three" */

// Where the sun is: to the left of where the camera begins.
const FROM = new Vector3(-0.5, 0.3, 1.2).normalize();
// The shadow map has so many texels on a side.
const TEXELS = 1024;
// Shadows reach so many times as far as it is from the camera to what it looks at.
const REACH = 0.9;
// Shadows draw each triangle twice, so a frame with more of them has none.
const MOST_TRIANGLES = 400_000;

export class Light {
  #sun = new DirectionalLight(0xffffff, 1.2);

  /** @param {InstanceType<typeof Scene>} scene @param {InstanceType<typeof Camera>[]} cameras */
  constructor(scene, cameras) {
    this.#sun.castShadow = true;
    this.#sun.shadow.mapSize.set(TEXELS, TEXELS);
    this.#sun.shadow.radius = 2;
    const sky = new HemisphereLight(0xffffff, 0x707888, 1);
    sky.position.set(0, 0, 1);
    scene.add(this.#sun, this.#sun.target, sky);
    // What faces the camera is never dark.
    for (const camera of cameras) {
      const lamp = new DirectionalLight(0xffffff, 0.8);
      lamp.position.set(-0.3, 0.4, 1);
      camera.add(lamp);
    }
  }

  /**
   * Cast shadows around what the camera looks at.
   * @param {InstanceType<typeof Vector3>} target @param {number} distance from the camera (m)
   */
  follow(target, distance) {
    const { shadow } = this.#sun;
    const reach = distance * REACH;
    Object.assign(shadow.camera, { left: -reach, right: reach, top: reach, bottom: -reach, near: 0, far: 4 * reach });
    shadow.camera.updateProjectionMatrix();
    // Else surfaces would cast shadows on themselves, in stripes.
    shadow.normalBias = (3 * reach) / TEXELS;
    this.#sun.target.position.copy(target);
    this.#sun.position.copy(target).addScaledVector(FROM, 2 * reach);
  }

  /**
   * Decide whether the next frame has shadows, and return whether that is new.
   * @param {number} triangles of the last frame, with those of its shadows
   */
  drew(triangles) {
    const former = this.#sun.castShadow;
    this.#sun.castShadow = triangles / (former ? 2 : 1) <= MOST_TRIANGLES;
    return this.#sun.castShadow !== former;
  }
}

/** Let objects that light falls on cast shadows, and show those of others, unless one sees through them. @param {any} group */
export function shade(group) {
  group.traverse((/** @type {any} */ each) => {
    const materials = each.isMesh ? [each.material].flat() : [];
    const solid = materials.length > 0 && materials.every(({ transparent, isLineMaterial }) => !transparent && !isLineMaterial);
    each.castShadow = solid;
    each.receiveShadow = solid;
  });
}
