"""One page as one file, which needs no server."""

from __future__ import annotations

import base64
import importlib.resources
import re
from collections.abc import Iterator
from pathlib import Path
from textwrap import dedent

import pytest
from bags import drive, write_bag
from panel import Panel
from paths import ROOT
from playwright.sync_api import Browser, ConsoleMessage, Page, expect
from terminal import Terminal

from sitegen.__main__ import main

WIRE = base64.b64decode(
    "iVBORw0KGgoAAAANSUhEUgAAAAEAAAABCAYAAAAfFcSJAAAADUlEQVR42mNk+M9QDwADhgGAWjR9awAAAABJRU5ErkJggg=="
)
SITE = """\
site: {title: My robot, url: "https://me.github.io/robot/", logo: robot.png, font: own.ttf}
pages:
  - {path: /, file: index.md}
  - {path: guide/start/, title: Start, content: [{markdown: "![A robot](robot.png)"}]}
"""
TEXT = """\
# Home

![A robot](robot.png) [Start](guide/start/#top) [Manual](manual.pdf) [Up](#home)
[ROS](https://ros.org/?a=1&b=2)
"""


@pytest.fixture
def alone(browser: Browser) -> Iterator[Page]:
    """A tab that fails on errors and on whatever is loaded beside the file."""
    tab = browser.new_page()
    wrong: list[str] = []

    def note(message: ConsoleMessage) -> None:
        # The browser says so of its own reading, where it draws without a graphics card.
        if message.type in ("error", "warning") and "ReadPixels" not in message.text:
            wrong.append(message.text)

    tab.on("console", note)
    tab.on("pageerror", lambda error: wrong.append(str(error)))
    loaded: list[str] = []
    tab.on("request", lambda request: loaded.append(request.url))
    yield tab
    tab.close()
    assert wrong == []
    assert [url for url in loaded if not url.startswith(("file:", "blob:", "data:"))] == []
    assert len([url for url in loaded if url.startswith("file:")]) <= 2


@pytest.fixture
def site(tmp_path: Path) -> Path:
    (tmp_path / "site.yaml").write_text(SITE)
    (tmp_path / "index.md").write_text(TEXT)
    (tmp_path / "robot.png").write_bytes(WIRE)
    font = importlib.resources.files("font_source_sans_pro") / "files/SourceSansPro-Regular.ttf"
    (tmp_path / "own.ttf").write_bytes(font.read_bytes())
    (tmp_path / "manual.pdf").write_bytes(b"%PDF-1.4")
    return tmp_path


@pytest.mark.firefox
def test_nodes_run_in_a_file_that_was_opened(alone: Page, tmp_path: Path) -> None:
    file = tmp_path / "look inside.html"
    assert main(["build", str(ROOT), "--single-file", "demo05/", "--output", str(file)]) == 0
    alone.goto(file.as_uri())
    for name in ("listener", "talker", "server"):
        Panel(alone, name).start()
    Panel(alone, "listener").wait_for("I heard: 'Hello, world! 2'")
    tabs = alone.locator(".tabbed-labels")
    tabs.get_by_text("Services").click()
    services = alone.locator("[data-ros-widget=services]")
    services.scroll_into_view_if_needed()
    services.get_by_label("a int64").fill("40")
    services.get_by_label("b int64").fill("2")
    services.get_by_role("button", name="Call").click()
    expect(services.get_by_label("response")).to_have_text("sum: 42")
    tabs.get_by_text("Graph").click()
    alone.locator("[data-ros-widget=graph]").scroll_into_view_if_needed()
    expect(alone.locator(".ros-topic-box")).to_have_count(1)
    Panel(alone, "talker").stop()
    assert alone.get_by_role("button", name=re.compile("Share|Search|Pages")).count() == 0
    assert not alone.is_visible("#file-note")


@pytest.mark.firefox
def test_roslib_is_in_the_file_of_a_page_that_uses_it(alone: Page, tmp_path: Path) -> None:
    file = tmp_path / "file.html"
    assert main(["build", str(ROOT), "--single-file", "demo16/roslib/", "--output", str(file)]) == 0
    alone.goto(file.as_uri())
    readings = alone.locator(".ros-readings")
    expect(readings).to_contain_text("5.54, 5.54")
    alone.get_by_role("application", name="Joystick").press("ArrowLeft", delay=500)
    expect(readings).to_contain_text("Speed0.00")
    expect(readings).not_to_contain_text("Heading0°")


@pytest.mark.firefox
def test_cells_run_in_the_file(alone: Page, tmp_path: Path) -> None:
    (tmp_path / "site.yaml").write_text("site: {title: A}\npages: [{path: /, file: page.md}]\n")
    cell = """\
    # Cells

    ```js ros
    import { ros } from "sitegen";
    import { transportFactory } from "sitegen/rosbridge";
    import { Ros, Topic } from "sitegen/roslib";

    const page = new Ros({ transportFactory });
    page.connect("page:");
    const chatter = ros.topic("/chatter", "std_msgs/msg/String");
    const heard = new Topic({ ros: page, name: "/chatter", messageType: "std_msgs/String" });
    heard.subscribe(({ data }) => console.log("roslib heard", data));
    ros.timer(100, () => chatter.publish({ data: "a cell" }));
    ```
    """
    (tmp_path / "page.md").write_text(dedent(cell))
    file = tmp_path / "file.html"
    assert main(["build", str(tmp_path), "--single-file", "/", "--output", str(file)]) == 0
    alone.goto(file.as_uri())
    alone.get_by_role("button", name="Run JavaScript cell 1").click()
    expect(alone.get_by_role("log").get_by_text("roslib heard a cell").nth(2)).to_be_attached()
    alone.get_by_role("button", name="Stop JavaScript cell 1").click()
    expect(alone.locator(".ros-cell-state")).to_have_text("stopped")


def test_without_jspi_too(browser: Browser, tmp_path: Path) -> None:
    file = tmp_path / "file.html"
    assert main(["build", str(ROOT), "--single-file", "demo02", "--output", str(file)]) == 0
    context = browser.new_context()
    context.add_init_script("delete WebAssembly.Suspending; delete WebAssembly.promising;")
    tab = context.new_page()
    tab.goto(file.as_uri())
    Panel(tab, "talker").start()
    Panel(tab, "talker").wait_for("Hello, world! 1")
    context.close()


def test_a_robot_is_in_the_file(alone: Page, tmp_path: Path) -> None:
    file = tmp_path / "file.html"
    assert main(["build", str(ROOT), "--single-file", "demo04", "--output", str(file)]) == 0
    alone.goto(file.as_uri())
    expect(alone.locator("svg.ros-floor")).to_be_visible()


def test_meshes_and_what_is_loaded_later_are_in_the_file(alone: Page, tmp_path: Path) -> None:
    file = tmp_path / "file.html"
    assert main(["build", str(ROOT), "--single-file", "demo10", "--output", str(file)]) == 0
    alone.goto(file.as_uri())
    view = alone.locator(".ros-3d")
    expect(alone.get_by_role("region", name="trace", exact=True)).to_contain_text("tool at")
    # All displays show what they are for, the robot with its meshes among them.
    expect(view.locator(".ros-displays > summary")).to_have_text("Displays 4")
    parameters = alone.get_by_role("region", name="Parameters")
    parameters.scroll_into_view_if_needed()
    width = parameters.get_by_label("width double")
    expect(width).to_have_value("0.012")
    saved = tmp_path / "trace.yaml"
    saved.write_text("/trace: {ros__parameters: {width: 0.05}}\n")
    parameters.locator("input[type=file]").set_input_files(saved)
    expect(parameters).to_contain_text("All values were set.")
    expect(width).to_have_value("0.05")


def test_scripts_are_in_the_file(alone: Page, tmp_path: Path) -> None:
    site = tmp_path / "site"
    site.mkdir()
    page = "{path: /, title: A, scripts: [a.js, b.js], content: [{markdown: Text}]}"
    (site / "site.yaml").write_text(f"site: {{title: A}}\npages: [{page}]\n")
    (site / "a.js").write_text("document.body.dataset.said = 'a';\n")
    (site / "b.js").write_text("document.body.dataset.said += 'b';\n")
    file = tmp_path / "file.html"
    assert main(["build", str(site), "--single-file", "/", "--output", str(file)]) == 0
    alone.goto(file.as_uri())
    alone.wait_for_selector("body[data-said=ab]")


def test_a_bag_is_in_the_file(alone: Page, tmp_path: Path) -> None:
    site = tmp_path / "site"
    write_bag(site / "drive.mcap", drive())
    site.joinpath("site.yaml").write_text(
        "site: {title: A}\n"
        "pages: [{path: /, content: [{markdown: '# A'}, {bag: drive.mcap}, {bag: }]}]"
    )
    file = tmp_path / "alone.html"
    assert main(["build", str(site), "--single-file", "/", "--output", str(file)]) == 0
    alone.goto(file.as_uri())
    player = alone.get_by_role("region", name="Player").first
    expect(player.locator(".ros-bag-row")).to_have_count(3)
    expect(player.locator(".ros-name").first).to_have_text("drive.mcap")
    player.get_by_role("button", name="Play", exact=True).click()
    expect(player.locator(".ros-bag-time")).to_contain_text("0:01.")
    recorder = alone.get_by_role("region", name="Recorder")
    recorder.get_by_role("button", name="Record", exact=True).click()
    expect(recorder.get_by_role("status").first).to_contain_text("on 3 topics")
    recorder.get_by_role("button", name="Stop", exact=True).click()
    expect(recorder.get_by_role("status").first).to_contain_text("Recorded: ")


def test_a_terminal_of_a_file_records_and_plays(alone: Page, tmp_path: Path) -> None:
    site = tmp_path / "site"
    write_bag(site / "drive.mcap", drive())
    site.joinpath("site.yaml").write_text(
        "site: {title: A}\n"
        "pages: [{path: /, content: [{markdown: '# A'}, {bag: drive.mcap}, {terminal: }]}]"
    )
    file = tmp_path / "alone.html"
    assert main(["build", str(site), "--single-file", "/", "--output", str(file)]) == 0
    alone.goto(file.as_uri())
    # The bag above grows when it is loaded, and a terminal outside of the window does not draw.
    expect(alone.locator(".ros-bag-row")).to_have_count(3)
    alone.locator(".ros-terminal").evaluate("(terminal) => terminal.scrollIntoView()")
    terminal = Terminal(alone)
    assert terminal.run("ros2 bag info drive.mcap -t") == "/latched\n/places\n/words"
    line = (
        "ros2 bag record -a -o again > a 2>&1 & ros2 bag play drive -r 20 > b 2>&1; kill %1; wait"
    )
    terminal.run(line)
    assert terminal.run("ros2 bag info again -t") == "/latched\n/places\n/words"


def test_images_and_links_of_a_file(alone: Page, site: Path) -> None:
    assert main(["build", str(site), "--single-file", "/"]) == 0
    file = site / "index.html"
    text = file.read_text()
    assert re.findall(r'(?:src|href)="(?!data:|#|https://)[^"]*"', text) == []
    alone.goto(file.as_uri())
    assert alone.evaluate("document.querySelector('main img').naturalWidth") == 1
    assert alone.evaluate("[...document.fonts].some(({ status }) => status === 'loaded')")
    links = alone.eval_on_selector_all("main .prose p a", "all => all.map((a) => a.href)")
    assert links[0] == "https://me.github.io/robot/guide/start/#top"
    assert links[1].startswith("data:application/pdf;base64,")
    assert links[2].endswith("index.html#home")
    assert links[3] == "https://ros.org/?a=1&b=2"
    assert main(["build", str(site), "--single-file", "guide/start"]) == 0
    assert (site / "guide-start.html").is_file()


def test_its_policy_allows_nothing_that_is_not_in_it(site: Path) -> None:
    assert main(["build", str(site), "--single-file", "/"]) == 0
    text = (site / "index.html").read_text()
    (policy,) = re.findall(r'http-equiv="Content-Security-Policy" content="([^"]+)"', text)
    assert "unsafe-inline" not in policy
    assert "unsafe-eval" not in policy.replace("wasm-unsafe-eval", "")
    assert "http" not in policy
    for rule in ("default-src", "connect-src", "worker-src"):
        assert rule in policy


def test_the_same_page_is_the_same_file(site: Path) -> None:
    assert main(["build", str(site), "--single-file", "/"]) == 0
    first = (site / "index.html").read_bytes()
    assert main(["build", str(site), "--single-file", "/"]) == 0
    assert (site / "index.html").read_bytes() == first


def test_python_nodes_are_left_out_with_a_word(
    alone: Page, tmp_path: Path, capsys: pytest.CaptureFixture[str]
) -> None:
    file = tmp_path / "file.html"
    assert main(["build", str(ROOT), "--single-file", "demo06", "--output", str(file)]) == 0
    said = capsys.readouterr().out
    assert re.search(r"left out: talker; --with-python embeds Python \(\d+\.\d MB", said)
    assert file.stat().st_size < 2_000_000
    alone.goto(file.as_uri())
    expect(alone.locator(".admonition")).to_contain_text("does not run talker, which needs Python")
    expect(alone.locator("[data-ros-widget=console]")).to_have_count(1)
    Panel(alone, "listener").start()


def test_python_runs_in_a_file_when_asked(
    alone: Page, tmp_path: Path, capsys: pytest.CaptureFixture[str]
) -> None:
    file = tmp_path / "file.html"
    words = ["--single-file", "demo06", "--with-python", "--output", str(file)]
    assert main(["build", str(ROOT), *words]) == 0
    assert re.search(r"Python for talker: \d+\.\d MB of the file", capsys.readouterr().out)
    alone.goto(file.as_uri())
    for name in ("listener", "talker"):
        Panel(alone, name).start()
    Panel(alone, "listener").wait_for("I heard: 'Hello")


def test_what_cannot_be_a_file_is_said(
    site: Path, tmp_path: Path, capsys: pytest.CaptureFixture[str]
) -> None:
    assert main(["build", str(site), "--single-file", "guide/strat"]) == 1
    assert "did you mean 'guide/start/'?" in capsys.readouterr().err
    (site / "index.html").write_text("mine")
    assert main(["build", str(site), "--single-file", "/"]) == 1
    assert "was not written by sitegen; choose another --output" in capsys.readouterr().err
    assert (site / "index.html").read_text() == "mine"
    (site / "index.md").write_text('# Home\n\n<iframe src="guide/start/" title="S"></iframe>\n')
    assert main(["build", str(site), "--single-file", "/", "--output", f"{tmp_path}/x.html"]) == 1
    assert "a single file cannot embed another page" in capsys.readouterr().err
