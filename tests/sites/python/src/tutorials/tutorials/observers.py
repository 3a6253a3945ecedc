"""Parameters of another node: asked for, set from a file, and watched as they change."""

import tempfile

import rclpy
from ament_index_python import get_package_share_directory
from rcl_interfaces.msg import FloatingPointRange, ParameterDescriptor, SetParametersResult
from rclpy.executors import SingleThreadedExecutor
from rclpy.node import Node
from rclpy.parameter import (
    Parameter,
    parameter_dict_from_yaml_file,
    parameter_value_to_python,
)
from rclpy.parameter_client import AsyncParameterClient
from rclpy.parameter_event_handler import ParameterEventHandler


class Board(Node):
    """Takes what it is told, but no negative wheels."""

    def __init__(self):
        super().__init__("board", allow_undeclared_parameters=True)
        self.declare_parameter("wheels", 2)
        self.declare_parameter("note", Parameter.Type.STRING)
        descriptor = ParameterDescriptor(
            description="metres a second",
            floating_point_range=[FloatingPointRange(from_value=0.0, to_value=2.0, step=0.5)],
        )
        self.declare_parameter("speed", 0.5, descriptor)
        self.add_on_set_parameters_callback(self.check)

    def check(self, parameters):
        """Refuse negative numbers of wheels."""
        wrong = any(one.name == "wheels" and one.value < 0 for one in parameters)
        return SetParametersResult(successful=not wrong, reason="too few" if wrong else "")


def ask(executor, future):
    """Return what the other node says."""
    executor.spin_until_future_complete(future, timeout_sec=10)
    return future.result()


def main():
    """Watch and change."""
    with rclpy.init():
        board, watcher = Board(), rclpy.create_node("watcher")
        executor = SingleThreadedExecutor()
        executor.add_node(board)
        executor.add_node(watcher)
        handler = ParameterEventHandler(watcher)
        seen = []
        one = handler.add_parameter_callback(
            "wheels", "board", lambda p: seen.append(parameter_value_to_python(p.value))
        )
        every = handler.add_parameter_event_callback(
            lambda event: seen.append(
                (
                    event.node,
                    sorted(p.name for p in event.new_parameters + event.changed_parameters),
                )
            )
        )

        client = AsyncParameterClient(watcher, "board")
        print("there:", client.wait_for_services(10.0), client.services_are_ready())
        wanted = [
            Parameter("wheels", Parameter.Type.INTEGER, 3),
            Parameter("wheels", Parameter.Type.INTEGER, -1),
            Parameter("speed", Parameter.Type.DOUBLE, 0.75),
            Parameter("extra.deep", Parameter.Type.STRING_ARRAY, ["a", "b"]),
        ]
        for result in ask(executor, client.set_parameters(wanted)).results:
            print("set:", result.successful, result.reason)
        result = ask(executor, client.set_parameters_atomically(wanted[:2])).result
        print("at once:", result.successful, result.reason)
        names = ask(executor, client.list_parameters(["wheels", "speed", "extra"], 10)).result.names
        print("named:", sorted(names))
        values = ask(executor, client.get_parameters(["wheels", "speed", "extra.deep"])).values
        print("values:", [parameter_value_to_python(value) for value in values])
        for one_type in ask(executor, client.get_parameter_types(["wheels", "speed"])).types:
            print("type:", one_type)
        [about] = ask(executor, client.describe_parameters(["speed"])).descriptors
        print("about:", about.description, about.floating_point_range[0].step)

        file = f"{get_package_share_directory('tutorials')}/config/robot.yaml"
        done = ask(executor, client.load_parameter_file(file, use_wildcard=True))
        print("loaded:", [each.successful for each in done.results])
        print("in the file:", sorted(parameter_dict_from_yaml_file(file, use_wildcard=True)))
        with tempfile.NamedTemporaryFile("w", suffix=".yaml") as other:
            other.write("board:\n  ros__parameters:\n    note: written\n")
            other.flush()
            done = ask(executor, client.load_parameter_file_atomically(other.name))
            print("at once:", done.result.successful, board.get_parameter("note").value)
        for result in ask(executor, client.delete_parameters(["wheels", "extra.deep"])).results:
            print("deleted:", result.successful, result.reason)

        while len(seen) < 9:
            executor.spin_once()
        handler.remove_parameter_callback(one)
        handler.remove_parameter_event_callback(every)
        board.set_parameters([Parameter("wheels", value=8)])
        executor.spin_once(timeout_sec=0.2)
        for each in seen:
            print("seen:", each)
        board.set_descriptor("wheels", ParameterDescriptor(type=2, read_only=True))
        print(board.set_parameters([Parameter("wheels", value=9)])[0])
        print(board.describe_parameter("wheels").read_only)
