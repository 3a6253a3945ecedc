"""What is compiled and what is not, and what is said when it fails."""

from __future__ import annotations

import io
import os
import re
import time
from pathlib import Path

import pytest
from packages import Workspace

from sitegen.build import Made, make
from sitegen.options import Options
from sitegen.report import Report


def test_what_changed_is_compiled_and_nothing_else(workspace: Workspace) -> None:
    workspace.package(
        "counts",
        """\
        find_package(rosidl_default_generators REQUIRED)
        rosidl_generate_interfaces(${PROJECT_NAME} "msg/Count.msg" "msg/Other.msg")
        """,
    )
    workspace.write("src/counts/msg/Count.msg", "int32 value\n")
    workspace.write("src/counts/msg/Other.msg", "int32 value\n")
    workspace.package(
        "pair",
        """\
        find_package(rclcpp REQUIRED)
        find_package(counts REQUIRED)
        include_directories(include)
        add_executable(one src/one.cpp)
        ament_target_dependencies(one rclcpp counts)
        add_executable(two src/two.cpp)
        """,
        depends="rclcpp counts",
    )
    workspace.write("src/pair/include/pair/name.hpp", '#define NAME "pair"\n')
    main = """\
        #include <cstdio>
        #include "pair/name.hpp"
        {}
        int main() {{std::puts(NAME);}}
        """
    one = main.format('#include "counts/msg/count.hpp"')
    workspace.write("src/pair/src/one.cpp", one)
    workspace.write("src/pair/src/two.cpp", main.format(""))
    workspace.site("pair/one", "pair/two")

    def build() -> set[str]:
        before = workspace.compiled()
        workspace.build()
        return workspace.changed(before)

    assert workspace.build() == ["counts", "pair/one", "pair/two"]
    logs = {log: log.stat().st_mtime_ns for log in workspace.cache.glob("**/.ninja_log")}
    assert workspace.build() == []
    assert {log: log.stat().st_mtime_ns for log in logs} == logs

    workspace.write("src/pair/src/one.cpp", one.replace("NAME)", 'NAME " one")'))
    assert build() == {"one.cpp.o"}
    workspace.write("src/pair/include/pair/name.hpp", '#define NAME "two"\n')
    assert build() == {"one.cpp.o", "two.cpp.o"}
    workspace.write("src/counts/msg/Other.msg", "int64 value\n")
    assert build() == set()
    workspace.write("src/counts/msg/Count.msg", "int64 value\n")
    assert build() == {"one.cpp.o"}

    # A change that is taken back is in the cache.
    workspace.write("src/counts/msg/Count.msg", "int32 value\n")
    workspace.write("src/counts/msg/Other.msg", "int64 value\n")
    assert workspace.build() == []

    # What was not used for long goes when something is compiled, and what was used stays.
    long_ago = time.time() - 61 * 24 * 3600
    for folder in (*workspace.cache.glob("nodes/*"), *workspace.cache.glob("work/*")):
        os.utime(folder, (long_ago, long_ago))
    assert workspace.build() == []
    workspace.write("src/pair/src/two.cpp", main.format("") + "\n")
    assert workspace.build() == ["counts", "pair/one", "pair/two"]
    assert len([*workspace.cache.glob("nodes/*")]) == 2
    assert len([*workspace.cache.glob("work/*")]) == 1

    # A message that is gone is not found in what was generated before.
    (workspace.folder / "src/counts/msg/Count.msg").unlink()
    workspace.package(
        "counts",
        """\
        find_package(rosidl_default_generators REQUIRED)
        rosidl_generate_interfaces(${PROJECT_NAME} "msg/Other.msg")
        """,
    )
    (problem,) = workspace.problems()
    assert problem == (
        "src/pair/src/one.cpp:3: 'pair' includes 'counts/msg/count.hpp', which was not found; "
        "package 'counts' has no such header"
    )


def wasm(made: Made, package: str, executable: str) -> bytes:
    """The WebAssembly of a program that is built for one engine."""
    found = (file.source for file in made.programs[package, executable].files)
    [file] = (each for each in found if isinstance(each, Path) and each.suffix == ".wasm")
    return file.read_bytes()


@pytest.mark.exhaustive
def test_a_draft_is_only_linked_otherwise(workspace: Workspace) -> None:
    workspace.package("quick", "add_executable(quick src/main.cpp)", main="int main() {}\n")
    workspace.site("quick/quick")
    said: list[str] = []

    def program(*, draft: bool) -> tuple[set[str], bytes]:
        before = workspace.compiled()
        out = io.StringIO()
        made = make(workspace.folder, Report(out), options=Options(draft=draft))
        said.append(out.getvalue())
        return workspace.changed(before), wasm(made, "quick", "quick")

    compiled, draft = program(draft=True)
    assert compiled == {"main.cpp.o"}
    assert "for publication" not in said[-1]
    compiled, published = program(draft=False)
    assert compiled == set()
    assert "optimizing 1 node for publication (up to half the size); " in said[-1]
    assert len(published) < len(draft)
    # What is there as it is published is no worse for whoever edits.
    assert program(draft=True) == (set(), published)

    workspace.write("src/quick/src/main.cpp", "int main() { return 0; }\n")
    compiled, again = program(draft=True)
    assert compiled == {"main.cpp.o"}
    assert len(again) > len(published)


@pytest.mark.exhaustive
def test_what_a_draft_left_behind_is_not_published(workspace: Workspace) -> None:
    main = "int main() {}\n"
    both = "add_executable(one src/main.cpp)\nadd_executable(two src/main.cpp)"
    workspace.package("part", both, main=main)
    workspace.package(
        "whole",
        "find_package(part REQUIRED)\nadd_executable(whole src/main.cpp)",
        depends="part",
        main=main,
    )
    workspace.site("part/one", "whole/whole")
    workspace.build()  # for which `part` is prepared
    workspace.site("part/one", "part/two", "whole/whole")

    def size(*, draft: bool) -> int:
        made = make(workspace.folder, Report(io.StringIO()), options=Options(draft=draft))
        return len(wasm(made, "part", "two"))

    assert size(draft=True) > size(draft=False)


def test_all_problems_are_told_at_once_and_the_old_site_stays(workspace: Workspace) -> None:
    workspace.package("fine", "add_executable(fine src/main.cpp)", main="int main() {}\n")
    # What needs no OpenCV runs beside what does.
    workspace.package(
        "half_vision",
        """\
        find_package(OpenCV REQUIRED COMPONENTS core imgproc)
        add_executable(seeing src/main.cpp)
        target_link_libraries(seeing ${OpenCV_LIBRARIES})
        add_executable(blind src/blind.cpp)
        """,
        main='#include "opencv2/core.hpp"\nint main() {}\n',
    )
    workspace.write("src/half_vision/src/blind.cpp", "int main() {}\n")
    workspace.site("fine/fine", "half_vision/blind")
    workspace.build()
    dist = workspace.folder / "dist"
    before = {file: file.read_bytes() for file in dist.rglob("*") if file.is_file()}

    workspace.package(
        "wrong_source",
        "add_executable(wrong src/main.cpp)",
        main="""\
        int main()
        {
          int number = "text";
        }
        """,
    )
    workspace.package(
        "wrong_link",
        "add_executable(wrong src/main.cpp)",
        main="void missing_part();\nint main() {missing_part();}\n",
    )
    workspace.package("wrong_need", "find_package(Arm3D REQUIRED)\nadd_executable(wrong a.cpp)")
    workspace.package(
        "wrong_cmake",
        'message(FATAL_ERROR "this robot has no wheels")\nadd_executable(wrong a.cpp)',
    )
    workspace.package(
        "wrong_name",
        "find_package(rmw_other_cpp QUIET)\nadd_executable(${PROJECT_NAME}${SUFFIX} src/main.cpp)",
        main="int main() {}\n",
    )
    names = ("source", "link", "need", "cmake", "name")
    wrong = [f"wrong_{name}/wrong" for name in names]
    workspace.site("fine/fine", *wrong, "half_vision/seeing")

    source, link, need, cmake, name, vision = workspace.problems()
    assert source.splitlines() == [
        "src/wrong_source/src/main.cpp:3:7: could not compile: cannot initialize a variable of type"
        " 'int' with an lvalue of type 'const char[5]' (package 'wrong_source')",
        "src/wrong_source/src/main.cpp:3:7: error: cannot initialize a variable of type 'int' with"
        " an lvalue of type 'const char[5]'",
        '  int number = "text";',
        "      ^        ~~~~~~",
        "1 error generated.",
    ]
    first, *rest = link.splitlines()
    assert first == (
        "src/wrong_link/CMakeLists.txt: could not link 'wrong': undefined symbol: missing_part()"
        " (package 'wrong_link')"
    )
    assert [re.sub(r"^wasm-ld\S*: ", "", line) for line in rest] == [
        "error: CMakeFiles/wrong.dir/src/main.cpp.o: undefined symbol: missing_part()"
    ]
    assert need == (
        "src/wrong_need/CMakeLists.txt: 'wrong_need' needs 'Arm3D', which has no build for the page"
    )
    assert vision == (
        "src/half_vision/CMakeLists.txt: 'half_vision' needs 'OpenCV', "
        "which has no build for the page"
    )
    assert cmake.splitlines() == [
        "src/wrong_cmake/CMakeLists.txt: CMake failed",
        "CMake Error at CMakeLists.txt:4 (message):",
        "  this robot has no wheels",
    ]
    assert name == (
        "src/wrong_name/CMakeLists.txt: package 'wrong_name' has no executable 'wrong' "
        "without 'rmw_other_cpp', which has no build for the page"
    )
    assert {file: file.read_bytes() for file in dist.rglob("*") if file.is_file()} == before


def test_wrong_definitions_are_told_by_file_and_line(workspace: Workspace) -> None:
    files = {
        "msg/Type.msg": "# A speed\n\nfloat speed\n",
        "msg/Name.msg": "int32 ok\nint32 notOk\n",
        "msg/Value.msg": "uint8 small 256\n",
        "msg/Constant.msg": "int8 A=1\nint8 b=2\n",
        "msg/Twice.msg": "int8 one\nint8 two\nint8 one\n",
        "msg/Alone.msg": "int32\n",
        "msg/Unknown.msg": "std_msgs/Header header\nWhel wheel\nstd_msgs/Sting text\nno_msgs/A a\n",
        "msg/Former.msg": "time stamp\n",
        "msg/Twins.idl": "module wrong_msgs {\n  module msg {\n    struct Twins {\n    int x\n",
        "srv/Half.srv": "int32 a\n",
        "srv/Whole.srv": "int32 a\n---\nint32 b\nstrin c\n",
        "action/Long.action": "---\n---\nint8 x\n---\n",
    }
    for name, text in files.items():
        workspace.write(f"src/wrong_msgs/{name}", text)
    names = " ".join(f'"{name}"' for name in [*files, "msg/Nam.msg"])
    generate = f"rosidl_generate_interfaces(${{PROJECT_NAME}} {names})"
    workspace.package(
        "wrong_msgs",
        f"find_package(rosidl_default_generators REQUIRED)\n{generate}",
        depends="std_msgs",
    )
    workspace.package(
        "user",
        "find_package(wrong_msgs REQUIRED)\nadd_executable(user src/main.cpp)",
        depends="wrong_msgs",
    )
    workspace.site("user/user")
    found = [line.removeprefix("src/wrong_msgs/") for line in workspace.problems()]
    assert found == [
        "msg/Type.msg:3: no type 'float'; did you mean 'float64'?",
        "msg/Name.msg:2: 'notOk' is an invalid field name; write it like wheel_speed",
        "msg/Value.msg:1: value '256' can not be converted to type 'uint8': must be a "
        "valid integer value >= 0 and <= 255",
        "msg/Constant.msg:2: 'b' is an invalid constant name; write it like WHEEL_SPEED",
        "msg/Twice.msg:3: more than one field named 'one'",
        "msg/Alone.msg:1: 'int32' is not a valid field; write a type and a name",
        "msg/Unknown.msg:2: package 'wrong_msgs' has no message 'Whel'; known: Alone, "
        "Constant, Former, Nam, Name, Twice, Twins, Type, Unknown, Value",
        "msg/Unknown.msg:3: package 'std_msgs' has no message 'Sting'; did you mean 'String'?",
        "msg/Unknown.msg:4: no package 'no_msgs' with interfaces; did you mean "
        "'nav_msgs'? (package.xml must list it)",
        "msg/Former.msg:1: 'time' is builtin_interfaces/Time now",
        "msg/Twins.idl:4: unexpected end of file",
        "srv/Half.srv:1: service needs 1 line '---', found 0",
        "srv/Whole.srv:4: no type 'strin'; did you mean 'string'?",
        "action/Long.action:4: action needs 2 lines '---', found 3",
        "CMakeLists.txt: rosidl_generate_interfaces() lists 'msg/Nam.msg', which does "
        "not exist; did you mean 'msg/Name.msg'?",
    ]


def test_a_missing_compiler_is_told_with_who_needs_it(
    workspace: Workspace, monkeypatch: pytest.MonkeyPatch
) -> None:
    workspace.package("fine", "add_executable(fine src/main.cpp)", main="int main() {}\n")
    workspace.site("fine/fine")
    monkeypatch.setenv("PATH", str(workspace.folder))
    assert workspace.problems() == [
        "em++ not found (apt-get install emscripten, or see emscripten.org): "
        "needed for the C++ nodes of 'fine'"
    ]
