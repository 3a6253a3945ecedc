// Prints what it hears on /chatter. It has no parameters, so that only site.yaml knows its name.
importScripts("middleware.js");

(async () => {
  register("/rosout", "publisher");
  register("/chatter", "subscriber");
  for (;;) {
    const yaml = await retrieve("/chatter");
    if (yaml) log("INFO", "minimal_subscriber", `I heard: '${fields(yaml).data}'`);
  }
})();
