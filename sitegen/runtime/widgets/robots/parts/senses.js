// @ts-check
// The sensors of Vernie: readings, and topics if the page knows their types.

import { plain } from "./motion.js";
import { say } from "../../../ui/words.js";

/** @import { Publisher, Ros } from "../../../protocol.js" */
/** @import { Reading } from "./robot.js" */

const FLOAT = "std_msgs/msg/Float32";
const VECTOR = "geometry_msgs/msg/Vector3";
const BOOL = "std_msgs/msg/Bool";
// The distance of the simulated hand (m), and the time between its messages (ms).
const HAND = 0.05;
const EYES = 200;

/**
 * Publish distance, tilt and button below the topic `name`. `seen` tells whether the distance is published.
 * @param {Ros} ros @param {string} name @param {() => void} changed
 */
export function createSenses(ros, name, changed) {
  const advertise = (/** @type {string} */ topic, /** @type {string} */ type) =>
    ros.types[type] ? ros.advertise(`${name}/${topic}`, type) : undefined;
  const distance = advertise("distance", FLOAT);
  const tilt = advertise("tilt", VECTOR);
  const pressed = advertise("button", BOOL);
  /** The last readings of the hub, by name. @type {Map<string, string>} */
  const said = new Map();
  /** @type {ReturnType<typeof setInterval> | undefined} */
  let timer;

  /** @param {string} sense @param {string} text @param {Publisher} [publisher] @param {object} [message] */
  const tell = (sense, text, publisher, message) => {
    said.set(sense, text);
    publisher?.publish(message);
    changed();
  };
  return {
    seen: distance !== undefined,
    listener: {
      battery: (/** @type {number} */ percent) => tell(say("Battery"), `${percent} %`),
      button: (/** @type {boolean} */ data) =>
        tell(say("Button"), data ? say("pressed") : say("released"), pressed, { data }),
      distance: (/** @type {number} */ data) =>
        tell(say("Distance"), Number.isFinite(data) ? `${plain(data, 2)} m` : say("free"), distance, { data }),
      tilt: (/** @type {number} */ x, /** @type {number} */ y) =>
        tell(say("Tilt"), `${degrees(x)}, ${degrees(y)}`, tilt, { x, y, z: 0 }),
    },
    /** @returns {Reading[]} */
    readings: () => [...said].map(([sense, text]) => ({ name: sense, text })),
    clear: () => said.clear(),
    /** Let the simulated robot see a hand, or nothing. @param {boolean} held */
    hold(held) {
      clearInterval(timer);
      distance?.publish({ data: held ? HAND : Infinity });
      if (held) timer = setInterval(() => distance?.publish({ data: HAND }), EYES);
    },
    close() {
      clearInterval(timer);
      for (const publisher of [distance, tilt, pressed]) publisher?.close();
    },
  };
}

/** @param {number} radians */
function degrees(radians) {
  return `${plain((radians * 180) / Math.PI, 0)}°`;
}
