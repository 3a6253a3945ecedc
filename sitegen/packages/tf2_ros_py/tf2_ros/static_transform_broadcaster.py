"""Publish static transforms on /tf_static, which is transient local."""

from __future__ import annotations

from collections.abc import Sequence

from geometry_msgs.msg import TransformStamped
from rclpy.node import Node
from rclpy.qos import DurabilityPolicy, HistoryPolicy, QoSProfile
from tf2_msgs.msg import TFMessage


class StaticTransformBroadcaster:
    """A broadcaster of static transforms."""

    def __init__(self, node: Node, qos: QoSProfile | int | None = None) -> None:
        kept = QoSProfile(
            depth=1, durability=DurabilityPolicy.TRANSIENT_LOCAL, history=HistoryPolicy.KEEP_LAST
        )
        self.pub_tf = node.create_publisher(TFMessage, "/tf_static", qos or kept)
        self.net_message = TFMessage()

    def sendTransform(self, transform: TransformStamped | Sequence[TransformStamped]) -> None:
        """Publish one or more transforms, together with all previous ones."""
        # Latecomers receive only the last message, so it must contain all transforms.
        new = list(transform) if isinstance(transform, (list, tuple)) else [transform]
        known = {each.child_frame_id: each for each in [*self.net_message.transforms, *new]}
        self.net_message = TFMessage(transforms=list(known.values()))
        self.pub_tf.publish(self.net_message)
