"""Find and read the packages of a colcon workspace."""

from sitegen.workspace.dependencies import with_dependencies, with_plugins
from sitegen.workspace.folders import report_outside
from sitegen.workspace.packages import PYTHON, interfaces, scan, unknown_interface
from sitegen.workspace.shipped import (
    CELLS,
    NOTEBOOK,
    SITEGEN,
    replaced,
    shipped_packages,
    sitegen_package,
    with_replaced,
    with_shipped,
)

__all__ = [
    "CELLS",
    "NOTEBOOK",
    "PYTHON",
    "SITEGEN",
    "interfaces",
    "replaced",
    "report_outside",
    "scan",
    "shipped_packages",
    "sitegen_package",
    "unknown_interface",
    "with_dependencies",
    "with_plugins",
    "with_replaced",
    "with_shipped",
]
