"""Clients of rosbridge that send nonsense: each message has one answer, and the page goes on."""

from __future__ import annotations

from playwright.sync_api import Page

ODD = """async () => {
  const told = [];
  const socket = new rosbridge.RosbridgeSocket();
  await new Promise((resolve) => { socket.onopen = resolve; });
  socket.onmessage = ({ data }) => told.push(JSON.parse(data));
  const ask = async (message, answered = false) => {
    told.length = 0;
    socket.send(typeof message === "string" ? message : JSON.stringify(message));
    await pause(20);
    while (answered && !told.length) await pause(20);
    return told.map(({ op, level, msg, values }) => [op, level ?? "", msg ?? values].join(" "));
  };
  globalThis.ask = ask;
}"""
MESSAGES = [
    ("{", "error the message is not valid JSON"),
    ([1], "error a message is an object with a text 'op'"),
    ({"op": "nonsense"}, "error unknown operation 'nonsense'"),
    ({"op": "constructor"}, "error unknown operation 'constructor'"),
    ({"op": "subscribe"}, "error subscribe: 'topic' is missing; it is a string"),
    ({"op": "subscribe", "topic": 3}, "error subscribe: 'topic' is a number; it must be a string"),
    (
        {"op": "subscribe", "topic": "/nowhere"},
        "error subscribe: /nowhere has no type; give one, or publish it first",
    ),
    (
        {"op": "subscribe", "topic": "/chatter", "type": "std_msgs/Int8"},
        "error subscribe: /chatter has the type std_msgs/msg/String, not std_msgs/msg/Int8",
    ),
    (
        {"op": "subscribe", "topic": "/a b", "type": "std_msgs/Int8"},
        "error subscribe: '/a b' is not a valid name in ROS",
    ),
    (
        {"op": "subscribe", "topic": "/chatter", "compression": "zip"},
        "error subscribe: unknown compression 'zip'; it is one of none, png, cbor, cbor-raw",
    ),
    (
        {"op": "advertise", "topic": "/x", "type": "no_msgs/No"},
        "error advertise: this page has no definition of no_msgs/msg/No",
    ),
    (
        {"op": "publish", "topic": "/new", "msg": {}},
        "error publish: /new has no type; advertise it first",
    ),
    (
        {"op": "publish", "topic": "/echo", "msg": {"data": 1}},
        'error publish: std_msgs/String.data: expected a text for string, found the number "1"',
    ),
    (
        {"op": "publish", "topic": "/echo", "msg": {"dat": ""}},
        "error publish: std_msgs/String has no field 'dat'",
    ),
    (
        {"op": "unadvertise", "topic": "/other"},
        "error unadvertise: this client does not advertise /other",
    ),
    (
        {"op": "service_response", "service": "/s", "id": "7"},
        "error service_response: no request with this id waits at /s",
    ),
    (
        {"op": "action_feedback", "action": "/a", "id": "7"},
        "error action_feedback: /a has no active goal with this id",
    ),
    (
        {"op": "fragment", "id": "a", "data": "", "num": 0, "total": 1e9},
        "error fragment: it needs an id, data, num and total, which is at most 10000",
    ),
    (
        {"op": "fragment", "id": "b", "data": '{"op":"fragment"}', "num": 0, "total": 1},
        "error fragment: unknown operation 'fragment'",
    ),
    (
        {"op": "set_level", "level": "loud"},
        "error set_level: 'level' is one of none, error, warning, info",
    ),
    (
        {"op": "subscribe", "id": {}, "topic": "/t"},
        "error subscribe: 'id' is a text of at most 1000 characters, or a number",
    ),
]


def test_each_mistake_has_an_answer(page: Page) -> None:
    page.evaluate(ODD)
    for message, wanted in MESSAGES:
        assert page.evaluate("(message) => ask(message)", message) == [f"status {wanted}"], message
    # And it goes on.
    found = page.evaluate(
        """() => {
          const args = { a: 1, b: 1 };
          return ask({ op: "call_service", service: "/add_two_ints", args }, true);
        }"""
    )
    assert found == ["service_response  [object Object]"]


def test_a_status_names_the_message_that_it_is_about(page: Page) -> None:
    found = page.evaluate(
        """async () => {
          const told = [];
          const socket = new rosbridge.RosbridgeSocket();
          await new Promise((resolve) => { socket.onopen = resolve; });
          socket.onmessage = ({ data }) => told.push(JSON.parse(data));
          const inner = JSON.stringify({ op: "nonsense", id: "inner" });
          const fragment = (id, data) => ({ op: "fragment", id, data, num: 0, total: 1 });
          const sent = [
            { op: "nonsense", id: "q1" }, { op: "nonsense", id: 7 }, { id: "q2" },
            { op: "publish", id: "q3", topic: "/new" }, { op: "nonsense", id: {} }, "{",
            { op: "subscribe", id: "q4", topic: "/" + "a".repeat(2000) },
            fragment("f1", inner), fragment("f2", "{"),
          ];
          for (const one of sent) socket.send(typeof one === "string" ? one : JSON.stringify(one));
          while (told.length < sent.length) await pause(1);
          return told.map(({ op, id }) => [op, id ?? "none"]);
        }"""
    )
    ids = ["q1", 7, "q2", "q3", "none", "none", "q4", "inner", "f2"]
    assert found == [["status", one] for one in ids]


def test_values_that_do_not_fit(page: Page) -> None:
    page.evaluate(ODD)
    found = page.evaluate(
        """async () => {
          const types = {
            "/u8": "std_msgs/UInt8", "/i64": "std_msgs/Int64", "/bool": "std_msgs/Bool",
            "/array": "std_msgs/UInt8MultiArray", "/pose": "geometry_msgs/PoseWithCovariance",
          };
          for (const [topic, type] of Object.entries(types)) await ask({ op: "advertise", topic,
            type });
          const said = [];
          const publish = async (topic, msg) => {
            const [one = ""] = await ask({ op: "publish", topic, msg });
            said.push(one.replace("status error publish: ", ""));
          };
          await publish("/u8", { data: 256 });
          await publish("/u8", { data: 1.5 });
          await publish("/i64", { data: 2 ** 70 });
          await publish("/bool", { data: "yes" });
          await publish("/array", { data: "*" });
          await publish("/array", { data: [1, 2, 300] });
          await publish("/pose", { covariance: [1] });
          await publish("/pose", { pose: { position: { x: "a" } } });
          await publish("/pose", { pose: [] });
          await publish("/array", { data: [1, 2, 3] });
          return said;
        }"""
    )
    assert found == [
        "std_msgs/UInt8.data: uint8 cannot be 256",
        'std_msgs/UInt8.data: expected a whole number for uint8, found the number "1.5"',
        "std_msgs/Int64.data: int64 cannot be 1.1805916207174113e+21",
        'std_msgs/Bool.data: expected true or false for bool, found the string "yes"',
        "std_msgs/UInt8MultiArray.data: the text is not base64",
        "std_msgs/UInt8MultiArray.data[2]: uint8 cannot be 300",
        "geometry_msgs/PoseWithCovariance.covariance: float64[36] cannot have 1 items",
        "geometry_msgs/PoseWithCovariance.pose.position.x: "
        'expected a number for float64, found the string "a"',
        "geometry_msgs/PoseWithCovariance.pose: "
        "expected an object for geometry_msgs/Pose, found a list",
        "",
    ]


def test_the_number_of_things_is_bounded(page: Page) -> None:
    page.evaluate(ODD)
    found = page.evaluate(
        """async () => {
          const socket = new rosbridge.RosbridgeSocket();
          await new Promise((resolve) => { socket.onopen = resolve; });
          const told = new Set();
          socket.onmessage = ({ data }) => told.add(JSON.parse(data).msg);
          for (let i = 0; i < 1100; i++) {
            socket.send(JSON.stringify({ op: "advertise", topic: `/many/t${i}`,
              type: "std_msgs/Int8" }));
            socket.send(JSON.stringify({ op: "fragment", id: i, data: "x".repeat(1e5), num: 0,
              total: 2 }));
          }
          await pause(50);
          const topics = ros.topics().filter(({ name }) => name.startsWith("/many/")).length;
          socket.close();
          return { told: [...told], topics, left: ros.topics().some(({ name }) =>
            name.startsWith("/many/")) };
        }"""
    )
    assert found == {"told": ["advertise: too many topics"], "topics": 1000, "left": False}


def test_many_malformed_messages_leave_nothing_behind(page: Page) -> None:
    page.evaluate(ODD)
    found = page.evaluate(
        """async () => {
          const socket = new rosbridge.RosbridgeSocket();
          await new Promise((resolve) => { socket.onopen = resolve; });
          let told = 0;
          socket.onmessage = () => told++;
          const before = ros.topics().length + ros.services().length;
          const odd = ["{", "[]", "null", '{"op":"publish"}', '{"op":"fragment","id":"a"}',
            '{"op":"subscribe","topic":"/x","type":"a/B"}', '{"op":"call_service","service":"/x"}',
            '{"op":"advertise_action","action":"/x","type":"std_msgs/String"}'];
          const most = 100_000;
          for (let i = 0; i < most; i++) {
            socket.send(odd[i % odd.length]);
            if (i % 1000 === 0) await pause(0);
          }
          await pause(100);
          const after = ros.topics().length + ros.services().length;
          // A call has a response besides its status.
          return [told, after - before];
        }"""
    )
    assert found == [112_500, 0]
