"""The commonest thread: it spins, and the main thread does something else."""

import threading
import time

import rclpy
from rclpy.executors import ExternalShutdownException, SingleThreadedExecutor
from std_msgs.msg import String
from std_srvs.srv import Trigger


def by_function():
    """Spin a node, and keep a rate."""
    rclpy.init()
    node = rclpy.create_node("node")
    heard, ticks = [], []
    node.create_subscription(String, "chatter", lambda m: heard.append(m.data), 10)
    node.create_timer(0.02, lambda: ticks.append(None))
    publisher = node.create_publisher(String, "chatter", 10)
    thread = threading.Thread(target=rclpy.spin, args=(node,), daemon=True)
    thread.start()
    rate = node.create_rate(50)
    while publisher.get_subscription_count() == 0:
        rate.sleep()
    for count in range(5):
        publisher.publish(String(data=f"rate {count}"))
        rate.sleep()
    while len(heard) < 5:
        rate.sleep()
    begin = len(ticks)
    time.sleep(0.3)
    print(heard, 3 < len(ticks) - begin < 30, thread.is_alive())
    rclpy.shutdown()
    thread.join()
    print("alive:", thread.is_alive())


def by_executor():
    """Spin an executor, and call what it serves."""
    with rclpy.init():
        node, other = rclpy.create_node("server"), rclpy.create_node("client")

        def answer(request, response):
            response.success, response.message = True, "yes"
            return response

        node.create_service(Trigger, "ask", answer)
        client = other.create_client(Trigger, "ask")
        executor = SingleThreadedExecutor()
        executor.add_node(node)
        executor.add_node(other)

        thread = threading.Thread(target=executor.spin)
        thread.start()
        print("there:", client.wait_for_service(10))
        print("called:", client.call(Trigger.Request()).message)
        future = client.call_async(Trigger.Request())
        while not future.done():
            time.sleep(0.01)
        print("asked:", future.result().message)
        executor.shutdown()
        thread.join()
        print("alive:", thread.is_alive())


def beside_spinning():
    """Spin one node here, and another one there."""
    with rclpy.init():
        here, there = rclpy.create_node("here"), rclpy.create_node("there")
        heard = []
        publisher = there.create_publisher(String, "chatter", 10)
        there.create_timer(0.02, lambda: publisher.publish(String(data="from there")))
        here.create_subscription(String, "chatter", lambda m: heard.append(m.data), 10)
        executor = SingleThreadedExecutor()
        executor.add_node(there)
        thread = threading.Thread(target=executor.spin, name="spinner")
        thread.start()
        while len(heard) < 3:
            rclpy.spin_once(here)
        print(heard[:3], [each.name for each in threading.enumerate() if each is thread])
        there.create_timer(0.0, lambda: 1 / 0)
        thread.join()
        print("it failed:", thread.is_alive())


def main():
    """Run all."""
    try:
        by_function()
        by_executor()
        beside_spinning()
    except ExternalShutdownException:
        print("shut down")
