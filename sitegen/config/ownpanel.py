"""Read a panel that the author wrote."""

from __future__ import annotations

import math
import re
from dataclasses import replace
from pathlib import Path

from sitegen.config.document import Value
from sitegen.config.files import locate
from sitegen.config.section import check, conforms
from sitegen.config.widgetkeys import WIDGETS
from sitegen.errors import Problems
from sitegen.model import Widget

WORD = "panel"
# Its kind in page.json; `ros-panel` is the class of the frame around widgets.
KIND = "own"
SUFFIXES = (".js", ".mjs")


def own_panel(value: Value, problems: Problems, page: Path) -> Widget | None:
    """Return the panel that `value` describes; `page` is the folder of the page."""
    keys = WIDGETS[WORD]
    title = ""
    options: object = {}
    if value.kind == "mapping":
        section = check(value, keys, problems)
        given, title = section.get("file"), section.text("title")
        data = section.get("options")
        options = data_of(data, problems) if data else {}
    else:
        short = replace(keys[0], example=f"{WORD}: {keys[0].example.removeprefix('file: ')}")
        given = value if conforms(value, short, problems) else None
    file = locate(given, problems, page=page) if given else None
    if not given or not file:
        return None
    name = file.relative_to(problems.root.resolve()).as_posix()
    if file.suffix not in SUFFIXES:
        message = f"'{given.text}' is not a module; name a '.js' file that exports 'mount'"
        problems.add(given.location, given.key, message)
        return None
    title = title or file.stem.replace("-", " ").replace("_", " ").capitalize()
    return Widget(KIND, "", {"file": name, "title": title, "options": options}, value.location)


def own_scripts(
    one: Value | None, several: Value | None, problems: Problems, folder: Path
) -> tuple[str, ...]:
    """Return the paths of the scripts of a page below the site's folder, each once.

    They are the values of `script` and `scripts`.
    """
    found = []
    for each in [*([one] if one else []), *(several.items() if several else [])]:
        file = locate(each, problems, page=folder)
        if file and file.suffix not in SUFFIXES:
            message = f"'{each.text}' is not a module; name a '.js' file"
            problems.add(each.location, each.label, message)
        elif file:
            found.append(file.relative_to(problems.root.resolve()).as_posix())
    return tuple(dict.fromkeys(found))


def data_of(value: Value, problems: Problems) -> object:
    """Return a value of YAML as one of JSON; dates and the like are texts."""
    if value.kind == "mapping":
        entries = value.entries(problems)
        return {name: data_of(entry, problems) for name, entry in entries.items()}
    if value.kind == "list":
        return [data_of(item, problems) for item in value.items()]
    if value.kind == "nothing":
        return None
    if value.node.tag == "tag:yaml.org,2002:float":
        try:
            number = float(value.text.replace("_", ""))
        except ValueError:  # .inf, .nan, 12:30.5
            number = math.nan
        if not math.isfinite(number):
            message = f"'{value.text}' is not a number of JSON; put it in quotes"
            problems.add(value.location, value.key, message)
        return number
    if value.node.tag == "tag:yaml.org,2002:int" and re.fullmatch(r"[-+]\d+", value.text):
        return int(value.text)
    return value.scalar
