"""An open page shows what its author edits, in a real browser."""

from __future__ import annotations

import contextlib
import json
import shutil
from collections.abc import Callable
from pathlib import Path

import pytest
from browser import WITHOUT_JSPI
from panel import Panel
from paths import ROOT
from playwright.sync_api import Browser, Page, Route, expect
from served import SITE, TEXT, Serving, edited_site
from waiting import until

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
    served.write("index.md", "# Welcome\n\nThe third text.\n")
    expect(tab.locator("main")).to_contain_text("The third text.")
    assert tab.evaluate("window.still")


def test_an_edit_while_a_page_loads_is_shown(
    tab: Page, site: Path, serving: Callable[[Path], Serving]
) -> None:
    served = serving(site)
    edits = ["Edited while it loads."]

    def late(route: Route) -> None:
        if edits:
            before = served.live.builds
            served.write("index.md", f"# Welcome\n\n{edits.pop()}\n")
            until(lambda: served.live.builds > before)
        route.continue_()

    tab.route("**/_sitegen/follow.js", late)
    tab.goto(served.url)
    expect(tab.locator("main")).to_contain_text("Edited while it loads.", timeout=20_000)


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
    until(lambda: len(talker.lines()) > seen)


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
    until(opened.is_file)
    assert opened.read_text() == f"{site / 'site.yaml'} 4\n"
    problems.get_by_role("button", name="Close").click()
    expect(problems).to_be_hidden()


def test_an_error_of_the_compiler_can_be_opened_where_it_is(
    tab: Page,
    tmp_path: Path,
    serving: Callable[[Path], Serving],
    monkeypatch: pytest.MonkeyPatch,
) -> None:
    opened = tmp_path / "opened"
    monkeypatch.setenv("SITEGEN_EDITOR", f"sh -c 'echo {{file}} {{line}} > {opened}'")
    served = serving(edited_site(tmp_path))
    tab.goto(served.url)
    source = "src/cpp_pubsub/src/talker.cpp"
    served.write(source, "int first = 1;\nint second = fist;\nint main() {return third;}\n")
    problems = tab.get_by_role("alert")
    expect(problems).to_contain_text("could not compile: use of undeclared identifier 'fist'")
    places = problems.get_by_role("button", name=source)
    expect(places).to_have_text([f"{source}:{place}" for place in ("2:14", "2:14", "1:5", "3:20")])
    places.last.click()
    until(opened.is_file)
    assert opened.read_text() == f"{served.folder / source} 3\n"


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


def test_going_back_shows_what_was_edited_meanwhile(
    tab: Page, site: Path, serving: Callable[[Path], Serving]
) -> None:
    served = serving(site)
    tab.goto(served.url)
    tab.goto(f"{served.url}other/")
    served.write("index.md", "# Welcome\n\nThe second text.\n")
    until(lambda: "index.md: built" in served.said.getvalue())
    tab.go_back()
    expect(tab.locator("main")).to_contain_text("The second text.")
