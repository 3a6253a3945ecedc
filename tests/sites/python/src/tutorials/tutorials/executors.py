"""Executors, callback groups, guard conditions, tasks, rates, asyncio, waiting for a message."""

import asyncio
import threading
import time

import rclpy
from rclpy.callback_groups import MutuallyExclusiveCallbackGroup, ReentrantCallbackGroup
from rclpy.executors import MultiThreadedExecutor, SingleThreadedExecutor
from rclpy.experimental import EventsExecutor
from rclpy.task import Future
from rclpy.wait_for_message import wait_for_message
from std_msgs.msg import String
from std_srvs.srv import Trigger


def call_within_a_callback(node, executor, group):
    """Call a service from a timer's callback, which only works if both may run at a time."""

    def answer(request, response):
        response.message = "yes"
        return response

    done = Future(executor=executor)
    node.create_service(Trigger, "question", answer, callback_group=group)
    client = node.create_client(Trigger, "question", callback_group=group)

    def ask():
        timer.cancel()
        client.wait_for_service()
        done.set_result(client.call(Trigger.Request()).message)

    other = MutuallyExclusiveCallbackGroup()
    timer = node.create_timer(0.01, ask, callback_group=other)
    executor.spin_until_future_complete(done, 20.0)
    print("answer within a callback:", done.result())


def tasks(node, executor):
    """Run functions and coroutines."""
    gate = Future(executor=executor)

    async def wait(name):
        return f"{name} {await gate}"

    async def fail():
        raise KeyError("in a task")

    waiting = [executor.create_task(wait, name) for name in "ab"]
    simple = executor.create_task(lambda x: x * 2, 21)
    executor.spin_until_future_complete(simple, 10.0)
    print(simple.result())
    gate.set_result("through the gate")
    for task in waiting:
        executor.spin_until_future_complete(task, 10.0)
        print(task.result())
    if not isinstance(executor, SingleThreadedExecutor):
        return  # with threads it raises at any time, and the experimental one crashes
    try:
        executor.spin_until_future_complete(executor.create_task(fail), 10.0)
    except KeyError as error:
        print("raised", error)


def guard(node, executor):
    """Trigger from another thread."""
    heard = Future(executor=executor)
    condition = node.create_guard_condition(lambda: heard.set_result("triggered"))
    threading.Timer(0.05, condition.trigger).start()
    executor.spin_until_future_complete(heard, 10.0)
    print(heard.result())
    node.destroy_guard_condition(condition)


def rate(node):
    """Wait in the rhythm of a rate while another thread spins."""
    executor = SingleThreadedExecutor()
    executor.add_node(node)
    thread = threading.Thread(target=executor.spin, daemon=True)
    thread.start()
    began = time.monotonic()
    rate = node.create_rate(20)
    for _ in range(4):
        rate.sleep()
    print("as slow as it should be:", time.monotonic() - began > 0.14)
    executor.shutdown()
    thread.join()


async def spin_with_asyncio(node):
    """Share the thread with asyncio."""
    heard = []
    publisher = node.create_publisher(String, "aio", 10)
    node.create_subscription(String, "aio", lambda message: heard.append(message.data), 10)

    async def publish():
        while len(heard) < 3:
            publisher.publish(String(data=f"number {len(heard)}"))
            await asyncio.sleep(0.02)

    async def spin():
        while len(heard) < 3:
            rclpy.spin_once(node, timeout_sec=0)
            await asyncio.sleep(0.001)

    await asyncio.gather(publish(), spin())
    print("asyncio heard", len(heard) >= 3, heard[0])


def main():
    """Use one executor after the other."""
    rclpy.init()
    for kind in (MultiThreadedExecutor, SingleThreadedExecutor, lambda: EventsExecutor()):
        node = rclpy.create_node("node")
        executor = kind()
        executor.add_node(node)
        print("added again:", executor.add_node(node))
        if kind is MultiThreadedExecutor:
            call_within_a_callback(node, executor, ReentrantCallbackGroup())
        tasks(node, executor)
        if kind in (MultiThreadedExecutor, SingleThreadedExecutor):  # natively the other has none
            guard(node, executor)
        executor.shutdown()
        node.destroy_node()
    node = rclpy.create_node("last")
    rate(node)
    asyncio.run(spin_with_asyncio(node))
    publisher = node.create_publisher(String, "late", 10)
    threading.Timer(0.2, lambda: publisher.publish(String(data="there"))).start()
    print(wait_for_message(String, node, "late", time_to_wait=10))
    print(wait_for_message(String, node, "never", time_to_wait=0.1))
    rclpy.shutdown()
