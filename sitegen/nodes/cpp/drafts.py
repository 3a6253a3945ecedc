"""The place of drafts in the cache, and why a build for publication makes their programs again."""

from __future__ import annotations

from collections.abc import Sequence
from pathlib import Path

from sitegen.model import BROWSERS, Build
from sitegen.report import count


def draft_of(folder: Path) -> Path:
    """Return the folder for the drafts of the programs that `folder` is for."""
    return folder.with_name(f"{folder.name}-draft")


def reason(missing: Sequence[Sequence[Build]]) -> str:
    """Return what is to do for programs that exist as drafts, in one line; "" if none does.

    `missing` has the programs of each package that are to be made, for one engine each.
    """
    drafted = {
        _key(build) for builds in missing if all(map(_is_drafted, builds)) for build in builds
    }
    if not drafted:
        return ""
    others = {
        f" and compiling them for {BROWSERS[build.engine]}"
        for builds in missing
        for build in builds
        if _key(build) in drafted and not _is_drafted(build)
    }
    what = f"optimizing {count(len(drafted), 'node')} for publication (up to half the size)"
    return f"{what}{''.join(others)}; `sitegen serve` leaves this out to be faster"


def _is_drafted(build: Build) -> bool:
    return (draft_of(build.wasm.parent) / build.wasm.name).exists()


def _key(build: Build) -> tuple[Path, str]:
    """Return what identifies a program, whatever its engine."""
    return build.wasm.parent, build.wasm.name.removesuffix(f".{build.engine}.wasm")
