"""Make type descriptions of interfaces that no wheel describes: sitegen's, the workspace's."""

from __future__ import annotations

import contextlib
import os
import tempfile
from collections.abc import Iterable, Sequence
from pathlib import Path

from sitegen import workspace
from sitegen.cache.digest import digest_of
from sitegen.cache.folder import use
from sitegen.errors import SiteError
from sitegen.interfaces import generator
from sitegen.model import Package, Site
from sitegen.shipped import INTERFACES, ROS

GENERATOR = ("definitions.py", "generator.py", "values.py")


def described(site: Site, named: Iterable[str], *, cache: Path) -> Path:
    """Return a prefix with type descriptions and Python classes of the packages `named`.

    It contains those packages of sitegen and of the workspace, with the packages that they need.

    Raises: SiteError if definitions of the workspace are wrong.
    """
    needs: dict[str, Package] = {}
    for name in named:
        needs |= {one.name: one for one in workspace.with_dependencies(site.packages, name)}
    packages = [
        *((folder.name, folder, _files(folder)) for folder in sorted(INTERFACES.iterdir())),
        *((one.name, one.path, one.interfaces) for one in needs.values() if one.interfaces),
    ]
    sources = [Path(__file__).with_name(name) for name in GENERATOR]
    inputs = [*sources, ROS / ".digest", *(folder for _, folder, _ in packages)]
    prefix = cache / "descriptions" / digest_of(inputs, roots={site.root, site.workspace})
    if not prefix.exists():
        prefix.parent.mkdir(parents=True, exist_ok=True)
        with tempfile.TemporaryDirectory(dir=prefix.parent) as temporary:
            fresh = Path(temporary) / "new"
            for package, folder, files in packages:
                _describe(fresh, package, folder, files, site.root)
            with contextlib.suppress(OSError):  # another build was first
                fresh.rename(prefix)
    use(prefix)
    return prefix


def _files(folder: Path) -> Sequence[str]:
    return sorted(file.relative_to(folder).as_posix() for file in folder.glob("*/*.*"))


def _describe(prefix: Path, package: str, folder: Path, files: Sequence[str], root: Path) -> None:
    # rosidl writes its progress to the standard output.
    with Path(os.devnull).open("w") as nowhere, contextlib.redirect_stdout(nowhere):
        try:
            arguments = generator.describe(prefix, [prefix], package, folder, files)
        except SiteError as error:
            lines = [line.removeprefix(f"{root}/") for line in error.lines]
            raise SiteError(lines) from None
        generator.write_classes(prefix, arguments)
