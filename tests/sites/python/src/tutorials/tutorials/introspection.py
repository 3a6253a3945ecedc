"""Services and actions that tell what they are asked."""

import rclpy
from rclpy.action import ActionClient, ActionServer
from rclpy.executors import SingleThreadedExecutor
from rclpy.qos import qos_profile_system_default
from rclpy.service_introspection import ServiceIntrospectionState
from test_msgs.action import Fibonacci
from test_msgs.srv import BasicTypes

STATES = [
    ServiceIntrospectionState.METADATA,
    ServiceIntrospectionState.CONTENTS,
    ServiceIntrospectionState.OFF,
]


def answer(request, response):
    """Answer with what was asked."""
    response.string_value = request.string_value.upper()
    return response


def execute(goal):
    """End at once."""
    goal.succeed()
    return Fibonacci.Result(sequence=[1, 2, 3])


def told(event):
    """Return what is the same wherever it runs."""
    return (
        event.info.event_type,
        event.info.sequence_number > 0,
        event.info.stamp.sec > 0,
        len(set(event.info.client_gid)) > 1,
        [request.string_value for request in event.request],
        [response.string_value for response in event.response],
    )


def introspect_service(node, executor):
    """Call a service in each state."""
    events, gids = [], set()

    def hear(event):
        events.append(told(event))
        gids.add(bytes(list(event.info.client_gid)))

    node.create_subscription(BasicTypes.Event, "/shout/_service_event", hear, 10)
    service = node.create_service(BasicTypes, "shout", answer)
    client = node.create_client(BasicTypes, "shout")
    client.wait_for_service()
    for state in STATES:
        for side in (service, client):
            side.configure_introspection(node.get_clock(), qos_profile_system_default, state)
        wanted = 0 if state == ServiceIntrospectionState.OFF else 4
        publishers = 2 if wanted else 0
        while node.count_publishers("/shout/_service_event") != publishers:
            executor.spin_once(0.05)
        while wanted and service_topic_matched(node) < publishers:
            executor.spin_once(0.05)
        events.clear()
        request = BasicTypes.Request(string_value="hello")
        future = client.call_async(request)
        executor.spin_until_future_complete(future, 20.0)
        for _ in range(100):
            if len(events) >= wanted:
                break
            executor.spin_once(0.05)
        print(state.name, future.result().string_value)
        for event in sorted(events):
            print("  ", event)
    print(len(gids), "client")


def service_topic_matched(node):
    """Return how many publishers the subscription has found."""
    return len(node.get_publishers_info_by_topic("/shout/_service_event"))


def introspect_action(node, executor):
    """Let an action tell of its goal service."""
    events = []
    server = ActionServer(node, Fibonacci, "count", execute)
    client = ActionClient(node, Fibonacci, "count")
    client.wait_for_server()
    server.configure_introspection(
        node.get_clock(), qos_profile_system_default, ServiceIntrospectionState.CONTENTS
    )
    topics = dict(node.get_topic_names_and_types())
    for name in ("send_goal", "cancel_goal", "get_result"):
        topic = f"/count/_action/{name}/_service_event"
        while topic not in topics:
            executor.spin_once(0.05)
            topics = dict(node.get_topic_names_and_types())
        print(topic, topics[topic])
    node.create_subscription(
        Fibonacci.Impl.SendGoalService.Event,
        "/count/_action/send_goal/_service_event",
        lambda event: events.append(
            (event.info.event_type, [request.goal.order for request in event.request])
        ),
        10,
    )
    while node.count_subscribers("/count/_action/send_goal/_service_event") != 1:
        executor.spin_once(0.05)
    for _ in range(10):
        executor.spin_once(0.05)
    future = client.send_goal_async(Fibonacci.Goal(order=7))
    executor.spin_until_future_complete(future, 20.0)
    for _ in range(100):
        if len(events) >= 2:
            break
        executor.spin_once(0.05)
    print(sorted(events))


def main(args=None):
    """Run one after the other."""
    with rclpy.init(args=args):
        node = rclpy.create_node("introspected")
        executor = SingleThreadedExecutor()
        executor.add_node(node)
        introspect_service(node, executor)
        introspect_action(node, executor)
    print("done")
