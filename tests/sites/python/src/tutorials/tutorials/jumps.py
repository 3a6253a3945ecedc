"""Timers, sleeps and rates on a clock of ROS time that jumps."""

import threading
import time

import rclpy
from rclpy.clock import JumpThreshold, ROSClock
from rclpy.clock_type import ClockType
from rclpy.duration import Duration
from rclpy.executors import SingleThreadedExecutor
from rclpy.time import Time

PERIOD = 100


class Simulation(ROSClock):
    """A clock that this program sets."""

    def at(self, seconds):
        """Show `seconds` when ROS time is active."""
        nanoseconds = round(seconds * 1e9)
        self.set_ros_time_override(Time(nanoseconds=nanoseconds, clock_type=ClockType.ROS_TIME))

    def simulate(self, enabled):
        """Activate ROS time, or deactivate it."""
        self._set_ros_time_is_active(enabled)


def simulation():
    """Return a new clock."""
    clock = ROSClock()
    clock.__class__ = Simulation
    return clock


def show(timer, what):
    """Print when the timer is called, in seconds."""
    until, since = timer.time_until_next_call(), timer.time_since_last_call()
    # Of times since 1970, the last digits differ.
    known = [None if each is None else round(each / 1e9) for each in (until, since)]
    far = ["far" if each and abs(each) > 1e6 else each for each in known]
    print(what, *far, timer.is_ready())


def call(timer):
    """Do what an executor does with a timer that is ready."""
    if timer.is_ready():
        info = timer.handle.call_timer_with_info()
        print("called", info["expected_call_time"] // 10**9, info["actual_call_time"] // 10**9)


def timers(node):
    """Let the clock jump between calls of a timer."""
    clock = simulation()
    jumps = []
    threshold = JumpThreshold(
        min_forward=Duration(nanoseconds=1), min_backward=Duration(nanoseconds=-1)
    )
    handle = clock.create_jump_callback(
        threshold, post_callback=lambda jump: jumps.append(jump.delta.nanoseconds // 10**9)
    )
    timer = node.create_timer(PERIOD, lambda: None, clock=clock)
    show(timer, "system time")
    clock.simulate(True)
    show(timer, "no time yet")
    for seconds in (0, 5000, 5030, 5010, 4990, 5100, 5290, 5300, 5500, 5900, 5450, 5050, 5050):
        clock.at(seconds)
        show(timer, seconds)
        call(timer)
    clock.at(5080)
    clock.simulate(False)
    show(timer, "system time")
    clock.simulate(True)
    show(timer, "simulated time")
    timer.cancel()
    clock.at(2000)
    show(timer, "canceled")
    timer.reset()
    show(timer, "reset")
    clock.at(2060)
    show(timer, "later")
    clock.at(0)
    show(timer, "zero")
    clock.simulate(False)
    show(timer, "after zero")
    clock.simulate(True)
    clock.at(50)
    timer.timer_period_ns = 2 * PERIOD * 10**9
    clock.at(20)
    show(timer, "other period")
    print(jumps)
    handle.unregister()
    zero = node.create_timer(0, lambda: None, clock=clock)
    for seconds in (30, 10, 10):
        clock.at(seconds)
        show(zero, "always")
        call(zero)
    node.destroy_timer(timer)
    node.destroy_timer(zero)


def meanwhile(act, change):
    """Return what `act` does while `change` is called with the numbers from 0."""
    over = threading.Event()

    def run():
        count = 0
        while not over.is_set():
            change(count)
            count += 1
            time.sleep(0.005)

    thread = threading.Thread(target=run)
    thread.start()
    result = act()
    over.set()
    thread.join()
    return result


def sleeps():
    """Sleep while another thread sets the clock."""
    clock = simulation()
    clock.at(100)
    clock.simulate(True)
    until = Time(seconds=150, clock_type=ClockType.ROS_TIME)
    print(meanwhile(lambda: clock.sleep_until(until), lambda i: clock.at(20 if i < 3 else 200 + i)))
    print(clock.now() >= until)
    never = Time(seconds=2**32, clock_type=ClockType.ROS_TIME)
    print(meanwhile(lambda: clock.sleep_until(never), lambda i: clock.simulate(i % 2 == 1)))


def rates(node):
    """Let a rate and a timer of an executor follow a clock that jumps back."""
    clock = simulation()
    clock.at(1000)
    clock.simulate(True)
    fired = threading.Event()
    rate = node.create_rate(1.0, clock)
    timer = node.create_timer(0.2, fired.set, clock=clock)
    executor = SingleThreadedExecutor()
    executor.add_node(node)
    spinner = threading.Thread(target=executor.spin)
    spinner.start()
    meanwhile(rate.sleep, lambda i: clock.at(10 + i / 10))
    print(clock.now().nanoseconds < 900 * 10**9, fired.is_set())
    executor.shutdown()
    spinner.join()
    node.destroy_timer(timer)
    node.destroy_rate(rate)


def main(args=None):
    """Do it."""
    with rclpy.init(args=args):
        node = rclpy.create_node("jumps")
        timers(node)
        sleeps()
        rates(node)
        node.destroy_node()
