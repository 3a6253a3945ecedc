"""The folders that tools write to, which are not part of a workspace or a site."""

from __future__ import annotations

# At any depth.
TOOLS = frozenset(
    {".git", ".mypy_cache", ".pytest_cache", ".ruff_cache", "__pycache__", "node_modules"}
)
# At the root of a workspace or a site: the three folders of colcon, and the output of sitegen.
# Deeper in the tree, such a folder belongs to the author: `log` is a good name for a folder of
# sources.
AT_ROOT = frozenset({"build", "dist", "install", "log"})


def is_ignored(name: str, *, at_root: bool) -> bool:
    """Return whether a folder called `name` is filled by a tool.

    `at_root` says that it is at the root of a workspace or a site.
    """
    return name in TOOLS or (at_root and name in AT_ROOT)
