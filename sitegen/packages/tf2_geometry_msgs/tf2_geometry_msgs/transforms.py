"""Transform messages of geometry_msgs to another frame."""

from __future__ import annotations

from collections.abc import Sequence
from typing import Any

import tf2_ros
from geometry_msgs.msg import (
    Point,
    Point32,
    PointStamped,
    PolygonStamped,
    Pose,
    PoseStamped,
    PoseWithCovariance,
    PoseWithCovarianceStamped,
    Quaternion,
    TransformStamped,
    Vector3,
    Vector3Stamped,
    Wrench,
    WrenchStamped,
)
from tf2_py import geometry


def _of(transform: TransformStamped) -> geometry.Pose:
    t, r = transform.transform.translation, transform.transform.rotation
    return geometry.Pose((r.x, r.y, r.z, r.w), (t.x, t.y, t.z))


def _moved(point: Any, by: geometry.Pose, kind: type) -> Any:
    x, y, z = geometry.moved(by, (point.x, point.y, point.z))
    return kind(x=x, y=y, z=z)


def _turned(vector: Vector3, by: geometry.Pose) -> Vector3:
    x, y, z = geometry.rotated(by.rotation, (vector.x, vector.y, vector.z))
    return Vector3(x=x, y=y, z=z)


def do_transform_point(point: PointStamped, transform: TransformStamped) -> PointStamped:
    """Return a point in another frame."""
    moved = _moved(point.point, _of(transform), Point)
    return PointStamped(header=transform.header, point=moved)


def do_transform_vector3(vector3: Vector3Stamped, transform: TransformStamped) -> Vector3Stamped:
    """Return a direction in another frame."""
    return Vector3Stamped(header=transform.header, vector=_turned(vector3.vector, _of(transform)))


def do_transform_pose(pose: Pose, transform: TransformStamped) -> Pose:
    """Return a pose in another frame."""
    by = _of(transform)
    q = pose.orientation
    x, y, z, w = geometry.multiplied(by.rotation, (q.x, q.y, q.z, q.w))
    turned = Quaternion(x=x, y=y, z=z, w=w)
    return Pose(position=_moved(pose.position, by, Point), orientation=turned)


def do_transform_pose_stamped(pose: PoseStamped, transform: TransformStamped) -> PoseStamped:
    """Return a pose with a header in another frame."""
    return PoseStamped(header=transform.header, pose=do_transform_pose(pose.pose, transform))


def transform_covariance(covariance: Sequence[float], transform: TransformStamped) -> list[float]:
    """Rotate a 6x6 covariance matrix: each of its four blocks becomes R C Rᵀ."""
    by = _of(transform)
    axes = [geometry.rotated(by.rotation, axis) for axis in ((1.0, 0, 0), (0, 1.0, 0), (0, 0, 1.0))]
    found = [0.0] * 36
    for top in (0, 3):
        for left in (0, 3):
            for i in range(3):
                for j in range(3):
                    found[(top + i) * 6 + left + j] = sum(
                        axes[k][i] * covariance[(top + k) * 6 + left + m] * axes[m][j]
                        for k in range(3)
                        for m in range(3)
                    )
    return found


def do_transform_pose_with_covariance(
    pose: PoseWithCovariance, transform: TransformStamped
) -> PoseWithCovariance:
    """Return a pose and its covariance in another frame."""
    turned = transform_covariance(pose.covariance, transform)
    return PoseWithCovariance(pose=do_transform_pose(pose.pose, transform), covariance=turned)


def do_transform_pose_with_covariance_stamped(
    pose: PoseWithCovarianceStamped, transform: TransformStamped
) -> PoseWithCovarianceStamped:
    """Return a pose with a header and its covariance in another frame."""
    moved = do_transform_pose_with_covariance(pose.pose, transform)
    return PoseWithCovarianceStamped(header=transform.header, pose=moved)


def do_transform_polygon_stamped(
    polygon: PolygonStamped, transform: TransformStamped
) -> PolygonStamped:
    """Return a polygon in another frame."""
    by = _of(transform)
    found = PolygonStamped(header=transform.header)
    found.polygon.points = [_moved(point, by, Point32) for point in polygon.polygon.points]
    return found


def do_transform_wrench(wrench: WrenchStamped, transform: TransformStamped) -> WrenchStamped:
    """Return a force and a torque in another frame."""
    by = _of(transform)
    turned = Wrench(
        force=_turned(wrench.wrench.force, by), torque=_turned(wrench.wrench.torque, by)
    )
    return WrenchStamped(header=transform.header, wrench=turned)


def to_msg_msg(msg: Any) -> Any:
    """Return the message unchanged."""
    return msg


def from_msg_msg(msg: Any) -> Any:
    """Return the message unchanged."""
    return msg


KNOWN = {
    PointStamped: do_transform_point,
    Vector3Stamped: do_transform_vector3,
    PoseStamped: do_transform_pose_stamped,
    PoseWithCovarianceStamped: do_transform_pose_with_covariance_stamped,
    PolygonStamped: do_transform_polygon_stamped,
    WrenchStamped: do_transform_wrench,
}
for _type, _function in KNOWN.items():
    tf2_ros.TransformRegistration().add(_type, _function)
    tf2_ros.ConvertRegistration().add_to_msg(_type, to_msg_msg)
    tf2_ros.ConvertRegistration().add_from_msg(_type, from_msg_msg)
