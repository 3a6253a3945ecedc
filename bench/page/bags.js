// Publish as much as a recorder should take, hear what a player publishes, and what a timer can do.

const { ros } = await import(document.querySelector("script[type=module]").src);

const TYPE = "bench/msg/Bytes";
ros.types[TYPE] = { fields: [{ name: "data", type: "uint8[]" }], constants: [] };

/** Publish `count` messages of `size` bytes each 10 ms, for some seconds; note the times between frames and those of steps (ms). */
export async function publish(size, count, seconds) {
  const publisher = ros.advertise("/load", TYPE, { keepAll: true });
  // As without a recorder, too, somebody listens.
  ros.subscribeBytes("/load", TYPE, () => {}, { keepAll: true });
  await new Promise((done) => setTimeout(done, 500));
  const data = new Uint8Array(size);
  for (let at = 0; at < size; at += 3) data[at] = Math.random() * 256;
  const frames = [];
  const steps = [];
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
    const since = performance.now();
    while (sent < due) {
      try {
        publisher.publish({ data });
      } catch {
        break; // the recorder is behind
      }
      sent += 1;
    }
    steps.push(performance.now() - since);
    await new Promise((done) => setTimeout(done, 10));
  }
  const took = (performance.now() - begun) / 1000;
  going = false;
  // It stays until the page is closed: what the recorder has not taken yet would go with it.
  return { sent, seconds: took, frames, steps };
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

/** Play the bag of the page; resolve with the time (ms) of its first message, from navigation on. */
export function first() {
  return new Promise((resolve) => {
    const end = ros.subscribeBytes("/images", TYPE, () => {
      end();
      resolve(performance.now());
    }, { depth: 10, reliable: true });
    const buttons = [...document.querySelectorAll(".ros-bag-player button")];
    buttons.find(({ textContent }) => textContent === "Play").click();
  });
}

/** Seek to the message with a number, while the bag is playing; resolve with the time (ms) until it or its next ones come. */
export function seek(number, period) {
  return new Promise((resolve) => {
    const slider = document.querySelector(".ros-bag-slider");
    const begun = performance.now();
    const end = ros.subscribeBytes("/images", TYPE, (message) => {
      // After the head of CDR and the length of the array.
      const found = new DataView(message.buffer, message.byteOffset).getUint32(8, true);
      if (found < number || found > number + 20) return;
      end();
      resolve(performance.now() - begun);
    }, { depth: 10, reliable: true });
    slider.value = String(number * period);
    slider.dispatchEvent(new Event("input"));
  });
}
