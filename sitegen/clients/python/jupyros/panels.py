"""Describe panels, which the page shows in the output of a cell."""

from __future__ import annotations

from collections.abc import Callable, Mapping
from typing import Any

# As widgets/cell/output.js and jupyter/panels.js read it.
MEDIA_TYPE = "application/vnd.sitegen.panel+json"


class Panel:
    """A panel: its kind and its options, which are those of the widget in site.yaml."""

    def __init__(self, kind: str, **options: Any) -> None:
        self.kind = kind
        self.options = {name: value for name, value in options.items() if value is not None}

    def __repr__(self) -> str:
        options = "".join(f", {name}={value!r}" for name, value in self.options.items())
        return f"Panel({self.kind!r}{options})"

    def _repr_mimebundle_(self, include: object = None, exclude: object = None) -> dict[str, Any]:
        described = {"kind": self.kind, "options": self.options}
        return {"text/plain": repr(self), MEDIA_TYPE: described}

    def display(self) -> Panel:
        """Return the panel itself, which is shown as the value of a cell."""
        return self


def publish(topic: str, msg_type: type | str | None = None) -> Panel:
    """Return a form that publishes messages to a topic."""
    return Panel("publish", topic=_full(topic), type=_type(msg_type))


def service_client(name: str, srv_type: type | str | None = None) -> Panel:
    """Return a form that calls a service; its server, which must run, tells the type."""
    return Panel("services", show=[_full(name)])


def action_client(name: str, action_type: type | str | None = None) -> Panel:
    """Return a form that sends goals to an action; its server, which must run, tells the type."""
    return Panel("actions", show=[_full(name)])


def echo(topic: str) -> Panel:
    """Return the messages of a topic, as they arrive."""
    return Panel("topics", show=[_full(topic)], echo=_full(topic))


def subscribe(
    topic: str, msg_type: type, callback: Callable[[Any], object] | None = None, *, node: Any = None
) -> Panel:
    """Return the messages of a topic, and let `callback` have each, too.

    Raises: ValueError if there is a `callback` and no `node` that subscribes.
    """
    if callback:
        if node is None:
            raise ValueError("a callback needs a node that subscribes: subscribe(…, node=node)")
        node.create_subscription(msg_type, topic, callback, 10)
    return echo(topic)


def live_plot(
    paths: str | list[str],
    topic_type: type | str | None = None,
    history: float = 30,
    title: str | None = None,
) -> Panel:
    """Return curves of numbers in messages, of the last `history` seconds.

    A path is like "/odom.twist.twist.linear.x", or as in Jupyter-ROS "/turtle1/pose/:x:y".
    """
    given = [paths] if isinstance(paths, str) else paths
    series = [one for path in given for one in _series(path)]
    return Panel("plot", series=series, window=history, title=title)


def view(**options: Any) -> Panel:
    """Return a 3D view; its options are those of the widget `3d`."""
    return Panel("3d", **options)


def joints(**options: Any) -> Panel:
    """Return sliders for the joints of the robot; its options are those of the widget `joints`."""
    return Panel("joints", **options)


def parameters(*nodes: str) -> Panel:
    """Return the parameters of some nodes, or of all."""
    return Panel("parameters", show=[_full(name) for name in nodes] or None)


def tf() -> Panel:
    """Return the tree of the frames."""
    return Panel("tf")


def image(topic: str | None = None) -> Panel:
    """Return the images of a topic."""
    return Panel("image", topic=_full(topic) if topic else None)


def bag_player(file: str | None = None, **options: Any) -> Panel:
    """Return a player of bags, with the address of one, relative to the page."""
    return Panel("bag", **_as_in_yaml({"file": file, **options}))


def _as_in_yaml(options: Mapping[str, Any]) -> dict[str, Any]:
    """Return options; `from` is a word of Python, so it is written `from_`."""
    return {name.rstrip("_"): value for name, value in options.items()}


def _series(path: str) -> list[str]:
    topic, *fields = path.split(":")
    if not fields:
        return [_full(path)]
    return [f"{_full(topic.rstrip('/'))}.{field}" for field in fields]


def _full(name: str) -> str:
    return name if name.startswith("/") else f"/{name}"


def _type(given: type | str | None) -> str | None:
    """Return the name of a type as ROS writes it: that of a class, or a text."""
    if given is None or isinstance(given, str):
        return given
    package, kind, *_ = given.__module__.split(".")
    return f"{package}/{kind}/{given.__name__}"
