"""Message paths: what they name in a message, and what is said about those that are wrong."""

from __future__ import annotations

from typing import Any

import pytest
from playwright.sync_api import Page as Tab

pytestmark = pytest.mark.firefox

TYPES = """
ros.types["sensor_msgs/msg/JointState"] = ros.fields(
  "builtin_interfaces/msg/Time stamp, string[] name, float64[] position, int64[2] count, " +
  "bool[] on");
ros.types["robot_msgs/msg/Arm"] = ros.fields(
  "string title, sensor_msgs/msg/JointState joints, geometry_msgs/msg/Vector3[] points, " +
  "uint8[] data");
"""
MESSAGE = """({
  title: "left", data: new Uint8Array(9),
  joints: {
    stamp: { sec: 2, nanosec: 500000000 }, name: ["shoulder", "elbow", ""],
    position: Float64Array.of(0.5, -1, NaN), count: BigInt64Array.of(1n, 2n ** 60n),
    on: [true, false],
  },
  points: [{ x: 1, y: 2, z: 3 }, { x: 4, y: 5, z: 6 }],
})"""


def read(stage: Tab, path: str) -> list[Any]:
    """The label and the number of each value, or what is said in place of them."""
    found: list[Any] = stage.evaluate(
        """async ([path, types, message]) => {
          const { checkNumeric, parsePath, readPath, toNumber } =
            await import("./runtime/messages/path.js");
          new Function("ros", types)(ros);
          try {
            const parsed = parsePath(path);
            checkNumeric(parsed, "robot_msgs/msg/Arm", ros.types);
            const values = [];
            readPath(parsed, new Function(`return ${message}`)(), (label, value) => {
              values.push([label, String(toNumber(value))]);
            });
            return values;
          } catch (error) {
            return [error.message];
          }
        }""",
        [path, TYPES, MESSAGE],
    )
    return found


@pytest.mark.parametrize(
    ("path", "values"),
    [
        ("/arm.joints.position[0]", [["", "0.5"]]),
        ("/arm.joints.position[-2]", [["", "-1"]]),
        ("/arm.joints.position[7]", []),
        ("/arm.joints.position[-7]", []),
        ("/arm.joints.position[:]", [["0", "0.5"], ["1", "-1"], ["2", "NaN"]]),
        ("/arm.joints.position[1:]", [["1", "-1"], ["2", "NaN"]]),
        ("/arm.joints.position[:-1]", [["0", "0.5"], ["1", "-1"]]),
        ("/arm.joints.position[1:99]", [["1", "-1"], ["2", "NaN"]]),
        (
            "/arm.joints.position[:]{name}",
            [["shoulder", "0.5"], ["elbow", "-1"], ["2", "NaN"]],
        ),
        ("/arm.joints.count[:]", [["0", "1"], ["1", "1152921504606847000"]]),
        ("/arm.joints.on[:]", [["0", "1"], ["1", "0"]]),
        ("/arm.joints.stamp", [["", "2.5"]]),
        ("/arm.points[:].y", [["0", "2"], ["1", "5"]]),
        ("/arm.points[-1].z.@derivative", [["", "6"]]),
    ],
)
def test_a_path_names_values(stage: Tab, path: str, values: list[list[str]]) -> None:
    assert read(stage, path) == values


@pytest.mark.parametrize(
    ("path", "said"),
    [
        ("arm.x", "'arm.x' is not a message path; write it like /odom.pose.pose.position.x"),
        ("/arm.", "'/arm.' is not a message path; write it like /odom.pose.pose.position.x"),
        (
            "/arm[0]",
            "'/arm[0]' is not a message path; write it like /odom.pose.pose.position.x",
        ),
        ("/arm.x[a]", "'/arm.x[a]' is not a message path"),
        ("/arm.x.@norm", "unknown '.@norm' in /arm.x.@norm; there is only .@derivative"),
        ("/arm.x{name}", "'{name}' in /arm.x{name} must stand behind [:], whose elements it names"),
        ("/arm.points[:].x[:]", "/arm.points[:].x[:] has two slices; keep one"),
        (
            "/arm.joint.x",
            "/arm.joint.x: robot_msgs/msg/Arm has no field 'joint'; "
            "its fields are title, joints, points, data",
        ),
        (
            "/arm.joints",
            "/arm.joints is a whole sensor_msgs/msg/JointState; add one of its fields: "
            "stamp, name, position, count, on",
        ),
        ("/arm.title", "/arm.title is text, not a number"),
        ("/arm.title.length", "/arm.title.length: string has no fields, so no 'length'"),
        ("/arm.title[0]", "/arm.title[0]: 'title' is not an array"),
        (
            "/arm.joints.position",
            "/arm.joints.position: 'position' is an array; write position[0] or position[:]",
        ),
        ("/arm.points.x", "/arm.points.x: 'points' is an array; write points[0] or points[:]"),
        (
            "/arm.joints.position[:]{count}",
            "/arm.joints.position[:]{count}: 'count' is not an array of texts, "
            "so it cannot name elements",
        ),
        ("/arm." + "x" * 600, "'/arm.xxx"),
        ("/arm.constructor", "/arm.constructor: robot_msgs/msg/Arm has no field 'constructor'"),
    ],
)
def test_a_wrong_path_is_explained(stage: Tab, path: str, said: str) -> None:
    [found] = read(stage, path)
    assert found.startswith(said)
    assert len(found) < 200


def test_the_numbers_of_a_type_are_listed(stage: Tab) -> None:
    fields = stage.evaluate(
        """async (types) => {
          const { numericFields } = await import("./runtime/messages/path.js");
          new Function("ros", types)(ros);
          return [
            numericFields("robot_msgs/msg/Arm", ros.types), numericFields("x/msg/Y", ros.types),
            numericFields("geometry_msgs/msg/Twist", ros.types, 2),
          ];
        }""",
        TYPES,
    )
    assert fields == [
        [
            ".joints.position[:]{name}",
            ".joints.count[:]{name}",
            ".joints.on[:]{name}",
            ".points[0].x",
            ".points[0].y",
            ".points[0].z",
        ],
        [],
        [".linear.x", ".linear.y"],
    ]
