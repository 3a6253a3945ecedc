"""Read and write versions.json, which names the versions of a site, the newest first."""

from __future__ import annotations

import json
from collections.abc import Iterable, Sequence
from pathlib import Path

from packaging.version import InvalidVersion
from packaging.version import Version as Release

from sitegen.build import VERSIONS
from sitegen.commands.versions.names import Version, is_name
from sitegen.errors import SiteError

LATEST = "latest"


def read(folder: Path) -> list[Version]:
    """Return the versions in `folder`, or none."""
    file = folder / VERSIONS
    if not file.exists():
        return []
    try:
        found = [
            Version(str(each["version"]), tuple(map(str, each["aliases"])))
            for each in json.loads(file.read_text(encoding="utf-8"))
        ]
    except (ValueError, KeyError, TypeError):
        found = []
    names = [name for version in found for name in (version.name, *version.aliases)]
    if not found or not all(map(is_name, names)) or len(set(names)) < len(names):
        raise SiteError([f"{file}: not a valid list of versions; correct or delete it"])
    return found


def written(versions: Iterable[Version]) -> bytes:
    """Return versions.json."""
    rows = [{"version": each.name, "aliases": list(each.aliases)} for each in versions]
    return (json.dumps(rows, indent=1) + "\n").encode()


def with_version(versions: Sequence[Version], new: Version) -> list[Version]:
    """Return `versions` with a new one, or a new state of one. Aliases move to it.

    Raises: SiteError if a name would mean two versions.
    """
    for each in versions:
        if new.name in each.aliases:
            raise SiteError(
                [f"'{new.name}' is an alias of version {each.name}; choose another --version"]
            )
        if each.name in new.aliases:
            raise SiteError([f"'{each.name}' is a version; choose another --alias"])
    before = next((each.aliases for each in versions if each.name == new.name), ())
    kept = [
        Version(each.name, tuple(name for name in each.aliases if name not in new.aliases))
        for each in versions
        if each.name != new.name
    ]
    new = Version(new.name, tuple(dict.fromkeys((*before, *new.aliases))))
    return sorted([*kept, new], key=_age, reverse=True)


def default(versions: Sequence[Version]) -> Version:
    """Return the version that visitors get: the latest, or else the newest."""
    return next((each for each in versions if LATEST in each.aliases), versions[0])


def _age(version: Version) -> tuple[bool, Release, str]:
    """Return a key that grows with the version; names such as `dev` come before all numbers."""
    try:
        return True, Release(version.name), version.name
    except InvalidVersion:
        return False, Release("0"), version.name
