"""Find the endpoints of widgets."""

from __future__ import annotations

from collections.abc import Iterable, Iterator, Mapping

from sitegen.commands.wiring.endpoint import CLIENT, PUBLISHER, SUBSCRIPTION, Endpoint
from sitegen.config.displays import kinds
from sitegen.errors import Location
from sitegen.model import Widget

# Stands for a widget whose topic or service the visitor chooses.
ANY = "*"
# These widgets start nodes, show the graph, or use only topics and services of all nodes.
_LOOK_ON = {
    *("actions", "buttons", "console", "diagnostics", "graph", "launch", "lifecycle", "log"),
    *("nodes", "parameters", "tf"),
    # What cells do is read from them.
    *("cell", "javascript", "jupyter", "notebook"),
}
_TWIST, _ODOMETRY = "geometry_msgs/msg/Twist", "nav_msgs/msg/Odometry"
_STAMPED, _JOY = "geometry_msgs/msg/TwistStamped", "sensor_msgs/msg/Joy"
_STATE, _STRING = "sensor_msgs/msg/JointState", "std_msgs/msg/String"
_IMAGE, _COMPRESSED = "sensor_msgs/msg/Image", "sensor_msgs/msg/CompressedImage"
_INFO = "sensor_msgs/msg/CameraInfo"
_WINDOW = "turtlesim_window/msg/Window"
_SENSORS = {
    "distance": "std_msgs/msg/Float32",
    "tilt": "geometry_msgs/msg/Vector3",
    "button": "std_msgs/msg/Bool",
}


def endpoints(widgets: Iterable[Widget]) -> tuple[list[Endpoint], bool]:
    """Return the endpoints of `widgets`, and whether there may be others."""
    found: list[Endpoint] = []
    known = True
    for widget in widgets:
        if widget.kind in _READ:
            found += _READ[widget.kind](widget)
        else:
            known = known and widget.kind in _LOOK_ON
    return found, not known


def _topics(widget: Widget) -> Iterator[Endpoint]:
    echo = widget.options.get("echo")
    if echo:
        yield Endpoint(SUBSCRIPTION, str(echo), "", widget.location)
    shown = widget.options.get("show")
    for name in shown if isinstance(shown, list) else [ANY]:
        yield Endpoint(SUBSCRIPTION, name, "", widget.location, sure=False)


def _services(widget: Widget) -> Iterator[Endpoint]:
    yield Endpoint(CLIENT, ANY, "", widget.location, sure=False)


def _publish(widget: Widget) -> Iterator[Endpoint]:
    topic, type = widget.options.get("topic"), widget.options.get("type")
    if topic:
        yield Endpoint(PUBLISHER, str(topic), str(type or ""), widget.location)
    else:
        yield Endpoint(PUBLISHER, ANY, "", widget.location, sure=False)


def _plot(widget: Widget) -> Iterator[Endpoint]:
    series = widget.options.get("series")
    paths = [*(series if isinstance(series, list) else []), widget.options.get("x")]
    for path in dict.fromkeys(str(path) for path in paths if path):
        yield _subscription(path, widget.location)
    # Visitors add others.
    yield Endpoint(SUBSCRIPTION, ANY, "", widget.location, sure=False)


def _value(widget: Widget) -> Iterator[Endpoint]:
    yield _subscription(str(widget.options["path"]), widget.location)


def _subscription(path: str, location: Location) -> Endpoint:
    """Return the subscription for a message path; `/a/b/c` may be the field `c` of `/a/b`."""
    topic, dot, _ = path.partition(".")
    parts = topic.split("/")
    shorter = ("/".join(parts[:count]) for count in range(2, len(parts)))
    instead = frozenset(() if dot else shorter)
    return Endpoint(SUBSCRIPTION, topic, "", location, instead=instead)


def _image(widget: Widget) -> Iterator[Endpoint]:
    topic = widget.options.get("topic")
    yield Endpoint(SUBSCRIPTION, str(topic or ANY), "", widget.location, sure=bool(topic))


def _camera(widget: Widget) -> Iterator[Endpoint]:
    topic = str(widget.options["topic"])
    type = _COMPRESSED if widget.options["compressed"] else _IMAGE
    yield Endpoint(PUBLISHER, topic, type, widget.location)
    info = widget.options.get("info") or f"{topic.rpartition('/')[0]}/camera_info"
    yield Endpoint(PUBLISHER, str(info), _INFO, widget.location, sure=False)


def _robot(widget: Widget) -> Iterator[Endpoint]:
    given: Mapping[str, object] = widget.options
    if given["kind"] == "turtlesim":
        yield Endpoint(SUBSCRIPTION, str(given["window"]), _WINDOW, widget.location)
        return
    if given.get("odometry"):
        yield Endpoint(SUBSCRIPTION, str(given["odometry"]), _ODOMETRY, widget.location)
    else:
        # The endpoints of its default topics exist whether they are used or not.
        own = given["twist"] != "/cmd_vel"
        yield Endpoint(SUBSCRIPTION, str(given["twist"]), _TWIST, widget.location, sure=own)
    if given["kind"] == "vernie":
        own = given["color"] != "/color"
        yield Endpoint(SUBSCRIPTION, str(given["color"]), _STRING, widget.location, sure=own)
        for name, type in _SENSORS.items():
            sensor = f"{given['sensors']}/{name}"
            yield Endpoint(PUBLISHER, sensor, type, widget.location, sure=False)


def _joints(widget: Widget) -> Iterator[Endpoint]:
    topic = widget.options.get("topic") or "/joint_states"
    description = widget.options.get("description") or "/robot_description"
    yield Endpoint(PUBLISHER, str(topic), _STATE, widget.location)
    yield Endpoint(SUBSCRIPTION, str(description), _STRING, widget.location)


def _teleop(widget: Widget) -> Iterator[Endpoint]:
    topic = widget.options.get("topic") or "/cmd_vel"
    type = _STAMPED if widget.options.get("stamped") else _TWIST
    yield Endpoint(PUBLISHER, str(topic), type, widget.location)
    if joy := widget.options.get("joy"):
        yield Endpoint(PUBLISHER, str(joy), _JOY, widget.location)


def _scene(widget: Widget) -> Iterator[Endpoint]:
    """A view says itself which of its topics, often those of an `.rviz` file, nobody publishes."""
    where = widget.location
    topics = [ANY]
    if isinstance(shown := widget.options.get("displays"), list):
        given = (each.get("topic") or kinds()[each["kind"]].defaults.get("topic") for each in shown)
        topics = sorted({str(topic) for topic in given if topic})
    for topic in topics:
        yield Endpoint(SUBSCRIPTION, topic, "", where, sure=False)
        # What comes beside a map and an image, and what interactive markers answer.
        folder, name = topic.rpartition("/")[::2]
        for beside in (f"{topic}_updates", f"{folder}/camera_info"):
            yield Endpoint(SUBSCRIPTION, beside, "", where, sure=False)
        if name == "update":
            yield Endpoint(PUBLISHER, f"{folder}/feedback", "", where, sure=False)
    tools = widget.options.get("tools")
    for topic in {**_TOOLS, **(tools if isinstance(tools, dict) else {})}.values():
        yield Endpoint(PUBLISHER, str(topic), "", where, sure=False)


_TOOLS = {"goal": "/goal_pose", "estimate": "/initialpose", "point": "/clicked_point"}
_READ = {
    "3d": _scene,
    "joints": _joints,
    "teleop": _teleop,
    "topics": _topics,
    "services": _services,
    "publish": _publish,
    "plot": _plot,
    "value": _value,
    "image": _image,
    "camera": _camera,
    "robot": _robot,
}
