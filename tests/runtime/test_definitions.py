"""Definitions as texts: the schemas of bags, and what the terminal shows."""

from __future__ import annotations

import json
import subprocess
from pathlib import Path
from typing import Any

from paths import ROOT

from sitegen.interfaces.values import values_of

NAME = "labels/msg/Label"
CONSTANTS: list[dict[str, Any]] = [
    {"name": "ALL", "type": "uint64", "value": "18446744073709551615"},
    {"name": "LOWEST", "type": "int64", "value": "-9223372036854775808"},
    {"name": "TAB", "type": "string", "value": 'a\tb \\ "c" \\t'},
    {"name": "HALF", "type": "float64", "value": 0.5},
]
FIELDS: list[dict[str, Any]] = [
    {"name": "keys", "type": "uint64[2]", "default": ["1", "9007199254740993"]},
    {"name": "serial", "type": "int64", "default": "9007199254740993"},
    {"name": "path", "type": "string", "default": "C:\\temp"},
]


def test_definitions_keep_64_bit_integers_and_escapes(tmp_path: Path) -> None:
    script = ROOT / "tests/support/definitions.mjs"
    types = json.dumps({NAME: {"constants": CONSTANTS, "fields": FIELDS}})
    done = subprocess.run(["node", script, types], text=True, capture_output=True, check=True)
    found = json.loads(done.stdout)
    lines = [
        "uint64 ALL=18446744073709551615",
        "int64 LOWEST=-9223372036854775808",
        r'string TAB="a\tb \\\\ \"c\" \\\\t"',
        "float64 HALF=0.5",
        "uint64[2] keys [1, 9007199254740993]",
        "int64 serial 9007199254740993",
        r'string path "C:\\\\temp"',
    ]
    assert found["text"].splitlines() == lines
    assert found["shown"].splitlines() == lines
    assert found["read"][NAME]["constants"] == CONSTANTS
    # The text means the same to rosidl.
    (tmp_path / "msg").mkdir()
    (tmp_path / "msg/Label.msg").write_text(found["text"])
    values = values_of(NAME, {"labels": tmp_path})
    assert values.constants == CONSTANTS
    assert values.defaults == {one["name"]: one["default"] for one in FIELDS}
