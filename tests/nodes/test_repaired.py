"""Sources that g++ accepts and clang 14 does not are compiled."""

from __future__ import annotations

import subprocess
import sys
from pathlib import Path

import pytest

from sitegen.nodes.cpp import precompiled, repaired
from sitegen.nodes.cpp.toolchain import Toolchain

SOURCE = """\
#include <map>
#include <string>
struct Board {template<class T> T get(const std::string &) {return T{};}};
template<class T> struct Node {
  T board;
  int run() {return board.get<int>("Größe") + this->board.get<int>("b");}
};
int sum(const std::map<std::string, int> & all) {
  int sum = Node<Board>().run();
  for (const auto & [name, value] : all) {
    const auto named = [&name, value]() {return name.size() + value;};
    const auto nested = [&]() {return [&]() {return name.size() + value;}();};
    const auto copied = [=](int more) {return value + more;};
    const auto mixed = [&sum, name = name]() {return name.size() + sum;};
    sum += named() + nested() + copied(1) + mixed();
  }
  return sum;
}
"""


def run(folder: Path, text: str) -> subprocess.CompletedProcess[str]:
    """Compile a source as a build does, without rclcpp.hpp."""
    source = folder / "source.cpp"
    source.write_text(text)
    tools = Toolchain.find()
    script = ["-I", "-S", precompiled.__file__, str(folder), str(folder)]
    words: list[str | Path] = [
        tools.compiler,
        "-std=gnu++17",
        "-o",
        str(folder / "x.o"),
        "-c",
        str(source),
    ]
    return tools.run(sys.executable, *script, *words)


def test_what_clang_lacks_is_inserted(tmp_path: Path) -> None:
    done = run(tmp_path, SOURCE)
    assert (done.returncode, done.stdout) == (0, "")
    assert (tmp_path / "x.o").read_bytes().startswith(b"\0asm")
    assert (tmp_path / "source.cpp").read_text() == SOURCE


def test_a_source_with_errors_of_its_own_is_shown_as_it_is(tmp_path: Path) -> None:
    done = run(tmp_path, SOURCE.replace("return sum;", "return total;"))
    assert done.returncode == 1
    assert "use of undeclared identifier 'total'" in done.stdout
    assert "'name' in capture list does not name a variable" in done.stdout
    assert "name = name, value]" not in done.stdout


LINE = "for (auto [a, b] : all) {auto f = [&](int c) {use(a);}; }\n"


@pytest.mark.parametrize(
    ("what", "column", "expected"),
    [
        (
            "reference to local binding 'a' declared in enclosing function 'f'",
            52,
            [(36, ", &a = a")],
        ),
        ("reference to local binding 'z' declared in enclosing function 'f'", 1, None),
        ("'a' in capture list does not name a variable", 12, [(11, "a = ")]),
    ],
)
def test_places_are_those_that_the_compiler_names(
    tmp_path: Path, what: str, column: int, expected: list[tuple[int, str]] | None
) -> None:
    file = tmp_path / "a.cpp"
    file.write_text(LINE)
    found = repaired.insertions(f"{file}:1:{column}: error: {what}\n", {})
    assert found == ({file: {*expected}} if expected else {})
    other = f"{file}:1:1: error: expected ';'\n"
    assert repaired.insertions(f"{file}:1:{column}: error: {what}\n{other}", {}) is None
