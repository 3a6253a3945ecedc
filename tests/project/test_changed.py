"""The tests that `make check` chooses for a change."""

from __future__ import annotations

import changed
import pytest
from paths import ROOT


@pytest.mark.parametrize(
    ("file", "nearest"),
    [
        ("sitegen/config/level.py", "config/test_config.py"),
        ("sitegen/yamlnodes.py", "hostile/test_inputs.py"),
        ("sitegen/runtime/widgets/plot/legend.js", "browser/widgets/test_plot.py"),
        ("sitegen/runtime/widgets/3d/displays/map.js", "browser/widgets/test_3d.py"),
        ("sitegen/runtime/widgets/connect/texts.js", "browser/gateway/test_connect.py"),
        ("sitegen/runtime/participant/reader.js", "browser/graph/test_qos.py"),
        ("sitegen/runtime/terminal/ros2/topic/pub.js", "browser/terminal/test_ros2.py"),
        ("sitegen/runtime/workers/gateway/owns.js", "browser/gateway/test_page.py"),
        ("sitegen/clients/cpp/src/platform/threads.cpp", "browser/graph/test_faults.py"),
        ("themes/default/head.html", "site/test_early.py"),
        ("tests/support/scenes.py", "browser/widgets/test_meshes.py"),
        ("tests/sites/faults/site.yaml", "browser/graph/test_faults.py"),
        ("tests/config/wrong/a-list/said.txt", "config/test_config.py"),
        ("tests/browser/cpp/test_tf.py", "browser/cpp/test_tf.py"),
        ("Makefile", "project/test_workflows.py"),
    ],
)
def test_a_change_has_its_tests(file: str, nearest: str) -> None:
    found = {test.relative_to(ROOT / "tests").as_posix() for test in changed.tests_of(file)}
    assert nearest in found
    assert len(found) < len(changed.TESTS) / 4


def test_what_all_tests_share_is_left_to_the_whole_run() -> None:
    assert changed.tests_of("tests/conftest.py") == set()


@pytest.mark.parametrize("pattern", changed.RUNTIME.values())
def test_the_rooms_of_the_runtime_have_tests(pattern: str) -> None:
    assert {*changed.BROWSER.glob(pattern)} & {*changed.TESTS}


@pytest.mark.parametrize("folder", changed.OTHERS)
def test_what_is_of_no_room_has_tests(folder: str) -> None:
    assert (ROOT / folder).is_dir()
    assert changed.tests_of(f"{folder}/any")
