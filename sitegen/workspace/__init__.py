"""Find and read the packages of a colcon workspace."""

from sitegen.workspace.dependencies import with_dependencies, with_plugins
from sitegen.workspace.folders import report_outside
from sitegen.workspace.packages import PYTHON, interfaces, scan
from sitegen.workspace.shipped import (
    CELLS,
    NOTEBOOK,
    SITEGEN,
    shipped_packages,
    sitegen_package,
    with_shipped,
)

__all__ = [
    "CELLS",
    "NOTEBOOK",
    "PYTHON",
    "SITEGEN",
    "interfaces",
    "report_outside",
    "scan",
    "shipped_packages",
    "sitegen_package",
    "with_dependencies",
    "with_plugins",
    "with_shipped",
]
