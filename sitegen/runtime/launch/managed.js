// @ts-check
// The states of managed nodes, as launch files change and follow them.

/** @import { LaunchHandler, Ros } from "../protocol.js" */

const CHANGE = "lifecycle_msgs/srv/ChangeState";
const EVENT = "lifecycle_msgs/msg/TransitionEvent";
// As launch_ros calls them.
const TRANSITIONS = [
  "create", "configure", "cleanup", "activate", "deactivate", "unconfigured_shutdown", "inactive_shutdown", "active_shutdown",
];

/**
 * Change the state of a node by transitions one after another, as soon as it offers that; a failure ends it.
 * @param {Ros} ros @param {string} node its full name @param {number[]} ids of the transitions
 * @param {(error: string) => void} failed @param {AbortSignal} signal ends the waiting
 */
export async function changeStates(ros, node, ids, failed, signal) {
  const service = `${node}/change_state`;
  for (const id of ids) {
    await isOffered(ros, service, signal);
    if (signal.aborted) return;
    const what = `transition '${TRANSITIONS[id] ?? id}' of '${node}'`;
    try {
      const { success } = await ros.call(service, CHANGE, { transition: { id, label: "" } }, Infinity, signal);
      if (success) continue;
      failed(`${what} failed`);
    } catch (error) {
      if (!signal.aborted) failed(`${what} failed: ${error instanceof Error ? error.message : error}`);
    }
    return;
  }
}

/**
 * Follow the states of the nodes that handlers wait for.
 * @param {Ros} ros @param {LaunchHandler[]} handlers
 * @param {(node: string, facts: Record<string, string>) => void} changed
 * @returns {() => void} end it
 */
export function followStates(ros, handlers, changed) {
  const names = new Set(followed(handlers));
  if (!ros.types[EVENT]) return () => {};
  const ends = [...names].map((node) => ros.subscribe(`${node}/transition_event`, EVENT, (message) => changed(node, {
    transition: message.transition.label,
    start_state: message.start_state.label,
    goal_state: message.goal_state.label,
  }), { reliable: true }));
  return () => ends.forEach((end) => end());
}

/** @param {LaunchHandler[]} handlers @returns {string[]} */
function followed(handlers) {
  return handlers.flatMap(({ on, effects }) => [
    ...(on.kind === "state" ? on.nodes ?? [] : []),
    ...followed(effects.flatMap(({ handler }) => handler ?? [])),
  ]);
}

/** Resolve when a service has a server. @param {Ros} ros @param {string} service @param {AbortSignal} signal @returns {Promise<void>} */
function isOffered({ graph }, service, signal) {
  return new Promise((resolve) => {
    const look = () => {
      if (!graph.services().some(({ name, servers }) => name === service && servers.length)) return;
      graph.removeEventListener("change", look);
      resolve();
    };
    graph.addEventListener("change", look, { signal });
    signal.addEventListener("abort", () => resolve(), { once: true });
    look();
  });
}
