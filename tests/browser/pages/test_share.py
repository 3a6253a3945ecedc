"""Links that carry what a page shows, and pages in frames of others."""

from __future__ import annotations

import base64
import json
from collections.abc import Iterator
from pathlib import Path
from typing import Any

import pytest
from browser import Built, Serve
from panel import Panel
from paths import ROOT
from playwright.sync_api import Browser, FrameLocator, Locator, Page, expect

from sitegen.commands.build import build
from sitegen.report import Report

pytestmark = pytest.mark.firefox

PROSE = ROOT / "tests/sites/prose"
LEFT_OUT = "Parts of this link no longer match this page"


@pytest.fixture
def url(built: Built, serve: Serve) -> str:
    return serve(built(ROOT), "/my-robot/")


def shared(tab: Page) -> Locator:
    """Open the dialog."""
    tab.get_by_role("button", name="Share").click()
    dialog = tab.get_by_role("dialog", name="Share")
    expect(dialog).to_be_visible()
    return dialog


def fragment(state: object, version: object = 1) -> str:
    text = base64.urlsafe_b64encode(json.dumps(state).encode()).decode().rstrip("=")
    return f"#share={version}.{text}"


def read(link: str) -> Any:
    text = link.partition("#share=1.")[2]
    return json.loads(base64.urlsafe_b64decode(text + "=" * (-len(text) % 4)))


def word(tab: Page | FrameLocator) -> Locator:
    return tab.locator(".ros-word")


def agree(tab: Page | FrameLocator, who: str) -> None:
    """Let the link start its nodes."""
    expect(word(tab)).to_contain_text(f"This link starts {who}.")
    word(tab).get_by_role("button", name="Start").click()
    expect(word(tab)).to_have_count(0)


def panel(tab: Page, kind: str) -> Locator:
    """A panel, seen: nobody can use one that is not, and it does nothing."""
    tab.locator(".tabbed-labels").get_by_text(kind.title()).click()
    found = tab.locator(f"[data-ros-widget={kind}]")
    found.scroll_into_view_if_needed()
    return found


@pytest.fixture
def fresh(browser: Browser, serve: Serve) -> Iterator[Page]:
    """A tab of another visitor."""
    context = browser.new_context()
    yield context.new_page()
    context.close()


def test_a_link_carries_what_runs_and_what_panels_show(tab: Page, fresh: Page, url: str) -> None:
    tab.goto(f"{url}demo05/")
    Panel(tab, "talker").start()
    Panel(tab, "server").start()
    panel(tab, "topics").get_by_role("checkbox").check()
    panel(tab, "topics").get_by_role("button", name="/rosout").click()
    panel(tab, "publish").get_by_label("data").fill("Grüße, 世界 “”")
    panel(tab, "publish").get_by_label("messages per second").fill("5")
    services = panel(tab, "services")
    services.get_by_label("a int64").fill("no number")
    services.get_by_label("b int64").fill("2")
    panel(tab, "log").get_by_label("severity").select_option("warn")
    panel(tab, "log").get_by_label("text").fill("hello")
    Panel(tab, "talker").wait_for("Hello")
    Panel(tab, "server").expect_state("running")
    link = shared(tab).get_by_label("Link").input_value()
    assert link.startswith(f"{url}demo05/#share=1.")
    assert len(link) < 600
    assert read(link)["run"] == ["server", "talker"]

    fresh.goto(link)
    agree(fresh, "server and talker")
    Panel(fresh, "talker").wait_for("Hello")
    Panel(fresh, "server").expect_state("running")
    Panel(fresh, "listener").expect_state("stopped")
    topics = panel(fresh, "topics")
    chosen = topics.locator("[aria-pressed=true]")
    expect(chosen).to_have_text("/rosout")
    expect(topics.locator(".ros-echo")).to_contain_text("Hello, world!")
    publish = panel(fresh, "publish")
    expect(publish.get_by_label("data")).to_have_value("Grüße, 世界 “”")
    expect(publish.get_by_label("messages per second")).to_have_value("5")
    services = panel(fresh, "services")
    expect(services.get_by_label("a int64")).to_have_value("no number")
    expect(services.get_by_label("b int64")).to_have_value("2")
    # A link fills forms; it sends nothing.
    assert services.locator(".ros-note").inner_text() == ""
    assert publish.locator(".ros-note").inner_text() == ""
    expect(panel(fresh, "log").get_by_label("severity")).to_have_value("warn")
    expect(panel(fresh, "log").get_by_label("text")).to_have_value("hello")
    expect(word(fresh)).to_have_count(0)
    # The same again is the same link.
    again = shared(fresh).get_by_label("Link").input_value()
    assert read(again) == read(link)


def test_a_page_as_it_begins_has_a_short_link(tab: Page, url: str) -> None:
    tab.goto(f"{url}demo05/")
    Panel(tab, "talker").expect_state("stopped")
    assert read(shared(tab).get_by_label("Link").input_value()) == {"run": []}


def test_nodes_without_buttons_run_whatever_a_link_says(tab: Page, url: str) -> None:
    tab.goto(f"{url}demo01/{fragment({'run': []})}")
    Panel(tab, "talker").wait_for("Hello, world! 1")


@pytest.mark.parametrize(
    "odd",
    [
        "#share=",
        "#share=1.%%%",
        "#share=1." + "A" * 40_000,
        fragment({"run": ["talker"]}, 2),
        fragment([1, 2]),
        fragment(None),
        fragment({"run": "talker"}),
        fragment({"run": ["talker", "gone"], "show": {}}),
        fragment({"run": [], "parameters": {"talker": {"rate": 3}}}),
        fragment({"show": {"topics-1": {"topic": 7}}}),
        fragment({"show": {"topics-9": {"topic": "/chatter"}}}),
        fragment({"show": {"topics-1": {"__proto__": "x", "constructor": "y"}}}),
        fragment({"show": {"log-1": {"severity": "loud"}}}),
        fragment({"show": {"publish-1": {"message": {"data": {"a": 1}, "more": "x"}}}}),
        fragment({"show": ["x"], "tabs": ["main", "nowhere"]}),
    ],
)
def test_an_odd_link_breaks_nothing_and_is_told_in_one_word(tab: Page, url: str, odd: str) -> None:
    tab.goto(f"{url}demo05/{odd}")
    talker = Panel(tab, "talker")
    panel(tab, "publish")
    expect(word(tab)).to_contain_text(LEFT_OUT)
    assert word(tab).count() == 1
    if talker.button("Start").is_enabled():
        talker.start()
    talker.wait_for("Hello")
    word(tab).get_by_role("button", name="Close").click()
    expect(word(tab)).to_have_count(0)


def test_a_link_that_is_pasted_into_the_page_itself_counts(tab: Page, url: str) -> None:
    tab.goto(f"{url}demo02/")
    Panel(tab, "talker").expect_state("stopped")
    tab.goto(f"{url}demo02/{fragment({'run': ['talker']})}")
    agree(tab, "talker")
    Panel(tab, "talker").wait_for("Hello")


def test_a_link_starts_nothing_against_the_will_of_the_visitor(tab: Page, url: str) -> None:
    tab.goto(f"{url}demo05/{fragment({'run': ['talker', 'gone']})}")
    expect(word(tab)).to_contain_text(f"This link starts talker. {LEFT_OUT}")
    assert word(tab).get_attribute("role") == "status"
    word(tab).get_by_role("button", name="Close").click()
    expect(word(tab)).to_have_count(0)
    Panel(tab, "talker").expect_state("stopped")
    # Others can be started as ever.
    Panel(tab, "server").start()
    Panel(tab, "server").expect_state("running")


def test_the_question_goes_when_the_visitor_starts_the_nodes(tab: Page, url: str) -> None:
    tab.goto(f"{url}demo05/{fragment({'run': ['talker', 'server']})}")
    expect(word(tab)).to_contain_text("This link starts server and talker.")
    Panel(tab, "talker").start()
    Panel(tab, "talker").expect_state("running")
    expect(word(tab)).to_be_visible()
    Panel(tab, "server").start()
    expect(word(tab)).to_have_count(0)


def test_the_author_decides_whether_links_start_nodes(
    tmp_path: Path, tab: Page, serve: Serve
) -> None:
    program = "ros2wasm: node.js, types: {}"
    names = [f"node{number}" for number in range(6)]
    nodes = ", ".join(f"{name}: {{{program}}}" for name in ["itself", *names])
    content = ", ".join(f"{{buttons: {name}}}" for name in names)
    itself = "{buttons: {node: itself, autostart: true}}"
    page = f"title: T, nodes: {{{nodes}}}, content: [{itself}, {content}]"
    (tmp_path / "node.js").write_text("setInterval(() => {}, 1000);\n")
    (tmp_path / "site.yaml").write_text(
        f"site: {{title: T}}\npages:\n  - {{path: /, {page}}}\n"
        f"  - {{path: at-once/, start_from_links: [{', '.join(names)}], {page}}}\n"
        f"  - {{path: some/, start_from_links: [node0], {page}}}\n"
    )
    build(tmp_path, output=tmp_path / "dist", report=Report())
    home = serve(tmp_path / "dist")

    def shown(name: str) -> Locator:
        # A narrow panel hides the button that cannot be pressed.
        group = tab.get_by_role("group", name=name)
        return group.get_by_role("button", name="Start", include_hidden=True)

    everything = fragment({"run": names})
    tab.goto(f"{home}at-once/{everything}")
    for name in names:
        expect(shown(name)).to_be_disabled()
    # What starts with the page stays stopped if the link says so, and nobody is asked.
    expect(shown("itself")).to_be_enabled()
    expect(word(tab)).to_have_count(0)
    # Only the nodes that the author named start by themselves.
    tab.goto(f"{home}some/{everything}")
    expect(shown("node0")).to_be_disabled()
    expect(word(tab)).to_contain_text("This link starts node1, node2, node3, node4, and node5.")
    expect(shown("node1")).to_be_enabled()
    tab.goto(f"{home}{everything}")
    expect(shown("node0")).to_be_enabled()
    expect(shown("itself")).to_be_enabled()
    agree(tab, "6 nodes")
    for name in names:
        expect(shown(name)).to_be_disabled()
    tab.goto("about:blank")
    tab.goto(f"{home}{fragment({'run': ['itself']})}")
    expect(shown("itself")).to_be_disabled()
    expect(word(tab)).to_have_count(0)


@pytest.mark.parametrize(
    "state",
    [
        {"topics-1": {"topic": "/secret"}},
        {"services-1": {"service": "/erase", "request": {}}},
        {"actions-1": {"action": "/launch", "goal": {}}},
        {"publish-1": {"topic": "/_hidden"}},
        {"publish-1": {"topic": "/rosout"}},
        {"image-1": {"topic": "/secret"}},
    ],
)
def test_a_link_opens_nothing_that_the_visitor_could_not(
    tmp_path: Path, tab: Page, serve: Serve, state: dict[str, object]
) -> None:
    """Panels with `show` are about what the author chose."""
    panels = (
        *("topics: {show: [/shown]}", "services: {show: [/shown]}", "actions: {show: [/shown]}"),
        *("publish: {}", "image: /shown", "buttons: node"),
    )
    (tmp_path / "node.js").write_text("setInterval(() => {}, 1000);\n")
    content = ", ".join(f"{{{panel}}}" for panel in panels)
    (tmp_path / "site.yaml").write_text(
        "site: {title: T}\nnodes: {node: {ros2wasm: node.js, types: {}}}\n"
        f"pages: [{{path: /, title: T, content: [{content}]}}]\n"
    )
    build(tmp_path, output=tmp_path / "dist", report=Report())
    tab.goto(f"{serve(tmp_path / 'dist')}{fragment({'show': state})}")
    expect(word(tab)).to_contain_text(LEFT_OUT)
    for name in ("/secret", "/erase", "/launch", "/_hidden", "/rosout"):
        assert name not in tab.locator("main").inner_text()


def test_tabs_of_the_text_are_carried(tmp_path: Path, tab: Page, serve: Serve) -> None:
    page = '# Tabs\n\n=== "C++"\n    One\n=== "Python"\n    Two\n\n```ros\nconsole: talker\n```\n'
    node = "---\nnodes: {talker: {ros2wasm: talker.js, types: {}}}\n---\n"
    (tmp_path / "talker.js").write_text("// a program\n")
    (tmp_path / "page.md").write_text(node + page)
    (tmp_path / "site.yaml").write_text("site: {title: T}\npages: [{path: /, file: page.md}]\n")
    build(tmp_path, output=tmp_path / "dist", report=Report())
    home = serve(tmp_path / "dist")
    tab.goto(home)
    tab.get_by_text("Python", exact=True).click()
    link = shared(tab).get_by_label("Link").input_value()
    tab.goto("about:blank")
    tab.goto(link)
    expect(tab.get_by_text("Two", exact=True)).to_be_visible()
    expect(tab.get_by_text("One", exact=True)).to_be_hidden()


def test_the_link_is_copied_or_marked(tab: Page, url: str) -> None:
    tab.goto(f"{url}demo02/")
    dialog = shared(tab)
    expect(dialog.get_by_role("status")).to_have_text("This link works only on this computer.")
    tab.evaluate(
        "() => { navigator.clipboard.writeText = async (text) => { window.copied = text; }; }"
    )
    dialog.get_by_role("button", name="Copy").first.click()
    expect(dialog.get_by_role("status")).to_have_text("Copied")
    assert tab.evaluate("window.copied") == dialog.get_by_label("Link").input_value()
    tab.evaluate("() => { navigator.clipboard.writeText = () => Promise.reject(new Error()); }")
    dialog.get_by_role("button", name="Copy").last.click()
    expect(dialog.get_by_role("status")).to_contain_text("Ctrl+C")
    assert tab.evaluate(MARKED)
    tab.keyboard.press("Escape")
    expect(dialog).to_be_hidden()


MARKED = """(() => {
  const { selectionStart, selectionEnd, value } = document.activeElement;
  return selectionStart === 0 && selectionEnd === value.length && value.startsWith("<iframe ");
})()"""


def test_a_frame_runs_in_a_page_of_another_site(
    tab: Page, url: str, serve: Serve, tmp_path: Path
) -> None:
    tab.goto(f"{url}demo02/")
    Panel(tab, "talker").start()
    Panel(tab, "talker").wait_for("Hello")
    html = shared(tab).get_by_label("Embed code").input_value()
    head = '<meta charset="utf-8"><title>Blog</title><link rel="icon" href="data:,">'
    (tmp_path / "index.html").write_text(f'<!doctype html><html lang="en">{head}\n{html}')
    other = serve(tmp_path)
    assert other.split("/")[2] != url.split("/")[2]
    tab.goto(other)
    frame = tab.frame_locator("iframe")
    agree(frame, "talker")
    expect(frame.get_by_role("log")).to_contain_text("Hello, world! 1")
    expect(frame.get_by_role("heading", level=1)).to_be_visible()
    for around in ("header.site", "nav", "footer"):
        assert frame.locator(around).locator("visible=true").count() == 0
    whole = frame.get_by_role("link", name="Open the full page")
    expect(whole).to_have_attribute("target", "_blank")
    with tab.context.expect_page() as opened:
        whole.click()
    opened.value.wait_for_url(f"{url}demo02/")
    opened.value.close()
    box = tab.locator("iframe").bounding_box()
    assert box
    assert 320 <= box["height"] <= 720
    assert tab.locator("iframe").get_attribute("title") == "Start and stop · sitegen"


def test_a_link_leads_to_the_slide_that_was_shown(
    tab: Page, fresh: Page, built: Built, serve: Serve
) -> None:
    tab.goto(f"{serve(built(PROSE))}slides/")
    number, button = tab.locator(".deck .number"), tab.get_by_role("button", name="Next")
    button.click()
    button.click()
    Panel(tab, "talker").start()
    Panel(tab, "talker").wait_for("Hello")
    link = shared(tab).get_by_label("Link").input_value()
    assert read(link) == {"run": ["talker"], "at": "3"}
    tab.keyboard.press("Escape")
    # The keys of slides are the page's again.
    tab.locator("body").press("ArrowRight")
    expect(number).to_have_text("4 / 4")

    fresh.goto(link)
    expect(fresh.locator(".deck .number")).to_have_text("3 / 4")
    agree(fresh, "talker")
    Panel(fresh, "talker").wait_for("Hello")
    expect(word(fresh)).to_have_count(0)


def test_a_link_leads_to_the_heading_that_was_chosen(tab: Page, fresh: Page, url: str) -> None:
    tab.goto(f"{url}demo04/")
    heading = tab.locator("main :is(h2, h3)[id]").last
    name = heading.get_attribute("id")
    tab.goto(f"{url}demo04/#{name}")
    link = shared(tab).get_by_label("Link").input_value()
    assert read(link)["at"] == name
    fresh.goto(link)
    expect(fresh.locator(f"[id='{name}']")).to_be_in_viewport()
    # One that names another link leads nowhere else.
    fresh.goto("about:blank")
    fresh.goto(f"{url}demo04/{fragment({'run': [], 'at': 'share=1.x'})}")
    expect(word(fresh)).to_contain_text(LEFT_OUT)
