"""What scripts send is checked before it is sent: fields, types and ranges."""

from __future__ import annotations

from pathlib import Path
from typing import Any

import pytest
from browser import Serve
from playwright.sync_api import Browser, ConsoleMessage, Page

# `fault` returns how work ends: what it throws, or "nothing"; `heard` what arrives of a message.
TOOLS = """() => {
  const shown = (error) => `${error.name} ${error.message}`;
  const attempt = (work) => { try { work(); return "nothing"; } catch (error) {
    return shown(error); } };
  const told = (promise) => promise.then(() => "nothing", shown);
  const text = (value) => JSON.stringify(value, (_, one) => (typeof one === "bigint" ? `${one}n`
    : ArrayBuffer.isView(one) ? [one.constructor.name, ...one].map(String)
    : Object.is(one, NaN) ? "NaN" : one));
  let next = 0;
  const heard = async (type, message) => {
    const topic = ros.topic(`/heard${next++}`, type);
    const one = topic.next();
    topic.publish(message);
    const late = (resolve) => setTimeout(() => resolve("nothing arrives"), 5000);
    return Promise.race([one.then(text), new Promise(late)]);
  };
  Object.assign(globalThis, { attempt, told, heard, text });
}"""
TWIST = "geometry_msgs/msg/Twist"
POSE = "geometry_msgs/msg/PoseWithCovariance"
# Type, message in JavaScript, and the error at the caller without the name of the topic.
WRONG = [
    (
        TWIST,
        "{ linear: { xx: 1 } }",
        f"{TWIST} has no field 'linear.xx'; the fields of geometry_msgs/msg/Vector3 are x, y, z",
    ),
    (TWIST, "{ x: 1 }", f"{TWIST} has no field 'x'; its fields are linear, angular"),
    ("std_msgs/msg/Empty", "{ a: 1 }", "std_msgs/msg/Empty has no field 'a'; std_msgs/msg/Empty "),
    (TWIST, '"hello"', f'{TWIST}: expected an object for {TWIST}, found the string "hello"'),
    (TWIST, "undefined", f"{TWIST}: expected an object for {TWIST}, found undefined"),
    (TWIST, "null", f"{TWIST}: expected an object for {TWIST}, found null"),
    (TWIST, "[1, 2]", f"{TWIST}: expected an object for {TWIST}, found a list"),
    (
        TWIST,
        "Promise.resolve({})",
        f"{TWIST}: expected an object for {TWIST}, found an object of the class Promise",
    ),
    (
        TWIST,
        "{ linear: 1 }",
        f'{TWIST}.linear: expected an object for geometry_msgs/msg/Vector3, found the number "1"',
    ),
    (
        TWIST,
        '{ linear: { x: "1" } }',
        f'{TWIST}.linear.x: expected a number for float64, found the string "1"',
    ),
    (TWIST, "{ linear: { x: null } }", f"{TWIST}.linear.x: expected a number for float64, found n"),
    ("std_msgs/msg/UInt8", "{ data: 300 }", "std_msgs/msg/UInt8.data: uint8 cannot be 300"),
    ("std_msgs/msg/UInt8", "{ data: -1 }", "std_msgs/msg/UInt8.data: uint8 cannot be -1"),
    (
        "std_msgs/msg/UInt8",
        "{ data: 1.5 }",
        'std_msgs/msg/UInt8.data: expected a whole number for uint8, found the number "1.5"',
    ),
    (
        "std_msgs/msg/Int64",
        "{ data: 2n ** 70n }",
        "std_msgs/msg/Int64.data: int64 cannot be 118059",
    ),
    (
        "std_msgs/msg/Int64",
        "{ data: 2 ** 53 }",
        "std_msgs/msg/Int64.data: 9007199254740992 is not exact as a number; "
        "write it as a BigInt, like 9007199254740992n",
    ),
    ("std_msgs/msg/UInt64", "{ data: -1n }", "std_msgs/msg/UInt64.data: uint64 cannot be -1"),
    (
        "std_msgs/msg/Float32",
        "{ data: 1e300 }",
        "std_msgs/msg/Float32.data: float32 cannot be 1e+3",
    ),
    (
        "std_msgs/msg/Bool",
        "{ data: 1 }",
        'std_msgs/msg/Bool.data: expected true or false for bool, found the number "1"',
    ),
    (
        "std_msgs/msg/String",
        "{ data: 1 }",
        'std_msgs/msg/String.data: expected a text for string, found the number "1"',
    ),
    (
        "std_msgs/msg/Float64MultiArray",
        '{ data: [1, "x"] }',
        "std_msgs/msg/Float64MultiArray.data[1]: expected a number for float64, found the s",
    ),
    (
        "std_msgs/msg/UInt8MultiArray",
        '{ data: "AAEC" }',
        "std_msgs/msg/UInt8MultiArray.data: expected a list for uint8[], found the string",
    ),
    (
        "std_msgs/msg/Int32MultiArray",
        "{ data: new Float64Array([1, 2.5]) }",
        "std_msgs/msg/Int32MultiArray.data[1]: expected a whole number for int32, found the ",
    ),
    (
        "std_msgs/msg/Int32MultiArray",
        "{ data: new DataView(new ArrayBuffer(8)) }",
        "std_msgs/msg/Int32MultiArray.data: expected a list for int32[], found an object of the",
    ),
    (
        "std_msgs/msg/Int8MultiArray",
        "{ data: new Uint8Array([1, 200]) }",
        "std_msgs/msg/Int8MultiArray.data[1]: int8 cannot be 200",
    ),
    (
        "std_msgs/msg/Float64MultiArray",
        "{ layout: { dim: [{}, { sizes: 1 }] } }",
        "std_msgs/msg/Float64MultiArray has no field 'layout.dim[1].sizes'; the fields of "
        "std_msgs/msg/MultiArrayDimension are label, size, stride",
    ),
    (POSE, "{ covariance: [1] }", f"{POSE}.covariance: float64[36] cannot have 1 items"),
    (
        "std_msgs/msg/Header",
        '{ stamp: "now" }',
        "std_msgs/msg/Header.stamp: expected an object for builtin_interfaces/msg/Time, found ",
    ),
    (
        "builtin_interfaces/msg/Time",
        "{ secs: 1 }",
        "builtin_interfaces/msg/Time has no field 'secs'; its fields are sec, nanosec",
    ),
]
RANGES = ("cannot be", "cannot have", "is not exact")


@pytest.fixture
def page(scripted: Page) -> Page:
    scripted.evaluate(TOOLS)
    return scripted


def test_a_wrong_message_is_an_error_and_is_not_sent(page: Page) -> None:
    for number, (type_, message, fault) in enumerate(WRONG):
        kind = "RangeError" if any(word in fault for word in RANGES) else "TypeError"
        found = page.evaluate(
            f"""() => {{
              const topic = ros.topic("/wrong{number}", "{type_}");
              const told = attempt(() => topic.publish({message}));
              return [told, ros.topics().some(({{ name }}) => name === "/wrong{number}")];
            }}"""
        )
        assert found[0].startswith(f"{kind} /wrong{number}: {fault}"), found
        assert found[1] is False, "the publisher was not announced"


@pytest.mark.parametrize(
    ("type_", "message", "arrives"),
    [
        ("std_msgs/msg/Int64", "{ data: 5 }", '{"data":"5n"}'),
        ("std_msgs/msg/UInt64", "{ data: 2n ** 64n - 1n }", '{"data":"18446744073709551615n"}'),
        ("std_msgs/msg/Int32", "{ data: 5n }", '{"data":5}'),
        ("std_msgs/msg/Int32", "{ data: undefined }", '{"data":0}'),
        ("std_msgs/msg/Float64", "{ data: NaN }", '{"data":"NaN"}'),
        ("std_msgs/msg/Empty", "{}", "{}"),
        ("geometry_msgs/msg/Point", "new DOMPoint(1, 2, 3)", '{"x":1,"y":2,"z":3}'),
        (
            "geometry_msgs/msg/Point",
            "new (class { _x = 7; get x() { return this._x; } })()",
            '{"x":7,"y":0,"z":0}',
        ),
        ("geometry_msgs/msg/Point", "Object.create(null)", '{"x":0,"y":0,"z":0}'),
    ],
)
def test_values_that_fit_arrive(page: Page, type_: str, message: str, arrives: str) -> None:
    assert page.evaluate(f"() => heard('{type_}', {message})") == arrives


@pytest.mark.parametrize(
    ("type_", "given", "arrives"),
    [
        ("Int32", "new Float64Array([1, 2])", ["Int32Array", "1", "2"]),
        ("Int32", "[1, 2n]", ["Int32Array", "1", "2"]),
        ("Float32", "new Float64Array([0.5, Infinity])", ["Float32Array", "0.5", "Infinity"]),
        ("Float64", "new Float32Array([0.5])", ["Float64Array", "0.5"]),
        ("Int64", "new Int32Array([-1, 2])", ["BigInt64Array", "-1", "2"]),
        ("UInt64", "new BigInt64Array([3n])", ["BigUint64Array", "3"]),
        (
            "UInt8",
            "new Uint8ClampedArray([0, 1, 255, 4]).subarray(1, 3)",
            ["Uint8Array", "1", "255"],
        ),
        ("Float64", "new Float64Array(20).fill(1.5)", ["Float64Array", *["1.5"] * 20]),
    ],
)
def test_arrays_of_other_classes_are_converted(
    page: Page, type_: str, given: str, arrives: list[str]
) -> None:
    found = page.evaluate(
        f"""async () => JSON.parse(await heard("std_msgs/msg/{type_}MultiArray",
          {{ data: {given} }})).data"""
    )
    assert found == arrives


def test_messages_that_arrived_and_bytes_can_be_sent_again(page: Page) -> None:
    found = page.evaluate(
        """async () => {
          const type = "sensor_msgs/msg/PointCloud2";
          const cloud = ros.topic("/cloud", type);
          const again = ros.topic("/again", type);
          cloud.subscribe((message) => again.publish(message));
          const next = again.next();
          cloud.publish({ fields: [{ name: "x", count: 1 }], data: [1, 2], is_dense: true });
          const { fields, data, is_dense } = await next;
          const bytes = ros.topic("/bytes", "std_msgs/msg/UInt8");
          const one = bytes.next();
          bytes.publish(new Uint8Array([0, 1, 0, 0, 7]));
          return [fields[0].name, [...data], is_dense, (await one).data];
        }"""
    )
    assert found == ["x", [1, 2], True, 7]


def test_what_has_no_definition_is_named(page: Page) -> None:
    found = page.evaluate(
        """async () => [
          attempt(() => ros.topic("/new", "no_msgs/msg/No").publish({})),
          attempt(() => ros.topic("/new", "no_msgs/msg/No").subscribe(() => {})),
          await told(ros.service("/new", "no_msgs/srv/No").call()),
          attempt(() => ros.service("/new", "no_msgs/srv/No").serve(() => {})),
          await told(ros.action("/new", "no_msgs/action/No").send()),
          attempt(() => ros.action("/new", "no_msgs/action/No").serve(() => {})),
        ]"""
    )
    wanted = ["msg", "msg", "srv", "srv", "action", "action"]
    assert found == [
        f"Error /new: this page has no definition of no_msgs/{kind}/No" for kind in wanted
    ]


def test_a_wrong_request_or_goal_is_told_without_a_server(page: Page) -> None:
    found = page.evaluate(
        """async () => {
          const add = ros.service("/add", "example_interfaces/srv/AddTwoInts");
          const fibonacci = ros.action("/fibonacci", "example_interfaces/action/Fibonacci");
          return [await told(add.call({ c: 1n })), await told(add.call("1 + 2")),
            await told(fibonacci.send({ order: "3" }))];
        }"""
    )
    request = "example_interfaces/srv/AddTwoInts_Request"
    assert found == [
        f"TypeError /add: {request} has no field 'c'; its fields are a, b",
        f'TypeError /add: {request}: expected an object for {request}, found the string "1 + 2"',
        "TypeError /fibonacci: example_interfaces/action/Fibonacci_Goal.order: "
        'expected a whole number for int32, found the string "3"',
    ]


def test_a_request_is_checked_with_the_type_of_the_graph(page: Page) -> None:
    found = page.evaluate(
        """async () => {
          const calling = told(ros.service("/later").call({ c: 1n }));
          ros.service("/later", "example_interfaces/srv/AddTwoInts").serve(({ a, b }) =>
            ({ sum: a + b }));
          return [await calling, text(await ros.service("/later").call({ a: 40, b: 2 }))];
        }"""
    )
    request = "example_interfaces/srv/AddTwoInts_Request"
    assert found == [
        f"TypeError /later: {request} has no field 'c'; its fields are a, b",
        '{"sum":"42n"}',
    ]


@pytest.fixture
def loud(browser: Browser, serve: Serve, alone: Path) -> tuple[Page, list[tuple[str, str]]]:
    """The page, and what its console shows."""
    tab = browser.new_page()
    lines: list[tuple[str, str]] = []

    def note(message: ConsoleMessage) -> None:
        lines.append((message.type, message.text))

    tab.on("console", note)
    tab.goto(serve(alone))
    tab.wait_for_selector("body[data-scripted]")
    tab.evaluate(TOOLS)
    return tab, lines


Loud = tuple[Page, list[tuple[str, str]]]


def test_a_wrong_response_is_told_to_its_author(loud: Loud) -> None:
    tab, lines = loud
    found = tab.evaluate(
        """async () => {
          const add = ros.service("/add", "example_interfaces/srv/AddTwoInts");
          add.serve(async ({ a }) => (a ? { total: a } : undefined));
          return [await told(add.call({ a: 1 }, { timeout: 200 })), text(await add.call())];
        }"""
    )
    assert found == ["Error no response from /add within 0.2 s", '{"sum":"0n"}']
    [(kind, line)] = lines
    response = "example_interfaces/srv/AddTwoInts_Response"
    assert kind == "error"
    assert f"TypeError: /add: {response} has no field 'total'; its fields are sum" in line


ACTIONS = """async () => {
  const type = "example_interfaces/action/Fibonacci";
  let ended = 0;
  const ways = {
    async *feedback() { try { yield { numbers: [1] }; } finally { ended++; } },
    async *forgiven() {
      try { yield { sequence: ["a"] }; } catch { yield { sequence: [7] }; }
      return { sequence: [8] };
    },
    async published({ publish }) { publish({ sequence: 5 }); },
    async result() { return { sequence: [2 ** 40] }; },
    async nothing() {},
  };
  const outcomes = [];
  for (const [name, execute] of Object.entries(ways)) {
    const action = ros.action(`/${name}`, type);
    action.serve(execute);
    const goal = await action.send({});
    const steps = [];
    for await (const { sequence } of goal.feedback()) steps.push(...sequence);
    const result = await goal.result().catch((error) => error);
    outcomes.push([goal.state, steps, [...(result.sequence ?? [])]]);
  }
  return { outcomes, ended };
}"""


def test_wrong_feedback_and_results_abort_the_goal(loud: Loud) -> None:
    tab, lines = loud
    found: Any = tab.evaluate(ACTIONS)
    assert found["outcomes"] == [
        ["aborted", [], []],
        ["succeeded", [7], [8]],
        ["aborted", [], []],
        ["aborted", [], []],
        ["succeeded", [], []],
    ]
    assert found["ended"] == 1, "the generator ended as at an error of its own"
    fibonacci = "example_interfaces/action/Fibonacci"
    wanted = [
        f"/feedback: {fibonacci}_Feedback has no field 'numbers'; its fields are sequence",
        f"/published: {fibonacci}_Feedback.sequence: expected a list for int32[], found the number",
        f"/result: {fibonacci}_Result.sequence[0]: int32 cannot be 1099511627776",
    ]
    assert [kind for kind, _ in lines] == ["error"] * 3
    assert all(text in line for text, (_, line) in zip(wanted, lines, strict=True)), lines


def test_another_type_on_a_topic_is_a_warning(loud: Loud) -> None:
    tab, lines = loud
    tab.evaluate(
        """async () => {
          const robot = ros.node("/robot");
          robot.topic("/chatter", "std_msgs/msg/String").advertise();
          const wrong = ros.topic("/chatter", "std_msgs/msg/Int32");
          wrong.publish({ data: 1 });
          wrong.subscribe(() => {})();
          wrong.subscribe(() => {})();
          // One that comes later.
          const early = ros.topic("/late", "std_msgs/msg/Int32").messages();
          const events = ros.events();
          robot.topic("/late", "std_msgs/msg/Bool").advertise();
          for await (const { node, name } of events) {
            if (node === "/robot" && name === "/late") break;
          }
          ros.topic("/fine", "std_msgs/msg/Int32").subscribe(() => {});
          robot.topic("/fine", "std_msgs/msg/Int32").publish({ data: 1 });
          early.return();
        }"""
    )
    both = ("/chatter", "std_msgs/msg/String"), ("/late", "std_msgs/msg/Bool")
    told = [line for kind, line in lines if kind == "warning"]
    wanted = {
        f"{name} has the type {type_}, not std_msgs/msg/Int32, at /robot" for name, type_ in both
    }
    assert {
        line
        for line in told
        if not line.startswith(
            ("/chatter has the type std_msgs/msg/Int32", "/late has the type std_msgs/msg/Int32")
        )
    } == wanted
    assert len(told) == len({*told}), "each is told once"
