"""Constants and defaults are those of the Python classes that rosidl generates."""

from __future__ import annotations

import importlib
import json
import sys
from collections.abc import Iterator
from pathlib import Path
from typing import Any

import pytest

from sitegen.interfaces import generator
from sitegen.interfaces.declarations import declarations
from sitegen.interfaces.messages import MessageType, types
from sitegen.shipped import ROS

LABEL = r"""
string TAB="a\tb"
string QUOTED='she said "hi"'
string APOSTROPHE="it's"
string EMPTY=""
uint64 BROADCAST=18446744073709551615
int64 LOWEST=-9223372036854775808
bool ON=true
float64 HALF=0.5
char LETTER=65
string columns "one\ttwo"
string path "C:\\\\temp"
string once "C:\\temp"
string quoted "say \"no\""
string apostrophes 'it\'s'
string hex "\x41\102"
string plain not quoted
string spaced "  both sides  "
string letters "é中"
string<=8[<=2] codes ["ab", "it's"]
string[] escaped ["a\tb", "c\\d", 'say "no"']
wstring wide "x\ty"
char letter 65
byte mask 255
bool[] switches [true, false]
float64[2] lengths [0.5, -1e-7]
uint64 serial 9007199254740993
int64 offset -9007199254740993
uint64[3] keys [1, 9007199254740993, 18446744073709551615]
int64[] some [-9223372036854775808]
int64[<=2] few [0x7fffffffffffffff]
int32 small -7
string none
"""
SERVICE = f"uint64 FIRST=9007199254740993\nuint64 id 9007199254740993\n---{LABEL}"
ACTION = f'int64 goal 9007199254740993\n---{LABEL}---\nstring done "50\\t%"\n'
IDL = r"""
module labels { module msg {
  module Idl_Constants {
    const unsigned long long BROADCAST = 18446744073709551615;
    const string TAB = "a\tb";
    const wstring WIDE = L"\u00e9";
    const boolean ON = TRUE;
    const float HALF = 0.5;
  };
  struct Idl {
    @default (value=9007199254740993) long long serial;
    @default (value="C:\\temp \"x\"") string path;
    @default (value=TRUE) boolean on;
    @default (value=200) octet mask;
    @default (value="(1, 18446744073709551615)") sequence<uint64> keys;
    @default (value=1.5) double length;
    string none;
  };
}; };
"""
IDL_SERVICE = """
module labels { module srv {
  struct Ask_Request { @default (value=9007199254740993) uint64 id; };
  module Ask_Response_Constants { const int64 LOWEST = -9223372036854775807; };
  struct Ask_Response { @default (value="a\\tb") string text; };
}; };
"""


@pytest.fixture(scope="module")
def labels(tmp_path_factory: pytest.TempPathFactory) -> Iterator[Path]:
    """A prefix with a package of all kinds of definitions, and its classes."""
    source, prefix = tmp_path_factory.mktemp("labels"), tmp_path_factory.mktemp("prefix")
    texts = {
        **{"msg/Label.msg": LABEL, "srv/Label.srv": SERVICE, "action/Label.action": ACTION},
        **{"msg/Idl.idl": IDL, "srv/Ask.idl": IDL_SERVICE},
    }
    for name, text in texts.items():
        (source / name).parent.mkdir(exist_ok=True)
        (source / name).write_text(text.lstrip())
    arguments = generator.describe(prefix, [], "labels", source, list(texts))
    generator.write_classes(prefix, arguments)
    # The class of an action imports some of ROS.
    paths = [str(prefix / "python"), str(ROS / "page")]
    sys.path += paths
    yield prefix
    for path in paths:
        sys.path.remove(path)


@pytest.mark.parametrize(
    "name",
    [
        *("msg/Label", "msg/Idl", "srv/Label_Request", "srv/Label_Response", "action/Label_Goal"),
        *("action/Label_Result", "action/Label_Feedback", "srv/Ask_Request", "srv/Ask_Response"),
    ],
)
def test_values_are_those_of_the_generated_classes(labels: Path, name: str) -> None:
    kind, written = name.split("/")
    interface, _, part = written.partition("_")
    native = getattr(importlib.import_module(f"labels.{kind}"), interface)
    native = getattr(native, part) if part else native
    found = read(labels, name)
    constants = {one["name"]: typed(one["value"], one["type"]) for one in found["constants"]}
    assert constants == {one: plain(getattr(native, one)) for one in constants}
    given = {one.upper() for one in dir(type(native)) if one.endswith("__DEFAULT")}
    defaults = {f["name"]: f for f in found["fields"] if "default" in f}
    assert {f"{one.upper()}__DEFAULT" for one in defaults} == given
    for field, one in defaults.items():
        expected = plain(getattr(native, f"{field.upper()}__DEFAULT"))
        assert typed(one["default"], one["type"]) == expected, field
    assert set(constants) == {one for one in dir(type(native)) if one in ALL}


ALL = {"TAB", "QUOTED", "APOSTROPHE", "EMPTY", "BROADCAST", "LOWEST", "ON", "HALF", "LETTER"} | {
    *("FIRST", "WIDE"),
}


def test_integers_of_64_bits_survive_json_in_javascript(labels: Path) -> None:
    found = read(labels, "msg/Label")
    values = {one["name"]: one["value"] for one in found["constants"]}
    fields = {one["name"]: one.get("default") for one in found["fields"]}
    assert values["BROADCAST"] == "18446744073709551615"
    assert fields["keys"] == ["1", "9007199254740993", "18446744073709551615"]
    assert fields["small"] == -7


def test_the_types_of_an_editor_name_constants_as_numbers(labels: Path) -> None:
    text = declarations(types(["labels/msg/Label"], [labels]))
    assert "BROADCAST = 18446744073709551615n, LOWEST = -9223372036854775808n" in text
    assert 'TAB = "a\\tb"' in text


def read(prefix: Path, name: str) -> MessageType:
    found: MessageType = json.loads(json.dumps(types([f"labels/{name}"], [prefix])))
    one: MessageType = found[f"labels/{name}"]
    return one


def typed(value: Any, kind: str) -> Any:
    """Return a value of JSON as Python has it."""
    if isinstance(value, list):
        return [typed(one, kind.partition("[")[0]) for one in value]
    return int(value) if "int64" in kind else value


def plain(value: Any) -> Any:
    """Return a value of a class as JSON has it."""
    if isinstance(value, bytes):
        return value[0]
    if hasattr(value, "tolist"):
        return value.tolist()
    return value if isinstance(value, str | int | float) else [plain(one) for one in value]
