"""Turn a folder of Markdown files into the paths of pages, in order."""

from __future__ import annotations

import re
from collections.abc import Iterator, Sequence
from pathlib import Path

from sitegen.config.paths import segment
from sitegen.ignored import is_ignored

# The page of the folder itself.
INDEX = {"index", "readme"}
# `02-setup.md` is the second page; its path is `setup`.
ORDER = re.compile(r"\d+[-_. ]+(?=.)")


def files(folder: Path, languages: Sequence[str], root: Path) -> Iterator[tuple[str, Path]]:
    """Yield the path and the file of each page: the page of a folder first, then by name.

    Numbers in names are compared as numbers; a number at the start of a name only sets the order. A
    file in another one of `languages` belongs to the page that it translates. `root` is the site's
    folder.
    """
    yield from _below(folder, "", tuple(f".{language}" for language in languages), root)


def in_language(file: Path, language: str) -> Path:
    """Return the file for the translation of a page: `page.de.md` beside `page.md`."""
    return file.with_name(f"{file.stem}.{language}{file.suffix}")


def _below(
    folder: Path, path: str, translated: tuple[str, ...], root: Path
) -> Iterator[tuple[str, Path]]:
    entries = sorted(folder.iterdir(), key=lambda entry: _order(entry.name))
    for entry in entries:
        if entry.name.startswith((".", "_")):
            continue
        if entry.is_dir():
            if not is_ignored(entry.name, at_root=folder == root) and not entry.is_symlink():
                yield from _below(entry, f"{path}{_name(entry.name)}/", translated, root)
        elif entry.suffix == ".md" and not entry.stem.endswith(translated):
            own = entry.stem.lower() in INDEX
            yield (path if own else f"{path}{_name(entry.stem)}/"), entry


def _name(name: str) -> str:
    return segment(ORDER.sub("", name, count=1)) or "page"


def _order(name: str) -> tuple[bool, list[tuple[int, str]]]:
    words = re.split(r"(\d+)", name.lower())
    parts = [(int(word), "") if word.isdigit() else (-1, word) for word in words]
    return name.lower().removesuffix(".md") not in INDEX, parts
