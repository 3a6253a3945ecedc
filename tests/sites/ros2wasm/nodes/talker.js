// Publishes a numbered greeting on /chatter ten times a second, and ends after fifty.
importScripts("middleware.js");

(async () => {
  const own = registerNode("old_publisher");
  const publisher = register("/chatter", "publisher");
  for (let count = 0; count < 50; count++) {
    log("INFO", "old_publisher", `Publishing: 'Hello, world! ${count}'`);
    publish("/chatter", `data: Hello, world! ${count}`);
    await pause(100);
  }
  deregister(publisher);
  own.forEach(deregister);
  log("WARN", "old_publisher", "That was all");
})();
