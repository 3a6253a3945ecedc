"""The part of numpy that comes with sitegen: its results are numpy's, and the build knows it."""

from __future__ import annotations

import ast
import importlib
import io
import itertools
import math
import random
import runpy
import subprocess
import sys
from collections.abc import Callable
from pathlib import Path
from types import ModuleType, SimpleNamespace
from typing import Any

import numpy as np
import pytest
from browser import Serve
from playwright.sync_api import Browser

from sitegen.commands.build import build
from sitegen.nodes.python import arrays
from sitegen.report import Report
from sitegen.shipped import CLIENTS, PACKAGES
from tests.native.test_rclpy import printed, run

# The modules as pages have them, without what these import of theirs.
numbers: Any = SimpleNamespace(**runpy.run_path(str(CLIENTS / "numpy/numbers.py")))
part = ModuleType("part")
part.__path__ = [str(CLIENTS / "numpy")]
sys.modules["part"] = part
matrices: Any = importlib.import_module("part.matrices")
TRANSFORMS = PACKAGES / "tf_transformations/tf_transformations"
VALUES = (
    *(0, 1, -1, 2, 7, -3, 0.0, -0.0, 0.5, -0.5, 1.0, 1.5, -2.25, 3.0, 1e-9, 180.0, 1e308, -1e308),
    *(math.inf, -math.inf, math.nan, math.pi),
)
SITE = """
site: {title: Test}
nodes:
  sums: {package: mine, executable: sums.py}
  small: {package: mine, executable: small.py}
  turns: {package: mine, executable: turns.py}
  alone: {package: mine, executable: alone.py}
pages:
  - path: /
    title: Test
    content:
      - buttons: sums
      - console: sums
      - buttons: small
      - console: small
      - buttons: turns
      - console: turns
      - buttons: alone
      - console: alone
"""
FILES = {
    "package.xml": """<package format="3"><name>mine</name><version>1.0.0</version>
  <depend>rclpy</depend><depend>unique_identifier_msgs</depend><depend>tf_transformations</depend>
  <export><build_type>ament_cmake</build_type></export></package>
""",
    "CMakeLists.txt": "project(mine)\n"
    "install(PROGRAMS sums.py small.py turns.py alone.py DESTINATION lib/${PROJECT_NAME})\n",
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
print(np.array([1] * 2, dtype=uuid.dtype).dtype, isinstance(1.5, np.number))
""",
    "turns.py": """import numpy as np
import tf_transformations as tf
turn = tf.quaternion_matrix(tf.quaternion_from_euler(0.1, 0, np.deg2rad(30)))
pose = np.eye(4)
pose[:3, :3] = turn[:3, :3]
pose[0, 3] = 2.5
print(pose)
print(repr(np.dot(pose, pose)), pose[:3, 3].tolist(), pose.shape)
print(tf.concatenate_matrices(turn, pose)[1], 2 * turn[0] - 1)
""",
    "alone.py": """from tf_transformations import euler_from_matrix, euler_matrix
print([round(angle, 9) for angle in euler_from_matrix(euler_matrix(0.5, -0.25, 1.5))])
""",
}
# Text that numpy writes with and without exponents, on one line and on several.
SHAPES = ((3,), (4, 4), (3, 3), (6, 6), (2, 8), (9,), (1, 1), (30,))
NUMBERS: tuple[Callable[[random.Random], float], ...] = (
    lambda of: of.uniform(-1, 1),
    lambda of: of.choice([0.0, 1.0, -1.0]),
    lambda of: of.uniform(-1, 1) * 10.0 ** of.randint(-160, 160),
    lambda of: of.uniform(-1, 1) * 10.0 ** of.randint(-9, 9),
    lambda of: round(of.uniform(-200, 200), 2),
    lambda of: of.choice([0.0, -0.0, 6.123e-17, 1.0]),
    lambda of: of.choice([math.inf, math.nan, -math.inf, 1.5, 2.25]),
    lambda of: float(of.randint(-1000, 1000)),
)
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


def test_matrices_are_written_as_numpy_writes_them() -> None:
    chosen = random.Random(1)
    for shape, number in itertools.product(SHAPES, NUMBERS):
        for _ in range(20):
            theirs = np.array([number(chosen) for _ in range(math.prod(shape))]).reshape(shape)
            ours = matrices.matrix_of(theirs.tolist())
            assert (str(ours), repr(ours)) == (str(theirs), repr(theirs))


CALCULATED: tuple[Callable[[Any, Any, Any], Any], ...] = (
    lambda np, a, b: a @ b,
    lambda np, a, b: np.dot(a, b[:, 1]),
    lambda np, a, b: a[0] @ b,
    lambda np, a, b: a[2] @ b[:, 1],
    lambda np, a, b: np.matmul(a, np.eye(4)) - np.identity(4),
    lambda np, a, b: np.eye(2, 4) @ a,
    lambda np, a, b: (2 * a + 1 - b / 4) * a[3],
    lambda np, a, b: -a.T[1:, :2] + [[1, 2], [3, 4], [5, 6]],
    lambda np, a, b: np.dot(a, 2) * 3.0,
    lambda np, a, b: np.dot(a, [1.0, 2.0, 3.0, 1.0]),
    lambda np, a, b: np.dot((1, 2, 3, 1), a) + a.dot([1, 0, 0, 2]),
    lambda np, a, b: a @ [1, 2, 3, 1],
    lambda np, a, b: [[1, 2, 3, 4]] @ b,
    lambda np, a, b: np.matmul([1, 2, 3, 1], [b[0, 0], 1, 1, 1]),
    lambda np, a, b: a.copy().dot(b).transpose()[::-1, ::2],
    lambda np, a, b: 1 - a[-1, -1] * b[0][1],
    lambda np, a, b: list(a[1]) + a[2:].tolist() + [a.shape, a[0].shape, a.ndim, a.size, len(b)],
    lambda np, a, b: [row[3] for row in a],
)


@pytest.mark.parametrize("calculated", CALCULATED)
def test_matrices_give_what_numpy_gives(calculated: Callable[[Any, Any, Any], Any]) -> None:
    first = [[(7 * i + j * j) / 4 for j in range(4)] for i in range(4)]
    second = [[math.sin(4 * i + j) for j in range(4)] for i in range(4)]
    ours = calculated(matrices, matrices.matrix_of(first), matrices.matrix_of(second))
    theirs = calculated(np, np.array(first), np.array(second))
    assert str(ours) == str(theirs)


def test_slices_of_matrices_are_views() -> None:
    for module in (matrices, np):
        whole: Any = module.eye(4)
        whole[:3, 3] = [1, 2, 3]
        corner = whole[:3, :3]
        corner[1] = 7
        corner *= 2
        whole.T[3][0] = 0.5
        whole[3] = whole[0]
        whole[0, 1:3] = corner[2, :2]
        assert whole.tolist() == [[2, 0, 0, 0.5], [14, 14, 14, 2], [0, 0, 2, 3], [2, 0, 0, 0.5]]


@pytest.mark.parametrize(
    "wrong",
    [
        lambda np, a: a[4, 0],
        lambda np, a: a[0, 0, 0],
        lambda np, a: a @ np.eye(3),
        lambda np, a: a + np.eye(3),
        lambda np, a: a.__setitem__((slice(3), 0), [1, 2]),
        lambda np, a: bool(a),
        lambda np, a: hash(a),
    ],
)
def test_what_numpy_refuses_is_refused(wrong: Callable[[Any, Any], Any]) -> None:
    with pytest.raises((IndexError, ValueError, TypeError)) as theirs:
        wrong(np, np.eye(4))
    with pytest.raises(theirs.type):
        wrong(matrices, matrices.eye(4))


@pytest.mark.parametrize(
    "wrong",
    [
        lambda a: a.sum(),
        lambda a: a[[0, 1]],
        lambda a: a[a],
        lambda a: a == a,
        lambda a: a < 1,
        lambda a: a @ 2,
        lambda a: a + "1",
        lambda a: a + a[:, :1],
    ],
)
def test_what_matrices_lack_is_told_with_what_to_do(wrong: Callable[[Any], Any]) -> None:
    with pytest.raises((AttributeError, TypeError, ValueError), match="'pyodide: packages'"):
        wrong(matrices.eye(4))


def test_transforms_are_the_same_with_numpy_and_without(monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.syspath_prepend(str(TRANSFORMS.parent))
    found = []
    for module in (matrices, np):
        monkeypatch.setitem(sys.modules, "numpy", module)
        for name in ("tf_transformations", "tf_transformations.matrices"):
            monkeypatch.delitem(sys.modules, name, raising=False)
        tf: Any = importlib.import_module("tf_transformations")
        said = []
        for angles in itertools.product((0.0, 0.5, -1.25, 3.0), repeat=3):
            pose = tf.euler_matrix(*angles)
            again = tf.euler_matrix(*tf.euler_from_matrix(pose))
            assert tf.is_same_transform(again, pose)
            pose[:3, 3] = (1, -2, 0.5)
            there = tf.concatenate_matrices(
                tf.translation_matrix([1, -2, 0.5]),
                tf.quaternion_matrix([3 * value for value in tf.quaternion_from_matrix(pose)]),
            )
            assert tf.is_same_transform(there, pose)
            assert not tf.is_same_transform(there, tf.identity_matrix())
            back = tf.concatenate_matrices(pose, tf.inverse_matrix(pose))
            assert tf.is_same_transform(back, tf.identity_matrix())
            about = tf.rotation_matrix(angles[0], [0, 0, 2], [1, 1, 0])
            said.append([str(pose), str(there), str(about), str(tf.translation_from_matrix(pose))])
        with pytest.raises(ValueError, match="no inverse"):
            tf.inverse_matrix(tf.euler_matrix(0, 0, 0) * 0)
        with pytest.raises(AttributeError, match="'random_vector'"):
            tf.random_vector  # noqa: B018
        assert tf.OF_MATRICES == arrays.OF_TRANSFORMS
        found.append(said)
    assert found[0] == found[1]
    tree = ast.parse((TRANSFORMS / "matrices.py").read_text())
    functions = {node.name for node in tree.body if isinstance(node, ast.FunctionDef)}
    assert functions - {"_matrix"} == arrays.OF_TRANSFORMS


def natively(program: Path) -> list[str]:
    """Return what a program prints with numpy."""
    done = subprocess.run(
        [sys.executable, program],
        env={"PYTHONPATH": str(TRANSFORMS.parent)},
        capture_output=True,
        text=True,
        check=True,
    )
    return done.stdout.splitlines()


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
    for name in FILES:
        part = f"mine/{name}: no numpy, but the part of it that comes with sitegen"
        assert (part in report.said) is name.endswith(".py")
    page = browser.new_page()
    page.goto(serve(tmp_path / "dist"))
    *calculated, names = printed(run(page, "sums")[1])
    assert calculated == natively(package / "sums.py")[:-1]
    own = {"matrices", "numbers", "printing"}
    assert set(names.split()) - own == arrays.MATRICES | arrays.ARRAYS
    assert set(numbers.__all__) == arrays.NUMBERS
    assert printed(run(page, "turns")[1]) == natively(package / "turns.py")
    assert printed(run(page, "alone")[1]) == ["[0.5, -0.25, 1.5]"]
    assert set(dir(np)) >= arrays.MATRICES | arrays.ARRAYS
    state, lines = run(page, "small")
    assert printed(lines) == ["uint8 16 int32 [1 2]", "uint8 False"]
    assert state == "stopped"


@pytest.mark.parametrize(
    ("text", "enough"),
    [
        ("import numpy as np\nx = np.sin(np.pi / 2) + np.clip(3.0, -1, 1)", True),
        ("from numpy import deg2rad as r, inf\nx = min(r(90), inf)", True),
        ("import numpy\nx = numpy.zeros(9, dtype=numpy.float64)", True),
        ("import numpy as np\nx = np.array([0, 1.5], np.float32)", True),
        ("import numpy as np\nx = np.empty((4,))", True),
        ("import numpy as np\nx = isinstance(1, np.number)", True),
        ("import numpy as np\nx = np.array(values, dtype=field.dtype)", True),
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
        ("import numpy as np\nx = np.eye(4) @ np.identity(4)\nx[:3, 3] = np.sin(1.0)", True),
        ("import numpy as np\nx = np.eye(4, dtype=int)", False),
        ("import numpy as np\nx = np.eye(4).trace()", False),
        ("import numpy as np\nx = np.dot([1, 2], [3, 4])", False),
        ("import numpy as np\nx = np.eye(3) + np.array([1, 2, 3])", False),
    ],
)
def test_the_build_sees_which_programs_it_is_enough_for(
    tmp_path: Path, text: str, enough: bool
) -> None:
    file = tmp_path / "run.py"
    file.write_text(text)
    assert arrays.enough({"lib/mine/run.py": file}, "lib/mine/run.py") is enough
