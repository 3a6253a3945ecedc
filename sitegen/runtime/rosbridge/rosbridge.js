// @ts-check
// The module "sitegen/rosbridge": the graph of the page for clients of rosbridge, such as roslib.

export { listen } from "./listen.js";
export { RosbridgeSocket } from "./socket.js";
export { transportFactory } from "./transport.js";
export { serveWebSocket } from "./webSocket.js";
