// @ts-check
// What the visitor reads about a connection.

import { say } from "../../ui/words.js";

/** @import { State, Turn } from "../../gateway/orders.js" */

// Clocks that differ by more are worth a warning (ms).
const TOLERANCE = 1000;

/**
 * @param {State} state
 * @param {{address: string, graph: string, reason: string, seconds: number}} about `graph` describes the remote
 *   graph, and `seconds` is the time until the next try
 */
export function describe(state, { address, graph, reason, seconds }) {
  switch (state) {
    case "connecting":
      return say("Connecting to {}…", address);
    case "key":
      return say("This gateway asks for a key.");
    case "connected":
      return say("Connected to {} ({}).", address, graph);
    case "late":
      return say("The gateway at {} does not answer. Messages wait until it does.", address);
    case "lost":
      return say("No gateway answers at {}. Next try in {} s.", address, seconds);
    case "refused":
      return reason;
    case "ended":
      return say("The gateway has ended the connection: {}", reason);
    default:
      return say("Not connected. The nodes of this page are by themselves.");
  }
}

/** Describe the graph of a gateway. @param {{rmw: string, domain: number | null, distribution: string}} joined */
export function graphText({ rmw, domain, distribution }) {
  return [distribution, rmw, domain === null ? "" : say("domain {}", domain)].filter(Boolean).join(", ");
}

/** Say what a server that speaks rosbridge cannot do. */
export function rosbridgeNote() {
  return say("This server speaks rosbridge: the robot can use the topics, services and actions of this page, but does not see its nodes.");
}

/** @param {string} name @param {string} reason */
export function keptNote(name, reason) {
  return say("{} stays in this page: {}", name, reason);
}

/** @param {number} offset ms */
export function clockNote(offset) {
  if (Math.abs(offset) <= TOLERANCE) return "";
  const seconds = (Math.abs(offset) / 1000).toFixed(1);
  return offset > 0
    ? say("The clock of the gateway is {} s ahead of this computer's; times of messages differ.", seconds)
    : say("The clock of the gateway is {} s behind this computer's; times of messages differ.", seconds);
}

/** @param {number} seconds */
export function untilNote(seconds) {
  return say("Your key is good for {} more.", clock(seconds));
}

/** Say whose turn it is. @param {Turn} turn @param {number} passed seconds since then */
export function turnNote({ now, nowLeft, mineIn, mineLeft }, passed) {
  if (mineIn === 0) return say("It is your turn for {} more.", clock((mineLeft ?? 0) - passed));
  const whose = now
    ? say("It is the turn of {} for {} more.", now, clock((nowLeft ?? 0) - passed))
    : say("It is nobody's turn.");
  const mine = mineIn === null
    ? say("You have no appointment; you can watch.")
    : say("Yours begins in {}.", clock(mineIn - passed));
  return `${whose} ${mine}`;
}

/** @param {number} seconds */
function clock(seconds) {
  const left = Math.max(0, Math.round(seconds));
  const [hours, minutes] = [Math.floor(left / 3600), Math.floor(left / 60) % 60];
  const rest = String(left % 60).padStart(2, "0");
  return hours ? `${hours}:${String(minutes).padStart(2, "0")}:${rest}` : `${minutes}:${rest}`;
}
