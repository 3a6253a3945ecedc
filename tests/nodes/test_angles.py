"""The module `angles`; tests/sites/shapes has a program that uses the header."""

from __future__ import annotations

import importlib.util
from math import isclose, pi
from types import ModuleType

import pytest

from sitegen.shipped import PACKAGES


@pytest.fixture(scope="module")
def angles() -> ModuleType:
    file = PACKAGES / "angles/angles/__init__.py"
    spec = importlib.util.spec_from_file_location("angles", file)
    assert spec
    assert spec.loader
    module = importlib.util.module_from_spec(spec)
    spec.loader.exec_module(module)
    return module


@pytest.mark.parametrize(
    ("name", "given", "expected"),
    [
        ("normalize_angle", -pi, pi),
        ("normalize_angle", 3 * pi / 2, -pi / 2),
        ("normalize_angle_positive", -pi / 2, 3 * pi / 2),
        ("two_pi_complement", -pi / 4, 7 * pi / 4),
        ("two_pi_complement", pi / 4, -7 * pi / 4),
        ("two_pi_complement", 0.0, 2 * pi),
        ("two_pi_complement", 5 * pi, -pi),
    ],
)
def test_angles_are_normalized(
    angles: ModuleType, name: str, given: float, expected: float
) -> None:
    assert isclose(getattr(angles, name)(given), expected)


# What upstream returns.
@pytest.mark.parametrize(
    ("given", "expected"),
    [
        ((-0.5, 0.5, 0.25, -0.25), (True, 1.0 - 2 * pi)),
        ((-0.5, 0.5, -0.25, 0.25), (False, 1.0)),
        ((0.1, 0.2, -0.25, 0.25), (True, 0.1)),
        ((0.0, 0.5, 0.0, 1.0), (True, 0.5)),
        ((0.0, 3.0, -1.0, 1.0), (False, 3.0)),
        ((0.0, -3.0, -1.0, 1.0), (False, -3.0)),
        ((3.0, 0.0, -1.0, 1.0), (False, -3.0)),
        ((0.0, 2.0, -pi, pi), (True, 2.0)),
    ],
)
def test_turns_stay_within_limits(
    angles: ModuleType, given: tuple[float, ...], expected: tuple[bool, float]
) -> None:
    allowed, turn = angles.shortest_angular_distance_with_limits(*given)
    assert (allowed, isclose(turn, expected[1])) == (expected[0], True), turn


@pytest.mark.parametrize(
    ("given", "expected"),
    [
        ((0, 10.5 * pi, -2 * pi, 2 * pi), (True, 0.5 * pi)),
        ((0, 10.5 * pi, -2 * pi, 0.1 * pi), (True, -1.5 * pi)),
        ((10.5 * pi, 0, -2 * pi, 2 * pi), (False, -0.5 * pi)),
        ((0, 1, 2, -2), (False, 1)),
    ],
)
def test_limits_may_be_large(
    angles: ModuleType, given: tuple[float, ...], expected: tuple[bool, float]
) -> None:
    allowed, turn = angles.shortest_angular_distance_with_large_limits(*given)
    assert (allowed, isclose(turn, expected[1])) == (expected[0], True), turn
