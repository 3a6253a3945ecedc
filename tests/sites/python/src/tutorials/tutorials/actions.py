"""A server and a client of an action: goals that succeed, fail, are refused and cancelled."""

import threading
import time

import rclpy
from action_msgs.msg import GoalStatus
from action_msgs.srv import CancelGoal
from rclpy.action import ActionClient, ActionServer, CancelResponse, GoalResponse
from rclpy.callback_groups import ReentrantCallbackGroup
from rclpy.executors import MultiThreadedExecutor
from rclpy.node import Node
from test_msgs.action import Fibonacci

heard = []
NAMES = {getattr(GoalStatus, name): name for name in dir(GoalStatus) if name.startswith("STATUS")}


class Server(Node):
    """Counts as Fibonacci did."""

    def __init__(self):
        super().__init__("fibonacci_server")
        group = ReentrantCallbackGroup()
        self._server = ActionServer(
            self,
            Fibonacci,
            "fibonacci",
            execute_callback=self.execute,
            goal_callback=self.accept,
            handle_accepted_callback=lambda goal: goal.execute(),
            cancel_callback=self.cancel,
            callback_group=group,
        )

    def accept(self, request):
        """Refuse what is below zero."""
        return GoalResponse.REJECT if request.order < 0 else GoalResponse.ACCEPT

    def cancel(self, goal):
        """Let all but the goal of order 21 be cancelled."""
        return CancelResponse.REJECT if goal.request.order == 21 else CancelResponse.ACCEPT

    def execute(self, goal):
        """Add up, one number at a time."""
        order = goal.request.order
        feedback = Fibonacci.Feedback(sequence=[0, 1])
        for i in range(1, order):
            if goal.is_cancel_requested:
                goal.canceled()
                return Fibonacci.Result(sequence=feedback.sequence)
            feedback.sequence.append(feedback.sequence[i] + feedback.sequence[i - 1])
            goal.publish_feedback(feedback)
            if order > 10:
                time.sleep(0.2)
            # Who has the result hears no more feedback, so each waits for its own to be heard.
            while order < 10 and len(heard) < i:
                time.sleep(0.01)
        if order == 3:
            goal.abort()
        elif order == 4:
            raise ValueError("four")
        elif order != 2:
            goal.succeed()
        return Fibonacci.Result(sequence=feedback.sequence)


def main():
    """Ask in all ways."""
    rclpy.init()
    server, client_node = Server(), rclpy.create_node("client")
    client = ActionClient(client_node, Fibonacci, "fibonacci")
    nobody = ActionClient(client_node, Fibonacci, "nobody")
    executor = MultiThreadedExecutor(num_threads=6)
    executor.add_node(server)
    executor.add_node(client_node)

    def wait(future, limit=30.0):
        executor.spin_until_future_complete(future, limit)
        return future.result()

    print("nobody:", nobody.wait_for_server(timeout_sec=0.2))
    print("server:", client.wait_for_server(timeout_sec=10.0))
    for order in (6, 3, 4, 2, -1, 0):
        heard.clear()
        goal = Fibonacci.Goal(order=order)
        handle = wait(client.send_goal_async(goal, feedback_callback=heard.append))
        print(order, "accepted:", handle.accepted)
        if handle.accepted:
            answer = wait(handle.get_result_async())
            print(NAMES[answer.status], list(answer.result.sequence))
        for message in heard:
            print("feedback", list(message.feedback.sequence))

    long = wait(client.send_goal_async(Fibonacci.Goal(order=20)))
    stubborn = wait(client.send_goal_async(Fibonacci.Goal(order=21)))
    for handle in (long, stubborn):
        response = wait(handle.cancel_goal_async())
        print("cancelling", response.return_code, len(response.goals_canceling))
    answer = wait(long.get_result_async())
    print(NAMES[answer.status], len(answer.result.sequence) < 20)
    answer = wait(stubborn.get_result_async())
    print(NAMES[answer.status], len(answer.result.sequence))
    print("too late:", wait(stubborn.cancel_goal_async()).return_code)

    cancel = client_node.create_client(CancelGoal, "fibonacci/_action/cancel_goal")
    cancel.wait_for_service()
    request = CancelGoal.Request()
    request.goal_info.goal_id.uuid[0] = 7
    print("unknown:", wait(cancel.call_async(request)).return_code)
    goals = [wait(client.send_goal_async(Fibonacci.Goal(order=20))) for _ in range(2)]
    response = wait(cancel.call_async(CancelGoal.Request()))
    print("all:", response.return_code, len(response.goals_canceling))
    print([NAMES[wait(goal.get_result_async()).status] for goal in goals])

    forgetful = ActionServer(
        server, Fibonacci, "forgetful", lambda goal: Fibonacci.Result(), result_timeout=1
    )
    client = ActionClient(client_node, Fibonacci, "forgetful")
    client.wait_for_server()
    short = wait(client.send_goal_async(Fibonacci.Goal()))
    print("kept:", NAMES[wait(short.get_result_async()).status])
    end = time.monotonic() + 2
    while time.monotonic() < end:
        executor.spin_once(timeout_sec=0.1)
    print("expired:", NAMES[wait(short.get_result_async()).status])
    forgetful.destroy()

    thread = threading.Thread(target=executor.spin, daemon=True)
    thread.start()
    client = ActionClient(client_node, Fibonacci, "fibonacci")
    client.wait_for_server()
    answer = client.send_goal(Fibonacci.Goal(order=1))
    print("blocking:", list(answer.result.sequence))
    print(client_node.count_publishers("fibonacci/_action/feedback"))
    print(client_node.handle.get_action_names_and_types())
    try:
        ActionClient(client_node, Fibonacci, "no name")
    except ValueError as error:
        print("ValueError", str(error).split(", at ")[0])
    executor.shutdown()
    thread.join()
    rclpy.shutdown()
