"""The fields of messages of rowe, and those of ROS messages."""

from __future__ import annotations

import math
from pathlib import Path

import pytest

from sitegen.errors import SiteError
from sitegen.gateway.config import load
from sitegen.gateway.fieldmap import UNITS, FieldError, FieldMap

DRIVE = FieldMap(
    {"v": "linear.x", "turn": "angular.z"},
    {"linear.x": 0.1, "angular": {"y": 1}},
    {"v": UNITS["mm/s"], "turn": UNITS["deg/s"]},
)


def test_fields_go_to_their_places_in_the_units_of_ros() -> None:
    found = DRIVE.to_ros({"v": 250, "turn": 90})
    assert found == {"linear": {"x": 0.25}, "angular": {"z": pytest.approx(math.pi / 2)}}


def test_defaults_fill_what_is_missing() -> None:
    assert DRIVE.to_ros({}) == {"linear": {"x": 0.1}, "angular": {"y": 1}}


def test_what_comes_back_has_the_fields_and_units_of_the_program() -> None:
    message = {"linear": {"x": 0.25, "y": 0.0}, "angular": {"z": math.pi}, "frame": "base"}
    assert DRIVE.to_program(message) == {
        "v": pytest.approx(250),
        "turn": pytest.approx(180),
        "linear": {"y": 0.0},
        "frame": "base",
    }
    # The message of ROS itself is for other clients, too.
    assert message["linear"] == {"x": 0.25, "y": 0.0}


def test_lists_of_numbers_have_units_too() -> None:
    angles = FieldMap(units={"angles": UNITS["deg"]})
    assert angles.to_ros({"angles": [180]}) == {"angles": [pytest.approx(math.pi)]}
    assert angles.to_program({"angles": [math.pi, None]}) == {"angles": [pytest.approx(180), None]}


def test_a_body_is_not_changed() -> None:
    body = {"linear": {"y": 1.0}, "v": 1}
    assert DRIVE.to_ros(body)["linear"] == {"y": 1.0, "x": 0.001}
    assert body == {"linear": {"y": 1.0}, "v": 1}


@pytest.mark.parametrize(
    ("body", "error"),
    [
        ({"v": "fast"}, "v: must be a number"),
        ({"v": True}, "v: must be a number"),
        ({"linear": 7, "v": 1}, "v: 'linear' has a value of its own"),
        ({"v": 10**400}, "v: the number is too large"),
    ],
)
def test_what_does_not_fit_is_told(body: dict[str, object], error: str) -> None:
    with pytest.raises(FieldError, match=error):
        DRIVE.to_ros(body)


def test_gateway_yaml_says_all_of_it(tmp_path: Path) -> None:
    file = tmp_path / "gateway.yaml"
    file.write_text(
        """\
rowe:
  kind: command
  topics:
    drive:
      topic: /cmd_vel
      fields: {v: linear.x}
      defaults: {angular.z: 0.5}
      units: {v: mm/s}
  services:
    add: {service: /add_two_ints, reply: {fields: {answer: sum}}}
"""
    )
    rules = load(file)
    assert rules.rowe_kind == "command"
    drive = rules.rowe_topics["drive"].fields
    assert drive == FieldMap({"v": "linear.x"}, {"angular.z": 0.5}, {"v": 0.001})
    assert rules.rowe_services["add"].reply.to_program({"sum": 42}) == {"answer": 42}


@pytest.mark.parametrize(
    ("given", "message"),
    [
        ("units: {v: furlong}", "rowe.topics.a.units.v: unknown unit 'furlong'; the units are mm,"),
        ("fields: {v: linear..x}", "rowe.topics.a.fields.v: 'linear..x' is not the place of a"),
        ("fields: {v: x, w: x}", "rowe.topics.a.fields: two fields have the same place"),
        ("defaults: {x: 2026-01-01}", "rowe.topics.a.defaults.x: '2026-01-01' is not a value of"),
    ],
)
def test_mistakes_in_gateway_yaml_are_told(tmp_path: Path, given: str, message: str) -> None:
    file = tmp_path / "gateway.yaml"
    file.write_text(f"rowe:\n  topics:\n    a: {{topic: /a, {given}}}\n")
    with pytest.raises(SiteError) as caught:
        load(file)
    assert message in str(caught.value)
