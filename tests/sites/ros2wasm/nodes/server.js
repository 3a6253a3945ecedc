// Serves /add_two_ints. Under the name slow_server it takes its time, and asks for more meanwhile.
importScripts("middleware.js");

(async () => {
  registerNode(self.name);
  registerService("/add_two_ints", "service_server");
  log("INFO", self.name, "Ready to add two numbers");
  for (;;) {
    const yaml = await retrieve("/request/add_two_ints");
    if (!yaml) continue;
    const { a, b } = fields(yaml);
    log("INFO", self.name, `${a} + ${b}`);
    const answer = `sum: ${BigInt(a) + BigInt(b)}`;
    if (self.name === "slow_server") setTimeout(() => publish("/response/add_two_ints", answer), 100);
    else publish("/response/add_two_ints", answer);
  }
})();
