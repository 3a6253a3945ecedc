"""Define what `content` consists of: layouts and widgets, with the keys of each."""

from __future__ import annotations

from collections.abc import Mapping

from sitegen.config.schema import Key

MARKDOWN = Key("markdown", "text", "a `.md` file, or the text itself", "markdown: intro.md")

# Layouts; the values of `columns`, `grid` and `tabs` are lists or mappings of content.
_CONTENT = Key("content", "items", "text and widgets", "content: [{console: talker}]", True)
COLUMN = (
    Key("size", "number", "share of the width, relative to the others", "size: 2", default=1),
    _CONTENT,
)
ROW = (
    Key("size", "number", "share of the height of a dashboard", "size: 2", default=1),
    _CONTENT,
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
    "rows": "rows: [[{console: talker}], [{console: listener}]]",
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
        Key("region", "text", "only the region with this name", "region: timer"),
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
    "actions": (Key("show", "list of names", "only these actions", "show: [/fibonacci]"),),
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
    "tf": (
        Key("frame", "text", "frame whose transform is shown", "frame: base_link"),
        Key("reference", "text", "frame in which it is shown", "reference: map"),
    ),
    "parameters": (Key("show", "list of names", "only these nodes", "show: [/talker]"),),
    "lifecycle": (Key("show", "list of names", "only these nodes", "show: [/camera_driver]"),),
    "diagnostics": (
        Key(
            "topic",
            "name",
            "topic; defaults to `/diagnostics_agg`, else `/diagnostics`",
            "topic: /diagnostics",
        ),
    ),
    "log": (_LINES,),
    "notebook": (
        Key("file", "path", "Markdown file or Jupyter notebook", "file: first.ipynb", True),
    ),
    "jupyter": (
        Key("notebooks", "path", "folder of notebooks", "notebooks: notebooks"),
        Key("open", "text", "notebook that is open first", "open: first.ipynb"),
        Key(
            "page", "text", "path of the page whose nodes and panels are beside it", "page: demo05"
        ),
    ),
    "joints": (
        Key(
            "topic",
            "name",
            "topic of the positions",
            "topic: /joint_states",
            default="/joint_states",
        ),
        Key(
            "description",
            "name",
            "topic of the robot's description",
            "description: /arm/robot_description",
            default="/robot_description",
        ),
        Key("zeros", "mapping of decimals", "initial positions", "zeros: {elbow: 1.2}"),
    ),
    "teleop": (
        Key("topic", "name", "topic of the commands", "topic: /cmd_vel", default="/cmd_vel"),
        Key("stamped", "flag", "send `TwistStamped`", "stamped: true", default=False),
        Key("linear", "decimal", "largest speed in m/s", "linear: 0.22", default="0.5"),
        Key("angular", "decimal", "largest turning speed in rad/s", "angular: 2.84", default="1.0"),
        Key("joy", "name", "topic of the gamepad itself, as `Joy`", "joy: /joy"),
        Key(
            "deadman",
            "flag",
            "drive only while Shift or a shoulder button is held",
            "deadman: true",
            default=False,
        ),
    ),
    "robot": (
        Key("kind", "text", "`vernie`, `diffdrive` or `turtlesim`", "kind: vernie", True),
        Key("twist", "name", "topic of its commands", "twist: /cmd_vel", default="/cmd_vel"),
        Key("color", "name", "topic of its light's colors", "color: /color", default="/color"),
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
    "terminal": (
        Key(
            "nodes",
            "list of text",
            "nodes that visitors start with `ros2 run`",
            "nodes: [talker]",
        ),
        Key("run", "text", "command that runs first", "run: ros2 topic list"),
        Key(
            "docked",
            "flag",
            "open at the bottom of the window when a visitor runs a command of the text",
            "docked: true",
            default=False,
        ),
    ),
    "3d": (
        Key("frame", "text", "fixed frame; defaults to the root of the frames", "frame: map"),
        Key("displays", "displays", "what is shown; defaults to all topics", "displays: [tf]"),
        Key("rviz", "path", "configuration file of RViz", "rviz: rviz/view.rviz"),
        Key("top", "flag", "look straight down", "top: true", default=False),
        Key(
            "background",
            "color",
            "color of the background; defaults to the theme's",
            'background: "#303030"',
        ),
        Key(
            "tools",
            "mapping of names",
            "topics of the tools `goal`, `estimate` and `point`",
            "tools: {goal: /goal_pose}",
        ),
    ),
    "plot": (
        Key("series", "message paths", "what is plotted", "series: [/odom.pose.pose.position.x]"),
        Key("x", "message path", "plot against this, not time", "x: /odom.pose.pose.position.x"),
        Key("window", "number", "how many seconds are shown", "window: 10", default=30),
        Key("title", "text", "title of the panel", "title: Position"),
        Key("points", "flag", "mark each sample", "points: true", default=False),
        Key("min", "decimal", "lower end of the vertical axis", "min: -1.5"),
        Key("max", "decimal", "upper end of the vertical axis", "max: 1.5"),
        Key("time", "text", "`received` or `header`", "time: header", default="received"),
    ),
    "value": (
        Key("path", "message path", "the value", "path: /battery.percentage", True),
        Key("show", "text", "`number`, `gauge`, `light` or `text`", "show: gauge"),
        Key("title", "text", "title; defaults to the path", "title: Battery"),
        Key("unit", "text", "unit after the number", 'unit: "%"'),
        Key("scale", "decimal", "the number is multiplied by this", "scale: 100"),
        Key("decimals", "decimal", "number of decimals", "decimals: 2"),
        Key("min", "decimal", "lower end of a gauge", "min: -10", default=0),
        Key("max", "decimal", "upper end of a gauge", "max: 250.5", default=100),
        Key(
            "thresholds",
            "thresholds",
            "which values are good or bad",
            "thresholds: [{from: 0, is: danger}, {from: 20, is: good}]",
        ),
    ),
    "image": (
        Key("topic", "name", "topic; without it, visitors choose one", "topic: /image_raw"),
        Key("min", "decimal", "depth that is black", "min: 0.5"),
        Key("max", "decimal", "depth that is white", "max: 5"),
    ),
    "camera": (
        Key("topic", "name", "topic of the images", "topic: /image_raw", default="/image_raw"),
        Key("info", "name", "topic of the `CameraInfo`", "info: /camera_info"),
        Key("compressed", "flag", "publish JPEG", "compressed: true", default=False),
        Key("width", "number", "width of the images in pixels", "width: 640", default=320),
        Key("rate", "number", "most images per second", "rate: 15", default=10),
        Key("frame", "text", "`frame_id` of the images", "frame: base", default="camera"),
    ),
    "bag": (
        Key("file", "path", "bag that is played: a file or a folder", "file: bags/drive.mcap"),
        Key("autostart", "flag", "start when it becomes visible", "autostart: true", default=False),
        Key("loop", "flag", "start again at the end", "loop: true", default=False),
        Key("rate", "decimal", "playback speed", "rate: 0.5", default="1.0"),
        Key("from", "decimal", "where playing begins, in seconds from the start", "from: 2.5"),
        Key("to", "decimal", "where playing ends; defaults to the end", "to: 20"),
        Key("clock", "flag", "publish `/clock` while playing", "clock: true", default=False),
        Key("remap", "mapping of names", "other names for topics", "remap: {/odom: /old/odom}"),
        Key("topics", "list of names", "play only these topics", "topics: [/odom, /tf]"),
        Key("exclude", "list of names", "leave out these topics", "exclude: [/rosout]"),
        Key("views", "flag", "add panels for its topics", "views: false"),
        Key("record", "list of names", "record only these topics", "record: [/cmd_vel]"),
        Key("hidden", "flag", "record hidden topics, too", "hidden: true", default=False),
        Key("limit", "number", "largest size of a recording in MB", "limit: 200", default=1000),
        Key("ask", "text", "ask for consent to log what visitors do", "ask: For our study"),
    ),
    "connect": (),
    "launch": (),
    "panel": (
        Key("file", "path", "the module, a `.js` file", "file: panels/arm.js", True),
        Key("title", "text", "title; defaults to the name of the file", "title: Arm"),
        Key("options", "data", "what `mount` is given as `options`", "options: {speed: 2.5}"),
    ),
}

# The kinds of robots, and which keys of `robot` each has.
ROBOTS: Mapping[str, tuple[str, ...]] = {
    "vernie": ("twist", "color", "sensors"),
    "diffdrive": ("twist", "odometry"),
    "turtlesim": ("window",),
}

# Widgets that may be given one of their options in place of a mapping: `plot: /odom.twist.x`.
SHORT: Mapping[str, str] = {
    "notebook": "file",
    "plot": "series",
    "value": "path",
    "image": "topic",
    "camera": "topic",
    "bag": "file",
    "diagnostics": "topic",
    "panel": "file",
}

# An item of `thresholds`.
THRESHOLD = (
    Key("from", "decimal", "smallest value of this state", "from: 20", True),
    Key("is", "text", "`good`, `caution`, `danger` or `plain`", "is: caution", True),
    Key("text", "text", "text beside the value", "text: low"),
)

# The words that options with a fixed choice can have.
CHOICES: Mapping[tuple[Key, ...], Mapping[str, tuple[str, ...]]] = {
    WIDGETS["plot"]: {"time": ("received", "header")},
    WIDGETS["value"]: {"show": ("number", "gauge", "light", "text")},
    THRESHOLD: {"is": ("good", "caution", "danger", "plain")},
}
