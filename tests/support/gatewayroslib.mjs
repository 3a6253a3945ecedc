// Use roslib at a gateway with the robot of ros2/robot.py; print what was seen as JSON.
import { Action, Param, Ros, Service, Topic } from "roslib";

const ros = new Ros({ url: process.argv[2] });
const seen = {};

/** Wait for the arguments that `start` has its callbacks called with; the second one rejects. */
function called(start, name) {
  return new Promise((resolve, reject) => {
    setTimeout(() => reject(new Error(`${name} has not come`)), 15_000).unref();
    start(resolve, (error) => reject(new Error(`${name}: ${error}`)));
  });
}

function message(name, messageType, options = {}) {
  const topic = new Topic({ ros, name, messageType, ...options });
  return called((done) => topic.subscribe((one) => {
    topic.unsubscribe();
    done(one);
  }), name);
}

async function topics() {
  const heard = [];
  const listener = new Topic({ ros, name: "/heard", messageType: "std_msgs/String" });
  listener.subscribe((one) => heard.push(one.data));
  const teller = new Topic({ ros, name: "/tell", messageType: "std_msgs/msg/String" });
  while (!heard.includes("ready")) {
    teller.publish({ data: "ready" });
    await new Promise((done) => setTimeout(done, 100));
  }
  for (let i = 0; i < 10; i++) teller.publish({ data: `n${i}` });
  while (!heard.includes("n9")) await new Promise((done) => setTimeout(done, 20));
  seen.heard = heard.filter((text) => text !== "ready");
  seen.publishers = await called((done, no) => listener.getPublishers(done, no), "publishers");
  listener.unsubscribe();
  teller.unadvertise();
  const scan = await message("/scan", "sensor_msgs/LaserScan", { compression: "cbor" });
  seen.cbor = [scan.ranges.constructor.name, scan.ranges[3]];
  seen.png = (await message("/map", "std_msgs/String", { compression: "png" })).data;
  const raw = await message("/map", "std_msgs/String", { compression: "cbor-raw" });
  seen.raw = raw.bytes.length;
  seen.none = (await message("/image", "sensor_msgs/msg/Image")).data;
}

async function services() {
  const set = new Service({ ros, name: "/set", serviceType: "std_srvs/SetBool" });
  seen.called = await called((done, no) => set.callService({ data: true }, done, no), "set");
  const own = new Service({ ros, name: "/of_client", serviceType: "std_srvs/Trigger" });
  await own.advertiseAsync(async () => ({ success: true, message: "from roslib" }));
  const back = new Service({ ros, name: "/call_back", serviceType: "std_srvs/Trigger" });
  seen.served = await called((done, no) => back.callService({}, done, no), "call back");
  await own.unadvertise();
  const none = new Service({ ros, name: "/none", serviceType: "std_srvs/Trigger" });
  seen.failed = await called((done) => none.callService({}, () => done("?"), done), "none");
}

async function actions() {
  const feedback = [];
  const options = { ros, name: "/fibonacci", actionType: "test_msgs/action/Fibonacci" };
  const fibonacci = new Action(options);
  seen.result = await called(
    (done, no) => fibonacci.sendGoal({ order: 3 }, done, (one) => feedback.push(one.sequence), no),
    "result",
  );
  seen.feedback = feedback.length;
  seen.canceled = await called((done) => {
    const id = fibonacci.sendGoal({ order: 1000 }, () => done("succeeded"), () => {
      fibonacci.cancelGoal(id);
    }, done);
  }, "cancel");
  const count = new Action({ ros, name: "/count", actionType: "test_msgs/action/Fibonacci" });
  count.advertise((goal, id) => {
    count.sendFeedback(id, { sequence: [goal.order] });
    count.setSucceeded(id, { sequence: [goal.order, 1] });
  }, () => {});
  const send = new Service({ ros, name: "/send_goal", serviceType: "std_srvs/Trigger" });
  seen.goal = await called((done, no) => send.callService({}, done, no), "goal");
  count.unadvertise();
}

async function graph() {
  const ask = (name, ...args) => called((done, no) => ros[name](...args, done, no), name);
  seen.topics = (await ask("getTopics")).topics.includes("/heard");
  seen.nodes = (await ask("getNodes")).includes("/robot");
  seen.services = (await ask("getServices")).includes("/set");
  seen.servers = await ask("getActionServers");
  seen.type = await ask("getTopicType", "/cmd_vel");
  seen.serviceType = await ask("getServiceType", "/set");
  seen.forType = (await ask("getTopicsForType", "geometry_msgs/msg/Twist")).includes("/cmd_vel");
  seen.details = ros.decodeTypeDefs(await ask("getMessageDetails", "geometry_msgs/Twist"));
  const request = await ask("getServiceRequestDetails", "std_srvs/SetBool");
  seen.request = request.typedefs[0].fieldnames;
  seen.node = (await ask("getNodeDetails", "/robot")).services.includes("/set");
  seen.texts = (await ask("getTopicsAndRawTypes")).typedefs_full_text.length > 3;
  seen.params = (await ask("getParams")).includes("/robot:speed");
  const speed = new Param({ ros, name: "/robot:speed" });
  await called((done, no) => speed.set(2.5, done, no), "set");
  seen.speed = await called((done, no) => speed.get(done, no), "get");
}

try {
  await called((done, no) => ros.on("connection", done) && ros.on("error", no), "connection");
  await topics();
  await services();
  await actions();
  await graph();
} catch (error) {
  seen.error = String(error);
}
console.log(JSON.stringify(seen));
process.exit(0);
