"""The demos in a real browser, as the site of this repository publishes them."""

from __future__ import annotations

import re
from collections.abc import Iterator
from pathlib import Path
from urllib.parse import urljoin

import pytest
from browser import Built, Serve
from panel import Panel, expect_nothing_left, graph, numbers
from paths import ROOT
from playwright.sync_api import BrowserContext, ConsoleMessage, Locator, Page, expect

from sitegen.commands.build import build
from sitegen.report import Report

pytestmark = [pytest.mark.firefox, pytest.mark.asyncify(always=True)]


@pytest.fixture
def url(built: Built, serve: Serve, engine: str) -> str:
    """The address of the site: at the root of a server for one engine, below it for the other."""
    return serve(built(ROOT), "/" if engine == "jspi" else "/my-robot/")


def paths(addresses: list[str]) -> list[str]:
    """Addresses without the version that page.json gives programs."""
    return [address.partition("?")[0] for address in addresses]


@pytest.fixture
def page(url: str, context: BrowserContext, engine: str) -> Iterator[Page]:
    """A tab in a browser of either engine; the test fails on an error or a foreign request."""
    page = context.new_page()
    wrong: list[str] = []
    loaded: list[str] = []

    def note(message: ConsoleMessage) -> None:
        if message.type in ("error", "warning"):
            wrong.append(message.text)

    page.on("console", note)
    page.on("pageerror", lambda error: wrong.append(str(error)))
    context.on("request", lambda request: loaded.append(request.url))
    yield page
    page.close()
    assert wrong == []
    # Workers start from scripts that the page itself has made.
    own = (url, f"blob:{urljoin(url, '/')}")
    assert [address for address in loaded if not address.startswith(own)] == []
    compiled = [name for name in paths(loaded) if name.endswith(".wasm") and "/nodes/" in name]
    programs = {name.split(".")[-2] for name in compiled}
    assert programs <= {engine}


def test_demo01_talks_by_itself(page: Page, url: str) -> None:
    page.goto(f"{url}demo01/")
    talker = Panel(page, "talker")
    talker.wait_for("Hello, world! 2")
    assert numbers(talker, "Publishing")[:3] == [0, 1, 2]
    assert page.get_by_role("button", name="Start").count() == 0
    assert graph(page) == {
        "nodes": ["/minimal_publisher"],
        "topics": ["/minimal_publisher > /chatter (std_msgs/msg/String) > "],
        "all": ["/minimal_publisher", "/rosout", "/chatter"],
    }
    page.reload()
    talker.wait_for("Hello, world! 1")
    assert numbers(talker, "Publishing")[:2] == [0, 1]


def test_demo02_starts_and_stops(page: Page, url: str) -> None:
    page.goto(f"{url}demo02/")
    talker = Panel(page, "talker")
    talker.expect_state("stopped")
    assert page.workers == []
    for _ in range(3):
        talker.start()
        talker.wait_for("Hello, world! 1")
        assert len(page.workers) == 1
        talker.stop()
        talker.wait_for("Goodbye")  # consoles draw once a frame
        assert talker.messages() == [
            *(f"Publishing: 'Hello, world! {n}'" for n in numbers(talker, "Publishing")),
            f"Goodbye after {len(numbers(talker, 'Publishing'))} greetings",
        ]
        expect_nothing_left(page)
        talker.button("Clear").click()
        assert talker.lines() == []


def test_demo02_can_be_stopped_while_it_starts(page: Page, url: str) -> None:
    page.goto(f"{url}demo02/")
    talker = Panel(page, "talker")
    talker.expect_state("stopped")
    for pause in (0, 1, 5, 20, 60):
        page.evaluate(
            """async (pause) => {
              const src = document.querySelector("script[type=module]").src;
              const { ros } = await import(src);
              const talker = ros.nodes.get("talker");
              talker.start();
              await new Promise((resolve) => setTimeout(resolve, pause));
              talker.stop();
            }""",
            pause,
        )
        talker.expect_state("stopped")
        expect_nothing_left(page)
    talker.start()
    talker.wait_for("Hello, world! 0")


def test_demo03_talks_and_listens_in_any_order(page: Page, url: str) -> None:
    page.goto(f"{url}demo03/")
    talker, listener = Panel(page, "talker"), Panel(page, "listener")

    listener.start()
    listener.expect_state("running")
    talker.start()
    listener.wait_for("Hello, world! 3")
    heard = numbers(listener, "I heard")
    assert heard == list(range(heard[0], heard[-1] + 1))
    assert graph(page)["topics"] == [
        "/minimal_publisher > /chatter (std_msgs/msg/String) > /minimal_subscriber"
    ]

    # The listener alone, again: it hears what is said from now on, with nothing missing.
    listener.stop()
    listener.button("Clear").click()
    missed = numbers(talker, "Publishing")[-1]
    listener.start()
    listener.wait_for("I heard")
    later = numbers(talker, "Publishing")[-1] + 2
    listener.wait_for(f"Hello, world! {later}")
    heard = numbers(listener, "I heard")
    assert heard[0] > missed
    assert heard == list(range(heard[0], heard[-1] + 1))

    # The talker alone, again: nothing is missing from when the listener knows it.
    talker.stop()
    assert graph(page)["nodes"] == ["/minimal_subscriber"]
    listener.button("Clear").click()
    talker.start()
    listener.wait_for("I heard")
    listener.wait_for(f"Hello, world! {numbers(listener, 'I heard')[0] + 2}")
    heard = numbers(listener, "I heard")
    assert heard == list(range(heard[0], heard[-1] + 1))

    talker.stop()
    listener.stop()
    expect_nothing_left(page)


def test_demo05_looks_inside(page: Page, url: str) -> None:
    page.goto(f"{url}demo05/")
    talker, listener, server, client = (
        Panel(page, name) for name in ("talker", "listener", "server", "client")
    )

    def panel(name: str) -> Locator:
        page.locator(".tabbed-labels").get_by_text(name, exact=True).click()
        found = page.get_by_role("region", name=name, exact=True)
        found.scroll_into_view_if_needed()
        return found

    # The client waits for the server, says so, and gets its answer.
    client.start()
    client.wait_for("No service yet, waiting")
    expect(client.panel).to_contain_text("client needs server.")
    services = panel("Services")
    expect(services.get_by_text("no server now")).to_be_visible()
    services.get_by_role("button", name="Call").click()
    expect(services.get_by_role("status")).to_have_text("no server for /add_two_ints now")
    client.button("Start server first").click()
    client.wait_for("Sum: 42")
    client.expect_state("stopped")

    # So does the page, with numbers beyond those of JavaScript.
    services = panel("Services")
    expect(services.get_by_text("served by /add_two_ints_server")).to_be_visible()
    services.get_by_label("a int64").fill("9007199254740993")
    services.get_by_label("b int64").fill("x")
    services.get_by_role("button", name="Call").click()
    expect(services.get_by_text("'x' is not a whole number")).to_be_visible()
    services.get_by_label("b int64").fill("-1")
    services.get_by_role("button", name="Call").click()
    expect(services.get_by_label("response")).to_have_text("sum: 9007199254740992")

    talker.start()
    listener.start()
    topics = panel("Topics")
    expect(topics.get_by_role("log")).to_contain_text(re.compile(r"data: Hello, world! \d+\n---"))
    expect(topics.locator("tbody td:last-child span")).to_have_text(re.compile(r"^[12]\.\d\d Hz$"))
    expect(topics.get_by_text("/minimal_publisher → /minimal_subscriber")).to_be_visible()

    publish = panel("Publish")
    publish.get_by_label("data string").fill("Grüße")
    publish.get_by_role("button", name="Publish once").click()
    listener.wait_for("I heard: 'Grüße'")

    nodes = panel("Nodes")
    expect(nodes.get_by_role("listitem").filter(has_text="cpp_chatter/listener")).to_contain_text(
        "subscribes to"
    )
    expect(nodes).to_contain_text("MB of memory")

    # What the server logged before anybody looked here is not lost: it keeps it.
    log = panel("Log")
    expect(log.get_by_role("log")).to_contain_text("add_two_ints_server: 40 + 2 = 42")
    log.get_by_label("node", exact=True).select_option("minimal_subscriber")
    log.get_by_label("text").fill("Grüße")
    expect(log.get_by_role("log").locator("> *")).to_have_count(1)

    for each in (talker, listener, server):
        each.stop()
    expect(panel("Topics").get_by_text("no publishers")).to_be_hidden()
    page.evaluate("scrollTo(0, 0)")


def test_demo06_has_python_and_cpp_on_one_graph(page: Page, url: str, engine: str) -> None:
    page.goto(f"{url}demo06/")
    talker, listener = Panel(page, "talker"), Panel(page, "listener")
    listener.start()
    listener.expect_state("running")
    talker.start()
    if engine != "jspi":
        talker.expect_state("failed")
        talker.wait_for(
            "which Python nodes need; Chrome 137, Edge 137, Firefox 153 and newer support it"
        )
        listener.stop()
        return
    listener.wait_for("I heard: 'Hello, world! 2'")
    assert numbers(listener, "I heard")[:3] == [0, 1, 2]
    topics = page.get_by_role("region", name="Topics")
    topics.get_by_role("log").scroll_into_view_if_needed()  # only who looks at it subscribes
    expect(topics.get_by_role("log")).to_contain_text(re.compile(r"data: Hello, world! \d+\n---"))
    assert graph(page)["nodes"] == ["/minimal_publisher", "/minimal_subscriber"]
    talker.stop()
    talker.wait_for("Goodbye")
    assert talker.lines()[-1] == "Goodbye"
    listener.stop()


def test_demo15_watches_a_hot_plate(page: Page, url: str) -> None:
    page.goto(f"{url}demo15/")
    camera = Panel(page, "camera")
    camera.start()
    for transition in ("configure", "activate"):
        page.get_by_role("button", name=transition, exact=True).click()
    camera.wait_for("Looking")
    expect(page.locator(".ros-managed-state")).to_have_text("active")
    gauge = page.locator(".ros-value")
    expect(gauge).to_contain_text(re.compile(r"5\d\.\d"))
    heating = page.get_by_role("region", name="Parameters").get_by_label("heating").last
    heating.fill("100")
    heating.press("Enter")
    camera.wait_for("Too hot: ")
    expect(gauge).to_contain_text("too hot")
    status = page.locator(".ros-diagnostic").filter(has_text="Part").last
    status.scroll_into_view_if_needed()
    expect(status).to_contain_text("ERROR")
    expect(page.get_by_role("region", name="Log")).to_contain_text("Too hot")
    page.get_by_role("button", name="deactivate", exact=True).click()
    camera.wait_for("Paused")
    status.scroll_into_view_if_needed()
    expect(status).to_contain_text("STALE")
    camera.stop()


def test_demo16_is_driven_by_scripts(page: Page, url: str) -> None:
    for path, way in (("demo16/", "drag"), ("demo16/", "keys"), ("demo16/roslib/", "drag")):
        page.goto(f"{url}{path}")
        readings = page.locator(".ros-readings")
        expect(readings).to_contain_text("5.54, 5.54")
        stick = page.get_by_role("application", name="Joystick")
        if way == "keys":
            stick.focus()
            page.keyboard.down("ArrowUp")
        else:
            box = stick.bounding_box()
            assert box
            page.mouse.move(box["x"] + box["width"] / 2, box["y"] + box["height"] / 2)
            page.mouse.down()
            # Beyond the rim, where it is still held.
            page.mouse.move(box["x"] + box["width"] / 2, box["y"] - 20)
        # It comes further than by one command.
        expect(readings).to_contain_text(re.compile(r"([89]|1[01])\.\d\d, 5\.\d\d"))
        expect(readings).to_contain_text("2.00")
        page.keyboard.up("ArrowUp") if way == "keys" else page.mouse.up()
        expect(readings).to_contain_text("Speed0.00")
    page.get_by_role("main").get_by_role("link", name="joystick in JavaScript").click()
    expect(page).to_have_url(f"{url}demo16/")


def test_the_first_page_leads_to_the_demos(page: Page, url: str) -> None:
    page.goto(url)
    # A turtle draws at once, and says what.
    expect(page.locator(".ros-caption")).to_have_text(re.compile(r"5 waves in 2 turns$"))
    spirograph = Panel(page, "spirograph")
    spirograph.wait_for("5 waves in 2 turns")
    # Who drives it has it, and gives it back.
    page.get_by_role("button", name="Forward").click()
    spirograph.wait_for("The turtle is yours")
    expect(spirograph.console).to_have_text(re.compile(r"yours.*5 waves in 2 turns", re.DOTALL))
    page.locator(".cards").get_by_role("link", name="Start and stop").click()
    expect(page).to_have_url(f"{url}demo02/")
    page.get_by_role("link", name="Next").click()
    expect(page).to_have_url(f"{url}demo03/")


@pytest.mark.parametrize("demo", [*(f"demo0{n}" for n in range(1, 10)), "demo15", "demo16"])
def test_each_demo_builds_alone(demo: str, tmp_path: Path) -> None:
    build(ROOT / "demos" / demo, output=tmp_path / "dist", report=Report())
    assert (tmp_path / "dist" / "index.html").exists()
    assert (tmp_path / "dist" / "page.json").exists()
