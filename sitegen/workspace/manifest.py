"""Read the package.xml of a package (REP 149)."""

from __future__ import annotations

import re
from collections.abc import Iterator
from dataclasses import dataclass
from pathlib import Path
from xml.etree import ElementTree
from xml.parsers.expat import ErrorString

from sitegen.errors import Location, Problems

NAME = re.compile(r"[A-Za-z][A-Za-z0-9_-]*")
DEPENDS = {
    "depend",
    "build_depend",
    "build_export_depend",
    "buildtool_depend",
    "buildtool_export_depend",
    "exec_depend",
    "run_depend",
}
# The variables of conditions. The packages of ROS 2 for pages are those of this distribution.
ENVIRONMENT = {"ROS_VERSION": "2", "ROS_DISTRO": "kilted", "ROS_PYTHON_VERSION": "3"}


@dataclass(frozen=True)
class Manifest:
    """A package.xml without tags whose conditions are false; texts may be empty.

    `tags` has the tag and the name of each dependency, `depends` the names of those that are not
    only for tests.
    """

    name: str
    version: str
    depends: tuple[str, ...]
    build_type: str
    description: str = ""
    tags: tuple[tuple[str, str], ...] = ()


class _Tree(ElementTree.TreeBuilder):
    """Refuses document types, whose entities can read files and fill the memory."""

    def doctype(self, name: str, pubid: str | None, system: str | None) -> None:
        raise ValueError("a document type declaration is not allowed; remove the line <!DOCTYPE …>")


def read_manifest(file: Path, problems: Problems) -> Manifest | None:
    """Return the manifest in `file`, or report why it cannot be read."""
    try:
        xml = ElementTree.fromstring(file.read_bytes(), ElementTree.XMLParser(target=_Tree()))
    except ElementTree.ParseError as error:
        message = f"{ErrorString(error.code)}; check the tags here and above"
        problems.add(Location(file, error.position[0]), "xml", message)
        return None
    except (OSError, ValueError, LookupError) as error:
        message = getattr(error, "strerror", None) or str(error)
        problems.add(location_of(file, "!DOCTYPE"), "xml", message)
        return None
    name = (xml.findtext("name") or "").strip()
    if xml.tag != "package" or not NAME.fullmatch(name):
        what = f"'{name}' is not a valid package name" if name else "missing"
        message = f"{what}; write it like <name>my_robot</name>"
        problems.add(location_of(file, "name"), "name", message)
        return None
    tags = [(tag.tag, (tag.text or "").strip()) for tag in _true(xml, file, problems)]
    description = xml.find("description")
    types = (tag.text for tag in _true(xml.findall("export/build_type"), file, problems))
    return Manifest(
        name=name,
        version=(xml.findtext("version") or "").strip(),
        depends=tuple(text for tag, text in tags if tag in DEPENDS and text),
        build_type=next((text.strip() for text in types if text), ""),
        description=" ".join("".join(description.itertext()).split())
        if description is not None
        else "",
        tags=tuple((tag, text) for tag, text in tags if tag in (*DEPENDS, "test_depend") and text),
    )


def location_of(file: Path, tag: str) -> Location:
    """Return the location of the first tag with this name; the parser does not record it."""
    try:
        before, found, _ = file.read_text(encoding="utf-8-sig", errors="replace").partition(
            f"<{tag}"
        )
    except OSError:
        return Location(file, 1)
    return Location(file, before.count("\n") + 1 if found else 1)


def _true(
    tags: ElementTree.Element | list[ElementTree.Element], file: Path, problems: Problems
) -> Iterator[ElementTree.Element]:
    """Yield the tags whose condition is true."""
    for tag in tags:
        condition = tag.get("condition")
        if condition is None:
            yield tag
            continue
        # Most packages have no condition, and the parser of conditions takes a while to import.
        from catkin_pkg.condition import evaluate_condition

        try:
            if evaluate_condition(condition, ENVIRONMENT):
                yield tag
        except ValueError:
            message = f"'{condition}' is not a valid condition; write it like '$ROS_VERSION == 2'"
            problems.add(location_of(file, tag.tag), tag.tag, message)
