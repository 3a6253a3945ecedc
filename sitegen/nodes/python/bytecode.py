"""Add bytecode to the Python modules that pages load.

It was compiled when sitegen was built, by the Python of pages (hatch_build.py runs it in Node.js).
Builds of sites run with any Python.
"""

from __future__ import annotations

import functools
import hashlib
import re
import zipfile
from collections.abc import Iterator, Mapping

from sitegen.shipped import CLIENTS, ROS

CLIENT = CLIENTS / "python"
# The module that reads parameters, at build time and in pages.
RCL_YAML = CLIENTS.parent / "rclyaml.py"
PAGE = ROS / "page"
# By a digest of the module and its path: a module that has changed has no bytecode.
STORE = ROS / "bytecode.zip"
# The modules of the generators that pages need, too: of the parser, only the types of slots.
SHARED = (
    *("rosidl_parser/__init__.py", "rosidl_parser/definition.py", "rpyutils/__init__.py"),
    *("rpyutils/add_dll_directories.py", "rpyutils/import_c_library.py"),
)
# The suffix of bytecode files of the Python in pages, which is 3.14.
TAG = "cpython-314"
# Generated classes use numpy for their fixed-size arrays of numbers.
NUMPY = re.compile(rb"^import numpy\b", re.MULTILINE)
OUR_NUMPY = b"from rclpy_backend.arrays import numpy"
GENERATED = re.compile(r"python/(?!rclpy/)\w+/(msg|srv|action)/\w+\.py")


def brought() -> Iterator[tuple[str, bytes]]:
    """Yield the Python modules for pages that come with sitegen, with messages, by path."""
    for file in sorted(PAGE.rglob("*")):
        if file.is_file():
            yield f"python/{file.relative_to(PAGE).as_posix()}", with_our_numpy(file.read_bytes())
    for name in SHARED:
        yield f"python/{name}", (ROS / "python" / name).read_bytes()
    for file in sorted(CLIENT.rglob("*.py")):
        name = file.relative_to(CLIENT).as_posix()
        name = f"rclpy/{name}" if name == "_rclpy_pybind11.py" else name
        yield f"python/{name}", file.read_bytes()
    yield f"python/sitegen/{RCL_YAML.name}", RCL_YAML.read_bytes()


def modules() -> list[str]:
    """Return the names of these modules, without the modules nested in them."""
    return (
        ["sitegen"]
        + [file.name for folder in (PAGE, CLIENT) for file in folder.iterdir()]
        + [name.split("/")[0] for name in SHARED]
    )


def with_our_numpy(module: bytes) -> bytes:
    """Let a generated module import numpy only if the site has it."""
    return NUMPY.sub(OUR_NUMPY, module)


def key(path: str, module: bytes) -> str:
    """Return the name of a module's bytecode in STORE."""
    return hashlib.sha256(path.encode() + b"\0" + module).hexdigest()[:32]


def added(files: Mapping[str, bytes]) -> dict[str, bytes]:
    """Return `files` with bytecode added to the modules that have some.

    For generated classes, whose lines do not appear in tracebacks, it replaces the source.
    """
    found = {}
    known = _known()
    for path, content in files.items():
        code = known.get(key(path, content)) if path.endswith(".py") else None
        if code is None or not GENERATED.fullmatch(path):
            found[path] = content
        if code is not None and GENERATED.fullmatch(path):
            found[f"{path}c"] = code
        elif code is not None:
            folder, _, name = path.rpartition("/")
            found[f"{folder}/__pycache__/{name.removesuffix('py')}{TAG}.pyc"] = code
    return found


@functools.cache
def _known() -> dict[str, bytes]:
    with zipfile.ZipFile(STORE) as archive:
        return {name: archive.read(name) for name in archive.namelist()}
