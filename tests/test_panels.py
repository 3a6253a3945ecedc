"""Panels in a real browser, in a graph that does what the test says."""

from __future__ import annotations

import json
import re
import shutil
import sys
from pathlib import Path
from typing import Any

import pytest
import yaml
from browser import Serve
from playwright.sync_api import Locator, expect
from playwright.sync_api import Page as Tab

ROOT = Path(__file__).parent.parent
# What stands where there is no rate.
NONE = "\u2013"


@pytest.fixture
def page(tab: Tab, serve: Serve, tmp_path: Path) -> Tab:
    shutil.copytree(ROOT / "sitegen/runtime", tmp_path / "runtime")
    shutil.copytree(ROOT / "themes/default", tmp_path / "theme")
    shutil.copytree(ROOT / "tests/panels", tmp_path, dirs_exist_ok=True)
    tab.goto(serve(tmp_path))
    tab.wait_for_selector("body[data-ready]")
    return tab


def show(page: Tab, kind: str, options: dict[str, Any] | None = None) -> Locator:
    page.evaluate(
        "async ([kind, options]) => { await show(kind, options); await frames(); }",
        [kind, options or {}],
    )
    return page.locator("#panel")


def add(page: Tab, kind: str, node: str, name: str, type: str, **qos: Any) -> None:
    page.evaluate("(endpoint) => ros.graph.add(...endpoint)", [kind, node, name, type, qos])


def chatter(page: Tab) -> None:
    add(page, "publisher", "/talker", "/chatter", "std_msgs/msg/String", program="talker")
    add(page, "subscription", "/listener", "/chatter", "std_msgs/msg/String", program="listener")


def subscribed(page: Tab) -> list[str]:
    found: list[str] = page.evaluate(
        "ros.subscriptions.map(({topic, bytes}) => bytes ? `${topic} bytes` : topic).sort()"
    )
    return found


def hide_tab(page: Tab, hidden: bool) -> None:
    page.evaluate(
        """(state) => {
          Object.defineProperty(document, "visibilityState", { value: state, configurable: true });
          document.dispatchEvent(new Event("visibilitychange"));
        }""",
        "hidden" if hidden else "visible",
    )


def cells(panel: Locator) -> list[str]:
    return [" ".join(row.split()) for row in panel.locator("tbody tr").all_inner_texts()]


# YAML


TEXTS = [
    *["", "plain", "Hello, world! 0", "a: b", "a:b", "it's", "- item", "-", "-5", "#no", "a # b"],
    *["true", "No", "null", "~", "1", "1.5", "1e3", "1.0e+3", "0x1F", "12:30", "2024-01-01"],
    *["=", "<<", "[a]", "{a}", "*a", "&a", "%a", "@a", "`a", "!a", "|", ">", "? a", "?a", ": a"],
    *[" lead", "trail ", "two\nlines", "two\n\nlines\n", "a \nb", "a\n b", "tab\there", "\x07\x1b"],
    *["ünïcode", "😀 emoji", "日本", "\u2028", "\ufeff", "\x85"],
    *["quote\"d", "back\\slash", "---", "...", ".inf"],
]  # fmt: skip
NUMBERS = [
    *[0.0, -0.0, 1.0, -2.5, 0.1, 1e-4, 1e-5, 1.5e-7, 123456789.0, 1e15, 1e16, 1.5e300, 5e-324],
    *[float("inf"), float("-inf"), float("nan"), 0.10000000149011612],
]


def dumped(value: object) -> str:
    """What `ros2 topic echo` prints of a message, which asks PyYAML in the same way."""
    text: str = yaml.dump(
        value, allow_unicode=True, width=sys.maxsize, default_flow_style=False, sort_keys=False
    )
    return text.removesuffix("\n")


def test_yaml_is_that_of_ros2_topic_echo(page: Tab) -> None:
    values = [str(number) for number in NUMBERS]
    found = page.evaluate(
        """async ([texts, numbers]) => {
          const { toYaml } = await import("./runtime/messages/yaml.js");
          const types = {
            "a/msg/Inner": ros.fields("string[] words, float32 x"),
            "a/msg/None": ros.fields(""),
            "a/msg/All": ros.fields(
              "string text, float64 number, bool flag, int64 big, uint8[] bytes, string[] texts, "
              + "a/msg/Inner inner, a/msg/Inner[] inners, a/msg/None none, a/msg/None[] nones"),
          };
          const inner = { words: ["a: b", "c"], x: 0.5 };
          return texts.map((text, index) => toYaml({
            text, number: Number(numbers[index % numbers.length].replace("inf", "Infinity")),
            flag: index % 2 > 0, big: 9223372036854775807n,
            bytes: Uint8Array.from({ length: index % 3 }), texts: index % 2 ? [text, text] : [],
            inner, inners: index % 2 ? [inner, { words: [], x: -1 }] : [], none: {}, nones: [{}],
          }, "a/msg/All", types));
        }""",
        [TEXTS, values],
    )
    inner = {"words": ["a: b", "c"], "x": 0.5}
    for index, text in enumerate(TEXTS):
        expected = {
            "text": text,
            "number": NUMBERS[index % len(NUMBERS)],
            "flag": index % 2 > 0,
            "big": 2**63 - 1,
            "bytes": [0] * (index % 3),
            "texts": [text, text] if index % 2 else [],
            "inner": dict(inner, words=["a: b", "c"]),
            "inners": [dict(inner, words=["a: b", "c"]), {"words": [], "x": -1.0}]
            if index % 2
            else [],
            "none": {},
            "nones": [{}],
        }
        assert found[index] == dumped(expected), text


def test_long_arrays_and_texts_are_cut(page: Tab) -> None:
    found = page.evaluate(
        """async () => {
          const { toYaml } = await import("./runtime/messages/yaml.js");
          const types = { "a/msg/Long": ros.fields("uint8[] data, string text") };
          const message = { data: Uint8Array.from([1, 2, 3, 4]), text: "abcdef" };
          return [toYaml(message, "a/msg/Long", types, 3), toYaml({}, "a/msg/Empty",
            { "a/msg/Empty": ros.fields("") })];
        }"""
    )
    assert found == ["data:\n- 1\n- 2\n- 3\n- '...'\ntext: abc...", "{}"]


# Forms


def read_form(page: Tab, fields: str, constants: str = "[]", act: str = "") -> Any:
    """Build a form, do something to it, and return what it reads, with types that JSON lacks."""
    return page.evaluate(
        """async ([fields, constants, act]) => {
          const { createForm } = await import("./runtime/messages/form.js");
          const types = {
            "a/msg/A": ros.fields(fields, constants),
            "a/msg/Point": ros.fields("float64 x 1.5, float64 y"),
            "a/msg/Deep": ros.fields("a/msg/Point[] points"),
          };
          const form = createForm("a/msg/A", types);
          const panel = document.getElementById("panel");
          panel.replaceChildren(form.element);
          const input = (name) => document.getElementById([...panel.querySelectorAll("label")]
            .find((label) => label.firstChild.data === name).htmlFor);
          const press = (name) => [...panel.querySelectorAll("button")]
            .find(({ textContent }) => textContent === name).click();
          new Function("input", "press", "panel", act)(input, press, panel);
          const message = form.read();
          const faults = [...panel.querySelectorAll(".ros-fault")].map((p) => p.textContent);
          const plain = (_, one) => {
            if (typeof one === "bigint") return `${one}n`;
            if (!ArrayBuffer.isView(one)) return one;
            return { [one.constructor.name]: Array.from(one, String) };
          };
          const { id } = document.activeElement;
          return {
            message: JSON.parse(JSON.stringify(message, plain)),
            faults: faults.filter(Boolean),
            focus: id ? panel.querySelector(`[for=${id}]`)?.firstChild.data : null,
          };
        }""",
        [fields, json.loads(constants), act],
    )


def test_a_form_makes_a_message_with_the_types_of_its_fields(page: Tab) -> None:
    found = read_form(
        page,
        'bool flag true, int32 n -7, uint64 big, float32 x 0.5, string s "hi", wstring w, '
        "int16[3] three, float64[] list, string[] texts, bool[] flags, int64[<=2] two, "
        "a/msg/Point p, a/msg/Deep deep, a/msg/Point[2] pair",
        act="""
          input("big").value = "18446744073709551615";
          input("list").value = "[1, .5, -inf, 1e3]";
          input("texts").value = `one, "two, three", 'it''s', "line\\\\nbreak"`;
          input("flags").value = "true, false";
          input("two").value = "-1, 0x10";
          press("Add to points"); press("Add to points");
        """,
    )
    assert found["faults"] == []
    point = {"x": 1.5, "y": 0}
    assert found["message"] == {
        "flag": True, "n": -7, "big": "18446744073709551615n", "x": 0.5, "s": "hi", "w": "",
        "three": {"Int16Array": ["0", "0", "0"]},
        "list": {"Float64Array": ["1", "0.5", "-Infinity", "1000"]},
        "texts": ["one", "two, three", "it's", "line\nbreak"], "flags": [True, False],
        "two": {"BigInt64Array": ["-1", "16"]}, "p": point, "deep": {"points": [point, point]},
        "pair": [point, point],
    }  # fmt: skip


@pytest.mark.parametrize(
    ("field", "text", "fault"),
    [
        ("int8 v", "128", "int8 holds -128 to 127"),
        ("uint8 v", "-1", "uint8 holds 0 to 255"),
        ("int64 v", "9223372036854775808",
         "int64 holds -9223372036854775808 to 9223372036854775807"),
        ("int32 v", "1.5", "'1.5' is no whole number"),
        ("int32 v", "", "a whole number is needed"),
        ("float64 v", "1,5", "'1,5' is no number; write 1.5"),
        ("float64 v", "fast", "'fast' is no number"),
        ("float32 v", "1e39", "'1e39' is too large for float32"),
        ("string<=3 v", "äöü", "holds at most 3 bytes, here are 6"),
        ("int16[3] v", "[1, 2]", "needs 3 items, here are 2"),
        ("int16[<=2] v", "1, 2, 3", "holds at most 2 items, here are 3"),
        ("uint8[] v", "1, 300", "item 2: uint8 holds 0 to 255"),
        ("bool[] v", "true, maybe", "item 2: 'maybe' is neither true nor false"),
        ("string[] v", '"open',
         "a comma must stand between two items, and a quote must have its end"),
    ],
)  # fmt: skip
def test_a_form_says_what_is_wrong_and_where(page: Tab, field: str, text: str, fault: str) -> None:
    found = read_form(page, f"int8 before, {field}", act=f"input('v').value = {json.dumps(text)}")
    assert found == {"message": None, "faults": [fault], "focus": "v"}
    assert page.locator("[aria-invalid]").count() == 1


def test_constants_are_offered_as_values(page: Tab) -> None:
    constants = """[{"name": "STATUS_OK", "type": "byte", "value": 0},
      {"name": "STATUS_BAD", "type": "byte", "value": 2},
      {"name": "MAX", "type": "byte", "value": 9},
      {"name": "PI", "type": "float64", "value": 3.1}]"""
    fields = "uint8 status 2, uint8 other 7, int8 plain"
    found = read_form(page, fields, constants, "input('other')")
    assert found["message"] == {"status": 2, "other": 7, "plain": 0}
    selects = page.locator("#panel select")
    assert selects.nth(0).locator("option").all_inner_texts() == [
        "STATUS_OK (0)", "STATUS_BAD (2)", "another value…"
    ]  # fmt: skip
    expect(page.get_by_label("status, another value")).to_be_hidden()
    assert selects.nth(1).locator("option").count() == 4
    expect(page.get_by_label("other, another value")).to_have_value("7")
    assert selects.count() == 2


def test_items_are_added_and_removed_with_the_keyboard(page: Tab) -> None:
    found = read_form(page, "a/msg/Point[<=2] ps", act="press('Add to ps'); press('Add to ps')")
    assert len(found["message"]["ps"]) == 2
    expect(page.get_by_role("button", name="Add to ps")).to_be_disabled()
    assert page.locator("legend").all_inner_texts() == ["ps[0]", "ps[1]"]
    page.get_by_role("button", name="Remove").first.press("Enter")
    assert page.locator("legend").all_inner_texts() == ["ps[0]"]
    expect(page.get_by_role("button", name="Add to ps")).to_be_focused()


# Topics


def test_topics_come_and_go_with_their_types_and_numbers(page: Tab) -> None:
    panel = show(page, "topics")
    expect(panel.get_by_text("No topics now")).to_be_visible()
    chatter(page)
    add(page, "publisher", "/talker", "/rosout", "rcl_interfaces/msg/Log")
    add(page, "publisher", "/talker", "/_hidden", "std_msgs/msg/String")
    add(page, "subscription", "/_page", "/chatter", "std_msgs/msg/String")
    add(page, "subscription", "/_page", "/only_asked_for", "std_msgs/msg/String")
    assert cells(panel) == [f"/chatter std_msgs/msg/String 1 1 {NONE}"]
    row = panel.locator("tbody tr")
    assert row.locator("td").nth(1).get_attribute("title") == "/listener"
    panel.get_by_label("Show hidden").check()
    assert [cell.split()[0] for cell in cells(panel)] == ["/_hidden", "/chatter", "/rosout"]
    page.evaluate("ros.graph.remove('/talker')")
    assert cells(panel) == [f"/chatter std_msgs/msg/String 0 1 {NONE}"]
    page.evaluate("ros.graph.remove('/listener')")
    assert cells(panel) == []


def test_rate_and_bandwidth_are_measured(page: Tab) -> None:
    chatter(page)
    panel = show(page, "topics", {"show": ["/chatter", "/later"]})
    assert [cell.split()[0] for cell in cells(panel)] == ["/chatter", "/later"]
    assert subscribed(page) == ["/chatter bytes"]
    page.evaluate(
        """() => {
          let time = performance.timeOrigin + performance.now() - 4000;
          window.publisher = setInterval(() => {
            const now = performance.timeOrigin + performance.now();
            for (; time <= now; time += 20) ros.emit("/chatter", {}, 1500, time);
          }, 10);
        }"""
    )
    expect(panel.locator("tbody td span").first).to_have_text("50.0 Hz")
    expect(panel.locator("tbody td small").first).to_have_text("75.0 kB/s")
    page.evaluate("clearInterval(publisher)")
    # A publisher that is silent slows down, and soon has no rate at all.
    expect(panel.locator("tbody td span").first).to_have_text(NONE, timeout=9000)


def test_a_topic_is_echoed_paused_and_bounded(page: Tab) -> None:
    chatter(page)
    panel = show(page, "topics", {"echo": "/chatter"})
    log = panel.get_by_role("log")
    expect(panel.get_by_text("No message yet")).to_be_visible()
    expect(panel.get_by_text("/talker → /listener")).to_be_visible()
    page.evaluate("for (let i = 0; i < 200; i++) ros.emit('/chatter', { data: `${i}` })")
    page.evaluate("frames()")
    texts = log.locator("> *").all_inner_texts()
    assert texts == [f"data: '{number}'\n---" for number in range(150, 200)]
    assert log.evaluate("(e) => e.scrollHeight - e.scrollTop - e.clientHeight") < 2

    panel.get_by_role("button", name="Pause").click()
    assert subscribed(page) == ["/chatter bytes"]
    panel.get_by_role("button", name="Clear").click()
    expect(panel.get_by_text("Paused")).to_be_visible()
    panel.get_by_role("button", name="Resume").click()
    page.evaluate("ros.emit('/chatter', { data: '<img src=x>' })")
    expect(log).to_have_text("data: <img src=x>\n---")

    panel.get_by_role("button", name="/chatter").click()
    expect(panel.get_by_text("Choose a topic")).to_be_visible()
    assert subscribed(page) == ["/chatter bytes"]


def test_an_echo_asks_for_what_the_publishers_offer(page: Tab) -> None:
    add(page, "publisher", "/map", "/map", "std_msgs/msg/String", transientLocal=True)
    show(page, "topics", {"echo": "/map"})
    qos = (
        "(() => { const { qos } = ros.subscriptions.find(({ bytes }) => !bytes);"
        " return [qos.reliable, qos.transientLocal]; })()"
    )
    assert page.evaluate(qos) == [True, True]
    add(page, "publisher", "/other", "/map", "std_msgs/msg/String", reliable=False)
    assert page.evaluate(qos) == [False, False]


def test_a_type_without_definition_is_measured_and_named(page: Tab) -> None:
    add(page, "publisher", "/arm", "/grip", "arm_msgs/msg/Grip")
    panel = show(page, "topics", {"echo": "/grip"})
    expect(panel.get_by_text("This page has no definition of arm_msgs/msg/Grip")).to_be_visible()
    assert subscribed(page) == ["/grip bytes"]


@pytest.mark.parametrize("kind", ["topics", "log"])
def test_nothing_is_subscribed_while_nobody_looks(page: Tab, kind: str) -> None:
    chatter(page)
    show(page, kind, {"echo": "/chatter"})
    all_of_it = subscribed(page)
    assert all_of_it
    hide_tab(page, True)
    assert subscribed(page) == []
    hide_tab(page, False)
    assert subscribed(page) == all_of_it
    # Scrolled away, and in a closed <details>.
    into_details = (
        "{ const row = document.querySelector('.ros-row');"
        " const details = document.createElement('details');"
        " row.replaceWith(details); details.append(row); }"
    )
    for gone, back in [
        ("main.style.marginTop = '9000px'", "main.style.marginTop = ''"),
        (into_details, "document.querySelector('details').open = true"),
    ]:
        page.evaluate(gone)
        page.wait_for_function("ros.subscriptions.length === 0")
        page.evaluate(back)
        page.wait_for_function("(count) => ros.subscriptions.length === count", arg=len(all_of_it))
    page.evaluate("unmount()")
    assert subscribed(page) == []
    assert page.locator("#panel > *").count() == 0


# Services


def serve_sums(page: Tab) -> None:
    add(page, "service", "/adder", "/add", "tutorial_interfaces/srv/AddTwoInts")
    page.evaluate("void (ros.answer = async ({ a, b }) => ({ sum: a + b }))")


def test_a_service_is_called_with_a_form(page: Tab) -> None:
    serve_sums(page)
    add(page, "service", "/adder", "/adder/get_parameters", "rcl_interfaces/srv/GetParameters")
    panel = show(page, "services")
    assert panel.locator("li").all_inner_texts() == [
        "/add\ntutorial_interfaces/srv/AddTwoInts\nserved by /adder"
    ]
    panel.get_by_label("Show hidden").check()
    assert panel.locator("li").count() == 2
    panel.get_by_role("button", name="/add").first.click()
    panel.get_by_label("a int64").fill("9007199254740993")
    panel.get_by_label("b int64").fill("one")
    panel.get_by_role("button", name="Call").click()
    expect(panel.get_by_text("'one' is no whole number")).to_be_visible()
    expect(panel.get_by_label("b int64")).to_be_focused()
    assert page.evaluate("ros.calls.length") == 0
    panel.get_by_label("b int64").fill("1")
    panel.get_by_label("b int64").press("Enter")
    expect(panel.get_by_label("answer")).to_have_text("sum: 9007199254740994")
    expect(panel.get_by_role("status")).to_contain_text("/add answered in")
    assert page.evaluate("ros.calls[0].timeout") == 5000


def test_a_call_without_an_answer_is_said_plainly(page: Tab) -> None:
    panel = show(page, "services", {"show": ["/add"]})
    expect(
        panel.get_by_text("No server on /add now. Start the node that serves it.")
    ).to_be_visible()
    serve_sums(page)
    panel.get_by_label("a int64").fill("5")
    page.evaluate(
        "void (ros.answer = async () => { throw new Error('no answer from /add within 5 s'); })"
    )
    panel.get_by_role("button", name="Call").click()
    expect(panel.get_by_role("status")).to_have_text("no answer from /add within 5 s")
    # The server goes: the form stays as it is, and the call tells what the page's ROS says.
    page.evaluate("ros.graph.remove('/adder')")
    page.evaluate("void (ros.answer = async () => { throw new Error('no server on /add now'); })")
    expect(panel.get_by_text("no server now")).to_be_visible()
    expect(panel.get_by_label("a int64")).to_have_value("5")
    panel.get_by_role("button", name="Call").click()
    expect(panel.get_by_role("status")).to_have_text("no server on /add now")


def test_a_service_of_an_unknown_type_is_named(page: Tab) -> None:
    add(page, "service", "/arm", "/grip", "arm_msgs/srv/Grip")
    panel = show(page, "services")
    panel.get_by_role("button", name="/grip").click()
    expect(panel.get_by_role("status")).to_contain_text(
        "this page has no definition of arm_msgs/srv/Grip_Request"
    )
    expect(panel.get_by_role("button", name="Call")).to_be_disabled()


def test_a_request_may_have_no_fields(page: Tab) -> None:
    add(page, "service", "/adder", "/reset", "std_srvs/srv/Empty")
    panel = show(page, "services", {"show": ["/reset"]})
    panel.get_by_role("button", name="Call").click()
    expect(panel.get_by_label("answer")).to_have_text("{}")


# Publish


def test_a_message_is_published_once_and_repeated(page: Tab) -> None:
    panel = show(page, "publish", {"topic": "/cmd_vel"})
    expect(panel.get_by_text("Nobody uses /cmd_vel now")).to_be_visible()
    add(page, "subscription", "/robot", "/cmd_vel", "geometry_msgs/msg/Twist")
    panel.get_by_label("x float64").first.fill("0.25")
    panel.get_by_role("button", name="Publish once").click()
    expect(panel.get_by_role("status")).to_have_text("1 message published")
    zero = {"x": 0, "y": 0, "z": 0}
    assert page.evaluate("ros.published") == [
        {"topic": "/cmd_vel", "type": "geometry_msgs/msg/Twist",
         "message": {"linear": {**zero, "x": 0.25}, "angular": zero}}
    ]  # fmt: skip
    rate = panel.get_by_label("messages a second (Hz)")
    rate.fill("1000")
    panel.get_by_role("button", name="Repeat").click()
    expect(panel.get_by_role("status")).to_have_text("The rate is a number from 0.1 to 100 Hz")
    rate.fill("50")
    panel.get_by_role("button", name="Repeat").click()
    page.wait_for_function("ros.published.length > 10")
    # What is typed meanwhile goes out with the next message; what is no message stops it.
    panel.get_by_label("x float64").first.fill("2")
    page.wait_for_function("ros.published.at(-1).message.linear.x === 2")
    panel.get_by_role("button", name="Stop").click()
    count = page.evaluate("ros.published.length")
    page.wait_for_timeout(100)
    assert page.evaluate("ros.published.length") == count
    panel.get_by_role("button", name="Repeat").click()
    panel.get_by_label("x float64").first.fill("fast")
    expect(panel.get_by_text("'fast' is no number")).to_be_visible()
    expect(panel.get_by_role("button", name="Repeat")).to_be_visible()
    page.evaluate("unmount()")
    assert page.evaluate("ros.closed") == 1


def test_the_visitor_chooses_a_topic(page: Tab) -> None:
    panel = show(page, "publish")
    expect(panel.get_by_text("No topic to publish on")).to_be_visible()
    chatter(page)
    add(page, "subscription", "/arm", "/grip", "arm_msgs/msg/Grip")
    add(page, "subscription", "/robot", "/cmd_vel", "geometry_msgs/msg/Twist")
    choice = panel.get_by_label("topic", exact=True)
    assert choice.locator("option").all_inner_texts() == ["/chatter", "/cmd_vel"]
    panel.get_by_label("data string").fill("hi")
    panel.get_by_role("button", name="Publish once").click()
    choice.select_option("/cmd_vel")
    expect(panel.get_by_label("x float64")).to_have_count(2)
    assert page.evaluate("[ros.published.length, ros.closed]") == [1, 1]


def test_a_type_makes_a_form_before_anybody_uses_the_topic(page: Tab) -> None:
    options = {"topic": "/chatter", "type": "std_msgs/msg/String"}
    panel = show(page, "publish", options)
    panel.get_by_label("data string").fill("first")
    panel.get_by_label("data string").press("Enter")
    assert page.evaluate("ros.published[0].message") == {"data": "first"}


# Nodes


def test_nodes_tell_what_runs_and_what_it_does(page: Tab) -> None:
    page.evaluate("ros.addNode('talker', 'cpp_pubsub', 'talker')")
    panel = show(page, "nodes")
    item = panel.get_by_role("listitem")
    assert item.inner_text().split() == ["talker", "stopped", "cpp_pubsub/talker"]
    page.evaluate("ros.nodes.get('talker').become('running', 2_500_000)")
    add(page, "node", "/talker", "", "", program="talker")
    add(page, "publisher", "/talker", "/chatter", "std_msgs/msg/String", program="talker")
    add(page, "publisher", "/talker", "/rosout", "rcl_interfaces/msg/Log", program="talker")
    add(page, "service", "/talker", "/reset", "std_srvs/srv/Empty", program="talker")
    add(page, "client", "/talker", "/add", "tutorial_interfaces/srv/AddTwoInts", program="talker")
    add(page, "subscription", "/listener", "/chatter", "std_msgs/msg/String", program="other")
    expect(item.locator(".ros-state")).to_have_text("running")
    expect(item).to_contain_text("2.5 MB of memory")
    assert item.locator("dl").inner_text().split() == [
        "publishes", "/chatter", "serves", "/reset", "calls", "/add"
    ]  # fmt: skip
    panel.get_by_label("Show hidden").check()
    expect(item.locator("dl")).to_contain_text("/rosout")
    expect(item).to_contain_text("for 1 s")
    page.evaluate("ros.graph.remove('/talker'); ros.nodes.get('talker').become('failed')")
    expect(item.locator("dl")).to_have_count(0)
    expect(item.locator(".ros-state")).to_have_text("failed")


# Log


def log(page: Tab, *entries: tuple[int, str, str, float]) -> None:
    page.evaluate(
        """async (entries) => {
          for (const [level, name, msg, at] of entries) {
            const stamp = { sec: Math.floor(at), nanosec: Math.round((at % 1) * 1e9) };
            ros.emit("/rosout", { stamp, level, name, msg, file: "", function: "", line: 1 });
          }
          await frames();
        }""",
        [list(entry) for entry in entries],
    )


def logged(panel: Locator) -> list[str]:
    panel.page.evaluate("frames()")
    return [
        row.split(" ", 1)[1] for row in panel.get_by_role("log").locator("> *").all_inner_texts()
    ]


def test_the_log_is_filtered(page: Tab) -> None:
    panel = show(page, "log")
    expect(panel.get_by_text("Nothing logged yet")).to_be_visible()
    log(page, (20, "talker", "Hello", 1.0), (10, "talker", "detail", 2.0),
        (40, "arm", "<b>Broken</b>", 4.0), (30, "arm", "warm", 3.0))  # fmt: skip
    assert logged(panel) == ["INFO talker: Hello", "WARN arm: warm", "ERROR arm: <b>Broken</b>"]
    panel.get_by_label("severity").select_option("debug")
    assert len(logged(panel)) == 4
    panel.get_by_label("node", exact=True).select_option("arm")
    assert logged(panel) == ["WARN arm: warm", "ERROR arm: <b>Broken</b>"]
    panel.get_by_label("text").fill("broken")
    assert logged(panel) == ["ERROR arm: <b>Broken</b>"]
    panel.get_by_label("text").fill("nowhere")
    expect(panel.get_by_text("Nothing matches the filters")).to_be_visible()


def test_what_nodes_keep_is_shown_once(page: Tab) -> None:
    panel = show(page, "log", {"lines": 3})
    kept = [(20, "talker", f"line {number}", float(number)) for number in range(5)]
    log(page, *kept)
    assert logged(panel) == [f"INFO talker: line {number}" for number in (2, 3, 4)]
    hide_tab(page, True)
    hide_tab(page, False)
    log(page, *kept, (20, "talker", "new", 9.0))
    assert logged(panel) == ["INFO talker: line 3", "INFO talker: line 4", "INFO talker: new"]
    panel.get_by_role("button", name="Clear").click()
    log(page, *kept)
    assert logged(panel) == []


# Graph


def drawn(panel: Locator) -> list[str]:
    return panel.locator("svg text").all_text_contents()


def test_the_graph_is_drawn_and_follows(page: Tab) -> None:
    panel = show(page, "graph")
    expect(panel.get_by_text("No nodes now")).to_be_visible()
    add(page, "node", "/talker", "", "")
    chatter(page)
    add(page, "publisher", "/talker", "/rosout", "rcl_interfaces/msg/Log")
    add(page, "subscription", "/_page", "/chatter", "std_msgs/msg/String")
    add(page, "node", "/alone", "", "")
    picture = panel.get_by_role("img")
    expect(picture).to_have_attribute(
        "aria-label",
        "/talker publishes /chatter; /listener subscribes to /chatter; /alone stands alone",
    )
    assert sorted(drawn(panel)) == ["/alone", "/chatter", "/listener", "/talker"]
    # From left to right, as messages go, and each name inside its box.
    boxes = panel.locator("svg g > g").evaluate_all(
        """(groups) => Object.fromEntries(groups.map((group) => {
          const [box, text] = [...group.children].map((one) => one.getBoundingClientRect());
          return [group.textContent, [box.x, box.x + box.width, box.width - text.width]];
        }))"""
    )
    assert boxes["/talker"][1] < boxes["/chatter"][0]
    assert boxes["/chatter"][1] < boxes["/listener"][0]
    assert min(free for _, _, free in boxes.values()) > 8
    assert panel.locator(".ros-arrow").count() == 2
    panel.get_by_label("Show hidden").check()
    assert {"/rosout", "/_page"} < set(drawn(panel))
    page.evaluate("ros.graph.remove('/talker')")
    assert "/talker" not in drawn(panel)


def test_the_graph_is_moved_and_zoomed(page: Tab) -> None:
    chatter(page)
    panel = show(page, "graph")
    picture = panel.get_by_role("img")

    def view() -> list[float]:
        text = panel.locator("svg > g").get_attribute("transform") or ""
        return [float(number) for number in re.findall(r"-?[\d.]+(?:e-?\d+)?", text)]

    x, y, scale = view()
    assert scale == 1
    picture.focus()
    page.keyboard.press("+")
    assert view()[2] == pytest.approx(1.3)
    page.keyboard.press("-")
    page.keyboard.press("ArrowRight")
    assert view() == pytest.approx([x - 48, y, 1])
    page.keyboard.press("0")
    assert view() == pytest.approx([x, y, 1])
    panel.get_by_role("button", name="Zoom in").click()
    panel.get_by_role("button", name="Fit").click()
    assert view() == pytest.approx([x, y, 1])

    # The wheel scrolls the page until the drawing is chosen; then the point under it stays.
    picture.hover(position={"x": 100, "y": 50})
    page.mouse.wheel(0, -100)
    assert view()[2] == 1
    picture.focus()
    page.mouse.wheel(0, -100)
    page.wait_for_function(
        "document.querySelector('svg > g').getAttribute('transform').length > 30"
    )
    zoomed = view()
    assert zoomed[2] > 1
    assert (100 - zoomed[0]) / zoomed[2] == pytest.approx(100 - x, abs=1)

    page.keyboard.press("0")
    box = picture.bounding_box()
    assert box
    page.mouse.move(box["x"] + 20, box["y"] + 20)
    page.mouse.down()
    page.mouse.move(box["x"] + 60, box["y"] + 30)
    page.mouse.up()
    page.mouse.move(box["x"] + 90, box["y"] + 90)
    assert view() == pytest.approx([x + 40, y + 10, 1])


def test_two_fingers_zoom_the_graph(page: Tab) -> None:
    chatter(page)
    panel = show(page, "graph")
    page.evaluate(
        """() => {
          const svg = document.querySelector("#panel svg");
          svg.setPointerCapture = () => {};
          const { left, top } = svg.getBoundingClientRect();
          const send = (kind, pointerId, x) => svg.dispatchEvent(new PointerEvent(kind, {
            pointerId, clientX: left + x, clientY: top + 50, bubbles: true }));
          send("pointerdown", 1, 100);
          send("pointerdown", 2, 200);
          send("pointermove", 2, 300);
          send("pointerup", 1, 100);
          send("pointerup", 2, 300);
        }"""
    )
    expect(panel.locator("svg > g")).to_have_attribute("transform", re.compile(r"scale\(2\)"))


# All


@pytest.mark.parametrize("kind", ["topics", "nodes", "services", "publish", "graph", "log"])
def test_panels_fit_a_phone(page: Tab, kind: str) -> None:
    page.set_viewport_size({"width": 360, "height": 700})
    chatter(page)
    serve_sums(page)
    add(
        page,
        "publisher",
        "/a",
        "/a/very/long/name/of_a_topic/that_has_no_end",
        "a/msg/LongNameOfType",
    )
    page.evaluate(
        "ros.addNode('talker', 'a_package_with_a_long_name', 'an_executable_with_one_too')"
    )
    panel = show(page, kind, {"show": ["/add"]} if kind == "services" else {})
    assert page.evaluate("document.documentElement.scrollWidth") == 360
    sizes = panel.locator("button:visible, select:visible, input:not([type=checkbox]):visible")
    heights = sizes.evaluate_all("(all) => all.map((each) => each.offsetHeight)")
    assert all(height >= 36 for height in heights)
    height = panel.evaluate("(e) => e.offsetHeight")
    page.evaluate("ros.graph.remove('/talker')")
    assert panel.evaluate("(e) => e.offsetHeight") == height
