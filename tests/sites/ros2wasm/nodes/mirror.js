// Publishes what comes on a topic on the same with /back, as it is.
importScripts("middleware.js");

const TOPICS = ["/array", "/diagnostics", "/empty", "/image", "/imu", "/joints", "/number", "/text"];

for (const topic of TOPICS) {
  register(topic, "subscriber");
  register(`${topic}/back`, "publisher");
  (async () => {
    for (;;) {
      const yaml = await retrieve(topic);
      if (yaml) publish(`${topic}/back`, yaml);
    }
  })();
}
