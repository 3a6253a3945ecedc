// @ts-check
// Read the joints of a robot from its description (URDF).

import { say } from "../../ui/words.js";

/**
 * @typedef {{
 *   name: string, unit: "rad" | "m", lower: number, upper: number, speed: number, start: number, mimic?: Mimic,
 * }} Joint a joint that moves, with its limits (in units, and in units per second); one that mimics another has no
 *   position of its own
 * @typedef {{joint: string, multiplier: number, offset: number}} Mimic
 */

const UNITS = /** @type {const} */ ({ revolute: "rad", continuous: "rad", prismatic: "m" });
const MOST = 500;
// The speed of joints whose description has none.
const SPEEDS = { rad: 1.5, m: 0.2 };

/**
 * Return the joints that move along or around one axis, in the order of the file. Throws an Error if the text is no
 * description.
 * @param {string} text @param {Record<string, number>} zeros where joints start, by name
 * @returns {Joint[]}
 */
export function readJoints(text, zeros) {
  const { documentElement: robot } = new DOMParser().parseFromString(text, "application/xml");
  if (robot.nodeName !== "robot") throw new Error(say("not a robot description: its root is not <robot>"));
  const elements = [...robot.children].filter(({ nodeName }) => nodeName === "joint");
  const joints = elements.map((each) => readJoint(each, zeros)).filter((one) => !!one);
  if (joints.length > MOST) throw new Error(say("the description has more than {} joints", MOST));
  const names = new Set(joints.map(({ name }) => name));
  // A mimic of a joint that does not move stands still, as one without limits would.
  return joints.filter(({ mimic }) => !mimic || names.has(mimic.joint));
}

/** @param {Element} element @param {Record<string, number>} zeros @returns {Joint | undefined} */
function readJoint(element, zeros) {
  const type = element.getAttribute("type") ?? "";
  if (!Object.hasOwn(UNITS, type)) return undefined;
  const limit = element.querySelector(":scope > limit");
  const endless = type === "continuous";
  const lower = endless ? -Math.PI : number(limit, "lower", 0);
  const upper = endless ? Math.PI : number(limit, "upper", 0);
  const mimic = element.querySelector(":scope > mimic");
  const name = element.getAttribute("name") ?? "";
  const unit = UNITS[/** @type {keyof typeof UNITS} */ (type)];
  const speed = number(limit, "velocity", 0);
  // As joint_state_publisher: 0 where the joint can be, else the middle.
  const usual = lower <= 0 && upper >= 0 ? 0 : (lower + upper) / 2;
  return {
    name,
    unit,
    lower: Math.min(lower, upper),
    upper: Math.max(lower, upper),
    speed: speed > 0 ? speed : SPEEDS[unit],
    start: Object.hasOwn(zeros, name) ? zeros[name] ?? usual : usual,
    ...(mimic && {
      mimic: {
        joint: mimic.getAttribute("joint") ?? "",
        multiplier: number(mimic, "multiplier", 1),
        offset: number(mimic, "offset", 0),
      },
    }),
  };
}

/** @param {Element | null} element @param {string} name @param {number} standard */
function number(element, name, standard) {
  const found = Number.parseFloat(element?.getAttribute(name) ?? "");
  return Number.isFinite(found) ? found : standard;
}

/**
 * Return the position of each joint, from those of the joints that mimic no other.
 * @param {Joint[]} joints @param {Map<string, number>} own
 */
export function positionsOf(joints, own) {
  const known = new Map(joints.map((joint) => [joint.name, joint]));
  /** @type {(joint: Joint, depth: number) => number} */
  const position = ({ name, mimic, start }, depth) => {
    const leader = mimic && known.get(mimic.joint);
    // Joints that mimic each other in a circle stay where they begin.
    if (!mimic || !leader || depth > joints.length) return own.get(name) ?? start;
    return position(leader, depth + 1) * mimic.multiplier + mimic.offset;
  };
  return new Map(joints.map((joint) => [joint.name, position(joint, 0)]));
}
