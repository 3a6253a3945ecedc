// @ts-check
// What the nodes pong and sink do, between two bare workers.

// Up to this size (bytes), copying a buffer takes less than handing it over.
const SMALL = 1024;

/** @param {MessageEvent<{task: "ping" | "burst", port: MessagePort}>} event */
onmessage = ({ data: { task, port } }) => (task === "ping" ? pong : sink)(port);

/** @param {MessagePort} port */
function pong(port) {
  port.onmessage = ({ data }) => {
    const copy = data.slice();
    port.postMessage(copy, copy.length > SMALL ? [copy.buffer] : []);
  };
}

/** @param {MessagePort} port */
function sink(port) {
  let left = 0;
  port.onmessage = ({ data }) => {
    if (typeof data === "number") {
      left = data;
    } else if (--left === 0) {
      port.postMessage(null);
    }
  };
}
