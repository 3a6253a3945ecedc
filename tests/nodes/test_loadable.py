"""Programs that open libraries by name: which they are linked with, and their object files."""

from __future__ import annotations

import subprocess
from pathlib import Path

import pytest
from configuring import Configuring
from packages import Workspace

from sitegen.nodes.cpp.loadable import read_libraries
from sitegen.nodes.cpp.objectfile import Object
from sitegen.nodes.cpp.toolchain import Toolchain

OPENS = '#include <dlfcn.h>\nint main() { return dlopen("libpart.so", RTLD_NOW) == nullptr; }\n'
SYMBOLS = """\
#include <cstdint>
int inside();
extern "C" {
int outside(void *);
int counter = 3;
int64_t twice(float a, double b) {return a * b;}
void nothing(const char *, int64_t) {}
int calls() {return outside(&counter) + inside();}
static int own() {return counter;}
__attribute__((visibility("hidden"))) int hidden() {return own();}
__attribute__((weak)) int weak() {return hidden();}
inline int in_header() {return 1;}
int __reserved() {return weak() + in_header();}
int main() {return __reserved();}
}
int in_cpp() {return 1;}
"""


def compiled(folder: Path, name: str, text: str) -> Path:
    """Compile a source and return the object file."""
    source = folder / f"{name}.cpp"
    source.write_text(text)
    made = source.with_suffix(".o")
    subprocess.run([Toolchain.find().compiler, "-c", source, "-o", made], check=True)
    return made


def symbols(folder: Path, data: bytes) -> set[str]:
    """Return the symbols of an object file, each with its kind as `nm` tells it."""
    file = folder / "symbols.o"
    file.write_bytes(data)
    nm = Path(Toolchain.find().compiler).with_name("emnm")
    said = subprocess.run([nm, file], check=True, text=True, stdout=subprocess.PIPE).stdout
    return {" ".join(line.split()[-2:]) for line in said.splitlines()}


def test_functions_and_variables_of_c_are_declared(tmp_path: Path) -> None:
    found = Object(compiled(tmp_path, "part", SYMBOLS).read_bytes(), "libpart.so")
    assert found.declared == {
        b"counter": "extern char %s",
        b"twice": "long long %s(float, double)",
        b"nothing": "void %s(int, long long)",
        b"calls": "int %s()",
    }
    assert {b"_Z6in_cppv", b"__reserved"} < found.names


def test_names_of_the_library_take_the_place_of_others(tmp_path: Path) -> None:
    before = compiled(tmp_path, "part", SYMBOLS).read_bytes()
    found = Object(before, "libpart.so")
    after = symbols(tmp_path, found.renamed({b"calls", b"counter", b"outside", b"hidden"}))
    changed = {"T calls", "D counter", "U outside"}
    assert symbols(tmp_path, before) - after == changed
    assert after - symbols(tmp_path, before) == {
        *("T calls@libpart.so", "D counter@libpart.so", "U outside@libpart.so"),
        *("W calls", "W counter"),
    }


def test_what_is_no_object_file_has_no_names() -> None:
    assert Object(b"BC\xc0\xde", "libpart.so").names == set()


def test_libraries_with_equal_names_have_labels_of_their_own(tmp_path: Path) -> None:
    paths = [tmp_path / "one" / "libpart.a", tmp_path / "two" / "libpart.a"]
    for path in paths:
        path.parent.mkdir()
        path.write_bytes(b"!<arch>\n")
    labels = [library.label for library in read_libraries([*paths, *paths])]
    assert labels == ["libpart.so", "libpart.1.so"]


@pytest.mark.parametrize(
    ("main", "linked"), [(OPENS, True), ("int main() {} // dlopened", False)], ids=["opens", "not"]
)
def test_programs_that_open_libraries_are_linked_with_them(
    packages: Configuring, main: str, linked: bool
) -> None:
    """They may stand after ament_package()."""
    packages.package(
        "parts",
        """\
cmake_minimum_required(VERSION 3.8)
project(parts)
find_package(ament_cmake REQUIRED)
add_library(part SHARED src/part.cpp)
add_executable(main src/main.cpp)
ament_package()
add_library(used SHARED src/part.cpp)
add_library(more MODULE src/part.cpp)
target_link_libraries(part used)
""",
        main=main,
    )
    packages.write("parts/src/part.cpp", "int part() {return 1;}\n")
    assert packages.configure("parts") == ""
    [rule] = [
        block
        for block in (packages.tree("parts") / "build.ninja").read_text().split("\n\n")
        if block.startswith("build bin/main.js:")
    ]
    found = ("libpart.a" in rule, "libmore.a" in rule)
    assert found == (linked, linked)


@pytest.mark.parametrize("is_long", [False, True])
def test_libraries_with_copies_of_a_source_are_linked(workspace: Workspace, is_long: bool) -> None:
    """Each has other definitions, so the source is compiled for all, and one is not opened."""
    # CMake writes a command that would be too long to a file.
    force = "set(CMAKE_NINJA_FORCE_RESPONSE_FILE ON)" if is_long else ""
    workspace.package(
        "parts",
        f"""\
        {force}
        add_library(one SHARED src/part.cpp)
        target_compile_definitions(one PRIVATE NAME="one")
        add_library(two SHARED src/part.cpp)
        target_compile_definitions(two PRIVATE NAME="two")
        add_library(common STATIC src/part.cpp)
        target_compile_definitions(common PRIVATE NAME="common")
        add_executable(main src/main.cpp)
        target_link_libraries(main common)
        """,
        main=f'void say(const char *);\nstatic int done = (say("begin"), 0);\n{OPENS}',
    )
    workspace.write(
        "src/parts/src/part.cpp",
        """\
        #include <cstdio>
        void say(const char * text) {std::puts(text);}
        extern "C" void part() {say("this is " NAME);}
        """,
    )
    workspace.site("parts/main")
    workspace.build()
    [program] = (workspace.folder / "dist").rglob("main*.wasm")
    content = program.read_bytes()
    assert b"this is one" in content
    assert b"this is two" in content


@pytest.mark.parametrize("is_long", [False, True])
def test_libraries_with_copies_of_a_function_are_linked(
    workspace: Workspace, is_long: bool
) -> None:
    """As shared libraries, each has its own, such as one in a header that is not inline."""
    force = "set(CMAKE_NINJA_FORCE_RESPONSE_FILE ON)" if is_long else ""
    workspace.package(
        "parts",
        f"""\
        {force}
        add_library(one SHARED src/one.cpp)
        add_library(two SHARED src/two.cpp)
        add_executable(main src/main.cpp)
        target_link_libraries(main -Wl,--whole-archive one -Wl,--no-whole-archive two)
        """,
        main="int one();\nint two();\nint main() {return one() + two();}\n",
    )
    workspace.write(
        "src/parts/src/check.hpp", "bool check(int x) {return x > 0;}\nint calls = 0;\n"
    )
    for name in ("one", "two"):
        workspace.write(
            f"src/parts/src/{name}.cpp",
            f'#include "check.hpp"\nint {name}() {{return check(++calls);}}\n',
        )
    workspace.site("parts/main")
    assert workspace.build() == ["parts/main"]


def test_two_sources_of_a_program_with_one_function_are_an_error(workspace: Workspace) -> None:
    workspace.package(
        "parts", "add_executable(main src/main.cpp src/part.cpp)\n", main="int main() {return 0;}\n"
    )
    workspace.write("src/parts/src/part.cpp", "int main() {return 1;}\n")
    workspace.site("parts/main")
    [problem] = workspace.problems()
    assert "duplicate symbol: main" in problem
