"""Find the texts of a theme in the language of a page."""

from __future__ import annotations

from collections.abc import Iterable
from pathlib import Path
from types import SimpleNamespace
from typing import Any

import yaml


def texts(folders: Iterable[Path], language: str) -> SimpleNamespace:
    """Return the texts of a theme by name, in English if the theme lacks the language.

    `folders` are those of the theme, the most general first. The texts of `de` are used for
    `de-AT`, too.
    """
    found: dict[str, Any] = {}
    for tag in dict.fromkeys(("en", language.partition("-")[0].lower(), language)):
        for folder in folders:
            file = folder / "texts" / f"{tag}.yaml"
            if file.is_file():
                found |= yaml.safe_load(file.read_text(encoding="utf-8-sig")) or {}
    return SimpleNamespace(**found)
