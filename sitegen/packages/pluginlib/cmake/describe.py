"""Turn a plugin description into sources that register it: `describe.py file package category out`.

For each library in the file, it writes `<category>.<library>.cpp` to the folder `out`. It prints
the names of the libraries as a list of CMake.
"""

from __future__ import annotations

import json
import sys
from pathlib import Path, PurePosixPath
from xml.etree import ElementTree

REGISTRATION = """\
// generated from {file} by sitegen
#include "pluginlib/detail/descriptions.hpp"

namespace
{{
const pluginlib::detail::Registration registration({{
{entries}
}});
}}  // namespace
"""


def describe(file: Path, package: str, category: str, out: Path) -> list[str]:
    """Write the sources and return the names of the libraries."""
    root = ElementTree.parse(file).getroot()
    libraries = [root] if root.tag == "library" else list(root.iterfind("library"))
    if not libraries:
        raise ValueError("no <library> here")
    out.mkdir(parents=True, exist_ok=True)
    entries: dict[str, list[str]] = {}  # a file may name a library several times
    for library in libraries:
        path = PurePosixPath(library.get("path") or "").name
        name = path.removeprefix("lib").partition(".")[0]
        if not name:
            raise ValueError("a <library> without a path")
        found = (_entry(tag, file, package, category, name) for tag in library.iterfind("class"))
        entries.setdefault(name, []).extend(found)
    for name, lines in entries.items():
        text = REGISTRATION.format(file=file.name, entries="\n".join(lines))
        target = out / f"{category}.{name}.cpp"
        if not target.exists() or target.read_text() != text:  # else all would be compiled again
            target.write_text(text)
    return [*entries]


def _entry(tag: ElementTree.Element, file: Path, package: str, category: str, library: str) -> str:
    kind, base = tag.get("type"), tag.get("base_class_type")
    if not kind or not base:
        raise ValueError("a <class> needs its type and its base_class_type")
    description = " ".join((tag.findtext("description") or "").split())
    name = tag.get("name") or kind
    manifest = f"/ros/share/{package}/{file.name}"
    values = (category, name, kind, base, package, description, library, manifest)
    return "  {" + ", ".join(json.dumps(value, ensure_ascii=False) for value in values) + "},"


if __name__ == "__main__":
    source = Path(sys.argv[1])
    try:
        print(";".join(describe(source, sys.argv[2], sys.argv[3], Path(sys.argv[4]))), end="")
    except (OSError, ValueError, ElementTree.ParseError) as error:
        sys.exit(f"sitegen: {source}: {error}")
