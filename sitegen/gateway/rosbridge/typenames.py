"""Accept the names of types as ROS 1 and rosbridge clients write them."""

from __future__ import annotations

from sitegen.gateway.native import UnknownTypeError

# Clients written for ROS 1 name types that ROS 2 has in another package.
RENAMED = {
    "roslib/Header": "std_msgs/msg/Header",
    "std_msgs/Time": "builtin_interfaces/msg/Time",
    "std_msgs/Duration": "builtin_interfaces/msg/Duration",
    "tf/tfMessage": "tf2_msgs/msg/TFMessage",
}


def full(name: object, kind: str) -> str:
    """Return the name of a type in ROS 2: "std_msgs/String" is "std_msgs/msg/String" for "msg".

    Raises: UnknownTypeError if it cannot be one.
    """
    if not isinstance(name, str) or len(name) > 256:
        raise UnknownTypeError("a type must be text, like 'std_msgs/msg/String'")
    if name in RENAMED and kind == "msg":
        return RENAMED[name]
    parts = name.split("/")
    if len(parts) == 2:
        return f"{parts[0]}/{kind}/{parts[1]}"
    # Clients of services of actions write "msg" for all three.
    if len(parts) == 3 and parts[1] in ("msg", "srv", "action") and all(parts):
        return name
    raise UnknownTypeError(f"'{name[:80]}' is not a valid type; write it like 'std_msgs/String'")
