"""Services and names: who is there, who answers, and what things are called after remapping."""

import rclpy
from rclpy.exceptions import (
    InvalidNamespaceException,
    InvalidNodeNameException,
    InvalidServiceNameException,
    InvalidTopicNameException,
)
from rclpy.executors import SingleThreadedExecutor
from std_msgs.msg import String
from std_srvs.srv import SetBool, Trigger

INVALID = (
    ValueError,
    InvalidNamespaceException,
    InvalidNodeNameException,
    InvalidServiceNameException,
    InvalidTopicNameException,
)
ARGUMENTS = ["--ros-args", "-r", "flip:=toggle", "-r", "server:__ns:=/robot", "-r", "~/own:=mine"]


def attempt(what, act):
    """Say whether a name is taken."""
    try:
        act()
        print(what, "taken")
    except INVALID:
        print(what, "refused")


def play():
    """Do all of it."""
    rclpy.init(args=ARGUMENTS)
    server, asker = rclpy.create_node("server"), rclpy.create_node("asker", namespace="robot")
    print(server.get_fully_qualified_name(), asker.get_fully_qualified_name())
    executor = SingleThreadedExecutor()
    executor.add_node(server)
    executor.add_node(asker)

    def flip(request, response):
        response.success = not request.data
        response.message = f"was {'true' if request.data else 'false'}"
        return response

    def trigger(request, response):
        response.success = True
        return response

    service = server.create_service(SetBool, "flip", flip)
    own = server.create_service(Trigger, "~/own", trigger)
    client = asker.create_client(SetBool, "flip")
    nobody = asker.create_client(Trigger, "nobody")
    print(service.service_name, own.service_name, client.service_name)
    print("nobody", nobody.wait_for_service(timeout_sec=0.1), nobody.service_is_ready())
    print("there", client.wait_for_service(timeout_sec=10.0), client.service_is_ready())
    for value in (True, False):
        future = client.call_async(SetBool.Request(data=value))
        executor.spin_until_future_complete(future)
        print(future.result().success, future.result().message)
    lost = nobody.call_async(Trigger.Request())
    executor.spin_until_future_complete(lost, timeout_sec=0.2)
    print("lost", lost.done())
    order = []
    futures = [client.call_async(SetBool.Request(data=bool(i % 2))) for i in range(4)]
    for i, future in enumerate(futures):
        future.add_done_callback(lambda future, i=i: order.append((i, future.result().success)))
    while len(order) < len(futures):
        executor.spin_once(timeout_sec=0.05)
    print(*(f"{i}:{success}" for i, success in order))
    names = [(n, *t) for n, t in asker.get_service_names_and_types() if "parameter" not in n]
    for name in sorted(name for name in names if name[0].startswith(("/robot/toggle", "/robot/m"))):
        print(*name)
    server.destroy_service(service)
    while client.service_is_ready():
        executor.spin_once(timeout_sec=0.05)
    print("gone", client.wait_for_service(timeout_sec=0.1))

    # Names
    publisher = asker.create_publisher(String, "chatter", 10)
    print(publisher.topic_name, asker.create_publisher(String, "/a/b", 10).topic_name)
    print(asker.create_publisher(String, "~/private", 10).topic_name)
    print(asker.resolve_topic_name("x/y"), asker.resolve_service_name("flip"))
    for name in ("a b", "1a", "a//b", "/a/", "~a", "", "{node}/x", "{nobody}/x", "a__b"):
        attempt(f"topic '{name}'", lambda name=name: asker.create_publisher(String, name, 10))
    for name in ("a b", "1a", "a-b", "", "_a"):
        attempt(f"node '{name}'", lambda name=name: rclpy.create_node(name).destroy_node())
    for space in ("/a b", "a", "/a/", "/1"):
        attempt(
            f"namespace '{space}'",
            lambda space=space: rclpy.create_node("n", namespace=space).destroy_node(),
        )
    rclpy.shutdown()
