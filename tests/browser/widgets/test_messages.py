"""Messages as text and as forms, in a real browser."""

from __future__ import annotations

import json
import sys
from collections.abc import Iterator
from typing import Any

import pytest
import yaml
from browser import opened, serving
from playwright.sync_api import Browser, expect
from playwright.sync_api import Page as Tab
from stage import set_up

# What stands where there is no rate.
NONE = "\u2013"


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


@pytest.fixture(scope="module")
def stage(browser: Browser, tmp_path_factory: pytest.TempPathFactory) -> Iterator[Tab]:
    """One for all of these: they leave nothing behind."""
    folder = tmp_path_factory.mktemp("stage")
    set_up(folder)
    with serving(folder) as url, opened(browser) as tab:
        tab.goto(url)
        tab.wait_for_selector("body[data-ready]")
        yield tab


def test_yaml_is_that_of_ros2_topic_echo(stage: Tab) -> None:
    values = [str(number) for number in NUMBERS]
    found = stage.evaluate(
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


def test_long_arrays_and_texts_are_cut(stage: Tab) -> None:
    found = stage.evaluate(
        """async () => {
          const { toYaml } = await import("./runtime/messages/yaml.js");
          const types = { "a/msg/Long": ros.fields("uint8[] data, string text") };
          const message = { data: Uint8Array.from([1, 2, 3, 4]), text: "abcdef" };
          return [toYaml(message, "a/msg/Long", types, 3), toYaml({}, "a/msg/Empty",
            { "a/msg/Empty": ros.fields("") })];
        }"""
    )
    assert found == ["data:\n- 1\n- 2\n- 3\n- '...'\ntext: abc...", "{}"]


def read_form(stage: Tab, fields: str, constants: str = "[]", act: str = "") -> Any:
    """Build a form, do something to it, and return what it reads, with types that JSON lacks."""
    return stage.evaluate(
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


def test_a_form_makes_a_message_with_the_types_of_its_fields(stage: Tab) -> None:
    found = read_form(
        stage,
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
        ("int32 v", "1.5", "'1.5' is not a whole number"),
        ("int32 v", "", "enter a whole number"),
        ("float64 v", "1,5", "'1,5' is not a number; write 1.5"),
        ("float64 v", "fast", "'fast' is not a number"),
        ("float32 v", "1e39", "'1e39' is too large for float32"),
        ("string<=3 v", "äöü", "holds at most 3 bytes, not 6"),
        ("int16[3] v", "[1, 2]", "needs 3 items, not 2"),
        ("int16[<=2] v", "1, 2, 3", "holds at most 2 items, not 3"),
        ("uint8[] v", "1, 300", "item 2: uint8 holds 0 to 255"),
        ("bool[] v", "true, maybe", "item 2: 'maybe' is neither true nor false"),
        ("string[] v", '"open',
         "separate items with commas and close every quote"),
    ],
)  # fmt: skip
def test_a_form_says_what_is_wrong_and_where(stage: Tab, field: str, text: str, fault: str) -> None:
    found = read_form(stage, f"int8 before, {field}", act=f"input('v').value = {json.dumps(text)}")
    assert found == {"message": None, "faults": [fault], "focus": "v"}
    assert stage.locator("[aria-invalid]").count() == 1


def test_constants_are_offered_as_values(stage: Tab) -> None:
    constants = """[{"name": "STATUS_OK", "type": "byte", "value": 0},
      {"name": "STATUS_BAD", "type": "byte", "value": 2},
      {"name": "MAX", "type": "byte", "value": 9},
      {"name": "PI", "type": "float64", "value": 3.1}]"""
    fields = "uint8 status 2, uint8 other 7, int8 plain"
    found = read_form(stage, fields, constants, "input('other')")
    assert found["message"] == {"status": 2, "other": 7, "plain": 0}
    selects = stage.locator("#panel select")
    assert selects.nth(0).locator("option").all_inner_texts() == [
        "STATUS_OK (0)", "STATUS_BAD (2)", "another value…"
    ]  # fmt: skip
    expect(stage.get_by_label("status, another value")).to_be_hidden()
    assert selects.nth(1).locator("option").count() == 4
    expect(stage.get_by_label("other, another value")).to_have_value("7")
    assert selects.count() == 2


def test_64_bit_integers_of_definitions_stay_exact(stage: Tab) -> None:
    constants = """[{"name": "SERIAL_ALL", "type": "uint64", "value": "18446744073709551615"},
      {"name": "SERIAL_ONE", "type": "uint64", "value": "9007199254740993"}]"""
    fields = (
        'uint64 serial "9007199254740993", int64 offset "-9007199254740993", '
        'uint64[] keys ["9007199254740993","1"]'
    )
    found = read_form(stage, fields, constants)
    assert found["message"] == {
        "serial": "9007199254740993n", "offset": "-9007199254740993n",
        "keys": {"BigUint64Array": ["9007199254740993", "1"]},
    }  # fmt: skip
    expect(stage.get_by_label("keys")).to_have_value("[9007199254740993, 1]")
    assert stage.locator("#panel option").all_inner_texts()[:2] == [
        "SERIAL_ALL (18446744073709551615)", "SERIAL_ONE (9007199254740993)"
    ]  # fmt: skip


def test_items_are_added_and_removed_with_the_keyboard(stage: Tab) -> None:
    found = read_form(stage, "a/msg/Point[<=2] ps", act="press('Add to ps'); press('Add to ps')")
    assert len(found["message"]["ps"]) == 2
    expect(stage.get_by_role("button", name="Add to ps")).to_be_disabled()
    assert stage.locator("legend").all_inner_texts() == ["ps[0]", "ps[1]"]
    stage.get_by_role("button", name="Remove").first.press("Enter")
    assert stage.locator("legend").all_inner_texts() == ["ps[0]"]
    expect(stage.get_by_role("button", name="Add to ps")).to_be_focused()


READ = """async (texts) => {
  const { fromYaml } = await import("./runtime/messages/yamlReader.js");
  const types = {
    "a/msg/A": ros.fields("string s, bool b, int32 i, float64 f, string<=3 short, uint8[] bytes, "
      + "int16[2] two, string[<=1] one, a/msg/In in, a/msg/In[] ins, a/msg/None none"),
    "a/msg/In": ros.fields("int64 big"),
    "a/msg/None": ros.fields(""),
  };
  const plain = (_, one) => typeof one === "bigint" ? `${one}n`
    : ArrayBuffer.isView(one) ? { [one.constructor.name]: Array.from(one, String) } : one;
  return texts.map((text) => {
    try {
      return JSON.parse(JSON.stringify(fromYaml(text, "a/msg/A", types), plain));
    } catch (error) {
      return error.message;
    }
  });
}"""


@pytest.mark.parametrize(
    ("text", "expected"),
    [
        ("s: 007", {"s": "007"}),
        ("s: true\nb: true", {"s": "true", "b": True}),
        ("s: ~", {"s": "~"}),
        ("s:", {"s": ""}),
        ('s: "a\\u0020b\\n"', {"s": "a b\n"}),
        ("s: |\n  a\n  b\n", {"s": "a\nb\n"}),
        ("f: .inf\ni: -3", {"f": None, "i": -3}),  # JSON has no infinity
        ("bytes:\n  - 1\n  - 255", {"bytes": {"Uint8Array": ["1", "255"]}}),
        ("bytes:\n  []", {"bytes": {"Uint8Array": []}}),
        ("bytes: ~", {"bytes": {"Uint8Array": []}}),
        ("in:\n  big: 9223372036854775807", {"in": {"big": "9223372036854775807n"}}),
        ("{ins: [{big: 1}, {}]}", {"ins": [{"big": "1n"}, {}]}),
        ("none:\n  structure_needs_at_least_one_member: 0", {"none": {}}),
        ("{}", {}),
        ("", "expected a document, but the input is empty"),
        ("Hello", "expected the fields of a/msg/A, not 'Hello'"),
        ("- s", "expected the fields of a/msg/A, not a list"),
        ("s: a\nS: b", "a/msg/A has no field 'S'"),
        ("s: a\ns: b", "duplicated mapping key (2:1)"),
        ("s: [a]", "s: expected a string, not a list"),
        ("s: {a: b}", "s: expected a string, not fields"),
        ("short: four", "short: holds at most 3 bytes, not 4"),
        ("b: yes", "b: 'yes' is neither true nor false"),
        ("i: 1.5", "i: '1.5' is not a whole number"),
        ("bytes: [256]", "bytes: uint8 holds 0 to 255"),
        ("bytes: 7", "bytes: expected a list, not '7'"),
        ("two: [1]", "two: needs 2 items, not 1"),
        ("one: [a, b]", "one: holds at most 1 items, not 2"),
        ("in: 7", "in: expected the fields of a/msg/In, not '7'"),
        ("ins: [{big: x}]", "ins: big: 'x' is not a whole number"),
        ("s: !!binary aGk=", "unknown scalar tag !<tag:yaml.org,2002:binary> (1:4)"),
        ("__proto__: {s: a}", "a/msg/A has no field '__proto__'"),
    ],
)
def test_yaml_is_read_as_the_type_says(stage: Tab, text: str, expected: object) -> None:
    assert stage.evaluate(READ, [text]) == [expected]
