// Asks /add_two_ints for the sum of the two numbers in its name, add_1_2, five times, and ends. It does
// not know whether a server is there.
importScripts("middleware.js");

(async () => {
  const [, a, b] = self.name.split("_");
  const own = [...registerNode(self.name), ...registerService("/add_two_ints", "service_client")];
  for (let count = 0; count < 5; count++) {
    log("INFO", self.name, `Request ${count}`);
    publish("/request/add_two_ints", `a: ${a}\nb: ${Number(b) + count}`);
    let yaml = "";
    while (!yaml) yaml = await retrieve("/response/add_two_ints");
    log("INFO", self.name, `Sum: ${fields(yaml).sum}`);
  }
  own.forEach(deregister);
})();
