// @ts-check
// Subscriptions to topics whose type the page may come to know later: a bag brings the types of its topics.

/** @import { MessageInfo, Qos, Ros } from "../protocol.js" */

/**
 * Subscribe to a topic, now or as soon as the page knows its type.
 * @param {Ros} ros @param {string} topic @param {string} type
 * @param {(message: any, info: MessageInfo) => void} receive @param {Partial<Qos>} qos
 * @returns {() => void} unsubscribe
 */
export function subscribeOnceKnown(ros, topic, type, receive, qos) {
  let unsubscribe = () => {};
  const look = () => {
    if (!ros.types[type]) return;
    ros.graph.removeEventListener("change", look);
    unsubscribe = ros.subscribe(topic, type, receive, qos);
  };
  ros.graph.addEventListener("change", look);
  look();
  return () => {
    ros.graph.removeEventListener("change", look);
    unsubscribe();
  };
}
