"""Let CMake run the programs of Python packages of the workspace, as it does on a robot."""

from __future__ import annotations

import shlex
import sys
import tempfile
from collections.abc import Callable, Iterable, Iterator, Sequence
from pathlib import Path, PurePosixPath

from sitegen.model import Package

RUN = (
    "import sys; from importlib import import_module; "
    "module, _, function = sys.argv.pop(1).partition(':'); "
    "sys.exit(getattr(import_module(module), function)())"
)
# The modules of the workspace take precedence.
SCRIPT = """\
#!/bin/sh
PYTHONPATH={}${{PYTHONPATH:+:$PYTHONPATH}} PYTHONDONTWRITEBYTECODE=1 exec {} "$@"
"""


def write(packages: Sequence[Package], prefix: Callable[[Package], Path]) -> None:
    """Write a script for each entry point of `packages` to `bin/` in its prefix.

    find_program() looks there. The scripts run with the Python of sitegen.
    """
    roots = dict.fromkeys(root for package in packages for root in _roots(package))
    path = shlex.quote(":".join(map(str, roots)))
    python = shlex.quote(sys.executable)
    for package in packages:
        for name, target in _entry_points(package):
            script = SCRIPT.format(path, f"{python} -c {shlex.quote(RUN)} {shlex.quote(target)}")
            _write(prefix(package) / "bin" / name, script)


def _entry_points(package: Package) -> Iterable[tuple[str, str]]:
    scripts = package.setup.scripts.items() if package.setup else ()
    return ((name, target) for name, target in scripts if ":" in target)


def _roots(package: Package) -> Iterator[Path]:
    """Yield the folders that hold the modules of a package."""
    for installed, file in (package.setup.files if package.setup else {}).items():
        path = PurePosixPath(installed)
        if path.is_relative_to("python"):
            yield file.parents[len(path.relative_to("python").parts) - 1]


def _write(place: Path, text: str) -> None:
    """Write a program in one step: another build may run it."""
    place.parent.mkdir(parents=True, exist_ok=True)
    with tempfile.TemporaryDirectory(dir=place.parent) as temporary:
        draft = Path(temporary, place.name)
        draft.write_text(text, encoding="utf-8")
        draft.chmod(0o755)
        draft.replace(place)
