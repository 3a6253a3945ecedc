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
    for (const { name, value } of request.parameters) {
      if (name === "count" && value.integer_value > 9n) return { result: { successful: false, reason: "too many" } };
      node[name] = value;
    }
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
        "/mover: {ros__parameters: {speed: 4.5, count: 99, arm: {name: both}, more: 1}}\n"
        "/other: {ros__parameters: {on: false}}\n"
    )
    panel.locator("input[type=file]").set_input_files(file)
    note = panel.locator(".ros-parameter-node > .ros-parameter-hint")
    expect(note).to_have_text("count: too many\nmore: the node has no such parameter")
    assert [value(stage, name) for name in ("speed", "arm.name", "on")] == [4.5, "both", True]
    file.write_text("a: [")
    panel.locator("input[type=file]").set_input_files(file)
    expect(note).to_have_class("ros-parameter-hint ros-wrong")
    file.write_text("nothing: here")
    panel.locator("input[type=file]").set_input_files(file)
    expect(note).to_contain_text("not a file of parameters")


def test_one_node_can_be_chosen(stage: Tab) -> None:
    add(stage, "service", "/x", "/x/list_parameters", "rcl_interfaces/srv/ListParameters")
    panel = form(stage, {"show": ["/mover"]})
    expect(panel.locator("summary")).to_have_text(["/mover"])


def test_a_page_without_the_types_says_so(stage: Tab) -> None:
    panel = show(stage, "parameters")
    expect(panel).to_contain_text("no node on this page uses rcl_interfaces/srv/ListParameters")
