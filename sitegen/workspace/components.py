"""Find the source files of components, which CMakeLists.txt names by their classes."""

from __future__ import annotations

import re
from collections.abc import Mapping
from pathlib import Path

REGISTERS = re.compile(r"\bRCLCPP_COMPONENTS_REGISTER_NODE\s*\(\s*(?:::)?([\w:]+)\s*\)")
SOURCES = (".cpp", ".cc", ".cxx")


def sources(folder: Path, plugins: Mapping[str, str]) -> dict[str, list[str]]:
    """Return the source file of each executable, by the class of its component.

    It is the file that registers the class; a class that no file of `folder` registers is left out.
    """
    if not plugins:
        return {}
    found: dict[str, str] = {}
    for file in sorted(folder.rglob("*")):
        if file.suffix in SOURCES and file.is_file():
            text = file.read_text(encoding="utf-8-sig", errors="replace")
            name = file.relative_to(folder).as_posix()
            for plugin in REGISTERS.findall(text):
                found.setdefault(plugin, name)
    return {name: [found[plugin]] for name, plugin in plugins.items() if plugin in found}
