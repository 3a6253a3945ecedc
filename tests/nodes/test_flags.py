"""Options of other compilers, which packages give to theirs."""

from __future__ import annotations

import pytest
from packages import Workspace

from sitegen.nodes.cpp.flags import translated


@pytest.mark.parametrize(
    ("given", "expected"),
    [
        ("em++ -O2 -Og -Ofast -O3", "em++ -O2 -O1 -O3 -ffast-math -O3"),
        ("-std=c++20 -std=c++23 -std=gnu++23", "-std=c++20 -std=c++2b -std=gnu++2b"),
        ("-march=native -mtune=native -mavx2 -msse4.2 -mfpu=neon -m64 -mfma -c", "-c"),
        ("-msimd128 -msse4.2 -mavx", "-msimd128 -msse4.2 -mavx"),
        ("-mvectors -msse4.2 -mavx", "-msimd128"),
        ("-mllvm -disable-lsr -mbulk-memory", "-mllvm -disable-lsr -mbulk-memory"),
        ("-Werror -Werror=return-type -Wall -pedantic-errors -fcf-protection=full", "-Wall"),
        ("-lstdc++fs -latomic -lm -lmine -lgcc_s", "-lm -lmine"),
        ("-Wl,--no-undefined -Wl,--as-needed,-z,now -Wl,--exclude-libs,ALL", "-Wl,-z,now"),
        ("-Wl,--build-id=none,--hash-style=gnu -Wl,--disable-new-dtags -Wl,-Bsymbolic", ""),
        (
            "-Wl,--whole-archive,a.a,--no-whole-archive",
            "-Wl,--whole-archive,a.a,--no-whole-archive",
        ),
        ("-Wl,--wrap=abort -Wl,--stack-first", "-Wl,--wrap=abort -Wl,--stack-first"),
        ("-Wl,--undefined=main -Wl,-u,main", "-Wl,--undefined=main -Wl,-u,main"),
        ("-DNAME=-Og -o -fconcepts x.cpp -I -S", "-DNAME=-Og -o -fconcepts x.cpp -I -S"),
    ],
)
def test_options_that_pages_cannot_have_are_left_out(given: str, expected: str) -> None:
    assert [*translated(given.split())] == expected.split()


def test_a_package_with_options_of_gcc_is_built(workspace: Workspace) -> None:
    workspace.package(
        "tuned",
        """\
        find_package(rclcpp REQUIRED)
        set(CMAKE_CXX_FLAGS "${CMAKE_CXX_FLAGS} -Og -march=native -msse4.2 -fno-gnu-unique")
        set(CMAKE_C_FLAGS "${CMAKE_C_FLAGS} -Ofast -mavx2 -fno-ipa-icf")
        set(CMAKE_EXE_LINKER_FLAGS "-Wl,--no-as-needed -Wl,--no-undefined")
        add_compile_options(-fconcepts -fvar-tracking -finline-limit=1000 -fext-numeric-literals)
        add_executable(tuned src/main.cpp src/part.c)
        target_link_libraries(tuned stdc++fs atomic)
        ament_target_dependencies(tuned rclcpp)
        """,
        depends="rclcpp",
        main="""\
        #include <rclcpp/rclcpp.hpp>
        extern "C" int part();
        int main(int argc, char ** argv) {
          rclcpp::init(argc, argv);
          return part();
        }
        """,
    )
    workspace.write("src/tuned/src/part.c", "int part(void) { return 0; }\n")
    workspace.site("tuned/tuned")
    assert workspace.build() == ["tuned/tuned"]


def test_other_options_are_errors(workspace: Workspace) -> None:
    workspace.package(
        "wrong",
        """\
        add_compile_options(-std=fortran -fconcepts)
        add_executable(wrong src/main.cpp)
        """,
        main="int main() {}",
    )
    workspace.site("wrong/wrong")
    [problem] = workspace.problems()
    assert "invalid value 'fortran' in '-std=fortran'" in problem
    assert "flags.py" not in problem
