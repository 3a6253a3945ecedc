"""Define what `content` consists of: layouts and widgets, with the keys of each."""

from __future__ import annotations

from collections.abc import Mapping

from sitegen.config.schema import Key

MARKDOWN = Key("markdown", "text", "a `.md` file, or the text itself", "markdown: intro.md")

# Layouts; the values of `columns`, `grid` and `tabs` are lists or mappings of content.
COLUMN = (
    Key("size", "number", "share of the width, beside that of the others", "size: 2", default=1),
    Key("content", "items", "text and widgets", "content: [{console: talker}]", True),
)
STAGE = (
    Key("show", "items", "what the nodes move, such as a robot", "show: [{graph: }]", True),
    Key("nodes", "list of text", "nodes whose buttons are in the header", "nodes: [talker]", True),
    Key("consoles", "text", "`below`, `beside` or `none`", "consoles: beside", default="below"),
    Key(
        "autostart", "flag", "start the nodes when the page opens", "autostart: true", default=False
    ),
)
LAYOUTS: Mapping[str, str] = {
    "columns": "columns: [[{console: talker}], [{console: listener}]]",
    "grid": "grid: [{console: talker}, {console: listener}]",
    "tabs": "tabs: {Talk: [{console: talker}], Listen: [{console: listener}]}",
    "stage": "stage: {show: [{graph: }], nodes: [talker]}",
}

_NODE = Key("node", "text", "name of the node", "node: talker", True)
_AUTOSTART = Key(
    "autostart", "flag", "start the node when the page opens", "autostart: false", default=False
)
_LINES = Key("lines", "number", "number of lines kept", "lines: 1000", default=1000)

WIDGETS: Mapping[str, tuple[Key, ...]] = {
    "buttons": (
        _NODE,
        _AUTOSTART,
    ),
    "console": (_NODE, _LINES),
    "source": (
        Key("node", "text", "node whose source is shown", "node: talker"),
        Key("file", "text", "another file of the package", "file: src/talker.cpp"),
        Key("lines", "range", "only these lines", "lines: 10-20"),
        Key("region", "text", "only a region, by its name", "region: timer"),
    ),
    "prompt": (_NODE, _LINES),
    "editor": (
        _NODE,
        Key("file", "text", "another Python file of the package", "file: py_pubsub/words.py"),
        _AUTOSTART,
    ),
    # Widgets that can be used without a node are about the whole page.
    "topics": (
        Key("show", "list of names", "only these topics", "show: [/chatter]"),
        Key("echo", "name", "topic whose messages are shown first", "echo: /chatter"),
    ),
    "nodes": (),
    "services": (Key("show", "list of names", "only these services", "show: [/add_two_ints]"),),
    "publish": (
        Key("topic", "name", "topic; without it, visitors choose one", "topic: /chatter"),
        Key(
            "type",
            "type",
            "message type, if no node has the topic yet",
            "type: std_msgs/msg/String",
        ),
    ),
    "graph": (),
    "log": (_LINES,),
    "3d": (
        Key(
            "frame",
            "text",
            "fixed frame; by default `map`, `world`, `odom` or the root",
            "frame: map",
        ),
        Key(
            "displays",
            "displays",
            "what is shown; by default, all that can be",
            "displays: [grid, tf]",
        ),
        Key("rviz", "path", "configuration file of RViz", "rviz: rviz/view.rviz"),
        Key("top", "flag", "look straight down", "top: true", default=False),
        Key("background", "colour", "colour of the background", 'background: "#303030"'),
        Key(
            "tools",
            "name by name",
            "topics of the tools `goal`, `estimate` and `point`",
            "tools: {goal: /goal_pose}",
        ),
    ),
    "robot": (
        Key("kind", "text", "`vernie`, `diffdrive` or `turtlesim`", "kind: vernie", True),
        Key("twist", "name", "topic of its commands", "twist: /cmd_vel", default="/cmd_vel"),
        Key("color", "name", "topic of its light's colours", "color: /color", default="/color"),
        Key(
            "sensors", "name", "prefix of its sensor topics", "sensors: /vernie", default="/vernie"
        ),
        Key("odometry", "name", "topic of its odometry", "odometry: /odom"),
        Key(
            "window",
            "name",
            "topic of the turtlesim window",
            "window: /sim/window",
            default="/turtlesim/window",
        ),
    ),
}

# The kinds of robots, and which keys of `robot` each has.
ROBOTS: Mapping[str, tuple[str, ...]] = {
    "vernie": ("twist", "color", "sensors"),
    "diffdrive": ("twist", "odometry"),
    "turtlesim": ("window",),
}
