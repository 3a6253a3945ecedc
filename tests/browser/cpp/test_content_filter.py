"""Content filters: what passes, and what is wrong with an expression."""

from __future__ import annotations

from typing import Any

from playwright.sync_api import Page as Tab

from sitegen.interfaces import messages, typesupport
from sitegen.shipped import ROS

STATE = "sensor_msgs/msg/JointState"
MESSAGE: dict[str, Any] = {
    "header": {"stamp": {"sec": 7, "nanosec": 5}, "frame_id": "base's link"},
    "name": ["left", "right wheel", ""],
    "position": [0.5, -2.25, 1e300],
    "velocity": [],
    "effort": [9],
}
PASS = [
    "header.stamp.sec = 7",
    "7 = header.stamp.sec",
    "header.stamp.sec <> 8 and header.stamp.nanosec >= 5",
    "NOT (header.stamp.sec > 7 OR header.stamp.sec < 7)",
    "header.stamp.sec = 1 AND header.stamp.sec = 2 OR header.stamp.sec = 7",
    "header.stamp.sec BETWEEN 7 AND 8 AND header.stamp.sec NOT BETWEEN 0x8 AND 9",
    "position[1] = -2.25 AND position[2] > 1.5e+299 AND position[0]=.5",
    "effort[0] = 9 AND effort[0] >= %1",
    r"header.frame_id = 'base\'s link'",
    "header.frame_id LIKE 'base%' AND header.frame_id like '*_link'",
    "name[1] MATCH '[a-z]+ w.*' AND NOT name[1] LIKE 'right'",
    "name[2] = ''",
    "name[0] < name[1]",
    "header.frame_id <> %0",
]
STOP = [
    "header.stamp.sec = 8",
    "velocity[0] = 0",
    "velocity[0] <> 0",
    "header.stamp.sec NOT BETWEEN 7 AND 8",
    "header.frame_id LIKE 'bas_'",
    "name[1] MATCH 'wheel'",
]
WRONG = {
    "header.stamp.second = 1": "the message has no field 'header.stamp.second'",
    "header.stamp.sec.low = 1": "the message has no field 'header.stamp.sec.low'",
    "header = 1": "'header' is a message: name one of its fields",
    "position = 1": "'position' is an array",
    "header[0].frame_id = ''": "'header[0].frame_id' is not an array",
    "header.stamp.sec = '7'": "a number cannot be compared with a text",
    "header.stamp.sec = TRUE": "a number cannot be compared with a bool",
    "header.stamp.sec LIKE 7": "LIKE and MATCH are for texts, not for a number",
    "header.stamp.sec": "the expression ends too early: a comparison is missing",
    "header.stamp.sec = 1 AND": "the expression ends too early: a value is missing",
    "header.stamp.sec = 1)": "')' is not expected here",
    "(header.stamp.sec = 1": "a ')' is missing",
    "header.stamp.sec = %2": "there is no parameter %2",
    "header.stamp.sec = %100": "'%100' is not understood",
    "header.stamp.sec ~ 1": "'~ 1' is not understood",
}
VALUES = {
    **{"bool_value": True, "byte_value": 255, "char_value": 65, "int8_value": -128},
    **{"uint8_value": 200, "int16_value": -300, "uint16_value": 65535, "int32_value": -1},
    **{"uint32_value": 4294967295, "float32_value": 1.5, "float64_value": 0.1},
}
KINDS = {name: f"{name} = {str(value).upper()}" for name, value in VALUES.items()}
RUN = """async ([definition, types, type, message, expressions, parameters]) => {
  const { contentFilter } = await import("./runtime/messages/filter/contentFilter.js");
  const { Codec } = await import("./runtime/messages/codec.js");
  const bytes = new Codec(types).write(type, message);
  return expressions.map((expression) => {
    try {
      return contentFilter(definition, expression, parameters)(bytes);
    } catch (error) {
      return error.message;
    }
  });
}"""


def filtered(stage: Tab, expressions: list[str], type_: str, message: Any) -> list[Any]:
    package, kind, name = type_.split("/")
    [described] = typesupport.read_description(ROS / "share" / package / kind / f"{name}.json")
    types = messages.types([type_], [])
    given = [described.definition, types, type_, message, expressions, ["'x'", "9"]]
    result: list[Any] = stage.evaluate(RUN, given)
    return result


def test_messages_pass_as_the_expression_says(stage: Tab) -> None:
    expressions = [*PASS, *STOP]
    found = dict(zip(expressions, filtered(stage, expressions, STATE, MESSAGE), strict=True))
    assert found == dict.fromkeys(PASS, True) | dict.fromkeys(STOP, False)


def test_a_wrong_expression_says_what_is_wrong(stage: Tab) -> None:
    found = dict(zip(WRONG, filtered(stage, list(WRONG), STATE, MESSAGE), strict=True))
    assert found == WRONG


def test_each_kind_of_field_is_found(stage: Tab) -> None:
    found = filtered(stage, list(KINDS.values()), "test_msgs/msg/BasicTypes", VALUES)
    assert dict(zip(KINDS, found, strict=True)) == dict.fromkeys(KINDS, True)
    wide = {"wstring_value": "日本", "array_of_wstrings": ["a", "ü", ""]}
    expressions = ["wstring_value = '日本'", "array_of_wstrings[1] LIKE '_'"]
    assert filtered(stage, expressions, "test_msgs/msg/WStrings", wide) == [True, True]


def test_fields_are_found_behind_all_others(stage: Tab) -> None:
    sequences = {
        "bool_values": [True],
        "string_values": ["abc", "ü"],
        "basic_types_values": [{}, VALUES],
        "constants_values": [{}, {}, {}],
        "alignment_check": 3,
    }
    inner = "unbounded_sequence_of_unbounded_sequences[1]"
    message = {"unbounded_sequence_of_unbounded_sequences": [{}, sequences, {}]}
    expressions = [
        f"{inner}.alignment_check = 3",
        f"{inner}.string_values[1] = 'ü'",
        f"{inner}.basic_types_values[1].uint64_value = 0",
    ]
    found = filtered(stage, expressions, "test_msgs/msg/MultiNested", message)
    assert found == [True, True, True]
