"""The public names of the libraries of ROS that C++ programs of a page can use.

Each file of `public_names` lists names of a package of upstream in Humble, Jazzy and Rolling, one a
line: whether the page has it, its kind, the name and, if it is missing, the reason.
"""

from __future__ import annotations

import re
import subprocess
from pathlib import Path
from typing import NamedTuple

import pytest
from configuring import header_folders

from sitegen.nodes.cpp.toolchain import Toolchain

TABLES = sorted((Path(__file__).parent / "public_names").glob("*.txt"))
LINE = re.compile(r"(yes|no|different) (header|name|member|macro) (\S+)(?:: (\S.*))?")
# The reason of headers that C++ programs cannot include.
FOR_C = "for C only, as upstream"
# How a source uses a name of each kind. The line of an error is the number of the name.
USES = {
    "name": "namespace check_{0} {{using ::{1};}}",
    "member": "struct check_{0} : ::{2} {{using ::{1};}};",
    "macro": "\n#ifndef {1}\n#line {0}\n#error no macro {1}\n#endif",
}


class Name(NamedTuple):
    number: int
    there: str
    kind: str
    name: str
    reason: str | None


def read(table: Path) -> list[Name]:
    names = []
    for number, line in enumerate(table.read_text("utf-8").splitlines(), 1):
        if line.startswith("#"):
            continue
        found = LINE.fullmatch(line)
        assert found, f"{table.name}:{number}: {line}"
        names.append(Name(number, found[1], found[2], found[3], found[4]))
    return names


@pytest.fixture(scope="module")
def folders(tmp_path_factory: pytest.TempPathFactory) -> list[Path]:
    """The folders with the headers of the page."""
    return header_folders(tmp_path_factory.mktemp("prefix"))


def missing(names: list[Name], folders: list[Path], source: Path) -> tuple[set[int], str]:
    """The numbers of the names that do not compile, and what the compiler says."""
    lines = [
        f'#include "{one.name}"'
        for one in names
        if one.kind == "header" and one.there != "no" and one.reason != FOR_C
    ]
    for one in names:
        if one.kind != "header":
            use = USES[one.kind].format(one.number, one.name, one.name.rpartition("::")[0])
            lines.append(f'#line {one.number} "table"\n{use}')
    source.write_text("\n".join([*lines, ""]))
    done = subprocess.run(
        [
            *(Toolchain.find().compiler, source, "-fsyntax-only", "-std=gnu++17", "-fexceptions"),
            *("-ferror-limit=0", "-Wno-everything", *(f"-I{folder}" for folder in folders)),
        ],
        text=True,
        stdout=subprocess.PIPE,
        stderr=subprocess.STDOUT,
    )
    return {
        int(line) for line in re.findall(r"^table:(\d+):\d+: error", done.stdout, re.M)
    }, done.stdout


@pytest.mark.parametrize("table", TABLES, ids=lambda table: table.stem)
def test_tables_say_which_names_exist(table: Path, folders: list[Path], tmp_path: Path) -> None:
    names = read(table)
    assert [one for one in names if one.there != "yes" and not one.reason] == []
    absent, output = missing(names, folders, tmp_path / "names.cpp")
    absent |= {
        one.number
        for one in names
        if one.kind == "header" and not any((folder / one.name).is_file() for folder in folders)
    }
    expected = {one.number for one in names if one.there == "no"}
    wrong = [one for one in names if (one.number in absent) != (one.number in expected)]
    assert wrong == [], output
    # An error in a header is an error of the library.
    assert not re.search(r"^(?!table:)\S+:\d+:\d+: (fatal )?error", output, re.M), output
