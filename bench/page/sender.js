// @ts-check
// What the nodes ping and burst do, between two bare workers.

// Up to this size (bytes), copying a buffer takes less than handing it over.
const SMALL = 1024;

/** @param {MessageEvent<{task: "ping" | "burst", size: number, count: number, port: MessagePort}>} event */
onmessage = ({ data: { task, size, count, port } }) => {
  const payload = new Uint8Array(size);
  // A program keeps what it sends, so every message is a copy; large ones need not be copied again.
  const send = () => {
    const copy = payload.slice();
    port.postMessage(copy, size > SMALL ? [copy.buffer] : []);
  };
  (task === "ping" ? ping : burst)(port, send, count);
};

/** @param {MessagePort} port @param {() => void} send @param {number} rounds */
function ping(port, send, rounds) {
  /** @type {number[]} */
  const times = [];
  let sent = 0;
  port.onmessage = () => {
    times.push(performance.now() - sent);
    if (times.length < rounds) {
      again();
    } else {
      postMessage(times);
    }
  };
  const again = () => {
    sent = performance.now();
    send();
  };
  again();
}

/** @param {MessagePort} port @param {() => void} send @param {number} count */
function burst(port, send, count) {
  let warm = false;
  let begun = 0;
  port.onmessage = () => {
    const time = performance.now() - begun;
    if (warm) {
      postMessage([time]);
    } else {
      warm = true;
      again();
    }
  };
  const again = () => {
    begun = performance.now();
    port.postMessage(count);
    for (let left = count; left > 0; left--) send();
  };
  again();
}
