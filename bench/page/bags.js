// Publish as much as a recorder should take, hear what a player publishes, and what a timer can do.

const { ros } = await import(document.querySelector("script[type=module]").src);

const TYPE = "bench/msg/Bytes";
ros.types[TYPE] = { fields: [{ name: "data", type: "uint8[]" }], constants: [] };

/** Publish `count` messages of `size` bytes each 10 ms, for some seconds; note the times between frames (ms). */
export async function publish(size, count, seconds) {
  const publisher = ros.advertise("/load", TYPE, { keepAll: true });
  await new Promise((done) => setTimeout(done, 500));
  const data = new Uint8Array(size);
  for (let at = 0; at < size; at += 3) data[at] = Math.random() * 256;
  const frames = [];
  let last = 0;
  let going = true;
  const frame = (time) => {
    if (last) frames.push(time - last);
    last = time;
    if (going) requestAnimationFrame(frame);
  };
  requestAnimationFrame(frame);
  const begun = performance.now();
  let sent = 0;
  while (performance.now() - begun < seconds * 1000) {
    // As many as are due, so that a late timer does not make it fewer.
    const due = Math.ceil((performance.now() - begun) / 10) * count;
    while (sent < due) {
      try {
        publisher.publish({ data });
      } catch {
        break; // the recorder is behind
      }
      sent += 1;
    }
    await new Promise((done) => setTimeout(done, 10));
  }
  const took = (performance.now() - begun) / 1000;
  going = false;
  // It stays until the page is closed: what the recorder has not taken yet would go with it.
  return { sent, seconds: took, frames };
}

/** Resolve with the times (ms) at which the player sent that many messages. */
export function heard(count) {
  return new Promise((resolve) => {
    const times = [];
    const end = ros.subscribeBytes("/ticks", "std_msgs/msg/Int32", (message, { timestamp }) => {
      times.push(timestamp);
      if (times.length < count - 1) return;
      end();
      resolve(times);
    }, { depth: 1000, reliable: true });
  });
}

/** Resolve with the times (ms) at which a worker wakes that waits for each multiple of 10 ms. */
export function ticks(count) {
  const worker = new Worker("/bench/ticks.js");
  worker.postMessage(count);
  return new Promise((resolve) => (worker.onmessage = ({ data }) => {
    worker.terminate();
    resolve(data);
  }));
}
