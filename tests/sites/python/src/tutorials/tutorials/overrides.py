"""Quality of service from parameters, raw messages, liveliness by hand, and times of timers."""

import sys
import time

import rclpy
from rcl_interfaces.msg import SetParametersResult
from rclpy.clock import Clock, ClockType, JumpThreshold
from rclpy.clock_type import ClockType as Kind
from rclpy.duration import Duration
from rclpy.event_handler import PublisherEventCallbacks, SubscriptionEventCallbacks
from rclpy.exceptions import ParameterNotDeclaredException
from rclpy.node import Node
from rclpy.parameter import Parameter
from rclpy.qos import (
    DurabilityPolicy,
    HistoryPolicy,
    LivelinessPolicy,
    QoSPolicyKind,
    QoSProfile,
    ReliabilityPolicy,
    qos_profile_system_default,
)
from rclpy.qos_overriding_options import QosCallbackResult, QoSOverridingOptions
from rclpy.serialization import deserialize_message
from rclpy.signals import SignalHandlerOptions
from rclpy.timer import TimerInfo
from std_msgs.msg import String


def few(qos):
    """Accept what keeps few."""
    result = QosCallbackResult()
    result.successful = qos.depth <= 10
    result.reason = "too deep"
    return result


def qos_by_parameters():
    """Say QoS from outside, as a launch file would."""
    arguments = ["-p", "qos_overrides./chatter.publisher.depth:=3"]
    arguments += ["-p", "qos_overrides./chatter.publisher.reliability:=best_effort"]
    arguments += ["-p", "qos_overrides./chatter.subscription_own.durability:=transient_local"]
    arguments += ["-p", "qos_overrides./deep.publisher.depth:=11"]
    node = rclpy.create_node("overrides", cli_args=["--ros-args", *arguments])
    options = QoSOverridingOptions.with_default_policies(callback=few)
    publisher = node.create_publisher(String, "chatter", 5, qos_overriding_options=options)
    profile = publisher.qos_profile
    print(profile.depth, profile.reliability.name, profile.history.name)
    only = QoSOverridingOptions([QoSPolicyKind.DURABILITY], entity_id="own")
    subscription = node.create_subscription(
        String, "chatter", print, 5, qos_overriding_options=only
    )
    print(subscription.qos_profile.depth, subscription.qos_profile.durability.name)
    try:
        node.create_publisher(String, "deep", 5, qos_overriding_options=options)
    except Exception as error:
        print(type(error).__name__, error)
    for name in sorted(node.get_parameters_by_prefix("qos_overrides")):
        print(name, node.get_parameter(f"qos_overrides.{name}").value)
    node.destroy_node()


def raw():
    """Hear bytes."""
    node = rclpy.create_node("raw")
    heard = []
    node.create_subscription(String, "bytes", heard.append, qos_profile_system_default, raw=True)
    publisher = node.create_publisher(String, "bytes", 10)
    while not heard:
        publisher.publish(String(data="as bytes"))
        rclpy.spin_once(node, timeout_sec=0.1)
    print(type(heard[0]).__name__, len(heard[0]), deserialize_message(heard[0], String).data)
    node.destroy_node()


def liveliness():
    """Live by hand, and stop to."""
    node = rclpy.create_node("liveliness")
    qos = QoSProfile(
        depth=5,
        liveliness=LivelinessPolicy.MANUAL_BY_TOPIC,
        liveliness_lease_duration=Duration(seconds=0.2),
    )
    told = []
    publisher = node.create_publisher(
        *(String, "life", qos),
        event_callbacks=PublisherEventCallbacks(
            liveliness=lambda e: told.append(("lost", e.total_count)),
            matched=lambda e: told.append(("matched", e.current_count)),
            incompatible_qos=lambda e: told.append(("wants", e.last_policy_kind.name)),
        ),
    )
    lives = []
    node.create_subscription(
        *(String, "life", lambda _: None, qos),
        event_callbacks=SubscriptionEventCallbacks(
            liveliness=lambda e: lives.append((e.alive_count, e.not_alive_count)),
            message_lost=lambda e: told.append(("message lost", e.total_count)),
        ),
    )
    publisher.assert_liveliness()
    while ("lost", 1) not in told or (0, 1) not in lives:
        rclpy.spin_once(node, timeout_sec=0.1)
    print(told, lives[0], lives[-1])
    shorter = QoSProfile(depth=5, deadline=Duration(seconds=0.1))
    node.create_subscription(String, "life", lambda _: None, shorter)
    while told[-1][0] != "wants":
        rclpy.spin_once(node, timeout_sec=0.1)
    print(told[-1], publisher.wait_for_all_acked(Duration(seconds=1)))
    node.destroy_node()


def times():
    """Timers that are told when they are called, and clocks that jump."""
    node = rclpy.create_node("times", parameter_overrides=[Parameter("use_sim_time", value=True)])
    jumps = []
    clock = node.get_clock()
    threshold = JumpThreshold(
        min_forward=Duration(seconds=1), min_backward=Duration(seconds=-1), on_clock_change=True
    )
    handle = clock.create_jump_callback(
        threshold,
        pre_callback=lambda: jumps.append("before"),
        post_callback=lambda jump: jumps.append((jump.clock_change.name, jump.delta.nanoseconds)),
    )
    print(clock.clock_type == ClockType.ROS_TIME == Kind.ROS_TIME, clock.ros_time_is_active)
    clock.set_ros_time_override(rclpy.time.Time(seconds=5, clock_type=ClockType.ROS_TIME))
    clock.set_ros_time_override(rclpy.time.Time(seconds=5.5, clock_type=ClockType.ROS_TIME))
    clock.set_ros_time_override(rclpy.time.Time(seconds=2, clock_type=ClockType.ROS_TIME))
    print(jumps, clock.now().seconds_nanoseconds())
    node.set_parameters([Parameter("use_sim_time", value=False)])
    print(jumps[-1][0], clock.ros_time_is_active)
    handle.unregister()

    infos = []
    steady = Clock(clock_type=ClockType.STEADY_TIME)

    def called(info: TimerInfo):
        infos.append(info)

    timer = node.create_timer(0.05, called, clock=steady, autostart=False)
    rclpy.spin_once(node, timeout_sec=0.1)
    print(len(infos), timer.is_canceled())
    timer.reset()
    while len(infos) < 3:
        rclpy.spin_once(node)
    late = [info.actual_call_time - info.expected_call_time for info in infos]
    apart = infos[2].expected_call_time - infos[1].expected_call_time
    print(all(each.nanoseconds >= 0 for each in late), apart.nanoseconds % 50_000_000)
    timer.timer_period_ns = 20_000_000
    print(timer.timer_period_ns, timer.time_until_next_call() <= 50_000_000)
    begin = time.monotonic_ns()
    print(steady.sleep_for(Duration(seconds=0.05)), time.monotonic_ns() - begin >= 50_000_000)
    node.destroy_node()


class Strict(Node):
    """Parameters as nodes declare them in their constructor."""

    def __init__(self, **words):
        super().__init__("strict", **words)
        self.declare_parameters("arm", [("length", 0.5), ("joints", [1, 2]), ("name", "left")])
        self.add_on_set_parameters_callback(
            lambda parameters: SetParametersResult(successful=all(p.value for p in parameters))
        )


def declared():
    """Declare, and ask for what is not declared."""
    node = Strict(namespace="lab", enable_rosout=False, start_parameter_services=False)
    print(node.get_parameter("arm.joints").value, node.get_parameter_or("no", None).value)
    print(node.set_parameters_atomically([Parameter("arm.name", value="")]).successful)
    try:
        node.get_parameter("leg")
    except ParameterNotDeclaredException as error:
        print(error)
    print(node.get_fully_qualified_name(), node.resolve_topic_name("~/x"))
    node.undeclare_parameter("arm.length")
    print(node.has_parameter("arm.length"), sorted(node.get_parameters_by_prefix("arm")))
    node.destroy_node()


def main():
    """Run all."""
    rclpy.init(args=sys.argv, signal_handler_options=SignalHandlerOptions.NO)
    profile = QoSProfile(history=HistoryPolicy.KEEP_ALL, reliability=ReliabilityPolicy.RELIABLE)
    print(profile.depth, profile.durability is DurabilityPolicy.VOLATILE)
    qos_by_parameters()
    raw()
    liveliness()
    times()
    declared()
    rclpy.shutdown()
