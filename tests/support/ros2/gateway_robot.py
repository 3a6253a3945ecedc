"""A native node that does with a page's nodes what standard input says.

Each line is a JSON list: the name of a function and its arguments; the answer is a line, too.
"""

from __future__ import annotations

import json
import sys
import threading
import time
from typing import Any

import rclpy
from action_msgs.msg import GoalStatus
from rcl_interfaces.srv import GetParameters, SetParameters
from rclpy.action import ActionClient, ActionServer, CancelResponse
from rclpy.callback_groups import ReentrantCallbackGroup
from rclpy.executors import MultiThreadedExecutor
from rclpy.parameter import Parameter
from rclpy.qos import DurabilityPolicy, QoSProfile
from std_msgs import msg as std
from std_msgs.msg import String
from std_srvs.srv import SetBool
from test_msgs.action import Fibonacci

# The last Fibonacci number of 32 bits. Who asks for more has to cancel.
LARGEST = 46
LATCHED = QoSProfile(depth=5, durability=DurabilityPolicy.TRANSIENT_LOCAL)


class Robot:
    def __init__(self) -> None:
        rclpy.init()
        self.node = rclpy.create_node("robot")
        self.node.declare_parameter("gain", 2.5)
        self.heard: dict[str, list[Any]] = {}
        self.publishers: dict[str, Any] = {}
        self.count = 0
        self.chatter = self.node.create_publisher(String, "/robot/chatter", 100)
        self.map = self.node.create_publisher(String, "/robot/map", LATCHED)
        self.map.publish(String(data="map of the robot"))
        self.listen("/page/chatter", False)
        self.node.create_service(SetBool, "/robot/set", self._set)
        # Answers when it is told to.
        self.released = threading.Event()
        self.held = 0
        together = ReentrantCallbackGroup()
        self.node.create_service(SetBool, "/robot/slow", self._slow, callback_group=together)
        self.asked: dict[str, list[Any]] = {}
        self.clients = {
            SetBool: self.node.create_client(SetBool, "/page/set"),
            GetParameters: self.node.create_client(GetParameters, "/station/get_parameters"),
            SetParameters: self.node.create_client(SetParameters, "/station/set_parameters"),
        }
        self.goals = 0
        ActionServer(
            self.node,
            Fibonacci,
            "/robot/fibonacci",
            self._execute,
            cancel_callback=lambda _: CancelResponse.ACCEPT,
        )
        self.action = ActionClient(self.node, Fibonacci, "/page/fibonacci")
        self.node.create_timer(0.05, self._tick)
        executor = MultiThreadedExecutor(4)
        executor.add_node(self.node)
        threading.Thread(target=executor.spin, daemon=True).start()

    def _tick(self) -> None:
        self.count += 1
        self.chatter.publish(String(data=f"robot {self.count}"))

    def sent(self) -> int:
        return self.count

    def _set(self, request: Any, response: Any) -> Any:
        response.success, response.message = request.data, "from the robot"
        return response

    def _slow(self, request: Any, response: Any) -> Any:
        self.held += 1
        self.released.wait(60)
        response.success, response.message = request.data, "slowly"
        return response

    def holds(self) -> int:
        return self.held

    def release(self) -> None:
        self.released.set()

    def ask(self, service: str) -> None:
        client = self.node.create_client(SetBool, service)
        assert client.wait_for_service(10)
        calls = self.asked.setdefault(service, [])
        calls.append((client, client.call_async(SetBool.Request(data=True))))

    def answers(self, service: str) -> list[str]:
        calls = self.asked[service]
        return [call.result().message if call.done() else "" for _, call in calls]

    def ready(self, service: str) -> list[bool]:
        return [client.service_is_ready() for client, _ in self.asked[service]]

    def sides(self, service: str) -> list[int]:
        return [self.node.count_services(service), self.node.count_clients(service)]

    def _execute(self, goal: Any) -> Any:
        self.goals += 1
        numbers = [0, 1]
        for _ in range(1, min(goal.request.order, LARGEST)):
            numbers.append(numbers[-1] + numbers[-2])
        while goal.request.order > LARGEST and not goal.is_cancel_requested:
            time.sleep(0.02)
        goal.canceled() if goal.is_cancel_requested else goal.succeed()
        return Fibonacci.Result(sequence=numbers)

    def pursued(self) -> int:
        return self.goals

    def listen(self, topic: str, latched: bool, kind: str = "String") -> None:
        heard = self.heard.setdefault(topic, [])
        qos = LATCHED if latched else QoSProfile(depth=1000)
        self.node.create_subscription(
            getattr(std, kind), topic, lambda m: heard.append(m.data), qos
        )

    def texts(self, topic: str) -> list[Any]:
        return self.heard[topic]

    def nodes(self) -> list[str]:
        names = self.node.get_node_names_and_namespaces()
        return sorted(f"{space.rstrip('/')}/{name}" for name, space in names)

    def topic(self, name: str) -> dict[str, list[list[Any]]]:
        found = {
            "publishers": self.node.get_publishers_info_by_topic(name),
            "subscriptions": self.node.get_subscriptions_info_by_topic(name),
        }
        return {
            side: sorted(
                [
                    info.node_name,
                    info.qos_profile.reliability.name,
                    info.qos_profile.durability.name,
                ]
                for info in infos
            )
            for side, infos in found.items()
        }

    def services(self, node: str) -> list[str]:
        return sorted(name for name, _ in self.node.get_service_names_and_types_by_node(node, "/"))

    def call(self) -> str:
        return str(self._ask(SetBool.Request(data=True), SetBool).message)

    def speed(self) -> float:
        answer = self._ask(GetParameters.Request(names=["speed"]), GetParameters)
        return float(answer.values[0].double_value)

    def set_speed(self, value: float) -> bool:
        parameter = Parameter("speed", value=value).to_parameter_msg()
        answer = self._ask(SetParameters.Request(parameters=[parameter]), SetParameters)
        return bool(answer.results[0].successful)

    def _ask(self, request: Any, kind: Any) -> Any:
        client = self.clients[kind]
        assert client.wait_for_service(10)
        return self._result(client.call_async(request))

    def goal(self, order: int) -> dict[str, Any]:
        feedback: list[list[int]] = []
        assert self.action.wait_for_server(10)
        handle = self._result(
            self.action.send_goal_async(
                Fibonacci.Goal(order=order),
                lambda m: feedback.append(list(m.feedback.sequence)),
            )
        )
        result = self._result(handle.get_result_async())
        return {"result": list(result.result.sequence), "feedback": len(feedback)}

    def cancel(self) -> dict[str, Any]:
        begun = threading.Event()
        assert self.action.wait_for_server(10)
        handle = self._result(
            self.action.send_goal_async(Fibonacci.Goal(order=1000), lambda _: begun.set())
        )
        assert begun.wait(15)
        canceling = self._result(handle.cancel_goal_async()).goals_canceling
        status = self._result(handle.get_result_async()).status
        return {"canceling": len(canceling), "canceled": status == GoalStatus.STATUS_CANCELED}

    def _result(self, future: Any) -> Any:
        limit = time.monotonic() + 15
        while not future.done():
            assert time.monotonic() < limit, "no answer"
            time.sleep(0.01)
        return future.result()

    def publish(self, topic: str, values: list[Any], depth: int, kind: str = "String") -> None:
        message = getattr(std, kind)
        publisher = self.publishers.get(topic)
        if publisher is None:
            publisher = self.node.create_publisher(message, topic, depth)
            self.publishers[topic] = publisher
        for value in values:
            publisher.publish(message(data=value))

    def subscriptions(self, topic: str) -> int:
        return int(self.node.count_subscribers(topic))


def main() -> None:
    robot = Robot()
    print(json.dumps("ready"), flush=True)
    for line in sys.stdin:
        name, *arguments = json.loads(line)
        print(json.dumps(getattr(robot, name)(*arguments)), flush=True)


main()
