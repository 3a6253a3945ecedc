"""Names of endpoints that tell nothing of a program."""

from __future__ import annotations

_TOPICS = {"/clock", "/parameter_events", "/rosout", "/diagnostics", "/tf", "/tf_static"}
_SERVICES = {
    *("describe_parameters", "get_parameter_types", "get_parameters", "get_type_description"),
    *("list_parameters", "set_parameters", "set_parameters_atomically"),
}


def is_common(name: str) -> bool:
    """Return whether every node or the tools of ROS have endpoints of this name."""
    hidden = any(part.startswith("_") for part in name.split("/"))
    return hidden or name in _TOPICS or name.rpartition("/")[2] in _SERVICES
