// What a compiled program calls of middleware.js, by the names that it has in the ROS2WASM project. Both
// are put before Emscripten's own code.
Module["registerParticipant"] = (name, role) => register(name, role).gid;
Module["deregisterParticipant"] = (gid, role) => {
  deregister({ gid, role });
  return true;
};
Module["publishMessage"] = (message, topic) => {
  publish(topic, message);
  return true;
};
Module["retrieveMessage"] = retrieve;
Module["printErr"] = (message) => postMessage({ command: "console", role: "listener", message });
