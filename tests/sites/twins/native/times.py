"""Times, durations, clocks that are simulated, timers, and what loggers say."""

import rclpy
from rcl_interfaces.msg import Log
from rclpy.clock import Clock, ClockType
from rclpy.duration import Duration
from rclpy.parameter import Parameter
from rclpy.qos import QoSProfile
from rclpy.time import Time
from rosgraph_msgs.msg import Clock as ClockMessage


def attempt(what, act):
    """Say what comes of an act."""
    try:
        print(what, act())
    except (TypeError, ValueError, OverflowError, RuntimeError):
        print(what, "refused")


def play():
    """Do all of it."""
    # Arithmetic
    three, one = Time(seconds=3), Time(seconds=1, nanoseconds=500)
    print((three - one).nanoseconds, (three + Duration(seconds=2)).nanoseconds)
    print((one - Duration(nanoseconds=500)).nanoseconds, three > one, three == Time(seconds=3))
    ros = Time(seconds=3, clock_type=ClockType.ROS_TIME)
    attempt("less", lambda: three < ros)
    attempt("minus", lambda: three - ros)
    attempt("negative", lambda: Time(seconds=-1).nanoseconds)
    attempt("large", lambda: (Time(nanoseconds=2**63 - 1) + Duration(seconds=1)).nanoseconds)
    print(
        Duration(seconds=-2, nanoseconds=5).nanoseconds, Duration(seconds=1) > Duration(seconds=-1)
    )
    message = Time(seconds=5, nanoseconds=7).to_msg()
    print(message.sec, message.nanosec, Time.from_msg(message).nanoseconds)
    message = Duration(seconds=-1, nanoseconds=-1).to_msg()
    print(message.sec, message.nanosec)

    # A clock that is simulated
    rclpy.init()
    node = rclpy.create_node("times")
    clock = node.get_clock()
    print(
        clock.clock_type == ClockType.ROS_TIME,
        clock.ros_time_is_active,
        clock.now().nanoseconds > 0,
    )
    node.set_parameters([Parameter("use_sim_time", value=True)])
    print(clock.ros_time_is_active, clock.now().nanoseconds)
    fired = []
    timer = node.create_timer(1.0, lambda: fired.append(clock.now().nanoseconds))
    wall = node.create_timer(0.02, lambda: None, clock=Clock(clock_type=ClockType.STEADY_TIME))
    publisher = node.create_publisher(ClockMessage, "/clock", QoSProfile(depth=10))
    while not publisher.get_subscription_count():
        rclpy.spin_once(node, timeout_sec=0.05)

    def tick(milliseconds):
        tick = ClockMessage()
        tick.clock.sec, tick.clock.nanosec = divmod(milliseconds * 10**6, 10**9)
        publisher.publish(tick)
        while clock.now().nanoseconds != milliseconds * 10**6:
            rclpy.spin_once(node, timeout_sec=0.05)
        for _ in range(5):
            rclpy.spin_once(node, timeout_sec=0.05)
        print("tick", milliseconds, len(fired), timer.time_until_next_call() or "canceled")

    for milliseconds in (500, 1000, 1500, 2000, 2100):
        tick(milliseconds)
    print(timer.time_until_next_call(), timer.is_ready(), timer.is_canceled())
    timer.cancel()
    print(timer.is_canceled())
    tick(3500)
    timer.reset()
    tick(4400)
    tick(4600)
    # Back by little, by much, and exactly to the time of a call.
    for milliseconds in (4300, 5200, 5300, 1000, 1900, 2000, 9000, 8500, 9700):
        tick(milliseconds)
    node.set_parameters([Parameter("use_sim_time", value=False)])
    print(clock.ros_time_is_active, timer.time_until_next_call() < 500 * 10**6)
    late = rclpy.create_node("late")
    later = late.create_timer(1.0, lambda: None)
    late.set_parameters([Parameter("use_sim_time", value=True)])
    while late.get_clock().now().nanoseconds == 0:
        publisher.publish(ClockMessage(clock=Time(seconds=7).to_msg()))
        rclpy.spin_once(late, timeout_sec=0.05)
    print(later.time_until_next_call())
    late.destroy_node()
    node.destroy_timer(timer)
    node.destroy_timer(wall)

    # Timers and rates
    count = []
    timer = node.create_timer(0.01, lambda: count.append(1))
    while len(count) < 3:
        rclpy.spin_once(node, timeout_sec=1.0)
    timer.cancel()
    for _ in range(3):
        rclpy.spin_once(node, timeout_sec=0.02)
    print("timer", len(count), timer.timer_period_ns)

    # The log
    lines = []
    node.create_subscription(Log, "/rosout", lambda m: lines.append(m), 100)
    while node.count_publishers("/rosout") < 1:
        rclpy.spin_once(node, timeout_sec=0.05)
    logger = node.get_logger()
    child = logger.get_child("part")
    logger.info("first")
    logger.debug("not shown")
    for i in range(3):
        logger.warning(f"once {i}", once=True)
    for i in range(3):
        logger.error(f"skipped {i}", skip_first=True)
    for i in range(3):
        logger.warning(f"throttled {i}", throttle_duration_sec=60.0)
    child.fatal("of the child")
    logger.set_level(rclpy.logging.LoggingSeverity.WARN)
    logger.info("not shown either")
    print(child.is_enabled_for(rclpy.logging.LoggingSeverity.INFO))
    logger.set_level(rclpy.logging.LoggingSeverity.DEBUG)
    logger.debug("last")
    while not lines or lines[-1].msg != "last":
        rclpy.spin_once(node, timeout_sec=0.05)
    for line in lines:
        print(line.name, int(line.level), line.msg)
    rclpy.shutdown()
