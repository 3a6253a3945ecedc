"""The size of the browser's JavaScript: functions of 60 lines and files of 400 at most."""

from __future__ import annotations

import json
import subprocess
from pathlib import Path
from typing import NamedTuple

import pytest
from paths import ROOT, SUPPORT

FUNCTION, FILE = 60, 400
FILES = sorted(
    file.relative_to(ROOT).as_posix()
    for file in [*ROOT.glob("sitegen/runtime/**/*.js"), *ROOT.glob("themes/default/*.js")]
    if "vendor" not in file.parts
)


class Function(NamedTuple):
    """A function, as the parser found it."""

    file: str
    name: str
    line: int
    lines: int


class Parsed(NamedTuple):
    """The JavaScript of some TypeScript projects."""

    files: list[str]
    functions: list[Function]


def parse(folder: Path, *projects: str) -> Parsed:
    """Parse the JavaScript that the projects, tsconfig files in `folder`, cover."""
    done = subprocess.run(
        ["node", str(SUPPORT / "functions.mjs"), *projects],
        cwd=folder,
        capture_output=True,
        text=True,
        check=True,
    )
    found = json.loads(done.stdout)
    return Parsed(found["files"], [Function(**function) for function in found["functions"]])


def too_long(functions: list[Function]) -> list[str]:
    """Return a line for each function that is too long."""
    return [
        f"{file}:{line}: {name} has {lines} lines; split it, {FUNCTION} are allowed"
        for file, name, line, lines in sorted(functions)
        if lines > FUNCTION
    ]


def test_functions_are_short() -> None:
    parsed = parse(ROOT, "tsconfig.json", "tsconfig.workers.json")
    assert sorted({*FILES} - {*parsed.files}) == []
    assert too_long([one for one in parsed.functions if one.file in FILES]) == []


@pytest.mark.parametrize("file", FILES)
def test_files_are_short(file: str) -> None:
    lines = len((ROOT / file).read_text().splitlines())
    assert lines <= FILE, f"{file} has {lines} lines; split it, {FILE} are allowed"


@pytest.mark.parametrize(
    ("begin", "end", "name"),
    [
        ("export function declared() {", "}", "declared"),
        ("export const arrow = () => {", "};", "arrow"),
        ("export class C {\n  #method() {", "  }\n}", "#method"),
        ("export class C {\n  get property() {", "  }\n}", "property"),
        ("export class C {\n  field = async () => {", "  };\n}", "field"),
        ("export const object = { key: function () {", "} };", "key"),
        ("addEventListener('load', () => {", "});", "an argument of addEventListener"),
    ],
)
def test_long_functions_of_all_kinds_are_found(
    tmp_path: Path, begin: str, end: str, name: str
) -> None:
    config = {"compilerOptions": {"allowJs": True, "types": []}, "include": ["*.js"]}
    (tmp_path / "tsconfig.json").write_text(json.dumps(config))

    def found(statements: int) -> list[str]:
        (tmp_path / "long.js").write_text("\n".join([begin, *["  void 0;"] * statements, end]))
        return too_long(parse(tmp_path, "tsconfig.json").functions)

    assert found(FUNCTION - 2) == []
    line = begin.count("\n") + 1
    assert found(FUNCTION - 1) == [
        f"long.js:{line}: {name} has 61 lines; split it, 60 are allowed",
    ]
