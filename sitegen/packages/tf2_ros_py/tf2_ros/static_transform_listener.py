"""Fill a buffer from /tf_static."""

from __future__ import annotations

from typing import Any

from tf2_ros.transform_listener import TransformListener


class StaticTransformListener(TransformListener):
    """Subscribes to static transforms only."""

    def __init__(self, *args: Any, **options: Any) -> None:
        super().__init__(*args, **options, static_only=True)
