"""Find the endpoints of widgets."""

from __future__ import annotations

from collections.abc import Iterable, Iterator, Mapping

from sitegen.commands.wiring.endpoint import CLIENT, PUBLISHER, SUBSCRIPTION, Endpoint
from sitegen.model import Widget

# Stands for a widget whose topic or service the visitor chooses.
ANY = "*"
# These widgets start nodes or show the graph, and have no endpoints to check.
_LOOK_ON = {"buttons", "console", "graph", "log", "nodes"}
_TWIST, _ODOMETRY = "geometry_msgs/msg/Twist", "nav_msgs/msg/Odometry"
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
    for topic in dict.fromkeys(_topic_of(path) for path in paths if path):
        yield Endpoint(SUBSCRIPTION, topic, "", widget.location)
    # Visitors add others.
    yield Endpoint(SUBSCRIPTION, ANY, "", widget.location, sure=False)


def _value(widget: Widget) -> Iterator[Endpoint]:
    yield Endpoint(SUBSCRIPTION, _topic_of(widget.options["path"]), "", widget.location)


def _topic_of(path: object) -> str:
    return str(path).partition(".")[0]


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
        text = "std_msgs/msg/String"
        yield Endpoint(SUBSCRIPTION, str(given["color"]), text, widget.location, sure=own)
        for name, type in _SENSORS.items():
            sensor = f"{given['sensors']}/{name}"
            yield Endpoint(PUBLISHER, sensor, type, widget.location, sure=False)


_READ = {
    "topics": _topics,
    "services": _services,
    "publish": _publish,
    "plot": _plot,
    "value": _value,
    "image": _image,
    "camera": _camera,
    "robot": _robot,
}
