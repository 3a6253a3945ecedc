"""A site that is served while it is edited, in a real browser."""

from __future__ import annotations

import contextlib
import io
import json
import os
import shutil
import signal
import socket
import struct
import subprocess
import sys
import threading
import time
import urllib.error
import urllib.request
from collections.abc import Callable, Iterator
from http import HTTPStatus
from pathlib import Path

import pytest
from browser import WITHOUT_JSPI, Built
from panel import Panel
from paths import ROOT
from playwright.sync_api import Browser, Page, expect

from sitegen.commands.serve.live import LiveSite
from sitegen.commands.serve.media import media_type
from sitegen.commands.serve.server import Server, _Handler
from sitegen.commands.serve.watcher import changes
from sitegen.report import Report

SITE = """\
site: {title: My robot}
pages:
  - {path: /, file: index.md}
  - {path: other/, title: Other, content: [{markdown: The other page.}]}
"""

PAGE = """\
---
title: Two nodes
nodes:
  talker: {package: cpp_pubsub, executable: talker}
  listener: {package: cpp_pubsub, executable: listener}
---
```ros
- buttons: talker
- console: talker
- buttons: listener
- console: listener
```
"""


def wait_until(condition: Callable[[], bool]) -> None:
    end = time.monotonic() + 20
    while not condition():
        assert time.monotonic() < end
        time.sleep(0.02)


class Serving:
    """A site in a folder that follows its author."""

    def __init__(self, folder: Path) -> None:
        self.folder = folder
        self.said = io.StringIO()
        self.live = LiveSite(folder, Report(self.said))
        self.server = Server(self.live, 0)

    @property
    def url(self) -> str:
        return self.server.url

    def write(self, path: str, text: str) -> None:
        (self.folder / path).write_text(text)


@pytest.fixture
def serving(tmp_path: Path) -> Iterator[Callable[[Path], Serving]]:
    """A function that serves a folder, and follows its changes, until the test is over."""
    servers: list[Server] = []

    def start(folder: Path) -> Serving:
        serving = Serving(folder)
        serving.live.rebuild()
        servers.append(serving.server.__enter__())

        def follow() -> None:
            for changed in changes(folder):
                serving.live.rebuild(changed)

        threading.Thread(target=follow, daemon=True).start()
        return serving

    yield start
    for server in servers:
        server.__exit__()


@pytest.fixture
def site(tmp_path: Path) -> Path:
    (tmp_path / "site.yaml").write_text(SITE)
    (tmp_path / "index.md").write_text("# Welcome\n\nThe first text.\n")
    return tmp_path


def test_an_edited_page_is_shown_at_once(
    tab: Page, site: Path, serving: Callable[[Path], Serving]
) -> None:
    served = serving(site)
    tab.goto(served.url)
    expect(tab.locator("main")).to_contain_text("The first text.")
    served.write("index.md", "# Welcome\n\nThe second text.\n")
    expect(tab.locator("main")).to_contain_text("The second text.", timeout=20_000)
    # What is about another page leaves this one alone.
    tab.evaluate("window.still = true")
    served.write("site.yaml", SITE.replace("The other page.", "Edited."))
    served.write("index.md", "# Welcome\n\nThe second text.\n")
    tab.wait_for_timeout(500)
    assert tab.evaluate("window.still")


def test_a_broken_edit_is_told_and_the_last_good_page_stays(
    tab: Page, site: Path, serving: Callable[[Path], Serving]
) -> None:
    served = serving(site)
    tab.goto(served.url)
    served.write("site.yaml", SITE.replace("title: Other", "titel: Other"))
    problems = tab.get_by_role("alert")
    expect(problems).to_contain_text("did you mean 'title'?", timeout=20_000)
    expect(problems).to_contain_text("site.yaml:4: pages[1].titel: unknown key")
    expect(tab.locator("main")).to_contain_text("The first text.")
    assert "the pages are unchanged" in served.said.getvalue()
    # Also to who comes now.
    tab.goto(f"{served.url}other/")
    expect(tab.get_by_role("alert")).to_contain_text("unknown key")
    served.write("site.yaml", SITE)
    expect(tab.get_by_role("alert")).to_be_hidden(timeout=20_000)


def test_a_site_that_was_never_good_is_shown_when_it_is(
    browser: Browser, site: Path, serving: Callable[[Path], Serving]
) -> None:
    (site / "site.yaml").write_text("site: {}\n")
    served = serving(site)
    page = browser.new_page()
    page.goto(served.url)
    expect(page.get_by_role("alert")).to_contain_text("site.yaml:1: site.title: missing")
    served.write("site.yaml", SITE)
    expect(page.locator("main")).to_contain_text("The first text.", timeout=20_000)
    page.close()


def test_looks_change_without_loading_the_page_anew(
    tab: Page, site: Path, serving: Callable[[Path], Serving]
) -> None:
    shutil.copytree(ROOT / "themes/default", site / "themes/own")
    (site / "site.yaml").write_text(SITE.replace("My robot", "My robot, theme: own"))
    served = serving(site)
    tab.goto(served.url)
    tab.evaluate("window.still = true")
    css = site / "themes/own/style.css"
    css.write_text(css.read_text() + "\nmain { outline: 3px solid rgb(1, 2, 3); }\n")
    expect(tab.locator("main")).to_have_css("outline-color", "rgb(1, 2, 3)", timeout=20_000)
    assert tab.evaluate("window.still")


def test_only_the_node_that_changed_starts_again(
    tab: Page, tmp_path: Path, serving: Callable[[Path], Serving]
) -> None:
    site = tmp_path / "demo"
    shutil.copytree(ROOT / "demos/demo03", site, ignore=shutil.ignore_patterns("dist"))
    config = site / "site.yaml"
    config.write_text(config.read_text().replace("site:\n", "site:\n  asyncify: false\n"))
    # A page that shows its sources would change with them.
    (site / "page.md").write_text(PAGE)
    served = serving(site)
    tab.goto(served.url)
    talker, listener = Panel(tab, "talker"), Panel(tab, "listener")
    listener.start()
    talker.start()
    listener.wait_for("Hello, world!")
    before = listener.lines()[0]
    source = site / "src/cpp_pubsub/src/talker.cpp"
    source.write_text(source.read_text().replace("Hello, world!", "Good evening!"))
    expect(listener.console).to_contain_text("Good evening!", timeout=90_000)
    assert listener.lines()[0] == before
    listener.expect_state("running")


TEXT = """\
---
title: Two nodes
nodes:
  talker: {package: cpp_pubsub, executable: talker}
  listener: {package: cpp_pubsub, executable: listener}
---
# Two nodes

The first text.

```cpp
int first;
```

```ros
- buttons: talker
- console: talker
- topics: {echo: /chatter}
- publish: {topic: /chatter}
```

## Later

### Details

## Last

The end.
"""


def edited_site(tmp_path: Path) -> Path:
    site = tmp_path / "demo"
    shutil.copytree(ROOT / "demos/demo03", site, ignore=shutil.ignore_patterns("dist"))
    (site / "page.md").write_text(TEXT)
    return site


def talking(tab: Page, served: Serving) -> tuple[Panel, str]:
    """Open the page and start the talker; return its panel and the first line there."""
    tab.goto(served.url)
    talker = Panel(tab, "talker")
    talker.start()
    talker.wait_for("Hello, world! 1'")
    return talker, talker.lines()[0]


def test_an_edit_of_text_leaves_nodes_and_panels_alone(
    tab: Page, tmp_path: Path, serving: Callable[[Path], Serving]
) -> None:
    served = serving(edited_site(tmp_path))
    talker, before = talking(tab, served)
    field = tab.get_by_role("region", name="Publish").get_by_role("textbox").last
    field.fill("half written")
    tab.evaluate("window.still = true; scrollTo(0, 40)")

    served.write(
        "page.md",
        TEXT.replace("The first text.", "The second text.\n\n```cpp\nint second;\n```\n")
        .replace("## Later", "## Much later")
        .replace("title: Two nodes", "title: Three words now"),
    )
    expect(tab.locator("main")).to_contain_text("The second text.", timeout=20_000)
    expect(tab.locator("nav.toc")).to_contain_text("Much later")
    expect(tab).to_have_title("Three words now · Demo 03")
    # Also what a script added: every block of code can be copied.
    expect(tab.locator("div.code > .copy")).to_have_count(2)
    assert tab.evaluate("window.still && scrollY") == 40
    expect(field).to_have_value("half written")
    talker.expect_state("running")
    assert talker.lines()[0] == before
    seen = len(talker.lines())
    wait_until(lambda: len(talker.lines()) > seen)


def test_widgets_and_nodes_come_and_go_beside_those_that_run(
    tab: Page, tmp_path: Path, serving: Callable[[Path], Serving]
) -> None:
    served = serving(edited_site(tmp_path))
    talker, before = talking(tab, served)
    tab.evaluate("window.still = true")
    more = "```ros\n- buttons: listener\n- console: listener\n- graph:\n```\n\n"
    served.write(
        "page.md", TEXT.replace("```ros\n- buttons: talker", more + "```ros\n- buttons: talker")
    )
    listener = Panel(tab, "listener")
    listener.start()
    listener.wait_for("I heard: 'Hello, world!")
    graph = tab.get_by_role("region", name="Graph")
    graph.scroll_into_view_if_needed()
    expect(graph).to_contain_text("/minimal_subscriber")
    assert talker.lines()[0] == before
    served.write("page.md", TEXT.replace("- publish: {topic: /chatter}\n", ""))
    expect(tab.get_by_role("region", name="Publish")).to_have_count(0, timeout=20_000)
    assert talker.lines()[0] == before
    assert tab.evaluate("window.still")


def test_a_page_that_is_loaded_anew_keeps_what_runs(
    tab: Page, tmp_path: Path, serving: Callable[[Path], Serving]
) -> None:
    site = edited_site(tmp_path)
    shutil.copytree(ROOT / "themes/default", site / "themes/own")
    config = (site / "site.yaml").read_text()
    (site / "site.yaml").write_text(config.replace("site:\n", "site:\n  theme: own\n"))
    served = serving(site)
    tab.goto(served.url)
    Panel(tab, "talker").start()
    script = site / "themes/own/page.js"
    with tab.expect_navigation():
        script.write_text(script.read_text() + "\n// Changed.\n")
    talker = Panel(tab, "talker")
    talker.wait_for("Hello, world! 1'")
    assert tab.url == served.url


def test_a_problem_can_be_closed_and_opened_in_the_editor(
    tab: Page,
    site: Path,
    serving: Callable[[Path], Serving],
    tmp_path_factory: pytest.TempPathFactory,
    monkeypatch: pytest.MonkeyPatch,
) -> None:
    opened = tmp_path_factory.mktemp("editor") / "opened"
    monkeypatch.setenv("SITEGEN_EDITOR", f"sh -c 'echo {{file}} {{line}} > {opened}'")
    served = serving(site)
    tab.goto(served.url)
    served.write("site.yaml", SITE.replace("title: Other", "titel: Other"))
    problems = tab.get_by_role("alert")
    with tab.expect_response("**/_sitegen/open") as response:
        problems.get_by_role("button", name="site.yaml:4").first.click(timeout=20_000)
    assert response.value.ok
    wait_until(opened.is_file)
    assert opened.read_text() == f"{site / 'site.yaml'} 4\n"
    problems.get_by_role("button", name="Close").click()
    expect(problems).to_be_hidden()


def test_nobody_else_can_open_an_editor_or_read_the_site(
    site: Path, serving: Callable[[Path], Serving], monkeypatch: pytest.MonkeyPatch
) -> None:
    monkeypatch.setenv("SITEGEN_EDITOR", "false")
    (site / "site.yaml").write_text("site: {}\n")
    served = serving(site)
    place = b"site.yaml:1"
    here = served.url.rstrip("/")
    for origin, body, status in (
        ("http://example.org", place, 403),
        (here, b"index.md:1", 404),
        (here, b"/etc/passwd:1", 404),
        (here, place * 1000, 403),
    ):
        headers = {"Origin": origin}
        request = urllib.request.Request(f"{served.url}_sitegen/open", body, headers)
        with pytest.raises(urllib.error.HTTPError, match=str(status)):
            urllib.request.urlopen(request)
    # Another name for this computer is one that another site has given it.
    request = urllib.request.Request(served.url, headers={"Host": "example.org"})
    with pytest.raises(urllib.error.HTTPError, match="421"):
        urllib.request.urlopen(request)


def test_a_browser_without_jspi_gets_programs_of_its_own(
    browser: Browser, tmp_path: Path, serving: Callable[[Path], Serving]
) -> None:
    served = serving(edited_site(tmp_path))

    def engines() -> list[str]:
        entry = served.live.file("page.json")
        assert entry and isinstance(entry.source, bytes)
        return sorted(json.loads(entry.source)["nodes"]["talker"]["builds"])

    assert engines() == ["jspi"]
    with contextlib.closing(browser.new_context()) as context:
        context.add_init_script(WITHOUT_JSPI)
        page = context.new_page()
        page.goto(served.url)
        talker = Panel(page, "talker")
        # It fails until its program is there, then it starts by itself.
        talker.start()
        talker.wait_for("Hello, world! 1'")
    assert engines() == ["asyncify", "jspi"]


def test_no_module_is_sent_twice_and_none_that_has_not_changed(
    tab: Page,
    tmp_path: Path,
    serving: Callable[[Path], Serving],
    monkeypatch: pytest.MonkeyPatch,
) -> None:
    answers: list[tuple[str, int]] = []

    def note(handler: _Handler, code: int, _: object = "-") -> None:
        answers.append((handler.path, code))

    monkeypatch.setattr(_Handler, "log_request", note)
    page = edited_site(tmp_path) / "page.md"
    page.write_text(TEXT.replace("- buttons: talker\n", ""))
    served = serving(page.parent)
    # The node starts by itself: the page preloads the modules that its worker imports.
    tab.goto(served.url)
    Panel(tab, "talker").wait_for("Hello, world! 1'")
    sent = [path for path, code in answers if code == HTTPStatus.OK]
    assert {path for path in sent if path.startswith(("/runtime/", "/nodes/"))}
    assert [path for path in set(sent) if sent.count(path) > 1 and path.endswith(".js")] == []
    answers.clear()
    tab.reload()
    Panel(tab, "talker").wait_for("Hello, world! 1'")
    again = {path for path, code in answers if code == HTTPStatus.OK}
    assert not {path for path in again if path.startswith(("/runtime/", "/nodes/"))}


def test_going_back_shows_what_was_edited_meanwhile(
    tab: Page, site: Path, serving: Callable[[Path], Serving]
) -> None:
    served = serving(site)
    tab.goto(served.url)
    tab.goto(f"{served.url}other/")
    served.write("index.md", "# Welcome\n\nThe second text.\n")
    wait_until(lambda: "index.md: built" in served.said.getvalue())
    tab.go_back()
    expect(tab.locator("main")).to_contain_text("The second text.")


def test_a_closed_tab_prints_nothing(
    site: Path, serving: Callable[[Path], Serving], capfd: pytest.CaptureFixture[str]
) -> None:
    served = serving(site)
    for _ in range(20):
        with socket.create_connection(("127.0.0.1", served.server.port)) as connection:
            connection.sendall(b"GET /index.html HTTP/1.1\r\nHost: localhost\r\n\r\nGET / HT")
            # Closing with this option resets the connection, as a browser that quits does.
            connection.setsockopt(socket.SOL_SOCKET, socket.SO_LINGER, struct.pack("ii", 1, 0))
    with urllib.request.urlopen(served.url) as page:
        page.read()
    assert capfd.readouterr().err == ""


def test_every_file_is_sent_as_what_it_is(built: Built) -> None:
    suffixes = {file.suffix for file in built(ROOT).rglob("*") if file.is_file()} - {""}
    types = {suffix: media_type(f"file{suffix}") for suffix in suffixes}
    assert "application/octet-stream" not in types.values()
    assert {types[suffix] for suffix in (".js", ".mjs")} == {"text/javascript; charset=utf-8"}
    assert types[".wasm"] == "application/wasm"


def test_a_port_in_use_is_left_to_who_has_it(site: Path) -> None:
    with socket.socket() as taken:
        taken.bind(("127.0.0.1", 0))
        taken.listen()
        port = taken.getsockname()[1]
        with subprocess.Popen(
            [sys.executable, "-m", "sitegen", "serve", site, "--port", str(port)],
            stdout=subprocess.PIPE,
            text=True,
            env=os.environ | {"PYTHONUNBUFFERED": "1"},
        ) as process:
            assert process.stdout
            lines = []
            for line in process.stdout:
                lines.append(line)
                if "Ctrl-C" in line:
                    break
            assert f"port {port} is in use\n" in lines
            url = lines[-1].split()[0]
            assert url != f"http://localhost:{port}/"
            with urllib.request.urlopen(url) as page:
                assert b"The first text." in page.read()
            process.send_signal(signal.SIGINT)
            assert process.wait(10) == 0
    assert not (site / "dist").exists()


def test_nothing_outside_of_the_site_is_served(
    site: Path, serving: Callable[[Path], Serving]
) -> None:
    served = serving(site)
    for path in (
        "../site.yaml",
        "%2e%2e/site.yaml",
        "site.yaml",
        "_sitegen/server.py",
        "/etc/passwd",
    ):
        with pytest.raises(urllib.error.HTTPError, match="404"):
            urllib.request.urlopen(served.url + path)
    assert json.dumps(served.live.file("../site.yaml")) == "null"
