"""Parameters in forms: read from a node, set with its consent, saved and loaded."""

from __future__ import annotations

from pathlib import Path
from typing import Any

import pytest
from playwright.sync_api import Locator, expect
from playwright.sync_api import Page as Tab
from saving import saved
from stage import add, show, subscribed

pytestmark = pytest.mark.firefox

# A node that refuses what is above 9.
NODE = """() => {
  const value = (type, own) => ({ type, ...own });
  window.node = {
    speed: value(3, { double_value: 2.5 }), count: value(2, { integer_value: 4n }),
    "arm.name": value(4, { string_value: "left" }), on: value(1, { bool_value: true }),
    list: value(8, { double_array_value: Float64Array.of(1, 0.5) }), fixed: value(4, { string_value: "x" }),
    later: value(0),
  };
  const described = {
    speed: { description: "in m/s", floating_point_range: [{ from_value: 0, to_value: 5, step: 0.5 }] },
    count: { additional_constraints: "at most 9", integer_range: [] },
    fixed: { read_only: true },
  };
  for (const name of ["ListParameters", "GetParameters", "DescribeParameters", "SetParametersAtomically"]) {
    ros.types[`rcl_interfaces/srv/${name}_Request`] = ros.fields("");
  }
  ros.types["rcl_interfaces/msg/ParameterEvent"] = ros.fields("");
  ros.call = async (service, type, request) => {
    ros.calls.push({ service, request });
    const names = Object.keys(node);
    if (service.endsWith("list_parameters")) return { result: { names } };
    if (service.endsWith("get_parameters")) return { values: request.names.map((name) => node[name]) };
    if (service.endsWith("describe_parameters")) {
      return { descriptors: request.names.map((name) => ({ name, ...described[name] })) };
    }
    if (request.parameters.some(({ name, value }) => name === "count" && value.integer_value > 9n)) {
      return { result: { successful: false, reason: "too many" } };
    }
    for (const { name, value } of request.parameters) node[name] = value;
    return { result: { successful: true, reason: "" } };
  };
}"""  # noqa: E501


def form(stage: Tab, options: dict[str, Any] | None = None) -> Locator:
    stage.evaluate(NODE)
    add(stage, "service", "/mover", "/mover/list_parameters", "rcl_interfaces/srv/ListParameters")
    panel = show(stage, "parameters", options)
    expect(panel.locator(".ros-parameter")).to_have_count(7)
    return panel


def value(stage: Tab, name: str) -> Any:
    stage.evaluate("frames()")
    return stage.evaluate(
        "(name) => Object.entries(node[name]).filter(([key]) => key !== 'type')"
        ".map(([, value]) => typeof value === 'bigint' ? Number(value)"
        " : ArrayBuffer.isView(value) ? [...value] : value)[0]",
        name,
    )


def test_each_type_has_its_control(stage: Tab) -> None:
    panel = form(stage)
    assert panel.locator("label").all_inner_texts() == [
        *("arm.name string", "count integer", "fixed string", "later not set"),
        *("list double array", "on bool", "speed double"),
    ]
    expect(panel.get_by_label("on bool")).to_be_checked()
    panel.get_by_label("on bool").uncheck()
    assert value(stage, "on") is False
    slider = panel.get_by_role("slider", name="slider of speed")
    expect(slider).to_have_attribute("max", "5")
    slider.fill("3.5")
    expect(panel.get_by_label("speed double")).to_have_value("3.5")
    assert value(stage, "speed") == 3.5
    listed = panel.get_by_label("list double array")
    expect(listed).to_have_value("[1.0, 0.5]")
    listed.fill("[4, 5.5]")
    listed.press("Enter")
    expect(listed).to_have_value("[4.0, 5.5]")
    assert value(stage, "list") == [4, 5.5]
    expect(panel.get_by_label("fixed string")).to_be_disabled()
    expect(panel).to_contain_text("read-only")
    expect(panel).to_contain_text("in m/s")


def test_what_is_refused_comes_back_with_the_reason(stage: Tab) -> None:
    panel = form(stage)
    count = panel.get_by_label("count integer")
    count.fill("12")
    count.press("Enter")
    expect(panel).to_contain_text("too many")
    expect(count).to_have_value("4")
    count.fill("many")
    count.press("Enter")
    expect(panel).to_contain_text("'many' is not a whole number")
    count.fill("7")
    count.press("Enter")
    expect(panel.locator(".ros-note.ros-wrong")).to_have_count(0)
    assert value(stage, "count") == 7


def test_changes_by_others_appear(stage: Tab) -> None:
    panel = form(stage)
    assert subscribed(stage) == ["/parameter_events"]
    stage.evaluate(
        """() => ros.emit("/parameter_events", { node: "/mover", new_parameters: [], deleted_parameters: [],
          changed_parameters: [{ name: "arm.name", value: { type: 4, string_value: "right" } }] })"""  # noqa: E501
    )
    expect(panel.get_by_label("arm.name string")).to_have_value("right")
    stage.evaluate("ros.graph.remove('/mover')")
    expect(panel).to_contain_text("No node with parameters runs now.")


def test_they_are_saved_and_loaded_as_files(stage: Tab, tmp_path: Path) -> None:
    panel = form(stage)
    name, content = saved(panel.get_by_role("button", name="Save"))
    assert name == "mover.yaml"
    text = content.decode()
    assert text.startswith(
        "/mover:\n  ros__parameters:\n    arm:\n      name: left\n    count: 4\n"
    )
    assert "    list: [1.0, 0.5]\n" in text
    file = tmp_path / "mover.yaml"
    file.write_text(
        "/**: {ros__parameters: {speed: 1.0}}\n"
        "/mover: {ros__parameters: {speed: 4.5, fixed: x, arm: {name: both}}}\n"
        "/other: {ros__parameters: {on: false}}\n"
    )
    panel.locator("input[type=file]").set_input_files(file)
    note = panel.locator(".ros-parameter-node > .ros-parameter-hint")
    expect(note).to_have_text("All values were set.")
    assert [value(stage, name) for name in ("speed", "arm.name", "on")] == [4.5, "both", True]
    # What has its value already is not set: it may be read-only.
    assert stage.evaluate("ros.calls.at(-4).request.parameters.map(({ name }) => name)") == [
        *("speed", "arm.name")
    ]
    file.write_text("a: [")
    panel.locator("input[type=file]").set_input_files(file)
    expect(note).to_have_class("ros-parameter-hint ros-wrong")
    file.write_text("nothing: here")
    panel.locator("input[type=file]").set_input_files(file)
    expect(note).to_contain_text("not a file of parameters")


WRONG = {
    "a value": ("count: 99", "too many"),
    "a type": ("count: many", "count: 'many' is not a whole number"),
    "a name": ("more: 1", "more: the node has no such parameter"),
}


@pytest.mark.parametrize("kind", WRONG)
def test_of_a_file_with_a_fault_nothing_is_set(stage: Tab, tmp_path: Path, kind: str) -> None:
    entry, reason = WRONG[kind]
    panel = form(stage)
    file = tmp_path / "mover.yaml"
    file.write_text(f"/mover:\n  ros__parameters:\n    speed: 4.5\n    {entry}\n    on: false\n")
    panel.locator("input[type=file]").set_input_files(file)
    note = panel.locator(".ros-parameter-node > .ros-parameter-hint")
    expect(note).to_have_text(f"Nothing was set:\n{reason}")
    assert [value(stage, name) for name in ("speed", "on")] == [2.5, True]


def test_files_have_bytes_and_names_below_names(stage: Tab, tmp_path: Path) -> None:
    stage.evaluate(NODE)
    stage.evaluate(
        """() => {
          window.node = {
            a: { type: 2, integer_value: 1n }, "a.b": { type: 2, integer_value: 2n },
            "a.b.c": { type: 2, integer_value: 3n },
            bytes: { type: 5, byte_array_value: Uint8Array.of(1, 255) },
            "gains.p": { type: 3, double_value: 1 },
          };
        }"""
    )
    add(stage, "service", "/mover", "/mover/list_parameters", "rcl_interfaces/srv/ListParameters")
    panel = show(stage, "parameters")
    expect(panel.get_by_label("bytes byte array")).to_have_value("[1, 255]")
    _, content = saved(panel.get_by_role("button", name="Save"))
    assert content.decode() == (
        "/mover:\n  ros__parameters:\n    a: 1\n    a.b: 2\n    a.b.c: 3\n    bytes: [1, 255]\n"
        "    gains:\n      p: 1.0\n"
    )
    file = tmp_path / "mover.yaml"
    file.write_bytes(content.replace(b"a.b: 2", b"a.b: 5").replace(b"255", b"7"))
    panel.locator("input[type=file]").set_input_files(file)
    expect(panel).to_contain_text("All values were set.")
    assert [value(stage, name) for name in ("a", "a.b", "a.b.c", "bytes")] == [1, 5, 3, [1, 7]]


def test_what_is_being_typed_stays(stage: Tab) -> None:
    panel = form(stage)
    name = panel.get_by_label("arm.name string")
    name.fill("ha")
    event = """(event) => ros.emit("/parameter_events", { node: "/mover", new_parameters: [],
      changed_parameters: [], deleted_parameters: [], ...event })"""
    right = {"name": "arm.name", "value": {"type": 4, "string_value": "right"}}
    stage.evaluate(event, {"changed_parameters": [right]})
    stage.evaluate("void (node['arm.name'] = { type: 4, string_value: 'right' })")
    stage.evaluate("void (node.more = { type: 4, string_value: 'new' })")
    stage.evaluate(event, {"new_parameters": [{"name": "more"}]})
    expect(panel.get_by_label("more string")).to_have_value("new")
    expect(name).to_have_value("ha")
    expect(name).to_be_focused()
    stage.keyboard.type("lf")
    name.press("Enter")
    expect(name).to_have_value("half")
    assert value(stage, "arm.name") == "half"
    name.fill("no")
    name.press("Escape")
    expect(name).to_have_value("half")


def test_what_changes_during_a_read_is_read(stage: Tab) -> None:
    panel = form(stage)
    stage.evaluate(
        """() => {
          const { call } = ros;
          const held = new Promise((resolve) => { window.release = resolve; });
          ros.call = async (service, ...rest) => {
            const answer = await call(service, ...rest);
            if (service.endsWith("get_parameters")) await held;
            return answer;
          };
        }"""
    )
    event = "(event) => ros.emit('/parameter_events', { node: '/mover', new_parameters: [],"
    event += " changed_parameters: [], deleted_parameters: [], ...event })"
    count = stage.evaluate("ros.calls.length")
    stage.evaluate(event, {"deleted_parameters": [{"name": "later"}]})
    stage.wait_for_function("(count) => ros.calls.length >= count + 3", arg=count)
    stage.evaluate("void (node['arm.name'] = { type: 4, string_value: 'right' })")
    right = {"name": "arm.name", "value": {"type": 4, "string_value": "right"}}
    stage.evaluate(event, {"changed_parameters": [right]})
    stage.evaluate("release()")
    stage.wait_for_function("(count) => ros.calls.length >= count + 6", arg=count)
    stage.evaluate("frames()")
    expect(panel.get_by_label("arm.name string")).to_have_value("right")


def test_one_node_can_be_chosen(stage: Tab) -> None:
    add(stage, "service", "/x", "/x/list_parameters", "rcl_interfaces/srv/ListParameters")
    panel = form(stage, {"show": ["/mover"]})
    expect(panel.locator("summary")).to_have_text(["/mover"])


def test_a_page_without_the_types_says_so(stage: Tab) -> None:
    panel = show(stage, "parameters")
    expect(panel).to_contain_text("no node on this page uses rcl_interfaces/srv/ListParameters")
