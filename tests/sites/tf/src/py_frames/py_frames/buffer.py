"""The same questions to a buffer as in buffer.cpp, and filters of Python."""

import math

from geometry_msgs.msg import PointStamped, PoseStamped, TransformStamped
from message_filters import ApproximateTimeSynchronizer, Cache, SimpleFilter, TimeSynchronizer
from rclpy.duration import Duration
from rclpy.time import Time
from tf2_geometry_msgs import do_transform_pose_stamped
from tf2_py import BufferCore
from tf2_ros import TransformException
from tf_transformations import euler_from_quaternion, quaternion_from_euler


def at(seconds):
    return Time(nanoseconds=round(seconds * 1e9))


def transform(parent, child, seconds, x, yaw):
    message = TransformStamped()
    message.header.frame_id = parent
    message.child_frame_id = child
    message.header.stamp = at(seconds).to_msg()
    message.transform.translation.x = float(x)
    q = message.transform.rotation
    q.x, q.y, q.z, q.w = quaternion_from_euler(0, 0, yaw)
    return message


def show(buffer, to, source, time):
    try:
        found = buffer.lookup_transform_core(to, source, time)
    except TransformException as error:
        print(f"{type(error).__name__}: {error}")
        return
    t, r = found.transform.translation, found.transform.rotation
    _, _, yaw = euler_from_quaternion([r.x, r.y, r.z, r.w])
    stamp = Time.from_msg(found.header.stamp).nanoseconds / 1e9
    print(f"{to} <- {source} at {stamp:.6f}: {t.x + 0.0:.3f} {t.y + 0.0:.3f}, yaw {yaw:.3f}")


def frames():
    buffer = BufferCore(Duration(seconds=10))
    buffer.set_transform(transform("world", "base", 1, 0, 0), "test")
    buffer.set_transform(transform("world", "base", 3, 2, math.pi / 2), "test")
    buffer.set_transform_static(transform("base", "laser", 0, 0.5, math.pi), "test")
    buffer.set_transform(transform("world", "other", 2, -1, 0), "test")
    buffer.set_transform(transform("far", "away", 2, -1, 0), "test")
    show(buffer, "world", "base", at(2))
    show(buffer, "world", "base", Time())
    show(buffer, "world", "laser", at(3))
    show(buffer, "laser", "world", at(3))
    show(buffer, "other", "laser", Time())
    show(buffer, "base", "base", at(9))
    show(buffer, "world", "base", at(4))
    show(buffer, "world", "base", at(0.5))
    show(buffer, "other", "laser", at(2.5))
    show(buffer, "world", "nowhere", at(2))
    show(buffer, "world", "away", at(2))
    show(buffer, "/world", "base", at(2))
    pose = PoseStamped()
    pose.pose.position.x = 1.0
    moved = do_transform_pose_stamped(pose, buffer.lookup_transform_core("world", "base", at(3)))
    p = moved.pose.position
    print(f"pose {moved.header.frame_id} {p.x:.3f} {p.y:.3f}")


def point(milliseconds):
    made = PointStamped()
    made.header.stamp = at(milliseconds / 1000).to_msg()
    return made


def when(message):
    return round(Time.from_msg(message.header.stamp).nanoseconds / 1e6)


def filters():
    left, right = SimpleFilter(), SimpleFilter()
    exact = TimeSynchronizer([left, right], 10)
    exact.registerCallback(lambda a, b: print(f"exact {when(a)} {when(b)}"))
    close = ApproximateTimeSynchronizer([left, right], 10, 0.05)
    close.registerCallback(lambda a, b, name: print(f"{name} {when(a)} {when(b)}"), "close")
    cache = Cache(left, 3)
    for i in range(5):
        left.signalMessage(point(1000 + 100 * i))
        right.signalMessage(point(1000 + 100 * i + i % 2 * 20))
    print(f"cache {cache.getOldestTime().nanoseconds / 1e9:.1f} {when(cache.getLast())}")


def main():
    frames()
    filters()
