"""Read a robot description for a page."""

from __future__ import annotations

from collections.abc import Mapping
from pathlib import Path

from sitegen.launch.shares import by_package, on_page, shares
from sitegen.launch.xacro import description
from sitegen.model import Package


def published_description(file: Path, packages: Mapping[str, Package]) -> str:
    """Return the URDF in a file, or what xacro makes of it, with the paths that the page has.

    Raises: ValueError if it cannot be read.
    """
    with shares(packages) as folders:
        try:
            return on_page(description(file, folders), folders)
        except ValueError as error:
            raise ValueError(by_package(str(error))) from None
