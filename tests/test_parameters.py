"""Parameters of compiled nodes: in the program, on its command line, and over the services."""

from __future__ import annotations

from pathlib import Path

import pytest
from panel import Played

pytestmark = pytest.mark.firefox

SITE = Path(__file__).parent / "sites" / "rclcpp"


def test_parameters_are_checked_watched_and_served(played: Played) -> None:
    parameters = played(SITE, "parameters", "parameters")
    wrong = "Wrong parameter type, parameter {speed} is of type {double}"
    assert parameters.lines() == [
        "1.500000 r2 6 [3, 4, 5] 4",
        "refused: nothing",
        "refused: parameter 'speed' has already been declared",
        "refused: parameter 'nothing' cannot be set because it was not declared",
        "refused: parameter 'name' has invalid type: expected [integer] got [string]",
        "refused: cannot undeclare parameter 'serial' because it is read-only",
        "refused: parameter 'speed' has invalid type: "
        "cannot undeclare a statically typed parameter",
        "refused: parameter 'unset' is not initialized",
        "refused: parameter 'typed' is not initialized",
        'set {"name": "any", "type": "bool", "value": "true"}',
        'set {"name": "any", "type": "string", "value": "text"}',
        "0 too fast",
        f"0 {wrong}, setting it to {{string}} is not allowed.",
        "0 Parameter {even} doesn't comply with integer range.",
        "0 parameter 'serial' cannot be set because it is read-only",
        "1 ",
        "1 ",
        "or 1 1.5 0 else",
        "arm 7",
        "any arm.joints even list name serial speed typed unset use_sim_time wheels ",
        "1 0",
        "r2 7",
        'set {"name": "speed", "type": "double", "value": "2.500000"}',
        "1 ",
        "0 too fast",
        "0 parameter 'nothing' cannot be set because it was not declared",
        "10 1",
        "event 2.500000",
        "began 0",
        "slept 1",
        "ended 100, calls 1",
        "done",
    ]
