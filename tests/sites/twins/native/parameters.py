"""Parameters: overridden, in a range, refused, watched, taken back, and asked for by others."""

import rclpy
from rcl_interfaces.msg import (
    FloatingPointRange,
    IntegerRange,
    ParameterDescriptor,
    ParameterEvent,
    SetParametersResult,
)
from rcl_interfaces.srv import DescribeParameters, GetParameters, ListParameters, SetParameters
from rclpy.exceptions import (
    InvalidParameterTypeException,
    InvalidParameterValueException,
    ParameterAlreadyDeclaredException,
    ParameterImmutableException,
    ParameterNotDeclaredException,
)
from rclpy.parameter import Parameter

FAULTS = {
    InvalidParameterTypeException: "wrong type",
    InvalidParameterValueException: "wrong value",
    ParameterAlreadyDeclaredException: "declared already",
    ParameterImmutableException: "immutable",
    ParameterNotDeclaredException: "not declared",
}
ARGUMENTS = ["--ros-args", "-p", "rate:=2.5", "-p", "names:=[a, b]", "-p", "word:=7"]
OWN = ("rate", "names", "fixed", "even", "arm.", "loose")


def attempt(what, act):
    """Say what comes of an act."""
    try:
        act()
        print(what, "done")
    except tuple(FAULTS) as error:
        print(what, FAULTS[type(error)])


def play():
    """Do all of it."""
    rclpy.init(args=ARGUMENTS)
    node, other = rclpy.create_node("configured"), rclpy.create_node("other")
    events = []
    other.create_subscription(ParameterEvent, "/parameter_events", events.append, 100)
    while not other.count_publishers("/parameter_events"):
        rclpy.spin_once(other, timeout_sec=0.1)

    # Declared
    even = ParameterDescriptor(
        description="an even number",
        integer_range=[IntegerRange(from_value=0, to_value=10, step=2)],
    )
    length = ParameterDescriptor(
        floating_point_range=[FloatingPointRange(from_value=0.5, to_value=1.5)]
    )
    node.declare_parameter("rate", 1.0)
    node.declare_parameter("names", ["x"])
    node.declare_parameter("fixed", 1, ParameterDescriptor(read_only=True))
    node.declare_parameter("even", 4, even)
    node.declare_parameter("arm.length", 1.0, length)
    node.declare_parameter("arm.joints", [1, 2, 3])
    node.declare_parameter("loose", True, ParameterDescriptor(dynamic_typing=True))
    attempt("again", lambda: node.declare_parameter("rate", 1.0))
    attempt("word", lambda: node.declare_parameter("word", "text"))
    attempt("odd", lambda: node.declare_parameter("odd", 3, even))
    attempt("nothing", lambda: node.get_parameter("nothing"))
    print("rate", f"{node.get_parameter('rate').value:.2f}", *node.get_parameter("names").value)
    print("or", node.get_parameter_or("nobody", Parameter("nobody", value=5)).value)
    print("prefix", *sorted(node.get_parameters_by_prefix("arm")))

    # Set
    def before(parameters):
        print("before", *(p.name for p in parameters))
        return parameters

    def check(parameters):
        small = all(p.name != "rate" or p.value < 10 for p in parameters)
        print("check", *(p.name for p in parameters))
        return SetParametersResult(successful=small, reason="" if small else "too fast")

    def after(parameters):
        print("after", *(p.name for p in parameters))

    node.add_pre_set_parameters_callback(before)
    node.add_on_set_parameters_callback(check)
    node.add_post_set_parameters_callback(after)
    for name, value in (
        *(("rate", 3.0), ("rate", 30.0), ("rate", "fast"), ("fixed", 2), ("even", 6), ("even", 7)),
        *(("even", 12), ("arm.length", 0.25), ("arm.length", 1.25), ("loose", 3), ("loose", "x")),
    ):
        [result] = node.set_parameters([Parameter(name, value=value)])
        print(name, result.successful, result.reason if result.reason == "too fast" else "")
    attempt("nothing", lambda: node.set_parameters([Parameter("nothing", value=1)]))
    both = [Parameter("even", value=8), Parameter("rate", value=99.0)]
    print("together", node.set_parameters_atomically(both).successful)
    print("even", node.get_parameter("even").value)
    both = [Parameter("even", value=8), Parameter("rate", value=9.0)]
    print("together", node.set_parameters_atomically(both).successful)
    node.remove_on_set_parameters_callback(check)
    node.remove_pre_set_parameters_callback(before)
    node.remove_post_set_parameters_callback(after)
    print("fast", node.set_parameters([Parameter("rate", value=50.0)])[0].successful)

    # Taken back
    attempt("undeclare loose", lambda: node.undeclare_parameter("loose"))
    attempt("undeclare loose", lambda: node.undeclare_parameter("loose"))
    attempt("undeclare fixed", lambda: node.undeclare_parameter("fixed"))
    print("has", node.has_parameter("loose"), node.has_parameter("fixed"))

    # Asked for
    def ask(kind, name, request):
        client = other.create_client(kind, f"configured/{name}")
        client.wait_for_service()
        future = client.call_async(request)
        executor = rclpy.executors.SingleThreadedExecutor()
        executor.add_node(node)
        executor.add_node(other)
        executor.spin_until_future_complete(future)
        executor.shutdown()
        return future.result()

    for prefixes, depth in (([], 0), ([], 1), (["arm"], 0), (["arm"], 1), (["arm.length"], 0)):
        listed = ask(
            ListParameters,
            "list_parameters",
            ListParameters.Request(prefixes=prefixes, depth=depth),
        ).result
        print("list", *sorted(n for n in listed.names if n.startswith(OWN)), *listed.prefixes)
    values = ask(
        GetParameters, "get_parameters", GetParameters.Request(names=["even", "nothing"])
    ).values
    print("get", len(values))
    described = ask(
        DescribeParameters, "describe_parameters", DescribeParameters.Request(names=["even"])
    ).descriptors
    for each in described:
        steps = each.integer_range[0]
        print(each.name, each.type, each.description, each.read_only, steps.to_value, steps.step)
    wanted = [
        Parameter("even", value=2).to_parameter_msg(),
        Parameter("even", value=3).to_parameter_msg(),
        Parameter("fixed", value=3).to_parameter_msg(),
        Parameter("nothing", value=3).to_parameter_msg(),
    ]
    results = ask(SetParameters, "set_parameters", SetParameters.Request(parameters=wanted)).results
    print("set", *(each.successful for each in results))

    # Told
    while not any(
        p.name == "even" and p.value.integer_value == 2
        for e in events
        for p in e.changed_parameters
    ):
        rclpy.spin_once(other, timeout_sec=0.1)
    for event in events:
        if event.node != "/configured":
            continue
        for what, parameters in (
            ("new", event.new_parameters),
            ("changed", event.changed_parameters),
            ("deleted", event.deleted_parameters),
        ):
            names = [p.name for p in parameters if p.name.startswith(OWN)]
            if names:
                print("event", what, *names)
    rclpy.shutdown()
