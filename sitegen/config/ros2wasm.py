"""Read a ROS2WASM program in site.yaml."""

from __future__ import annotations

import re
from collections.abc import Iterator, Mapping
from pathlib import Path

from sitegen import workspace
from sitegen.config.files import locate
from sitegen.config.schema import FORMS
from sitegen.config.section import Section
from sitegen.errors import Problems
from sitegen.model import Package, Ros2wasm

# The pattern of file names in scripts: scripts made by Emscripten name every file that they load.
NAMED = re.compile(r"""["'`]([\w-][\w.-]*\.(?:js|wasm|data|mem))["'`]""")


def read(section: Section, problems: Problems) -> Ros2wasm | None:
    """Return the script and the files that it loads, and report missing files."""
    given, types = section.get("ros2wasm"), section.get("types")
    script = locate(given, problems) if given else None
    if given is None or script is None:
        return None
    if script.suffix != ".js":
        message = f"'{given.text}' is not a script; give the .js file that the compiler wrote"
        problems.add(given.location, given.key, message)
        return None
    files = [script, *_loaded(script)]
    for file in files:
        if not file.resolve().is_relative_to(problems.root):
            message = (
                f"'{file.name}', which the script loads, is outside the site's folder; "
                "copy it into the folder"
            )
            problems.add(given.location, given.key, message)
        elif not file.is_file():
            message = f"it loads '{file.name}', which does not exist; copy it next to the script"
            problems.add(given.location, given.key, message)
    return Ros2wasm(script, tuple(files), types.texts(problems) if types else {})


def check_types(section: Section, packages: Mapping[str, Package], problems: Problems) -> None:
    """Report invalid names, and types that neither ROS nor the workspace defines."""
    types = section.get("types")
    known = workspace.interfaces(packages)
    for name, given in types.entries(problems).items() if types else ():
        if not FORMS["name"].fullmatch(name):
            message = f"'{name}' is not a valid topic or service name; write it like '/chatter'"
            problems.add(given.location, given.key, message)
        if given.text not in known:
            problems.add(given.location, given.key, workspace.unknown_interface(given.text, known))


def _loaded(script: Path) -> Iterator[Path]:
    """Yield the files beside `script` that it loads, directly or indirectly."""
    seen = {script}
    waiting = [script]
    while waiting:
        text = waiting.pop().read_text(encoding="utf-8-sig", errors="replace")
        for name in dict.fromkeys(NAMED.findall(text)):
            file = script.parent / name
            # A .wasm file is always required; any other name may not stand for a file at all.
            if file in seen or not (file.is_file() or file.suffix == ".wasm"):
                continue
            seen.add(file)
            yield file
            if file.suffix == ".js" and file.is_file():
                waiting.append(file)
