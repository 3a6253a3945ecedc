"""The levels of loggers, set from the log: of a C++ node, and what is wrong with others."""

from __future__ import annotations

from browser import Built, Serve
from paths import SITES
from playwright.sync_api import Page as Tab
from playwright.sync_api import expect
from stage import WIDER, add, show

SRV = "rcl_interfaces/srv"


def test_a_node_logs_what_its_level_says(tab: Tab, serve: Serve, built: Built) -> None:
    tab.goto(f"{serve(built(SITES / 'instruments'))}health/")
    panel = tab.locator(".ros-log")
    panel.scroll_into_view_if_needed()
    expect(panel.get_by_text("Nothing logged yet")).to_be_visible()
    levels = panel.get_by_role("button", name="Levels")
    levels.click()
    expect(levels).to_have_attribute("aria-expanded", "true")
    level = panel.get_by_label("gauges")
    expect(level).to_have_value("0")
    level.select_option("debug")
    expect(panel.get_by_role("log")).to_contain_text("DEBUG gauges: measurement")
    expect(panel.get_by_label("severity")).to_have_value("debug")
    # The node itself says so, also to who asks later.
    levels.click()
    tab.get_by_role("region", name="gauges").get_by_role("button", name="Stop").click()
    tab.get_by_role("region", name="gauges").get_by_role("button", name="Start").click()
    levels.click()
    expect(panel.get_by_label("gauges")).to_have_value("0")
    panel.get_by_label("gauges").select_option("error")
    expect(panel.locator(".ros-logger-levels .ros-wrong")).to_have_count(0)
    value = """async () => {
      const { ros } = await import(document.querySelector("script[type=module]").src);
      const { levels } = await ros.call("/gauges/get_logger_levels",
        "rcl_interfaces/srv/GetLoggerLevels", { names: ["gauges"] });
      return levels[0].level;
    }"""
    while tab.evaluate(value) != 40:
        tab.wait_for_timeout(50)


def test_nodes_without_the_services_are_named(stage: Tab) -> None:
    stage.evaluate(
        f"""() => {{
          for (const name of ["GetLoggerLevels", "SetLoggerLevels"]) {{
            ros.types[`{SRV}/${{name}}_Request`] = ros.fields("");
          }}
          ros.answer = async (request) => request.names
            ? {{ levels: [{{ level: 20 }}] }}
            : {{ results: [{{ successful: false, reason: "not <i>now</i>" }}] }};
        }}"""
    )
    for name in ("/talker", "/arm/driver", "/_hidden"):
        add(stage, "node", name, "", "")
    for service in ("Get", "Set"):
        where = f"/arm/driver/{service.lower()}_logger_levels"
        add(stage, "service", "/arm/driver", where, f"{SRV}/{service}LoggerLevels")
    panel = show(stage, "log")
    panel.get_by_role("button", name="Levels").click()
    level = panel.get_by_label("arm.driver")
    expect(level).to_have_value("20")
    expect(panel.locator(".ros-note")).to_have_text(
        "No logger services: /talker. A node offers them if its program sets the option "
        "enable_logger_service."
    )
    level.select_option("fatal")
    expect(panel.get_by_role("status")).to_have_text("not <i>now</i>")
    expect(level).to_have_value("20")
    stage.evaluate(
        """ros.emit("/rosout", { stamp: { sec: 1, nanosec: 0 }, level: 20, name: "arm.driver.bus",
          msg: "", file: "", function: "", line: 1 })"""
    )
    expect(panel.get_by_label("arm.driver.bus")).to_have_value("20")
    stage.set_viewport_size({"width": 390, "height": 800})
    assert stage.evaluate(WIDER) <= 0
    stage.evaluate("ros.graph.remove('/arm/driver')")
    expect(panel.locator(".ros-level-list li")).to_have_count(0)
