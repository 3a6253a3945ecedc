"""Turn a Source into highlighted code: a file of a node, or a part of any file of the site."""

from __future__ import annotations

import re
from pathlib import Path

from sitegen.errors import Problems, nearest, relative
from sitegen.model import Package, Site, Source
from sitegen.site.prose import code, language_of

# The comments with which editors fold regions; they are not shown.
_BEGIN = re.compile(r"^\s*(?://|#|<!--|--)\s*#?region\s+(?P<name>\S+)")
_END = re.compile(r"^\s*(?://|#|<!--|--)\s*#?endregion\b")
_LARGEST = 500_000


def shown(source: Source, site: Site, problems: Problems) -> str:
    """Return the HTML of a source; nothing if it is wrong, which is reported."""
    file = _file(source, site, problems)
    if file is None:
        return ""
    try:
        lines = (
            file.read_text(encoding="utf-8-sig")
            .replace("\r\n", "\n")
            .removesuffix("\n")
            .split("\n")
        )
    except (OSError, UnicodeDecodeError):
        problems.add(
            source.location, "source", f"'{file.name}' is not a UTF-8 text file; choose another"
        )
        return ""
    if file.stat().st_size > _LARGEST:
        problems.add(
            source.location, "source", f"'{file.name}' is too large to show; choose another"
        )
        return ""
    first, last = _range(source, lines, file.name, problems)
    marks = (_BEGIN, _END)
    rows = [
        (number, line)
        for number, line in enumerate(lines[first - 1 : last], start=first)
        if not any(mark.match(line) for mark in marks)
    ]
    text = "\n".join(line for _, line in rows)
    numbers = tuple(number for number, _ in rows)
    package = _package(source, site)
    title = relative(file, package.path) if package else file.name
    return code(text, language_of(file.name), title=title, numbers=numbers)


def _file(source: Source, site: Site, problems: Problems) -> Path | None:
    root, package = site.root.resolve(), _package(source, site)
    folder, known = source.folder, tuple[str, ...]()
    if package and source.node:
        folder, known = package.path, package.sources.get(source.node.executable, ())
    name = source.file or next(iter(known), "")
    if not name:
        message = f"the source of '{source.target}' is unknown; give the 'file'"
        problems.add(source.location, "source", message)
        return None
    file = (folder / name).resolve()
    if not file.is_file() and not source.file:
        # A CMakeLists.txt in a subfolder names files relative to that folder.
        file = next(iter(sorted(folder.rglob(Path(name).name))), file).resolve()
    if not file.is_relative_to(root):
        message = (
            f"'{name}' is outside the site's folder; keep all files below the folder of site.yaml"
        )
        problems.add(source.location, "source", message)
        return None
    if not file.is_file():
        beside = sorted(folder.rglob(f"*{file.suffix}")) if file.suffix else []
        hint = nearest(name, (relative(other, folder) for other in beside[:200]))
        problems.add(source.location, "source", f"no file '{name}' in {folder.name}; {hint}")
        return None
    return file


def _package(source: Source, site: Site) -> Package | None:
    """Return the package of the node; a program compiled elsewhere has none."""
    return site.packages.get(source.node.package) if source.node else None


def _range(source: Source, lines: list[str], name: str, problems: Problems) -> tuple[int, int]:
    """Return the first and the last line to show, counted from 1."""
    if source.lines:
        first, last = source.lines
        if not first <= last <= len(lines):
            message = f"'{first}-{last}' is not a valid range of lines: {name} has {len(lines)}"
            problems.add(
                source.location, "source.lines", f"{message}; write 'lines: {1}-{len(lines)}'"
            )
        return first, last
    if source.region:
        names = []
        for number, line in enumerate(lines, start=1):
            if begin := _BEGIN.match(line):
                names.append(begin["name"])
                if begin["name"] == source.region:
                    ends = (n for n, text in enumerate(lines, 1) if n > number and _END.match(text))
                    return number + 1, next(ends, len(lines) + 1) - 1
        message = f"no region '{source.region}' in {name}; {nearest(source.region, names)}"
        problems.add(source.location, "source.region", message)
    return 1, len(lines)
