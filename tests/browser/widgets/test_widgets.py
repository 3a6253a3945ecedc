"""Widgets in a real browser, on a page whose nodes do what the test says."""

from __future__ import annotations

import shutil
from pathlib import Path

import pytest
from browser import Serve
from paths import ROOT
from playwright.sync_api import Page as Tab
from playwright.sync_api import expect
from stage import WIDER

PAGE = """<!DOCTYPE html>
<html lang="en"><title>Widgets</title>
<link rel="icon" href="theme/favicon.svg">
<link rel="stylesheet" href="theme/style.css">
<link rel="stylesheet" href="theme/widgets.css">
<link rel="stylesheet" href="theme/consoles.css">
<div class="ros-panel"><div class="ros-widget ros-console" id="alone"></div></div>
<div class="ros-panel">
<div class="ros-widget ros-buttons" id="buttons" data-ros-widget="buttons"></div>
<div class="ros-widget ros-console" id="console" data-ros-widget="console"></div>
</div>
<script type="module">
import { mount as mountConsole } from "./runtime/widgets/console.js";
import { mount as mountButtons } from "./runtime/widgets/buttons.js";

const node = Object.assign(new EventTarget(), {
  name: "talker",
  state: "stopped",
  needs: [],
  calls: [],
  start() { this.calls.push("start"); },
  stop() { this.calls.push("stop"); },
  clear() { this.calls.push("clear"); this.dispatchEvent(new Event("clear")); },
  become(state) { this.state = state; this.dispatchEvent(new Event("state")); },
  print(lines) { this.dispatchEvent(new CustomEvent("lines", { detail: lines })); },
  say(...texts) { this.print(texts.map((text) => ({ severity: "info", text }))); },
});
const ros = { nodes: new Map([["talker", node]]), keep() {} };
const options = { node: "talker" };
window.frames = (count) => new Promise((resolve) => {
  const next = () => (count-- > 0 ? requestAnimationFrame(next) : resolve());
  next();
});
window.node = node;
window.unmount = [
  mountConsole(document.getElementById("alone"), ros, options),
  mountConsole(document.getElementById("console"), ros, options),
  mountButtons(document.getElementById("buttons"), ros, options),
];
document.body.dataset.ready = "";
</script>
"""


@pytest.fixture
def page(tab: Tab, serve: Serve, tmp_path: Path) -> Tab:
    shutil.copytree(ROOT / "sitegen/runtime", tmp_path / "runtime")
    shutil.copytree(ROOT / "themes/default", tmp_path / "theme")
    (tmp_path / "index.html").write_text(PAGE)
    tab.goto(serve(tmp_path))
    tab.wait_for_selector("body[data-ready]")
    return tab


def lines(page: Tab) -> list[str]:
    """Return the lines of the console, once it has drawn them."""
    found: list[str] = page.evaluate(
        "async () => { await frames(2);"
        " return [...document.querySelector('#console .ros-lines').children]"
        ".map((row) => row.textContent); }"
    )
    return found


def from_end(page: Tab) -> float:
    """Return how far, in pixels, the console is scrolled away from its end."""
    distance: float = page.evaluate(
        "async () => { await frames(3); const log = document.querySelector('#console .ros-lines');"
        " return log.scrollHeight - log.scrollTop - log.clientHeight; }"
    )
    return distance


def print_numbers(page: Tab, first: int, last: int) -> None:
    page.evaluate(
        "([a, b]) => { for (let i = a; i <= b; i++) node.say(`line ${i}`); }", [first, last]
    )


def test_a_flood_keeps_the_newest_lines_in_order(page: Tab) -> None:
    created = page.evaluate(
        """async () => {
          let created = 0;
          const count = (changes) => {
            for (const { addedNodes } of changes) created += addedNodes.length;
          };
          const watch = new MutationObserver(count);
          watch.observe(document.querySelector("#console .ros-lines"), { childList: true });
          let number = 0;
          for (let burst = 0; burst < 10; burst++) {
            for (let i = 0; i < 10_000; i++) node.say(`line ${number++}`);
            await frames(1);
          }
          await frames(2);
          count(watch.takeRecords());
          return created;
        }"""
    )
    assert lines(page) == [f"line {number}" for number in range(99_000, 100_000)]
    assert created <= 11_000


def test_one_event_may_bring_a_hundred_thousand_lines(page: Tab) -> None:
    page.evaluate("node.say('before', 'that')")
    page.evaluate("node.say(...Array.from({ length: 100_000 }, (_, i) => `line ${i}`))")
    page.evaluate("node.say('after')")
    expected = [f"line {number}" for number in range(99_001, 100_000)]
    assert lines(page) == [*expected, "after"]


# Another browser cannot be asked to collect its garbage.
@pytest.mark.chromium
def test_nothing_piles_up_while_the_tab_is_hidden(page: Tab) -> None:
    # A hidden tab gets no frames: hold them back, and see which lines stay in memory.
    page.evaluate(
        """() => {
          window.real = window.requestAnimationFrame;
          window.held = [];
          window.requestAnimationFrame = (draw) => held.push(draw);
          window.printed = [];
          for (let i = 0; i < 50_000; i++) {
            const line = { severity: "info", text: `line ${i}` };
            printed.push(new WeakRef(line));
            node.print([line]);
          }
        }"""
    )
    page.context.new_cdp_session(page).send("HeapProfiler.collectGarbage")
    alive = page.evaluate("printed.filter((line) => line.deref()).length")
    assert 1000 <= alive <= 2100
    assert page.locator("#console .ros-lines > *").count() == 0
    page.evaluate("window.requestAnimationFrame = real; for (const draw of held) draw();")
    assert lines(page) == [f"line {number}" for number in range(49_000, 50_000)]


def test_lines_are_text_with_the_colour_of_their_severity(page: Tab) -> None:
    page.evaluate(
        """node.print([
          { severity: "error", text: "<img src=x onerror=alert(1)>" },
          { severity: "warn", text: "two\\nrows" },
          { severity: "stdout", text: "" },
        ])"""
    )
    assert lines(page) == ["<img src=x onerror=alert(1)>", "two\nrows", ""]
    assert page.locator("#console .ros-lines img").count() == 0
    rows = page.locator("#console .ros-lines > *")
    colours = rows.evaluate_all("(rows) => rows.map((row) => getComputedStyle(row).color)")
    assert len(set(colours)) == 3
    heights = rows.evaluate_all("(rows) => rows.map((row) => row.offsetHeight)")
    assert heights[1] > heights[0] >= heights[2] > 0


def test_colours_of_terminals_are_shown_and_other_escape_sequences_left_out(page: Tab) -> None:
    printed = [
        "[INFO] [1795000000.000000000] [arm]: ␛[34m␛[1mCreating␛[0m␛[0m it",
        "␛[38;5;208morange␛[48:2::1:2:3m on dark␛[39;49m, ␛[3;31mred␛[23m␛[m.",
        "␛[7mreversed␛[27;45m on magenta",
        "␛[2J␛[Hcleared ␛]0;title\a␛]8;;https://example.org␛\\a link␛]8;;␛\\"
        "␛(B ␛7end␛[999;999;5;1m␛[38m␛[38;9m␛",
    ]
    page.evaluate(
        "(printed) => node.say(...printed)", [line.replace("␛", "\x1b") for line in printed]
    )
    page.wait_for_selector("#console .ros-styled")
    assert lines(page) == [
        "[INFO] [1795000000.000000000] [arm]: Creating it",
        "orange on dark, red.",
        "reversed on magenta",
        "cleared a link end",
    ]
    found = page.locator("#console .ros-styled").evaluate_all(
        """(parts) => parts.map((part) => {
          const { color, backgroundColor, fontWeight, fontStyle } = getComputedStyle(part);
          const paper = backgroundColor.replace(/(?<=srgb).*/, "");
          return [part.textContent, color, paper, fontWeight, fontStyle];
        })"""
    )
    accent, ink, magenta = "rgb(147, 173, 255)", "rgb(227, 232, 243)", "color(srgb"
    paper, clear = "rgb(16, 20, 31)", "rgba(0, 0, 0, 0)"
    error = "rgb(255, 138, 138)"
    assert found == [
        ["Creating", accent, clear, "600", "normal"],
        ["orange", "rgb(255, 135, 0)", clear, "400", "normal"],
        [" on dark", "rgb(255, 135, 0)", "rgb(1, 2, 3)", "400", "normal"],
        ["red", error, clear, "400", "italic"],
        ["reversed", paper, ink, "400", "normal"],
        [" on magenta", paper, magenta, "400", "normal"],
    ]


def test_the_console_follows_until_the_reader_scrolls_up(page: Tab) -> None:
    newest = page.locator("#console .ros-newest")
    print_numbers(page, 1, 1000)
    assert from_end(page) < 2
    assert newest.is_hidden()

    page.locator("#console .ros-lines").evaluate("(log) => log.scrollTo(0, 4000)")
    assert from_end(page) > 1000
    assert newest.is_visible()
    reading = (
        "() => { const log = document.querySelector('#console .ros-lines');"
        " const { left, top } = log.getBoundingClientRect();"
        " return document.elementFromPoint(left + 30, top + 60).textContent; }"
    )
    before = page.evaluate(reading)
    print_numbers(page, 1001, 1100)
    assert lines(page)[0] == "line 101"
    assert page.evaluate(reading) == before

    newest.click()
    assert from_end(page) < 2
    assert newest.is_hidden()
    print_numbers(page, 1101, 1110)
    assert from_end(page) < 2


def test_a_console_that_becomes_smaller_follows(page: Tab) -> None:
    """Between the frame in which the console scrolls and the event that says so."""
    page.evaluate(
        """async () => {
          const log = document.querySelector("#console .ros-lines");
          const frame = () => new Promise(requestAnimationFrame);
          node.say(...Array.from({ length: 100 }, (_, number) => `line ${number}`));
          await frame();
          await new Promise((resolve) => setTimeout(resolve));
          log.style.height = `${log.clientHeight - 60}px`;
          for (let count = 0; count < 3; count += 1) await frame();
        }"""
    )
    assert from_end(page) < 2
    assert page.locator("#console .ros-newest").is_hidden()


def test_the_keyboard_scrolls_the_console(page: Tab) -> None:
    log = page.get_by_role("log", name="talker").last
    print_numbers(page, 1, 200)
    assert from_end(page) < 2
    log.focus()
    page.keyboard.press("Home")
    page.wait_for_function("() => document.querySelector('#console .ros-lines').scrollTop === 0")
    expect(page.locator("#console .ros-newest")).to_be_visible()


def test_clear_empties_the_console_and_the_hint_returns(page: Tab) -> None:
    hint = page.locator("#console .ros-hint")
    assert hint.inner_text() == "Press Start to run talker"
    assert page.locator("#alone .ros-hint").inner_text() == "Not running"
    page.evaluate("node.become('starting')")
    assert hint.inner_text() == "Starting…"
    page.evaluate("node.say('hello')")
    assert lines(page) == ["hello"]
    assert hint.is_hidden()
    page.evaluate("node.say('lost')")
    page.locator("#buttons").get_by_role("button", name="Clear").click()
    assert lines(page) == []
    assert hint.is_visible()


@pytest.mark.parametrize(
    ("state", "start", "stop"),
    [
        ("stopped", True, False),
        ("starting", False, True),
        ("running", False, True),
        ("stopping", False, False),
        ("failed", True, False),
    ],
)
def test_buttons_offer_what_the_state_allows(
    page: Tab, state: str, start: bool, stop: bool
) -> None:
    page.evaluate("(state) => node.become(state)", state)
    assert page.get_by_role("button", name="Start").is_enabled() is start
    assert page.get_by_role("button", name="Stop").is_enabled() is stop
    assert page.locator("#buttons").get_by_role("button", name="Clear").is_enabled()
    assert page.locator("#buttons [aria-live=polite]").inner_text() == state
    assert page.locator("#alone .ros-state").inner_text() == state
    assert page.locator("#console .ros-state").is_hidden()


def test_buttons_call_the_node_and_are_big_enough(page: Tab) -> None:
    page.set_viewport_size({"width": 360, "height": 700})
    page.get_by_role("button", name="Start").focus()
    page.keyboard.press("Enter")
    page.evaluate("node.become('running')")
    page.get_by_role("button", name="Stop").click()
    page.locator("#buttons").get_by_role("button", name="Clear").click()
    assert page.evaluate("node.calls") == ["start", "stop", "clear"]
    sizes = page.locator("#buttons button:visible").evaluate_all(
        "(all) => all.map((each) => Math.min(each.offsetWidth, each.offsetHeight))"
    )
    assert min(sizes) >= 44
    assert page.evaluate(WIDER) == 0


def test_nothing_moves_when_widgets_come_and_nothing_stays_when_they_go(page: Tab) -> None:
    measure = "() => [...document.querySelectorAll('.ros-widget')].map((e) => e.offsetHeight)"
    mounted = page.evaluate(measure)
    page.evaluate("window.left = document.querySelector('#console .ros-state')")
    page.evaluate("node.say('pending'); unmount.forEach((leave) => leave())")
    page.evaluate("node.say('late'); node.become('running'); node.clear()")
    assert page.evaluate("left.textContent") == "stopped"
    assert page.locator(".ros-widget > *").count() == 0
    assert page.evaluate(measure) == mounted


def test_a_notice_that_says_more_has_the_button_for_it(stage: Tab) -> None:
    stage.evaluate(
        """async () => {
          const { notify } = await import("./runtime/page/notice.js");
          notify("First.");
          notify("Second.", { label: "Start", press: () => void (window.pressed = true) });
        }"""
    )
    notice = stage.locator(".ros-word")
    expect(notice).to_contain_text("First. Second.")
    notice.get_by_role("button", name="Start").click()
    expect(notice).to_have_count(0)
    assert stage.evaluate("window.pressed")
