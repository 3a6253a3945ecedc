"""Log messages follow RCUTILS_CONSOLE_OUTPUT_FORMAT as those of native rclpy 9.1.2 do."""

from __future__ import annotations

import json
import re
import subprocess

import pytest
from paths import ROOT

MODULE = ROOT / "sitegen/runtime/workers/environment.js"
# `WARN` from the logger `a.b`, in line 3 of go() in /tmp/nat.py, with the message `hello {x} \n`.
MESSAGE = r"hello {x} \n"
CALL = """
const { logFormat } = await import(process.argv[1]);
const [format, text] = JSON.parse(process.argv[2]);
const line = logFormat({ RCUTILS_CONSOLE_OUTPUT_FORMAT: format });
const time = "1795703534.076459680";
console.log(JSON.stringify(line("warn", "a.b", text, time, ["go", "/tmp/nat.py", 3])));
"""


def line(form: str) -> str:
    words = ["node", "--input-type=module", "-e", CALL, "--", str(MODULE)]
    done = subprocess.run(
        [*words, json.dumps([form, MESSAGE])], text=True, capture_output=True, check=True
    )
    return str(json.loads(done.stdout))


@pytest.mark.parametrize(
    ("form", "expected"),
    [
        (
            r"<{name}> {severity} {message} {no}\t{function_name}:{line_number}|{file_name}",
            f"<a.b> WARN {MESSAGE} {{no}}\tgo:3|/tmp/nat.py",
        ),
        ("{{name}} {name {message}", f"{{a.b}} {{name {MESSAGE}"),
        (r"a\nb {time} {time_as_nanoseconds}", "a\nb 1795703534.076459680 1795703534076459680"),
        ("{name}{", "a.b{"),
        ("{constructor} {__proto__}", "{constructor} {__proto__}"),
        ("{ name } {NAME} {na-me} {severity}", "{ name } {NAME} {na-me} WARN"),
        (r"q\rw\b", "q\rw\b"),
        (r"x\x1b[1m{message}\x1b[0m", f"x\x1b[1m{MESSAGE}\x1b[0m"),
        (r"\033 \q\" {message}", rf"\033 \q\" {MESSAGE}"),
    ],
)
def test_formats(form: str, expected: str) -> None:
    assert line(form) == expected


def test_the_date_is_that_of_the_visitor() -> None:
    assert re.fullmatch(r"2026-11-2\d \d\d:\d\d:14\.076", line("{date_time_with_ms}"))
