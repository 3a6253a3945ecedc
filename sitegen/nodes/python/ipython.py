"""Pack IPython for pages, from the packages that `pip install 'ros-sitegen[jupyter]'` installs."""

from __future__ import annotations

import io
import zipfile
from collections.abc import Iterator
from functools import cache
from importlib import metadata
from pathlib import Path

from packaging.requirements import Requirement
from packaging.utils import canonicalize_name

from sitegen.errors import SiteError
from sitegen.nodes.python import pyodide
from sitegen.nodes.python.wheel import archived

PATH = "nodes/ipython.zip"
KERNEL = "jupyterlite-pyodide-kernel"
# Jupyter's kernel for the browser comes as a wheel inside that package.
WHEEL = "pyodide_kernel-*-py3-none-any.whl"
PACKAGES = ("ipython", "jedi", "comm")
# Tests, and descriptions of packages that no page has.
EXTRAS = ("tests/", "test/", "third_party/django-stubs", "typeshed/stubs", "conftest.py")
SUFFIXES = {".py", ".pyi", ".txt", ".json", ".css", ".toml"}
MISSING = (
    "notebooks need JupyterLite: pip install 'ros-sitegen[jupyter]', or in a checkout "
    "pip install --editable '.[jupyter]'"
)


@cache
def archive() -> bytes:
    """Return an archive with IPython, what it needs in a page, and Jupyter's kernel for browsers.

    Raises: SiteError if these packages are not installed.
    """
    try:
        files = dict(_kernel())
        for name in sorted(_needed()):
            files |= dict(installed(name))
    except metadata.PackageNotFoundError:
        raise SiteError([MISSING]) from None
    return archived(files)


def _needed() -> set[str]:
    """Return the packages to pack: PACKAGES and what these need in a page."""
    found: set[str] = set()
    left = list(PACKAGES)
    while left:
        name = left.pop()
        if name in found:
            continue
        found.add(name)
        for text in metadata.requires(name) or ():
            need = Requirement(text)
            if need.marker is None or need.marker.evaluate(pyodide.environment()):
                left.append(canonicalize_name(need.name))
    return found


def installed(name: str) -> Iterator[tuple[str, bytes]]:
    """Yield the files of an installed package that is written in Python, by path."""
    for file in metadata.files(name) or ():
        parts = file.parts
        # Entry points and versions are read by some packages.
        wanted = file.suffix in SUFFIXES or parts[-1] in (
            "METADATA",
            "entry_points.txt",
            "py.typed",
        )
        inside = "/".join(parts)
        if wanted and parts[0] != ".." and not any(f"/{extra}" in inside for extra in EXTRAS):
            yield f"python/{inside}", Path(str(file.locate())).read_bytes()


def _kernel() -> Iterator[tuple[str, bytes]]:
    """Yield the files of Jupyter's kernel for browsers, by path."""
    wheels = [one for one in metadata.files(KERNEL) or () if one.match(f"*/static/pypi/{WHEEL}")]
    if not wheels:
        raise metadata.PackageNotFoundError(KERNEL)
    data = Path(str(wheels[0].locate())).read_bytes()
    with zipfile.ZipFile(io.BytesIO(data)) as content:
        for name in content.namelist():
            if not name.endswith("/"):
                yield f"python/{name}", content.read(name)
