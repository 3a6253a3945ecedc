"""asyncio in full: loops in threads, other threads' calls, actions in coroutines."""

import asyncio
import threading
import time

import rclpy
from rclpy.action import ActionClient, ActionServer
from rclpy.callback_groups import ReentrantCallbackGroup
from rclpy.executors import MultiThreadedExecutor
from test_msgs.action import Fibonacci


async def ticks(name, count):
    """Wait a few times."""
    for _ in range(count):
        await asyncio.sleep(0.02)
    return name


def double(number):
    """Take some time."""
    time.sleep(0.05)
    return 2 * number


async def everything():
    """Use what programs use of a loop."""
    found = []
    thread = threading.Thread(target=lambda: found.append(asyncio.run(ticks("thread", 3))))
    thread.start()
    print(await asyncio.gather(ticks("a", 3), ticks("b", 2)))
    loop = asyncio.get_running_loop()
    print(await asyncio.gather(*(loop.run_in_executor(None, double, i) for i in range(3))))
    print(await asyncio.to_thread(double, 4))
    thread.join()
    print(found)
    try:
        await asyncio.wait_for(asyncio.sleep(60), 0.05)
    except TimeoutError:
        print("too late")
    event = asyncio.Event()
    threading.Timer(0.05, lambda: loop.call_soon_threadsafe(event.set)).start()
    print(await event.wait())
    from_thread = asyncio.run_coroutine_threadsafe(ticks("from a thread", 1), loop)
    print(await asyncio.wrap_future(from_thread))
    queue = asyncio.Queue(maxsize=1)

    async def produce():
        for number in range(3):
            await queue.put(number)

    task = asyncio.create_task(produce(), name="producer")
    print([await queue.get() for _ in range(3)], task.get_name())
    endless = asyncio.create_task(asyncio.sleep(60))
    await asyncio.sleep(0)
    endless.cancel()
    try:
        await endless
    except asyncio.CancelledError:
        print("canceled", len(asyncio.all_tasks()))


class Server(rclpy.node.Node):
    """Executes each goal in a loop of its own, in a thread of the executor."""

    def __init__(self):
        super().__init__("server")
        group = ReentrantCallbackGroup()
        self._server = ActionServer(
            self, Fibonacci, "fibonacci", self.execute, callback_group=group
        )

    def execute(self, goal):
        """Count in a coroutine."""

        async def count():
            feedback = Fibonacci.Feedback()
            feedback.sequence = [0, 1]
            for i in range(1, goal.request.order):
                feedback.sequence.append(feedback.sequence[i] + feedback.sequence[i - 1])
                goal.publish_feedback(feedback)
                await asyncio.sleep(0.05)
            return list(feedback.sequence)

        sequence = asyncio.new_event_loop().run_until_complete(count())
        goal.succeed()
        return Fibonacci.Result(sequence=sequence)


async def spin(node):
    """Take turns with the loop."""
    while rclpy.ok():
        rclpy.spin_once(node, timeout_sec=0.01)
        await asyncio.sleep(0.001)


async def ask(client, order):
    """Send a goal, and wait for its result."""
    client.wait_for_server()
    goal = await client.send_goal_async(Fibonacci.Goal(order=order))
    result = await goal.get_result_async()
    return order, list(result.result.sequence), result.status


async def ask_twice(node):
    """Send two goals at a time, then another one."""
    client = ActionClient(node, Fibonacci, "fibonacci")
    spinning = asyncio.create_task(spin(node))
    print(await asyncio.gather(ask(client, 4), ask(client, 5)))
    print(await ask(client, 3))
    spinning.cancel()
    try:
        await spinning
    except asyncio.CancelledError:
        print("no more spinning")


def main(args=None):
    """Run the parts one after another."""
    # As it was done before asyncio.run(); Python 3.14 makes no loop here any more.
    print(asyncio.get_event_loop().run_until_complete(ticks("in the loop of the thread", 1)))
    asyncio.run(everything())
    rclpy.init(args=args)
    executor = MultiThreadedExecutor()
    executor.add_node(Server())
    thread = threading.Thread(target=executor.spin, daemon=True)
    thread.start()
    asyncio.run(ask_twice(rclpy.create_node("client")))
    executor.shutdown()
    rclpy.shutdown()
    thread.join()
