"""Headers that g++ and Linux have, and that sitegen adds to those of the compiler."""

from __future__ import annotations

import pytest
from configuring import Configuring

from sitegen.workspace.libraries import of_header

PROGRAMS = {
    "bits/stdc++.h": "int main() {std::vector<std::string> v; std::sort(v.begin(), v.end());}",
    "error.h": 'int main() {error(0, 2, "%d", 1);}',
    "execinfo.h": "int main() {void * all[1]; return backtrace(all, 1);}",
    "execution": "static_assert(std::is_execution_policy_v<std::execution::parallel_policy>);"
    "int main() {int a[] = {2, 1}; std::sort(std::execution::par, a, a + 2, std::greater<>());}",
    "linux/limits.h": "static_assert(PATH_MAX == 4096);int main() {}",
    "linux/serial.h": "#include <sys/ioctl.h>\nint main() {serial_struct port;"
    "if (ioctl(0, TIOCGSERIAL, &port)) {return 1;} port.flags |= ASYNC_LOW_LATENCY;"
    "serial_rs485 bus{}; bus.flags = SER_RS485_ENABLED; return ioctl(0, TIOCSRS485, &bus);}",
    "linux/types.h": "static_assert(sizeof(__u16) == 2 && sizeof(__le64) == 8);int main() {}",
    "malloc.h": "int main() {return mallopt(M_MMAP_MAX, 0);}",
    "source_location": "constexpr auto here = std::source_location::current();"
    "static_assert(here.line() == 2);int main() {}",
    "sys/random.h": "int main() {char one; return getrandom(&one, 1, 0);}",
    "sys/syscall.h": "int main() {return syscall(SYS_gettid);}",
}


@pytest.mark.parametrize("header", PROGRAMS)
@pytest.mark.parametrize("version", [17, 20])
def test_each_compiles_by_itself(packages: Configuring, header: str, version: int) -> None:
    if header == "source_location" and version < 20:
        pytest.skip("it is of C++20")
    packages.package(
        "one",
        f"set(CMAKE_CXX_STANDARD {version})\nadd_compile_options(-Wall -Wextra -Werror)\n"
        "add_executable(one src/main.cpp)",
        main=f"#include <{header}>\n{PROGRAMS[header]}\n",
    )
    assert packages.configure("one") == ""
    assert packages.compile("one", "one") == ""


def test_of_linux_only_the_headers_of_devices_are_absent() -> None:
    assert of_header("linux/limits.h") is of_header("linux/serial.h") is None
    for header in ("linux/joystick.h", "linux/can/raw.h", "libudev.h", "gpiod.hpp"):
        library = of_header(header)
        assert library and library.name == "Linux drivers"


@pytest.mark.parametrize("header", ["linux/joystick.h", "bluetooth/bluetooth.h"])
def test_a_program_of_a_device_needs_its_driver(packages: Configuring, header: str) -> None:
    packages.package(
        "one", "add_executable(one src/main.cpp)", main=f"#include <{header}>\nint main() {{}}\n"
    )
    assert packages.configure("one") == ""
    [line] = packages.lacking("one", "one")
    assert line == (
        "one/CMakeLists.txt: 'one' needs 'Linux drivers', which has no build for the page"
    )


def test_packages_of_gazebo_are_found_and_empty(packages: Configuring) -> None:
    packages.package(
        "one",
        "".join(
            f"find_package({name} REQUIRED)\n"
            for name in ("ros_gz_sim", "gz_math_vendor", "gz-math", "gz-sim8", "sdformat_vendor")
        )
        + "add_executable(one src/main.cpp)\ntarget_link_libraries(one gz-sim8::gz-sim8)",
    )
    assert packages.configure("one") == ""
    assert packages.compile("one", "one") == ""
