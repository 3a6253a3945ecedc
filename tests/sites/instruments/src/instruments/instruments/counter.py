"""An action server: Fibonacci numbers, one every tenth of a second."""

import contextlib
import time

import rclpy
from rclpy.action import ActionServer, CancelResponse, GoalResponse
from rclpy.callback_groups import ReentrantCallbackGroup
from rclpy.executors import MultiThreadedExecutor
from rclpy.node import Node
from test_msgs.action import Fibonacci


class Counter(Node):
    """Refuses orders below zero and aborts at order 3."""

    def __init__(self):
        super().__init__("counter")
        self._server = ActionServer(
            self,
            Fibonacci,
            "fibonacci",
            self.execute,
            callback_group=ReentrantCallbackGroup(),
            goal_callback=self.accept,
            cancel_callback=lambda goal: CancelResponse.ACCEPT,
        )

    def accept(self, request):
        """Refuse what is below zero."""
        return GoalResponse.REJECT if request.order < 0 else GoalResponse.ACCEPT

    def execute(self, goal):
        """Add up, one number at a time."""
        feedback = Fibonacci.Feedback(sequence=[0, 1])
        while len(feedback.sequence) <= goal.request.order:
            if goal.is_cancel_requested:
                goal.canceled()
                return Fibonacci.Result(sequence=feedback.sequence)
            feedback.sequence.append(feedback.sequence[-1] + feedback.sequence[-2])
            goal.publish_feedback(feedback)
            time.sleep(0.1)
        if goal.request.order == 3:
            goal.abort()
        else:
            goal.succeed()
        return Fibonacci.Result(sequence=feedback.sequence)


def main():
    """Serve until stopped."""
    rclpy.init()
    executor = MultiThreadedExecutor(num_threads=4)
    executor.add_node(Counter())
    with contextlib.suppress(KeyboardInterrupt):
        executor.spin()
