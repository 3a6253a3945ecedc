"""An action: goals that succeed, abort, are refused and cancelled."""

import time

import rclpy
from action_msgs.msg import GoalStatus
from rclpy.action import ActionClient, ActionServer, CancelResponse, GoalResponse
from rclpy.callback_groups import ReentrantCallbackGroup
from rclpy.executors import MultiThreadedExecutor
from test_msgs.action import Fibonacci

heard = []


def accept(request):
    """Refuse what is below zero."""
    return GoalResponse.REJECT if request.order < 0 else GoalResponse.ACCEPT


def cancel(goal):
    """Let all but the goal of order 21 be cancelled."""
    return CancelResponse.REJECT if goal.request.order == 21 else CancelResponse.ACCEPT


def execute(goal):
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
            time.sleep(0.1)
        # Who has the result hears no more feedback, so each waits for its own to be heard.
        while order < 10 and len(heard) < i:
            time.sleep(0.01)
    if order == 3:
        goal.abort()
    else:
        goal.succeed()
    return Fibonacci.Result(sequence=feedback.sequence)


def play():
    """Ask in all ways."""
    rclpy.init()
    server, asker = rclpy.create_node("server"), rclpy.create_node("asker")
    ActionServer(
        server,
        Fibonacci,
        "fibonacci",
        execute,
        goal_callback=accept,
        cancel_callback=cancel,
        callback_group=ReentrantCallbackGroup(),
    )
    client = ActionClient(asker, Fibonacci, "fibonacci")
    nobody = ActionClient(asker, Fibonacci, "nobody")
    executor = MultiThreadedExecutor(num_threads=4)
    executor.add_node(server)
    executor.add_node(asker)

    def wait(future):
        executor.spin_until_future_complete(future, 30.0)
        return future.result()

    print("nobody", nobody.wait_for_server(timeout_sec=0.1))
    print("server", client.wait_for_server(timeout_sec=10.0))
    for order in (6, 3, -1, 0):
        heard.clear()
        goal = Fibonacci.Goal(order=order)
        handle = wait(client.send_goal_async(goal, feedback_callback=heard.append))
        print(order, "accepted", handle.accepted)
        if handle.accepted:
            answer = wait(handle.get_result_async())
            print("status", answer.status, *answer.result.sequence)
        for message in heard:
            print("feedback", *message.feedback.sequence)
    long = wait(client.send_goal_async(Fibonacci.Goal(order=40)))
    stubborn = wait(client.send_goal_async(Fibonacci.Goal(order=21)))
    print("running", long.status in (GoalStatus.STATUS_ACCEPTED, GoalStatus.STATUS_EXECUTING))
    for handle in (long, stubborn):
        response = wait(handle.cancel_goal_async())
        # When none is cancelled, rclcpp answers with an error and rclpy without.
        print("cancelling", len(response.goals_canceling))
    answer = wait(long.get_result_async())
    print("status", answer.status, len(answer.result.sequence) < 40)
    answer = wait(stubborn.get_result_async())
    print("status", answer.status, len(answer.result.sequence))
    print("too late", wait(stubborn.cancel_goal_async()).return_code)
    executor.shutdown()
    rclpy.shutdown()
