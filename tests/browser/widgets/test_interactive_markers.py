"""Interactive markers and the images of cameras in 3D, with a C++ node."""

from __future__ import annotations

import base64
import json
import math
import re
from collections.abc import Iterator

import pytest
from browser import Built, Serve
from panel import Panel
from paths import SITES
from playwright.sync_api import Locator, expect
from playwright.sync_api import Page as Tab
from scenes import ABOVE, REACH, at, emit, expect_colors, pixels, view
from stage import add

UPDATE = "visualization_msgs/msg/InteractiveMarkerUpdate"
FEEDBACK = "visualization_msgs/msg/InteractiveMarkerFeedback"
SERVICE = "visualization_msgs/srv/GetInteractiveMarkers"


@pytest.fixture
def knob(tab: Tab, serve: Serve, built: Built) -> Iterator[Panel]:
    """The node with its views, both seen from above."""
    state = {"show": {f"3d-{number}": {"view": ABOVE} for number in (1, 2)}}
    coded = base64.urlsafe_b64encode(json.dumps(state).encode()).decode().rstrip("=")
    tab.set_viewport_size({"width": 1280, "height": 720})
    tab.goto(f"{serve(built(SITES / 'instruments'))}knob/#share=1.{coded}")
    panel = Panel(tab, "knob")
    panel.expect_state("running")
    yield panel


def seen(canvas: Locator, x: float, y: float, color: str) -> None:
    """Wait until the point of the floor has this colour."""
    panel = canvas.locator("xpath=ancestor::*[contains(@class, 'ros-scene')]/..")
    expect_colors(panel, {(x, y): color})


def place(canvas: Locator, x: float, y: float) -> tuple[float, float]:
    """Return where a point of the floor is on the screen."""
    box = canvas.bounding_box()
    assert box
    scale = box["height"] / (2 * REACH)
    return box["x"] + box["width"] / 2 + x * scale, box["y"] + box["height"] / 2 - y * scale


def drag(canvas: Locator, start: tuple[float, float], *through: tuple[float, float]) -> None:
    mouse = canvas.page.mouse
    mouse.move(*place(canvas, *start))
    mouse.down()
    for point in through:
        mouse.move(*place(canvas, *point), steps=4)
    mouse.up()


def released(knob: Panel, control: str) -> tuple[float, float, float]:
    """Return where the marker was released, and how it is turned (degrees)."""
    knob.wait_for(f"up {control}")
    line = next(one for one in reversed(knob.messages()) if one.startswith(f"up {control}"))
    x, y, angle = (float(number) for number in re.findall(r"-?[\d.]+", line))
    return x, y, angle


def test_a_marker_is_moved_turned_and_pressed(knob: Panel, tab: Tab) -> None:
    canvas = tab.locator(".ros-scene canvas").first
    canvas.scroll_into_view_if_needed()
    # A ball, an arrow along x, and a ring.
    seen(canvas, 0, 0, "red")
    seen(canvas, 0.85, 0, "red")
    seen(canvas, 0, 0.57, "blue")
    assert at(pixels(tab.locator("[data-ros-widget='3d']").first), 0, 0.9) == "black"
    drag(canvas, (0.85, 0), (1.35, 0.2))
    knob.wait_for("down slide")
    assert released(knob, "slide") == pytest.approx((0.5, 0, 0), abs=0.03)
    seen(canvas, 0.5, 0, "red")
    seen(canvas, -0.3, 0, "red")
    # Around its middle, from the top of the ring to its left.
    drag(canvas, (0.5, 0.57), (0.1, 0.4), (-0.07, 0))
    x, y, angle = released(knob, "turn")
    assert (x, y) == pytest.approx((0.5, 0), abs=0.03)
    assert angle == pytest.approx(90, abs=3)
    seen(canvas, 0.5, 0.85, "red")
    # A click presses the ball, and does not move it.
    tab.mouse.click(*place(canvas, 0.5, 0))
    knob.wait_for("click press")
    tab.mouse.click(*place(canvas, 0.5, 0), button="right")
    menu = tab.get_by_role("menu", name="Menu of knob")
    items = menu.get_by_role("menuitem")
    expect(items).to_have_text(["Reset", "More", "Deep"])
    expect(items.nth(1)).to_be_disabled()
    tab.keyboard.press("ArrowDown")
    tab.keyboard.press("Enter")
    knob.wait_for("menu 3")
    expect(menu).to_have_count(0)
    tab.mouse.click(*place(canvas, 0.5, 0), button="right")
    menu.get_by_role("menuitem", name="Reset").click()
    knob.wait_for("menu 1")
    seen(canvas, 0.85, 0, "red")
    seen(canvas, 0.5, 0.85, "black")
    # Whoever comes later is told of all that has changed.
    knob.stop()
    seen(canvas, 0, 0, "black")
    knob.start()
    seen(canvas, 0, 0, "red")


def test_a_marker_is_moved_turned_and_pressed_by_keys(knob: Panel, tab: Tab) -> None:
    canvas = tab.locator(".ros-scene canvas").first
    canvas.scroll_into_view_if_needed()
    seen(canvas, 0.85, 0, "red")
    panel = tab.locator("[data-ros-widget='3d']").first
    panel.locator("summary", has_text="Displays").click()
    markers = panel.get_by_role("list", name="Interactive markers")
    move = markers.get_by_role("button", name="slide (move)")
    expect(move).to_have_attribute("title", "Arrow keys")
    move.focus()
    for _ in range(10):
        tab.keyboard.down("ArrowRight")
    tab.keyboard.up("ArrowRight")
    knob.wait_for("up slide at 0.50 0.00")
    seen(canvas, 0.5, 0, "red")
    seen(canvas, -0.3, 0, "red")
    markers.get_by_role("button", name="turn", exact=True).focus()
    tab.keyboard.down("ArrowUp")
    knob.wait_for("down turn")
    for _ in range(17):
        tab.keyboard.down("ArrowUp")
    tab.keyboard.up("ArrowUp")
    assert released(knob, "turn") == pytest.approx((0.5, 0, 90), abs=0.01)
    markers.get_by_role("button", name="press", exact=True).focus()
    tab.keyboard.press("Enter")
    knob.wait_for("click press")
    opener = markers.get_by_role("button", name="Menu of knob")
    opener.focus()
    tab.keyboard.press("Enter")
    expect(tab.get_by_role("menuitem", name="Reset")).to_be_focused()
    tab.keyboard.press("Enter")
    knob.wait_for("menu 1")
    expect(opener).to_be_focused()
    seen(canvas, 0.85, 0, "red")


def test_an_image_stands_on_what_its_camera_sees(knob: Panel, tab: Tab) -> None:
    canvas = tab.locator(".ros-scene canvas").nth(1)
    canvas.scroll_into_view_if_needed()
    # Its focal length is half of its width: a metre away, it sees a metre on each side.
    seen(canvas, -0.5, 0.2, "red")
    seen(canvas, 0.5, 0.2, "blue")
    assert at(pixels(tab.locator("[data-ros-widget='3d']").nth(1)), 1.3, 0.3) == "black"


SHOW = {"kind": "interactive_markers", "topic": "/k/update"}
MARKER = """(name, more = {}) => ({ name, header: header(), pose: pose(0, 0), scale: 1,
  description: "", menu_entries: [], controls: [{
    name: "c", orientation: { x: 0, y: 0, z: 0, w: 1 }, interaction_mode: 3, orientation_mode: 0,
    markers: [] }], ...more })"""


def served(stage: Tab, markers: str, last: int) -> Locator:
    """Show the markers of a server whose last update had this number."""
    stage.evaluate(
        f"""() => {{
          ros.types["{SERVICE}_Request"] = ros.types["{SERVICE}_Response"] = ros.fields("");
          ros.types["{FEEDBACK}"] = ros.fields("");
          window.asked = 0;
          ros.answer = async () => {{
            window.asked += 1;
            return {{ sequence_number: BigInt({last}), markers: (0, eval)(window.all) }};
          }};
          window.all = {json.dumps(markers)};
        }}"""
    )
    add(stage, "publisher", "/k", "/k/update", UPDATE)
    add(stage, "service", "/k", "/k/get_interactive_markers", SERVICE)
    panel = view(stage, SHOW)
    stage.evaluate(f"void (window.shape = window.marker, window.marker = {MARKER})")
    return panel


def test_updates_are_taken_in_order_and_gaps_are_closed(stage: Tab) -> None:
    panel = served(stage, "[]", 4)
    stage.wait_for_function("window.asked > 0")
    update = "{ type: 1, server_id: '', poses: [], erases: [], markers: [], "
    # What the answer contains already is ignored.
    emit(stage, "/k/update", update + "seq_num: 4n, markers: [marker('a')] }")
    assert at(pixels(panel), 0.85, 0) == "black"
    emit(stage, "/k/update", update + "seq_num: 5n, markers: [marker('a')] }")
    assert at(pixels(panel), 0.85, 0) == "red"
    moved = "[{ name: 'a', header: header(), pose: pose(0, 1) }]"
    emit(stage, "/k/update", update + f"seq_num: 6n, poses: {moved} }}")
    assert at(pixels(panel), 0.85, 1) == "red"
    asked = stage.evaluate("window.asked")
    emit(stage, "/k/update", update + "seq_num: 9n, erases: ['a'] }")
    stage.wait_for_function(f"window.asked > {asked}")
    emit(stage, "/k/update", update + "seq_num: 5n }")
    assert at(pixels(panel), 0.85, 1) == "black"


def test_hostile_markers_are_refused(stage: Tab) -> None:
    panel = served(stage, "[]", 0)
    stage.wait_for_function("window.asked > 0")
    update = "{ type: 1, server_id: '', poses: [], erases: [], seq_num: 1n, markers: "
    emit(
        stage,
        "/k/update",
        update + "[marker('a', { pose: pose(NaN) }), marker('b', { scale: -1, description: "
        "'<b>'.repeat(9999), controls: Array.from({ length: 500 }, () => ({ name: 'c', "
        "orientation: { x: NaN, y: 0, z: 0, w: 0 }, interaction_mode: 77, orientation_mode: 9, "
        "markers: [] })) })] }",
    )
    expect(panel).to_contain_text("marker a: its pose is not finite")
    assert panel.locator(".ros-scene b").count() == 0


def give(stage: Tab, mode: int) -> Locator:
    """Show a marker with one control, a ball whose axis looks up; return the canvas."""
    panel = served(stage, "[]", 0)
    stage.wait_for_function("window.asked > 0")
    stage.evaluate(f"window.mode = {mode}")
    emit(
        stage,
        "/k/update",
        """{ type: 1, server_id: '', poses: [], erases: [], seq_num: 1n, markers: [marker('a', {
          controls: [{ name: 'c', interaction_mode: mode, orientation_mode: 0,
            orientation: { x: 0, y: -Math.SQRT1_2, z: 0, w: Math.SQRT1_2 },
            markers: [shape({ type: 2, scale: { x: 0.6, y: 0.6, z: 0.6 } })] }] })] }""",
    )
    return panel.locator("canvas")


def told(stage: Tab) -> tuple[list[float], float]:
    """Return where the marker was moved to, and how far it was turned (degrees)."""
    events = stage.evaluate("ros.published.splice(0).map(({ message }) => message)")
    # On a slow machine, it also tells that it is still held.
    kinds = [event["event_type"] for event in events if event["event_type"] != 0]
    # Down, its poses, up.
    assert [kinds[0], kinds[-1]] == [4, 5]
    assert set(kinds[1:-1]) == {1}
    place, turn = events[-1]["pose"]["position"], events[-1]["pose"]["orientation"]
    angle = math.degrees(2 * math.acos(min(1, abs(turn["w"]))))
    return [place["x"], place["y"], place["z"]], angle


HALF_METRE = pytest.approx([0.5, 0.3, 0], abs=0.03)
STAYS = pytest.approx([0, 0, 0], abs=1e-9)


@pytest.mark.parametrize(
    ("mode", "shift", "where", "angle"),
    [
        pytest.param(4, False, HALF_METRE, 0, id="in a plane"),
        pytest.param(6, False, HALF_METRE, 0, id="in a plane, and turned"),
        pytest.param(7, False, HALF_METRE, 0, id="freely"),
        pytest.param(9, False, HALF_METRE, 0, id="freely, and turned"),
        pytest.param(5, False, STAYS, 45, id="around an axis"),
        pytest.param(6, True, STAYS, 45, id="around an axis, with Shift"),
    ],
)
def test_every_control_can_be_dragged(
    stage: Tab, mode: int, shift: bool, where: object, angle: float
) -> None:
    canvas = give(stage, mode)
    start, end = ((0.2, 0.0), (0.3, 0.3)) if angle else ((0.0, 0.0), (0.5, 0.3))
    if shift:
        stage.keyboard.down("Shift")
    drag(canvas, start, end)
    place, turned = told(stage)
    assert place == where
    assert turned == pytest.approx(angle, abs=2)


def test_a_drag_may_end_before_a_frame_is_drawn(stage: Tab) -> None:
    canvas = give(stage, 4)
    stage.evaluate("void (window.requestAnimationFrame = () => 1)")
    drag(canvas, (0.0, 0.0), (0.5, 0.3))
    assert told(stage)[0] == HALF_METRE


@pytest.mark.parametrize("mode", [8, 9])
def test_what_turns_freely_follows_the_pointer(stage: Tab, mode: int) -> None:
    canvas = give(stage, mode)
    stage.keyboard.down("Shift")
    x, y = place(canvas, 0, 0)
    stage.mouse.move(x, y)
    stage.mouse.down()
    stage.mouse.move(x + 100, y)
    stage.mouse.up()
    # A hundredth of a radian for each pixel.
    where, angle = told(stage)
    assert where == STAYS
    assert angle == pytest.approx(math.degrees(1), abs=1)


UP, ACROSS, ALONG = [0, 0, 0.05], [0, 0.05, 0], [-0.05, 0, 0]


@pytest.mark.parametrize(
    ("mode", "key", "where", "angle"),
    [
        (3, "ArrowRight", UP, 0),
        (3, "ArrowUp", UP, 0),
        (4, "ArrowRight", ACROSS, 0),
        (4, "ArrowUp", ALONG, 0),
        (5, "ArrowLeft", [0, 0, 0], 5),
        (6, "ArrowRight", ACROSS, 0),
        (6, "Shift+ArrowRight", [0, 0, 0], 5),
        (7, "ArrowRight", UP, 0),
        (7, "PageUp", ALONG, 0),
        (8, "PageDown", [0, 0, 0], 5),
        (9, "ArrowUp", ACROSS, 0),
        (9, "Shift+PageUp", [0, 0, 0], 5),
    ],
)
def test_every_control_obeys_keys(
    stage: Tab, mode: int, key: str, where: list[float], angle: float
) -> None:
    give(stage, mode)
    panel = stage.locator("#panel")
    panel.locator("summary", has_text="Displays").click()
    panel.get_by_role("list", name="Interactive markers").get_by_role("button").focus()
    stage.keyboard.press(key)
    found, turned = told(stage)
    assert found == pytest.approx(where, abs=1e-9)
    assert turned == pytest.approx(angle, abs=1e-6)


def test_answers_to_earlier_keys_do_not_move_a_marker_back(stage: Tab) -> None:
    give(stage, 3)
    found = stage.evaluate(
        """() => {
          const button = document.querySelector(".ros-marker-mover");
          const press = () => {
            for (const type of ["keydown", "keyup"])
              button.dispatchEvent(new KeyboardEvent(type, { key: "ArrowRight" }));
          };
          press();
          press();
          ros.emit("/k/update", {
            type: 1, server_id: "", seq_num: 2n, erases: [], markers: [],
            poses: [{ name: "a", header: header(), pose: pose(0, 0, 0.05) }],
          });
          press();
          return ros.published.at(-1).message.pose.position.z;
        }"""
    )
    assert found == pytest.approx(0.15)


def test_what_a_node_wants_after_a_key_is_shown(stage: Tab) -> None:
    canvas = give(stage, 3)
    stage.evaluate(
        """() => {
          const button = document.querySelector(".ros-marker-mover");
          for (const type of ["keydown", "keyup"])
            button.dispatchEvent(new KeyboardEvent(type, { key: "ArrowRight" }));
          ros.emit("/k/update", {
            type: 1, server_id: "", seq_num: 2n, erases: [], markers: [],
            poses: [{ name: "a", header: header(), pose: pose(1, 1) }],
          });
        }"""
    )
    seen(canvas, 1, 1, "red")
