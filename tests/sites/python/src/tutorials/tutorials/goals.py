"""Goals of an action that wait in a queue, asked for by a client in a loop of asyncio."""

import asyncio
import collections
import contextlib
import threading
import time

import rclpy
from action_msgs.msg import GoalStatus
from rclpy.action import ActionClient, ActionServer, CancelResponse, GoalResponse
from rclpy.callback_groups import ReentrantCallbackGroup
from rclpy.executors import ExternalShutdownException, MultiThreadedExecutor
from rclpy.node import Node
from test_msgs.action import Fibonacci


class Queue(Node):
    """An action server that works on one goal at a time."""

    def __init__(self):
        super().__init__("queue")
        self.waiting = collections.deque()
        self.lock = threading.Lock()
        self.current = None
        self.log = []
        self.server = ActionServer(
            self,
            Fibonacci,
            "fibonacci",
            execute_callback=self.work,
            handle_accepted_callback=self.accepted,
            goal_callback=self.asked,
            cancel_callback=lambda _: CancelResponse.ACCEPT,
            callback_group=ReentrantCallbackGroup(),
        )

    def asked(self, request):
        """Refuse goals that make no sense."""
        return GoalResponse.REJECT if request.order < 0 else GoalResponse.ACCEPT

    def accepted(self, goal):
        """Begin, or let it wait."""
        with self.lock:
            if self.current is None:
                self.current = goal
                goal.execute()
            else:
                self.waiting.append(goal)
                self.log.append(("waits", goal.request.order))

    def work(self, goal):
        """Compute, a number at a time."""
        try:
            feedback = Fibonacci.Feedback(sequence=[0, 1])
            for i in range(1, goal.request.order):
                if goal.is_cancel_requested:
                    goal.canceled()
                    return Fibonacci.Result(sequence=[])
                feedback.sequence.append(feedback.sequence[i] + feedback.sequence[i - 1])
                goal.publish_feedback(feedback)
                time.sleep(0.02)
            goal.succeed()
            return Fibonacci.Result(sequence=feedback.sequence)
        finally:
            self.log.append(("done", goal.request.order))
            with self.lock:
                self.current = self.waiting.popleft() if self.waiting else None
                if self.current:
                    self.current.execute()


class Asker(Node):
    """Asks for goals and waits for what becomes of them."""

    def __init__(self):
        super().__init__("asker")
        self.client = ActionClient(self, Fibonacci, "fibonacci")
        self.heard = collections.Counter()

    async def ask(self, order, cancel=False):
        """Return the status of a goal and its result."""
        self.client.wait_for_server()
        hear = lambda message: self.heard.update([(order, len(message.feedback.sequence))])  # noqa: E731
        goal = await self.client.send_goal_async(Fibonacci.Goal(order=order), hear)
        if not goal.accepted:
            return "rejected", []
        if cancel:
            answer = await goal.cancel_goal_async()
            print("canceling", len(answer.goals_canceling))
        result = await goal.get_result_async()
        names = {GoalStatus.STATUS_SUCCEEDED: "succeeded", GoalStatus.STATUS_CANCELED: "canceled"}
        return names[result.status], list(result.result.sequence)


async def spin(node):
    """Let rclpy take turns with asyncio."""
    while rclpy.ok():
        rclpy.spin_once(node, timeout_sec=0.01)
        await asyncio.sleep(0.001)


async def run(asker):
    """Ask for several goals."""
    spinning = asyncio.get_running_loop().create_task(spin(asker))
    tasks = [asyncio.ensure_future(asker.ask(order)) for order in (6, 4)]
    finished, unfinished = await asyncio.wait(tasks)
    print(len(finished), "unfinished:", len(unfinished))
    for task in tasks:
        print(*task.result())
    print(*await asker.ask(-1))
    print(*await asyncio.gather(asker.ask(40, cancel=True), asker.ask(3)))
    spinning.cancel()
    try:
        await spinning
    except asyncio.CancelledError:
        print("no more turns")


def serve(executor):
    """Spin until the end."""
    with contextlib.suppress(ExternalShutdownException):
        executor.spin()


def main():
    """Run both in one program."""
    rclpy.init()
    queue, asker = Queue(), Asker()
    executor = MultiThreadedExecutor()
    executor.add_node(queue)
    thread = threading.Thread(target=serve, args=(executor,))
    thread.start()
    loop = asyncio.new_event_loop()
    loop.run_until_complete(run(asker))
    print(queue.log[:3])
    print(sorted(asker.heard)[:5], max(asker.heard.values()))
    executor.shutdown()
    rclpy.shutdown()
    thread.join()
    print("over")
