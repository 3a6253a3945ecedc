"""Read an XML launch file."""

from __future__ import annotations

from pathlib import Path
from typing import Any
from xml.parsers import expat

from sitegen.errors import Location
from sitegen.launch.tree import Action, UnreadableError

# Far deeper than any launch file.
DEEPEST = 100


def read(file: Path) -> list[Action]:
    """Return the actions of a launch file.

    Raises: UnreadableError if the file is not valid.
    """
    top = Action("", {}, Location(file, 1))
    open_ = [top]
    parser = expat.ParserCreate()

    def start(name: str, attributes: dict[str, str]) -> None:
        location = Location(file, parser.CurrentLineNumber)
        # The only names that differ between XML and YAML.
        kind = name.replace("-", "_")
        action = Action(kind, {k.replace("-", "_"): v for k, v in attributes.items()}, location)
        if len(open_) > DEEPEST:
            raise UnreadableError(location, "nested too deeply")
        open_[-1].inside.append(action)
        open_.append(action)

    def doctype(*_: Any) -> None:
        location = Location(file, parser.CurrentLineNumber)
        raise UnreadableError(
            location, "a document type declaration is not allowed; remove <!DOCTYPE …>"
        )

    parser.StartElementHandler = start
    parser.EndElementHandler = lambda _: open_.pop()
    parser.StartDoctypeDeclHandler = doctype
    try:
        parser.Parse(file.read_bytes(), True)
    except expat.ExpatError as error:
        message = f"{expat.ErrorString(error.code)}; check the tags here and above"
        raise UnreadableError(Location(file, error.lineno), message) from None
    except (LookupError, ValueError) as error:  # an encoding that Python does not know
        raise UnreadableError(Location(file, 1), f"{error}; save the file as UTF-8") from None
    [root] = top.inside
    if root.kind != "launch":
        raise UnreadableError(root.location, f"expected <launch>, found <{root.kind}>")
    return root.inside
