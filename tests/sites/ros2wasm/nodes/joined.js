// Publishes a message of many lines in one, as their page stores it.
importScripts("middleware.js");

register("/point", "publisher");
const lines = [
  "header:", "  stamp:", "    sec: 7", "    nanosec: 8", "  frame_id: map",
  "point:", "  x: 1", "  y: -2.5", "  z: .inf",
];
setInterval(() => publish("/point", lines.join(", ")), 50);
