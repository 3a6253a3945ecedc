"""What native rclpy makes of command lines: each line of the input is one, as a list in JSON.

For each, it prints the parameters of the node /q/n by name, or the reason why there is none.
"""

from __future__ import annotations

import json
import sys
from typing import Any

from rclpy.context import Context
from rclpy.node import Node
from rclpy.parameter import Parameter


def parameters(words: list[str]) -> dict[str, Any] | str:
    context = Context()
    try:
        context.init(["n", "--ros-args", *words])
        node = Node(
            *("n",),
            namespace="/q",
            context=context,
            start_parameter_services=False,
            enable_rosout=False,
        )
        found = dict(node._parameter_overrides)
        node.destroy_node()
    except Exception as error:
        return f"{type(error).__name__}: {error}"
    finally:
        context.try_shutdown()
    return {name: value(one) for name, one in found.items()}


def value(parameter: Parameter[Any]) -> Any:
    array = isinstance(parameter.value, (list, tuple)) or hasattr(parameter.value, "typecode")
    return list(parameter.value) if array else parameter.value


for line in sys.stdin:
    print(json.dumps(parameters(json.loads(line))))
