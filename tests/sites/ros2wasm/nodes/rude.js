// Does everything wrong, twice, and then something right.
importScripts("middleware.js");

for (let time = 0; time < 2; time++) {
  for (const data of [null, 7, 7n, "register", [], {}, { command: { toString: 1 } }, { command: "constructor" }]) {
    postMessage(data);
  }
  postMessage({ command: "publish", topic: "/chatter" });
  postMessage({ command: "publish", topic: ["/chatter"], message: "data: a" });
  postMessage({ command: "console", message: new Uint8Array(3) });
  postMessage({ command: "register", topic: "/chatter", gid: "1" });
  publish("/unknown", "data: a");
  postMessage({ command: "retrieve", topic: "/unknown" });
  postMessage({ command: "deregister", topic: "/unknown", role: "publisher", gid: "2" });
  register("/untyped", "publisher");
  register("/untyped/service", "service_server");
  register("/response/untyped/service", "publisher");
  register("/request/untyped/service", "subscriber");
  publish("/untyped", "data: a");
  register("/mixed", "service_client");
  register("/add_two_ints", "subscriber");
  register("/chatter", "constructor");
  register("/fibonacci", "action_server");
  register("/fibonacci", "action_client");
  register('/<img src=x onerror="alert(1)">', "publisher");
  register("/number", "publisher");
  publish("/number", "data: seven");
  publish("/number", "value: 7");
  publish("/number", "data: [");
  publish("/number", "");
  publish("/number", `data: ${"9".repeat(1000)}`);
  registerService("/add_two_ints", "service_server");
  publish("/response/add_two_ints", "sum: 1");
  postMessage({ command: "console", role: "client", message: "printed <b>as it is</b>" });
}
register("/chatter", "publisher");
setInterval(() => publish("/chatter", "data: 'still, here'"), 100);
