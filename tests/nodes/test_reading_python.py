"""Bytes that are no messages, and what the reader of Python nodes makes of them."""

from __future__ import annotations

import subprocess
import sys
from pathlib import Path

from sitegen.nodes.python import bytecode

# Of these types there is everything: texts, bounds, nested and fixed arrays, sequences of each.
TYPES = [
    *("std_msgs.msg.String", "std_msgs.msg.UInt8MultiArray", "sensor_msgs.msg.PointCloud2"),
    *("geometry_msgs.msg.PoseWithCovarianceStamped", "diagnostic_msgs.msg.DiagnosticArray"),
    *("rcl_interfaces.msg.ParameterEvent", "rcl_interfaces.msg.ParameterDescriptor"),
    *("trajectory_msgs.msg.JointTrajectory", "type_description_interfaces.msg.TypeDescription"),
    *("shape_msgs.msg.SolidPrimitive", "test_msgs.msg.WStrings", "test_msgs.msg.BoundedSequences"),
]
# It prints how many were read and how many refused; anything but a CdrError ends it.
PROGRAM = """
import importlib, random, resource, sys
from rclpy_backend import cdr

# What eight kilobytes can hold fits into this many times over.
resource.setrlimit(resource.RLIMIT_AS, (1 << 30, 1 << 30))
chance = random.Random(int(sys.argv[1]))
found = []
for name in sys.argv[2:]:
    module, _, name = name.rpartition(".")
    kind = getattr(importlib.import_module(module), name)
    sound = cdr.serialize(kind(), kind)
    counts = [0, 0]
    for number in range(400):
        data = bytearray(sound if number % 2 else chance.randbytes(chance.randrange(8, 8192)))
        data[:4] = cdr.HEADER
        for _ in range(chance.randrange(4)):
            data[chance.randrange(4, len(data))] = chance.choice([0, 1, 4, 127, 255])
        if number % 3 == 0:
            del data[chance.randrange(4, len(data) + 1):]
        try:
            message = cdr.deserialize(bytes(data), kind)
        except cdr.CdrError as error:
            assert str(error)
            counts[1] += 1
        else:
            # What was read can be written, and is then the same.
            again = cdr.serialize(message, kind)
            assert repr(cdr.deserialize(again, kind)) == repr(message)
            counts[0] += 1
    found.append(counts)
print(found)
"""


def test_no_bytes_do_harm_to_a_python_node(tmp_path: Path) -> None:
    for place, module in bytecode.brought():
        if place.endswith(".py") and not place.startswith("python/rclpy/"):
            file = tmp_path / place
            file.parent.mkdir(parents=True, exist_ok=True)
            # Python 3.11, which tests may run with, has no such generic.
            file.write_bytes(module.replace(b"numbers.array[Any]", b"numbers.array"))
    done = subprocess.run(
        [sys.executable, "-c", PROGRAM, "20240607", *TYPES],
        env={"PYTHONPATH": str(tmp_path / "python")},
        capture_output=True,
        text=True,
        timeout=300,
    )
    assert done.returncode == 0, done.stderr[-3000:]
    counts = eval(done.stdout)
    assert len(counts) == len(TYPES)
    assert all(read and refused for read, refused in counts), counts
