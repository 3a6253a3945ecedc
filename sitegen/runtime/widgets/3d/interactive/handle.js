// @ts-check
// One interactive marker: where it is, what it shows, and its controls.

import { Group, Quaternion, Vector3 } from "../../../vendor/three.js";
import { say } from "../../../ui/words.js";
import { isFinitePose, poseOf } from "../../tf/pose.js";
import { seconds } from "../../tf/transforms.js";
import { createLabel } from "../label.js";
import { drawMarker } from "../marker.js";
import { dispose } from "../shapes.js";
import { put } from "../shown.js";
import { drawControl } from "./look.js";

/** @import { Context } from "../shown.js" */

const [INHERIT, FIXED, FACING] = [0, 1, 2];
const AXES = [new Vector3(1, 0, 0), new Vector3(0, 1, 0), new Vector3(0, 0, 1)];
const MOST_CONTROLS = 100;
/** Texts above markers, in their scale. */
const LETTERS = 0.15;

/**
 * @typedef {{name: string, mode: number, orientation: number, turn: InstanceType<typeof Quaternion>, group: any}} Control
 *   `mode` is the interaction_mode; `turn` is how its x axis, along or around which it moves, is turned in `group`
 */

export class Handle {
  name;
  frame;
  time;
  header;
  menu;
  /** Its size in metres. */
  scale;
  /** In the fixed frame, where the marker's frame is. */
  place = new Group();
  /** In that frame, where the marker is. */
  body = new Group();
  /** @type {Control[]} */
  controls = [];
  #label;
  #redraw;
  /** What the node wants while the visitor drags. @type {{header: any, pose: any} | undefined} */
  #wanted;
  #held = false;

  /** Throws an Error if it cannot be shown. @param {any} marker @param {Context} context */
  constructor(marker, context) {
    this.name = marker.name;
    this.#redraw = context.redraw;
    this.menu = marker.menu_entries;
    this.header = marker.header;
    this.frame = marker.header.frame_id;
    this.time = seconds(marker.header.stamp);
    const pose = poseOf(marker.pose);
    if (!isFinitePose(pose)) throw new Error(say("marker {}: its pose is not finite", this.name));
    put(this.body, pose);
    this.place.add(this.body);
    const scale = this.scale = marker.scale > 0 ? marker.scale : 1;
    for (const control of marker.controls.slice(0, MOST_CONTROLS)) this.#add(control, scale, context);
    this.#label = marker.description ? createLabel(marker.description, LETTERS * scale) : undefined;
    if (!this.#label) return;
    this.#label.position.set(0, 0, 0.75 * scale);
    // A text is not pressed.
    this.#label.raycast = () => {};
    this.body.add(this.#label);
  }

  /** The pose in its frame, as a message. */
  get pose() {
    const { position: p, quaternion: q } = this.body;
    return { position: { x: p.x, y: p.y, z: p.z }, orientation: { x: q.x, y: q.y, z: q.z, w: q.w } };
  }

  /** @param {boolean} on */
  describe(on) {
    if (this.#label) this.#label.visible = on;
  }

  /** Move it, or after the visitor has released it. @param {any} header @param {any} pose */
  move(header, pose) {
    if (this.#held) {
      this.#wanted = { header, pose };
      return;
    }
    const found = poseOf(pose);
    if (!isFinitePose(found)) return;
    if (header.frame_id) {
      this.header = header;
      this.frame = header.frame_id;
      this.time = seconds(header.stamp);
    }
    put(this.body, found);
  }

  /** @param {boolean} on whether the visitor holds it */
  set held(on) {
    this.#held = on;
    const wanted = this.#wanted;
    this.#wanted = undefined;
    if (on || !wanted) return;
    this.move(wanted.header, wanted.pose);
    this.#redraw();
  }

  /** Turn the controls that do not turn with the marker. @param {any} camera */
  face(camera) {
    for (const { orientation, group } of this.controls) {
      if (orientation === INHERIT) continue;
      group.position.copy(this.body.position);
      if (orientation !== FACING) continue;
      const to = camera.getWorldDirection(new Vector3()).negate();
      const inverse = this.place.getWorldQuaternion(new Quaternion()).invert();
      group.quaternion.setFromUnitVectors(AXES[0], to.applyQuaternion(inverse).normalize());
    }
  }

  /**
   * The direction of an axis of a control in the scene. @param {Control} control
   * @param {number} [which] 0 for the x axis, along or around which it moves, 1 for y, 2 for z
   */
  axis({ group, turn }, which = 0) {
    const axis = /** @type {any} */ (AXES[which]).clone().applyQuaternion(turn);
    return axis.applyQuaternion(group.getWorldQuaternion(new Quaternion())).normalize();
  }

  /** Move it to a position and a rotation in the scene. @param {any} position @param {any} rotation */
  put(position, rotation) {
    this.body.position.copy(this.place.worldToLocal(position.clone()));
    const turn = this.place.getWorldQuaternion(new Quaternion()).invert();
    this.body.quaternion.copy(turn.multiply(rotation)).normalize();
  }

  close() {
    dispose(this.place);
    this.place.removeFromParent();
  }

  /** @param {any} control @param {number} scale @param {Context} context */
  #add(control, scale, { resource, redraw, say: tell }) {
    const { name, interaction_mode: mode, orientation_mode: orientation, markers, orientation: q } = control;
    const group = new Group();
    (orientation === FIXED || orientation === FACING ? this.place : this.body).add(group);
    const turn = new Quaternion(q.x, q.y, q.z, q.w);
    if (!(turn.length() > 0)) turn.identity();
    turn.normalize();
    /** @type {Control} */
    const added = { name, mode, orientation, turn, group };
    this.controls.push(added);
    group.userData.control = added;
    group.userData.handle = this;
    if (!markers.length) drawControl(group, added, scale);
    for (const marker of markers.slice(0, MOST_CONTROLS)) {
      const inner = new Group();
      const pose = poseOf(marker.pose);
      if (!isFinitePose(pose)) continue;
      put(inner, pose);
      group.add(inner);
      drawMarker(inner, marker, { resource, redraw, say: tell });
    }
  }
}
