"""Parameters of compiled nodes: in the program, on its command line, and over the services."""

from __future__ import annotations

import pytest
from panel import Played
from paths import SITES

pytestmark = pytest.mark.firefox

SITE = SITES / "rclcpp"


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
        "past 1",
        "rate 1 1",
        "end 39",
        "became real",
        "done",
    ]


def test_files_of_parameters_are_read_while_a_program_runs(played: Played) -> None:
    files = played(SITE, "parameters", "files")
    # The values and the words of errors are those of native ROS 2 with the same file.
    assert files.lines() == [
        "folded string <one line",
        "and more",
        "  indented",
        "end>",
        "grip double <0.500000>",
        "kept string <first",
        "  second",
        ">",
        "limits.high double <1000.000000>",
        "limits.low integer <-1>",
        "list integer_array <[1, -2, 16]>",
        "name string <all>",
        'names string_array <["one", "2"]>',
        "nothing string <>",
        "number string <12>",
        "path string </a/b:c#d>",
        "plain string <words that go on",
        "below>",
        "quoted string <it's: here>",
        "switches bool_array <[true, false, true]>",
        "text string <a\tb ä on>",
        "nodes 4",
        "refused: Error opening YAML file",
        "file 1: /** 2 /arm/* 3 arm/left 10 arm/right 1 ",
        "value 1 1 0.2",
        "0 Sequence should be of same type. Value type 'bool' do not belong at line_num 1",
        "0 Error parsing a event near line 1",
        "0 Will not support aliasing at line 1",
        "0 Error parsing a event near line 1",
        "0 Error parsing a event near line 1",
        "0 No value at line 1",
        "map 15",
        "1 ",
        "1 ",
        "1 ",
        "0 parameter 'list' cannot be set because it was not declared",
        "0 parameter 'quoted' cannot be set because it was not declared",
        "1 ",
        "grip double <0.500000>",
        "name string <right>",
        "name string <mapped>",
        "refused: No valid parameter",
        "done",
    ]
