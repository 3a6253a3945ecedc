// A WebSocket server that sends back what comes, and prints its port.
import { WebSocketServer } from "ws";

const server = new WebSocketServer({ host: "127.0.0.1", port: 0, perMessageDeflate: false });
server.on("connection", (socket) => socket.on("message", (bytes) => socket.send(bytes)));
server.on("listening", () => console.log(server.address().port));
