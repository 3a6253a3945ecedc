"""What is left of a node whose context is over, as after a signal: it says so, or works on."""

import rclpy
from rclpy.action import ActionClient, ActionServer
from rclpy.duration import Duration
from rclpy.executors import SingleThreadedExecutor
from rclpy.lifecycle import LifecycleNode
from rclpy.parameter import Parameter
from rclpy.task import Future
from std_msgs.msg import String
from std_srvs.srv import Empty
from test_msgs.action import Fibonacci


def attempt(what, function):
    """Print what comes of it; where rcl adds the line of its source, that is left out."""
    try:
        found = function()
    except Exception as error:
        kind = f"{type(error).__module__}.{type(error).__name__}"
        print(what, "raises", kind, str(error).partition(", at /")[0])
        return
    simple = isinstance(found, (bool, int, str, type(None)))
    print(what, "gives", found if simple else type(found).__name__)


def main():
    """End the context below what uses it, and use that."""
    rclpy.init()
    node = rclpy.create_node("outlived")
    managed = LifecycleNode("managed")
    executor = SingleThreadedExecutor()
    executor.add_node(node)
    publisher = node.create_publisher(String, "words", 10)
    subscription = node.create_subscription(String, "words", print, 10)
    client = node.create_client(Empty, "empty")
    service = node.create_service(Empty, "empty", lambda _, response: response)
    timer = node.create_timer(100.0, lambda: None)
    guard = node.create_guard_condition(lambda: None)
    goals = ActionClient(node, Fibonacci, "count")
    ActionServer(node, Fibonacci, "count", lambda _: Fibonacci.Result())
    node.declare_parameter("speed", 1)
    with node.context.handle:
        node.context.handle.shutdown()
    print(rclpy.ok(), node.context.ok())

    attempt("publish", lambda: publisher.publish(String(data="late")))
    attempt("publish bytes", lambda: publisher.publish(b"\0\1\0\0\1\0\0\0\0"))
    attempt("publish a number", lambda: publisher.publish(3))
    attempt("subscription count", publisher.get_subscription_count)
    attempt("assert liveliness", publisher.assert_liveliness)
    attempt("acknowledged", lambda: publisher.wait_for_all_acked(Duration(seconds=0.1)))
    attempt("topic", lambda: publisher.topic_name)
    attempt("topic of subscription", lambda: subscription.topic_name)
    attempt("logger", lambda: subscription.logger_name)
    attempt("call", lambda: client.call_async(Empty.Request()))
    attempt("service is ready", client.service_is_ready)
    attempt("wait for service", lambda: client.wait_for_service(0.1))
    attempt("service name", lambda: service.service_name)
    attempt("cancel", timer.cancel)
    attempt("reset", timer.reset)
    attempt("is ready", timer.is_ready)
    attempt("trigger", guard.trigger)

    attempt("create publisher", lambda: node.create_publisher(String, "more", 10))
    attempt("create subscription", lambda: node.create_subscription(String, "more", print, 10))
    attempt("create client", lambda: node.create_client(Empty, "more"))
    attempt("create service", lambda: node.create_service(Empty, "more", print))
    attempt("create timer", lambda: node.create_timer(1.0, print))
    attempt("create guard condition", lambda: node.create_guard_condition(print))
    attempt("create rate", lambda: node.create_rate(10))
    attempt("create node", lambda: rclpy.create_node("more"))
    attempt("create action server", lambda: ActionServer(node, Fibonacci, "more", print))
    attempt("action server is ready", goals.server_is_ready)
    attempt("send goal", lambda: goals.send_goal_async(Fibonacci.Goal()))

    attempt("log", lambda: node.get_logger().info("late"))
    attempt("declare", lambda: node.declare_parameter("turn", 1))
    attempt("set", lambda: node.set_parameters([Parameter("speed", value=2)]))
    attempt("get", lambda: node.get_parameter("speed").value)
    attempt("names", node.get_node_names)
    attempt("topics", node.get_topic_names_and_types)
    attempt("services", node.get_service_names_and_types)
    attempt("publishers", lambda: node.count_publishers("words"))
    attempt("subscribers", lambda: node.count_subscribers("words"))
    attempt("clients", lambda: node.count_clients("empty"))
    attempt("servers", lambda: node.count_services("empty"))
    of = ("outlived", "/")
    attempt("its publishers", lambda: node.get_publisher_names_and_types_by_node(*of))
    attempt("its subscribers", lambda: node.get_subscriber_names_and_types_by_node(*of))
    attempt("its services", lambda: node.get_service_names_and_types_by_node(*of))
    attempt("its clients", lambda: node.get_client_names_and_types_by_node(*of))
    attempt("about publishers", lambda: node.get_publishers_info_by_topic("words"))
    attempt("about subscriptions", lambda: node.get_subscriptions_info_by_topic("words"))
    attempt("resolve", lambda: node.resolve_topic_name("words"))
    attempt("wait for node", lambda: node.wait_for_node("/outlived", 0.1))

    attempt("spin", executor.spin)
    attempt("spin once", lambda: executor.spin_once(0.1))
    attempt("spin until", lambda: executor.spin_until_future_complete(Future(), 0.1))
    attempt("configure", lambda: str(managed.trigger_configure()))
    attempt("try shutdown", rclpy.try_shutdown)
    attempt("domain", node.context.get_domain_id)
    attempt("destroy", node.destroy_node)
    attempt("publish", lambda: publisher.publish(String(data="late")))
    attempt("shutdown", rclpy.shutdown)
