"""rclcpp.hpp is compiled beforehand for programs, and nobody can tell."""

from __future__ import annotations

import subprocess
import sys
from concurrent.futures import ThreadPoolExecutor
from pathlib import Path

import pytest

from sitegen.interfaces import generator
from sitegen.nodes.cpp import precompiled
from sitegen.nodes.cpp.precompiled import HEADER, INTERFACES, LIBRARY, Command, Reader
from sitegen.nodes.cpp.toolchain import Toolchain

NODE = """\
#include <memory>
#include "rclcpp/rclcpp.hpp"
#include "name.hpp"
int main(int argc, char ** argv) {{
  rclcpp::init(argc, argv);
  auto node = std::make_shared<rclcpp::Node>(NAME);
  {}
  rclcpp::spin(node);
}}
"""


class Compiler:
    """The compiler, below a folder with sources and interfaces, with and without."""

    def __init__(self, folder: Path, ros: Path) -> None:
        self.folder = folder
        self.ros = ros
        self.store = folder / "store"
        self.tools = Toolchain.find()

    def write(self, name: str, text: str) -> Path:
        file = self.folder / name
        file.parent.mkdir(parents=True, exist_ok=True)
        file.write_text(text)
        return file

    def flags(self, *more: str) -> list[str]:
        folders = [LIBRARY, *sorted(self.ros.iterdir()), *sorted(INTERFACES.iterdir())]
        system = [word for folder in folders for word in ("-isystem", str(folder))]
        return [*more, "-I", f"{self.folder}/include", *system, "-std=gnu++17", "-fwasm-exceptions"]

    def words(self, source: Path, *more: str) -> list[str]:
        files = ["-MD", "-MT", "x.o", "-MF", f"{source}.d", "-o", f"{source}.o", "-c", str(source)]
        return [*self.flags(*more), *files]

    def plain(self, source: Path, *more: str) -> subprocess.CompletedProcess[str]:
        return self.tools.run(self.tools.compiler, *self.words(source, *more))

    def run(self, source: Path, *more: str) -> subprocess.CompletedProcess[str]:
        script = ["-I", "-S", precompiled.__file__, str(self.store), str(self.ros)]
        words = self.words(source, *more)
        return self.tools.run(sys.executable, *script, self.tools.compiler, *words)

    def made(self) -> list[Path]:
        return sorted(self.store.glob("*.pch"))

    def is_as_without(self, source: Path, *more: str) -> bool:
        """Tell whether `source` becomes the same bytes, and whether the same is said."""
        done = self.run(source, *more)
        made = Path(f"{source}.o").read_bytes() if not done.returncode else b""
        plain = self.plain(source, *more)
        assert (done.returncode, done.stdout) == (plain.returncode, plain.stdout)
        return not plain.returncode and Path(f"{source}.o").read_bytes() == made


@pytest.fixture(scope="module")
def ros(tmp_path_factory: pytest.TempPathFactory) -> Path:
    """The headers of interfaces, where a build has them."""
    prefix = tmp_path_factory.mktemp("work") / "ros"
    generator.write_ros(prefix)
    generator.write_shipped(prefix)
    return prefix / "include"


@pytest.fixture(scope="module")
def compiler(tmp_path_factory: pytest.TempPathFactory, ros: Path) -> Compiler:
    """One for all tests here, since its store takes seconds to fill."""
    compiler = Compiler(tmp_path_factory.mktemp("author"), ros)
    compiler.write("include/name.hpp", '#define NAME "node"\n')
    return compiler


def test_what_is_made_once_serves_all_sources(compiler: Compiler) -> None:
    sources = [compiler.write(f"{name}.cpp", NODE.format("")) for name in ("one", "two", "three")]
    with ThreadPoolExecutor(3) as pool:
        results = list(pool.map(compiler.run, sources, ["-Wall", "-Wextra", "-Wpedantic"]))
    assert [(done.returncode, done.stdout) for done in results] == [(0, "")] * 3
    assert len(compiler.made()) == 1
    for source in sources:
        assert Path(f"{source}.o").read_bytes().startswith(b"\0asm")
        listed = Path(f"{source}.d").read_text()  # what Ninja looks at when it is asked again
        assert "include/name.hpp" in listed
        assert str(HEADER) in listed
    # The folder that sources are in is no matter; how they are compiled is.
    again = compiler.write("elsewhere/one.cpp", NODE.format(""))
    assert not compiler.run(again, f"-ffile-prefix-map={again.parent}=shown").returncode
    assert len(compiler.made()) == 1
    assert not compiler.run(sources[0], "-DNAMED=1").returncode
    assert len(compiler.made()) == 2


@pytest.mark.exhaustive
def test_what_the_compiler_says_is_the_same(compiler: Compiler) -> None:
    wrong = compiler.write("wrong.cpp", NODE.format("std::make_shared<rclcpp::Node>(1, 2);"))
    assert not compiler.is_as_without(wrong)
    assert f"In file included from {wrong}:1:" in compiler.run(wrong).stdout
    unused = compiler.write("unused.cpp", NODE.format("int unused = 1;"))
    assert compiler.is_as_without(unused, "-Wall")
    assert "unused variable 'unused'" in compiler.run(unused, "-Wall").stdout


def test_what_is_said_before_counts(compiler: Compiler) -> None:
    early = '#define RCLCPP_INFO(logger, ...) static_assert(true)\n#include "rclcpp/rclcpp.hpp"\n'
    own = compiler.write("own.cpp", early + "#undef RCLCPP_INFO\nint main() {}\n")
    before = compiler.made()
    assert compiler.is_as_without(own, "-DOTHER=1")
    assert compiler.made() == before


def test_what_headers_of_another_standard_library_include_is_known(compiler: Compiler) -> None:
    sorts = """\
#include <functional>
int first(std::vector<int> values) {{
  std::sort(values.begin(), values.end());
  return {};
}}
"""
    plain = compiler.write("sorts.cpp", sorts.format("values[0]"))
    assert "namespace 'std'" in compiler.plain(plain).stdout
    assert (compiler.run(plain).returncode, compiler.run(plain).stdout) == (0, "")
    assert Path(f"{plain}.o").read_bytes().startswith(b"\0asm")
    # A source with an error of its own is shown as it is.
    wrong = compiler.write("wrong_sorts.cpp", sorts.format("unknown"))
    said = compiler.run(wrong).stdout
    assert said == compiler.plain(wrong).stdout
    assert "standard.h" not in said


PARTS = """#if defined(__linux__)
{}
#elif defined(_WIN32)
#include <windows.h>
#endif
"""


@pytest.mark.parametrize("where", ["the source", "a header of a header"])
def test_a_source_with_parts_for_systems_is_compiled_as_on_linux(
    compiler: Compiler, where: str
) -> None:
    part = PARTS.format("namespace robot { inline int wheels() {return 4;} }")
    compiler.write("include/parts.hpp", part)
    compiler.write("include/robot.hpp", '#include "parts.hpp"\nint w() {return robot::wheels();}\n')
    top = part if where == "the source" else '#include "robot.hpp"\n'
    source = compiler.write("src/parts.cpp", f"{top}int main() {{return robot::wheels();}}\n")
    assert compiler.plain(source).returncode == 1
    assert (compiler.run(source).returncode, compiler.run(source).stdout) == (0, "")


ONLY = """// The port.
#if defined(__linux__)
#ifdef ROBOT
#else
int on_linux() {return 4;}
#endif
#elif defined(_WIN32)
int elsewhere() {return 3;}
#endif
"""
MORE = "int more;\n"
OTHERS = {
    "a line after it": ONLY + MORE,
    "a line before it": MORE + ONLY,
    "a part for all others": ONLY.replace("#elif defined(_WIN32)", "#else"),
}


def test_a_source_that_is_only_for_linux_is_compiled_as_there(compiler: Compiler) -> None:
    source = compiler.write("src/only.cpp", ONLY)
    assert compiler.run(source).returncode == 0
    assert b"on_linux" in Path(f"{source}.o").read_bytes()
    other = compiler.write("src/other.cpp", ONLY.replace("defined(__l", "!defined(__l"))
    assert compiler.is_as_without(other)


@pytest.mark.parametrize("text", OTHERS.values(), ids=OTHERS)
def test_a_source_with_more_than_parts_for_systems_is_not(compiler: Compiler, text: str) -> None:
    assert compiler.is_as_without(compiler.write("src/more.cpp", text))


def test_a_part_for_linux_that_needs_drivers_says_so(compiler: Compiler) -> None:
    part = PARTS.format("#include <linux/joystick.h>\nusing Event = js_event;")
    source = compiler.write("src/port.cpp", f"{part}Event event;\n")
    assert "'linux/joystick.h' file not found" in compiler.run(source).stdout


def test_other_errors_of_a_source_that_asks_for_linux_are_those_it_has(compiler: Compiler) -> None:
    part = PARTS.format("int wheels;")
    source = compiler.write("src/wrong.cpp", f"{part}int main() {{return legs;}}\n")
    assert compiler.run(source).stdout == compiler.plain(source).stdout


def test_what_headers_of_upstream_include_is_known(compiler: Compiler) -> None:
    logs = """\
#include "rclcpp/qos.hpp"
void log(rclcpp::Rate & rate) {{
  RCLCPP_INFO(rclcpp::get_logger("a"), "b");
  {};
}}
"""
    plain = compiler.write("logs.cpp", logs.format("rate.sleep()"))
    assert "RCLCPP_INFO" in compiler.plain(plain).stdout
    assert (compiler.run(plain).returncode, compiler.run(plain).stdout) == (0, "")
    wrong = compiler.write("wrong_logs.cpp", logs.format("rate.jump()"))
    said = compiler.run(wrong).stdout
    assert said == compiler.plain(wrong).stdout
    assert "upstream.h" not in said


def test_a_header_of_the_author_that_stands_in_the_way(compiler: Compiler) -> None:
    source = compiler.write("way/node.cpp", NODE.format(""))
    compiler.write("way/include/rmw/rmw.h", "#error of the author\n")
    assert not compiler.is_as_without(source, f"-I{source.parent}/include")
    assert "of the author" in compiler.run(source, f"-I{source.parent}/include").stdout


@pytest.mark.exhaustive
def test_what_is_broken_is_made_again(compiler: Compiler) -> None:
    source = compiler.write("broken.cpp", NODE.format(""))
    before = compiler.made()
    assert not compiler.run(source, "-DBROKEN=1").returncode
    (made,) = set(compiler.made()) - set(before)
    whole = made.stat().st_size
    made.write_bytes(made.read_bytes()[:1000])
    for _ in range(2):
        done = compiler.run(source, "-DBROKEN=1")
        assert (done.returncode, done.stdout) == (0, "")
    assert made.stat().st_size == whole


OWN = {
    "own/guarded.hpp": '#ifndef OWN_HPP_\n#define OWN_HPP_\n#include "rclcpp/rclcpp.hpp"\nint x;\n',
    "own/once.hpp": "// Mine.\n#pragma once\n#include <rclcpp/rclcpp.hpp>\n",
    "own/words.hpp": "#pragma once\n#define WORDS\n",
    "own/msg/word.hpp": "#define WORDS\n",
    "own/empty.hpp": "#pragma once\n",
}
BEGINNINGS = {
    '#include "rclcpp/rclcpp.hpp"': True,
    "#include <rclcpp/rclcpp.hpp>": True,
    '/* #define A\n */ // B\n#include <map>\n#include "rclcpp/rclcpp.hpp"': True,
    '#include "std_msgs/msg/string.hpp"\n# include  "rclcpp/rclcpp.hpp" // it': True,
    '#include "rclcpp_action/rclcpp_action.hpp"\n#include "rclcpp/rclcpp.hpp"': True,
    '#include "own/guarded.hpp"': True,
    '#include "own/once.hpp"': True,
    '#include "own/empty.hpp"\n#include "own/once.hpp"': True,
    '#include "tf2_ros/buffer.hpp"\n#include "rclcpp/rclcpp.hpp"': True,
    "#include <map>\nint main() {}": False,
    "": False,
    '#define A\n#include "rclcpp/rclcpp.hpp"': False,
    '#undef NDEBUG\n#include "rclcpp/rclcpp.hpp"': False,
    '#ifdef A\n#include "rclcpp/rclcpp.hpp"\n#endif': False,
    '#pragma pack(1)\n#include "rclcpp/rclcpp.hpp"': False,
    'using A = int;\n#include "rclcpp/rclcpp.hpp"': False,
    '// as \\\n#include "rclcpp/rclcpp.hpp"': False,
    '#include "own/words.hpp"\n#include "rclcpp/rclcpp.hpp"': False,
    '#include "own/msg/word.hpp"\n#include "rclcpp/rclcpp.hpp"': False,
    '#include "rclcpp/node.hpp"': False,
}


@pytest.mark.parametrize("text", BEGINNINGS)
def test_only_where_it_comes_first(text: str, tmp_path: Path, ros: Path) -> None:
    for name, content in {**OWN, "main.cpp": text + "\n"}.items():
        file = tmp_path / name
        file.parent.mkdir(parents=True, exist_ok=True)
        file.write_text(content)
    tf2_ros = LIBRARY.parents[2] / "packages" / "tf2_ros" / "include"
    folders = [tmp_path, tf2_ros, LIBRARY, *sorted(ros.iterdir())]
    assert Reader(folders, ros).finds(tmp_path / "main.cpp") is BEGINNINGS[text]


@pytest.mark.parametrize(
    "words",
    [
        "-c a.cpp -include-pch theirs.pch",
        "-c a.cpp -include theirs.hpp",
        "-c a.cpp -Xclang -fmodules",
        "-c a.cpp b.cpp",
        "-E a.cpp",
        "-c @words",
        f"-I{LIBRARY} -c a.cpp",
    ],
)
def test_what_is_unusual_is_left_alone(words: str) -> None:
    assert Command.read(words.split()) is None
