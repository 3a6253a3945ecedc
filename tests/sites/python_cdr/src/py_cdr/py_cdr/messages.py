"""Read messages from a file of "type bytes" and write them again."""

import importlib
from importlib import resources

from rclpy.serialization import deserialize_message, serialize_message


def class_of(name):
    """Return the class of `pkg/msg/Name`, also for a part of a service."""
    package, kind, interface = name.split("/")
    module = importlib.import_module(f"{package}.{kind}")
    if hasattr(module, interface):
        return getattr(module, interface)
    service, _, part = interface.partition("_")
    return getattr(getattr(module, service), part)


def vectors():
    """Yield classes with the bytes of a message."""
    for line in resources.files("py_cdr").joinpath("vectors.txt").read_text().splitlines():
        name, data = line.split()
        yield class_of(name), bytes.fromhex(data)


def again():
    """Print what becomes of each message."""
    for kind, data in vectors():
        print(serialize_message(deserialize_message(data, kind)).hex())


def refuse():
    """Cut messages short, and set lengths to what they cannot be."""
    for kind, data in vectors():
        again = serialize_message(deserialize_message(data, kind))
        for end in range(4, min(len(again), 40)):
            wrong(kind, again[:end], len(again) - end)
    print("all refused")


def wrong(kind, data, missing):
    """Check that bytes are refused in the one way that callers expect."""
    try:
        deserialize_message(data, kind)
    except Exception as error:
        assert type(error).__name__ == "CdrError", repr(error)
    else:
        raise AssertionError(f"{kind} took a message without its last {missing} bytes")
