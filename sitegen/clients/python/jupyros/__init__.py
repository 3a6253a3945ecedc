"""The verbs of Jupyter-ROS for notebooks in pages: each shows a panel below its cell."""

from __future__ import annotations

from jupyros.bags import bag
from jupyros.panels import (
    Panel,
    action_client,
    bag_player,
    echo,
    image,
    joints,
    live_plot,
    parameters,
    publish,
    service_client,
    subscribe,
    tf,
    view,
)

__all__ = [
    "Panel",
    "action_client",
    "bag",
    "bag_player",
    "echo",
    "image",
    "joints",
    "live_plot",
    "parameters",
    "publish",
    "service_client",
    "subscribe",
    "tf",
    "view",
]
