"""What `sitegen init` writes for the packages of two demos, built and used in a browser."""

from __future__ import annotations

import io
import shutil
from pathlib import Path

from browser import Serve
from panel import Panel
from paths import ROOT
from PIL import Image
from playwright.sync_api import Locator, Page, expect
from waiting import until

from sitegen.__main__ import main


def test_its_pages_run(tmp_path: Path, serve: Serve, tab: Page) -> None:
    for demo in ("demo05", "demo09"):
        shutil.copytree(ROOT / "demos" / demo / "src", tmp_path / "src", dirs_exist_ok=True)
    shutil.rmtree(tmp_path / "src/cpp_chatter")
    assert main(["init", str(tmp_path)]) == 0
    assert main(["check", "--strict", str(tmp_path)]) == 0
    assert main(["build", str(tmp_path)]) == 0
    url = serve(tmp_path / "dist")

    tab.goto(url)
    tab.get_by_role("main").get_by_role("listitem").filter(has_text="A server").click()
    client = Panel(tab, "client")
    expect(tab.locator("main")).to_contain_text("auto client = node->create_client")
    client.start()
    # It says what it waits for, and offers to start it.
    client.panel.get_by_role("button", name="Start server first").click()
    client.wait_for("Sum: 3")

    tab.goto(f"{url}py_artist/")
    Panel(tab, "turtlesim").start()
    topics = tab.get_by_role("region", name="Topics")
    topics.scroll_into_view_if_needed()
    expect(topics).to_contain_text("theta: 0.0")


def test_a_robot_that_nothing_starts_is_shown_and_moves(
    tmp_path: Path, serve: Serve, tab: Page
) -> None:
    arm = ROOT / "demos/demo10/src/arm"
    left_out = shutil.ignore_patterns("launch", "src", "CMakeLists.txt")
    shutil.copytree(arm, tmp_path / "src/arm", ignore=left_out)
    (tmp_path / "src/arm/CMakeLists.txt").write_text("project(arm)\n")
    assert main(["init", str(tmp_path)]) == 0
    assert main(["check", "--strict", str(tmp_path)]) == 0
    assert main(["build", str(tmp_path)]) == 0
    tab.goto(serve(tmp_path / "dist"))
    elbow = tab.get_by_role("slider", name="elbow")
    expect(elbow).to_be_visible()
    view = tab.locator(".ros-scene canvas")
    until(lambda: len(colors(view)) > 50)  # the grid alone has few
    before = view.screenshot()
    elbow.fill("1.2")
    until(lambda: view.screenshot() != before)


def colors(view: Locator) -> set[str]:
    """The colors of what a view shows, without those of few pixels."""
    image = Image.open(io.BytesIO(view.screenshot())).convert("RGB")
    return {str(color) for count, color in image.getcolors(1 << 24) or [] if count > 3}
