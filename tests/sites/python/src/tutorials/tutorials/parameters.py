"""Parameters: declared, overridden, refused, and set by a service of the node's own."""

import rclpy
from rcl_interfaces.msg import ParameterDescriptor, SetParametersResult
from rcl_interfaces.srv import GetParameters, ListParameters
from rclpy.parameter import Parameter


def main():
    """Look at the parameters from inside and from outside."""
    rclpy.init(args=["--ros-args", "-p", "rate:=2.5", "-p", "names:=[a, b]"])
    node = rclpy.create_node("configured")
    node.declare_parameter("rate", 1.0)
    node.declare_parameter("names", ["x"])
    node.declare_parameter("fixed", 1, ParameterDescriptor(read_only=True))
    for name in ("rate", "names", "fixed"):
        print(name, node.get_parameter(name).value)

    def check(parameters):
        small = all(p.name != "rate" or p.value < 10 for p in parameters)
        return SetParametersResult(successful=small, reason="" if small else "too fast")

    node.add_on_set_parameters_callback(check)
    for value in (3.0, 30.0):
        result = node.set_parameters([Parameter("rate", value=value)])[0]
        print(result.successful, result.reason, node.get_parameter("rate").value)
    try:
        node.set_parameters_atomically([Parameter("fixed", value=2)])
        print(node.get_parameter("fixed").value)
        node.declare_parameter("rate", 1.0)
    except Exception as error:
        print(type(error).__name__, error)

    client = node.create_client(ListParameters, "configured/list_parameters")
    client.wait_for_service()
    future = client.call_async(ListParameters.Request())
    rclpy.spin_until_future_complete(node, future)
    print(sorted(n for n in future.result().result.names if n in ("rate", "names", "fixed")))
    getter = node.create_client(GetParameters, "configured/get_parameters")
    future = getter.call_async(GetParameters.Request(names=["rate"]))
    rclpy.spin_until_future_complete(node, future)
    print(future.result().values[0].double_value)
    rclpy.shutdown()
