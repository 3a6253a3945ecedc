// @ts-check
// Poses: a position in metres and a rotation as a quaternion.

/**
 * @typedef {[number, number, number]} Vector x, y, z
 * @typedef {[number, number, number, number]} Rotation x, y, z, w
 * @typedef {{position: Vector, rotation: Rotation}} Pose
 */

/** @type {Pose} */
export const IDENTITY = { position: [0, 0, 0], rotation: [0, 0, 0, 1] };

/** Return the pose `inner`, given in the frame of `outer`, in the frame that `outer` is given in. @param {Pose} outer @param {Pose} inner @returns {Pose} */
export function compose(outer, inner) {
  const [x, y, z] = rotated(outer.rotation, inner.position);
  const [a, b, c] = outer.position;
  return { position: [a + x, b + y, c + z], rotation: multiplied(outer.rotation, inner.rotation) };
}

/** @param {Pose} pose @returns {Pose} */
export function inverse({ position, rotation: [x, y, z, w] }) {
  /** @type {Rotation} */
  const back = [-x, -y, -z, w];
  const [a, b, c] = rotated(back, position);
  return { position: [-a, -b, -c], rotation: back };
}

/** Return the pose a `part` (0 to 1) of the way between two, with a constant velocity. @param {Pose} from @param {Pose} to @param {number} part @returns {Pose} */
export function between(from, to, part) {
  const [a, b, c] = from.position;
  const [d, e, f] = to.position;
  return {
    position: [a + (d - a) * part, b + (e - b) * part, c + (f - c) * part],
    rotation: slerp(from.rotation, to.rotation, part),
  };
}

/** Return the pose with a rotation of length 1; a rotation of zeros, as in an empty message, is none. @param {Pose} pose @returns {Pose} */
export function normalized({ position, rotation: [x, y, z, w] }) {
  const length = Math.hypot(x, y, z, w);
  return { position, rotation: length === 0 ? [0, 0, 0, 1] : [x / length, y / length, z / length, w / length] };
}

/** Return the pose of a geometry_msgs/msg/Pose. @param {any} pose @returns {Pose} */
export function poseOf({ position: p, orientation: q }) {
  return normalized({ position: [p.x, p.y, p.z], rotation: [q.x, q.y, q.z, q.w] });
}

/** Whether all its numbers are finite. @param {Pose} pose */
export function isFinitePose({ position, rotation }) {
  return position.every(Number.isFinite) && rotation.every(Number.isFinite);
}

/** Return roll, pitch and yaw in radians. @param {Rotation} rotation @returns {Vector} */
export function rollPitchYaw([x, y, z, w]) {
  const sine = 2 * (w * y - z * x);
  return [
    Math.atan2(2 * (w * x + y * z), 1 - 2 * (x * x + y * y)),
    Math.asin(Math.max(-1, Math.min(1, sine))),
    Math.atan2(2 * (w * z + x * y), 1 - 2 * (y * y + z * z)),
  ];
}

/** @param {Rotation} rotation @param {Vector} vector @returns {Vector} */
function rotated([x, y, z, w], [a, b, c]) {
  const i = 2 * (y * c - z * b);
  const j = 2 * (z * a - x * c);
  const k = 2 * (x * b - y * a);
  return [a + w * i + y * k - z * j, b + w * j + z * i - x * k, c + w * k + x * j - y * i];
}

/** @param {Rotation} one @param {Rotation} two @returns {Rotation} */
function multiplied([x, y, z, w], [a, b, c, d]) {
  return [
    w * a + x * d + y * c - z * b,
    w * b - x * c + y * d + z * a,
    w * c + x * b - y * a + z * d,
    w * d - x * a - y * b - z * c,
  ];
}

/** @param {Rotation} from @param {Rotation} to @param {number} part @returns {Rotation} */
function slerp(from, to, part) {
  let cosine = from.reduce((sum, each, index) => sum + each * /** @type {number} */ (to[index]), 0);
  const sign = cosine < 0 ? -1 : 1;
  cosine *= sign;
  let [one, two] = [1 - part, part];
  if (cosine < 0.9995) {
    const angle = Math.acos(cosine);
    [one, two] = [Math.sin(one * angle) / Math.sin(angle), Math.sin(two * angle) / Math.sin(angle)];
  }
  const [a, b, c, d] = from;
  const [e, f, g, h] = to;
  const mixed = normalized({
    position: [0, 0, 0],
    rotation: [
      one * a + sign * two * e, one * b + sign * two * f, one * c + sign * two * g, one * d + sign * two * h,
    ],
  });
  return mixed.rotation;
}
