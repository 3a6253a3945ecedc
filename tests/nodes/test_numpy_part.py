"""The part of numpy that comes with sitegen: its results are numpy's, and the build knows it."""

from __future__ import annotations

import io
import itertools
import math
import runpy
import subprocess
import sys
from pathlib import Path
from types import SimpleNamespace
from typing import Any

import numpy as np
import pytest
from browser import Serve
from playwright.sync_api import Browser

from sitegen.commands.build import build
from sitegen.nodes.python import arrays
from sitegen.report import Report
from sitegen.shipped import CLIENTS
from tests.native.test_rclpy import printed, run

# The module as pages have it, which imports nothing of theirs.
numbers: Any = SimpleNamespace(**runpy.run_path(str(CLIENTS / "numpy/numbers.py")))
VALUES = (
    *(0, 1, -1, 2, 7, -3, 0.0, -0.0, 0.5, -0.5, 1.0, 1.5, -2.25, 3.0, 1e-9, 180.0, 1e308, -1e308),
    *(math.inf, -math.inf, math.nan, math.pi),
)
SITE = """
site: {title: Test}
nodes:
  sums: {package: mine, executable: sums.py}
  small: {package: mine, executable: small.py}
pages:
  - path: /
    title: Test
    content: [buttons: sums, console: sums, buttons: small, console: small]
"""
FILES = {
    "package.xml": """<package format="3"><name>mine</name><version>1.0.0</version>
  <depend>rclpy</depend><depend>unique_identifier_msgs</depend>
  <export><build_type>ament_cmake</build_type></export></package>
""",
    "CMakeLists.txt": "project(mine)\n"
    "install(PROGRAMS sums.py small.py DESTINATION lib/${PROJECT_NAME})\n",
    "sums.py": """import sys
import numpy as np
angle = np.deg2rad(30.0)
print(f"{np.sin(angle):.6f}", np.clip(7, -1, 5), np.clip(0.5, -1, 1), np.sqrt(2.0) / 0.0)
print([np.arctan2(1.0, 1.0), np.sqrt(-1.0)], np.isnan(np.nan), np.hypot(3, 4) ** -0.5)
print(*(name for name in dir(sys.modules["numpy"]) if name[0] != "_"))
""",
    "small.py": """import numpy as np
from unique_identifier_msgs.msg import UUID
uuid = UUID(uuid=np.zeros(16, dtype=np.uint8)).uuid
print(uuid.dtype, len(UUID().uuid), np.array([1, 2], np.int32).dtype, np.array([1, 2]))
""",
}
OF_ONE = sorted(arrays.NUMBERS - arrays.CONSTANTS - {"arctan2", "clip", "hypot"})


def same(ours: object, theirs: object) -> bool:
    """Whether a number is numpy's: the same kind, sign and text, and the last digit at most off."""
    a, b = float(ours), float(theirs)  # type: ignore[arg-type]
    if isinstance(ours, bool | int) or isinstance(theirs, np.bool_ | np.integer):
        return a == b and isinstance(ours, int) and not isinstance(theirs, np.floating)
    if a != a or b != b:
        return a != a and b != b and repr(ours) == repr(theirs)
    near = a == b or abs(a - b) <= math.ulp(b)
    text = a != b or (repr(ours) == repr(theirs) and str(ours) == str(theirs))
    return near and text and math.copysign(1, a) == math.copysign(1, b)


@pytest.mark.parametrize("name", OF_ONE)
@pytest.mark.parametrize("value", VALUES)
@pytest.mark.filterwarnings("ignore::RuntimeWarning")
def test_functions_of_a_number_give_what_numpy_gives(name: str, value: float) -> None:
    for given in (value, float(value)):
        ours, theirs = getattr(numbers, name)(given), getattr(np, name)(given)
        assert same(ours, theirs), (ours, theirs)


@pytest.mark.parametrize("name", ["arctan2", "hypot"])
@pytest.mark.filterwarnings("ignore::RuntimeWarning")
def test_functions_of_two_numbers_give_what_numpy_gives(name: str) -> None:
    for pair in itertools.product(VALUES, repeat=2):
        ours, theirs = getattr(numbers, name)(*pair), getattr(np, name)(*pair)
        assert same(ours, theirs), (pair, ours, theirs)


def test_clip_gives_what_numpy_gives() -> None:
    for triple in itertools.product(VALUES, repeat=3):
        value, low, high = triple
        ours, theirs = numbers.clip(*triple), np.clip(value, low, high)
        assert same(ours, theirs), (triple, ours, theirs)


@pytest.mark.filterwarnings("ignore::RuntimeWarning")
def test_results_are_calculated_with_as_numpys() -> None:
    operations = {
        "+": lambda a, b: a + b,
        "-": lambda a, b: a - b,
        "*": lambda a, b: a * b,
        "/": lambda a, b: a / b,
        "//": lambda a, b: a // b,
        "%": lambda a, b: a % b,
        "**": lambda a, b: a**b,
    }
    floats = [float(value) for value in VALUES]
    for (name, operate), a, b in itertools.product(operations.items(), floats, floats):
        for left, right in ((True, False), (False, True), (True, True)):
            ours = operate(numbers.Number(a) if left else a, numbers.Number(b) if right else b)
            theirs = operate(np.float64(a) if left else a, np.float64(b) if right else b)
            assert same(ours, theirs), (a, name, b, ours, theirs)
    assert same(-numbers.Number(2), -np.float64(2)) and same(abs(numbers.Number(-2)), np.float64(2))
    assert f"{numbers.sin(0.5):.3f} {numbers.sin(0.5)}" == f"{np.sin(0.5):.3f} {np.sin(0.5)}"


@pytest.mark.parametrize("name", OF_ONE)
def test_what_is_no_number_is_refused_with_what_to_do(name: str) -> None:
    with pytest.raises(TypeError, match="'bool' is not a number"):
        getattr(numbers, name)(True)
    with pytest.raises(TypeError, match=r"'list' is not a number: .*'pyodide: packages'"):
        getattr(numbers, name)([1.0, 2.0])


def test_programs_of_pages_calculate_with_it(
    tmp_path: Path, browser: Browser, serve: Serve
) -> None:
    package = tmp_path / "src/mine"
    package.mkdir(parents=True)
    (tmp_path / "site.yaml").write_text(SITE)
    for name, text in FILES.items():
        (package / name).write_text(text)
    report = Report(io.StringIO())
    build(tmp_path, output=tmp_path / "dist", report=report)
    assert "mine/sums.py: no numpy; arrays do not support arithmetic" in report.said
    page = browser.new_page()
    page.goto(serve(tmp_path / "dist"))
    native = subprocess.run(
        [sys.executable, package / "sums.py"], capture_output=True, text=True, check=True
    )
    *calculated, names = printed(run(page, "sums")[1])
    assert calculated == native.stdout.splitlines()[:-1]
    assert set(names.split()) - {"numbers"} == arrays.NUMBERS | arrays.ARRAYS
    assert set(numbers.__all__) == arrays.NUMBERS
    assert set(dir(np)) >= arrays.NUMBERS | arrays.ARRAYS
    state, lines = run(page, "small")
    assert printed(lines) == ["uint8 16 int32 [1 2]"]
    assert state == "stopped"


@pytest.mark.parametrize(
    ("text", "enough"),
    [
        ("import numpy as np\nx = np.sin(np.pi / 2) + np.clip(3.0, -1, 1)", True),
        ("from numpy import deg2rad as r, inf\nx = min(r(90), inf)", True),
        ("import numpy\nx = numpy.zeros(9, dtype=numpy.float64)", True),
        ("import numpy as np\nx = np.array([0, 1.5], np.float32)", True),
        ("import numpy as np\nx = np.empty((4,))", True),
        # Names that it has, but not together, or for arrays.
        ("import numpy as np\nx = np.sin(np.array([1.0, 2.0]))", False),
        ("import numpy as np\nx = np.sin([1.0, 2.0])", False),
        ("import numpy as np\nx = np.clip([a for a in b], 0, 1)", False),
        ("import numpy as np\nx = np.clip(1, a_min=0, a_max=1)", False),
        ("import numpy as np\nx = np.sqrt(*values)", False),
        ("import numpy as np\nx = np.sqrt(2).round(2)", False),
        ("import numpy as np\nx = np.float64(2)", False),
        ("import numpy as np\nx = np.array([[1, 2], [3, 4]])", False),
        ("import numpy as np\nx = np.zeros((3, 3))", False),
        ("import numpy as np\nx = np.zeros(3, dtype=int)", False),
        ("import numpy as np\nx = np.array([1], dtype='float32')", False),
        ("import numpy as np\nx = np.array([1], copy=False)", False),
        ("import numpy as np\nx = np.linspace(0, 1)", False),
        ("import numpy.linalg", False),
    ],
)
def test_the_build_sees_which_programs_it_is_enough_for(
    tmp_path: Path, text: str, enough: bool
) -> None:
    file = tmp_path / "run.py"
    file.write_text(text)
    assert arrays.enough({"lib/mine/run.py": file}, "lib/mine/run.py") is enough
