"""The panel of diagnostics: with a real C++ node, and with statuses that are odd or many."""

from __future__ import annotations

from browser import Built, Serve
from paths import SITES
from playwright.sync_api import Locator, expect
from playwright.sync_api import Page as Tab
from stage import WIDER, add, hide_tab, show, stop_clock, subscribed


def rows(panel: Locator) -> list[str]:
    """What the rows of the tree say, with their depths."""
    found: list[str] = panel.locator(".ros-diagnostic").evaluate_all(
        "(rows) => rows.map((row) => `${row.dataset.depth} ${row.innerText.replace(/\\s+/g, ' ')}`)"
    )
    return [row.strip() for row in found]


def test_the_health_of_a_robot_is_shown(tab: Tab, serve: Serve, built: Built) -> None:
    tab.goto(f"{serve(built(SITES / 'instruments'))}health/")
    panel = tab.locator(".ros-diagnostics")
    panel.scroll_into_view_if_needed()
    base = panel.locator(".ros-diagnostic").filter(has_text="laser")
    expect(base).to_contain_text("ERROR")
    # A status that is no longer reported is stale.
    gripper = panel.locator(".ros-diagnostic").filter(has_text="gripper")
    expect(gripper).to_contain_text("STALE")
    assert rows(panel) == [
        "0 arm WARN",
        "1 left motor OK cool",
        "1 right motor WARN warm",
        "0 base ERROR",
        "1 laser ERROR <b>no echo</b>",
        "1 gripper STALE open",
    ]
    levels = panel.get_by_role("group", name="show only").get_by_role("button")
    assert [" ".join(one.split()) for one in levels.all_inner_texts()] == [
        *("ERROR 1", "STALE 1", "WARN 1", "OK 1"),
    ]
    base.get_by_role("button", name="laser").click()
    values = panel.locator(".ros-values")
    expect(panel.locator(".ros-detail")).to_contain_text("<b>no echo</b> · hardware: bus-7")
    expect(values.locator("tr").nth(1)).to_have_text("unitK & <i>")
    before = int(values.locator("td").first.inner_text())
    expect(values.locator("td").first).not_to_have_text(str(before))
    levels.first.click()
    assert rows(panel) == ["0 base ERROR", "1 laser ERROR <b>no echo</b>"]
    link = tab.evaluate(
        """async () => {
          const { ros } = await import(document.querySelector("script[type=module]").src);
          return ros.link();
        }"""
    )
    url = tab.url
    tab.goto("about:blank")
    tab.goto(url + link)
    panel.scroll_into_view_if_needed()
    expect(panel.locator(".ros-detail .ros-name")).to_have_text("base/laser")
    expect(panel.locator(".ros-diagnostic")).to_have_count(2)


SEND = """async (statuses) => {
  ros.emit("/diagnostics", { header: {}, status: statuses.map((one) =>
    ({ level: 0, name: "", message: "", hardware_id: "", values: [], ...one })) });
  await frames();
}"""
TYPE = "diagnostic_msgs/msg/DiagnosticArray"


def health(stage: Tab) -> Locator:
    stage.evaluate(f"void (ros.types['{TYPE}'] = ros.fields(''))")
    add(stage, "publisher", "/base", "/diagnostics", TYPE)
    return show(stage, "diagnostics")


def test_a_silent_status_becomes_stale_and_comes_back(stage: Tab) -> None:
    stop_clock(stage)
    stage.evaluate(f"void (ros.types['{TYPE}'] = ros.fields(''))")
    add(stage, "publisher", "/base", "/diagnostics", TYPE)
    stage.evaluate("void show('diagnostics')")
    while not subscribed(stage):
        stage.wait_for_timeout(20)
    send = SEND.replace("await frames();", "")
    stage.evaluate(send, [{"name": "/a/b", "level": 1}])
    stage.clock.run_for(4000)
    panel = stage.locator("#panel")
    expect(panel.locator(".ros-diagnostic .ros-health").last).to_have_text("WARN")
    stage.clock.run_for(3000)
    assert rows(panel) == ["0 a STALE", "1 b STALE"]
    stage.evaluate(send, [{"name": "/a/b"}])
    stage.clock.run_for(100)
    assert rows(panel) == ["0 a OK"]


def test_groups_open_and_close_with_the_keyboard(stage: Tab) -> None:
    panel = health(stage)
    stage.evaluate(SEND, [{"name": "arm: motor"}, {"name": "arm"}])
    assert rows(panel) == ["0 arm OK"]
    fold = panel.get_by_role("button", name="Show what arm contains")
    fold.focus()
    stage.keyboard.press("Enter")
    assert rows(panel) == ["0 arm OK", "1 motor OK"]
    expect(fold).to_be_focused()
    stage.keyboard.press("Enter")
    assert rows(panel) == ["0 arm OK"]
    panel.get_by_role("button", name="OK").click()
    assert rows(panel) == ["0 arm OK"]


def test_odd_and_many_statuses_are_bounded(stage: Tab) -> None:
    panel = health(stage)
    deep = {"name": "a/" * 500, "message": "m" * 9999}
    odd = [{"name": "", "level": 77}, {"name": "/" * 500}, deep]
    stage.evaluate(SEND, odd)
    assert rows(panel)[0] == "0 ? OK"
    stage.evaluate(
        "async (send) => (0, eval)(send)(Array.from({length: 5000}, (_, n) => "
        "({ name: `m${n}`, level: 2, values: Array.from({length: 9}, () => "
        "({ key: 'k', value: '<img src=x>' })) })))",
        SEND,
    )
    expect(panel.locator(".ros-note")).to_have_text("Only the first 2000 statuses are shown")
    assert panel.locator(".ros-diagnostic").count() <= 2100
    panel.get_by_role("button", name="m7", exact=True).click()
    expect(panel.locator(".ros-values td").first).to_have_text("<img src=x>")
    stage.set_viewport_size({"width": 390, "height": 800})
    assert stage.evaluate(WIDER) <= 0


def test_an_aggregator_comes_first_and_nothing_is_followed_unseen(stage: Tab) -> None:
    health(stage)
    assert subscribed(stage) == ["/diagnostics"]
    add(stage, "publisher", "/aggregator", "/diagnostics_agg", TYPE)
    assert subscribed(stage) == ["/diagnostics_agg"]
    hide_tab(stage, True)
    assert subscribed(stage) == []
    hide_tab(stage, False)
    assert subscribed(stage) == ["/diagnostics_agg"]
    stage.evaluate("unmount()")
    assert subscribed(stage) == []


def test_a_page_without_diagnostics_says_so(stage: Tab) -> None:
    panel = show(stage, "diagnostics", {"topic": "/arm/diagnostics"})
    expect(panel.get_by_text("No node uses /arm/diagnostics now.")).to_be_visible()
