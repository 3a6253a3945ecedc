"""Find the themes that sites and pages name."""

from __future__ import annotations

from dataclasses import dataclass
from pathlib import Path

from sitegen.config.section import Section
from sitegen.errors import Problems, nearest
from sitegen.shipped import THEMES

FOLDER = "themes"


@dataclass(frozen=True)
class Themes:
    """The themes by name; themes of the site take precedence."""

    found: dict[str, Path]
    root: Path

    @classmethod
    def of(cls, root: Path) -> Themes:
        """Return the themes that the site in `root` can name: all folders that are not hidden."""
        folders = (
            folder
            for themes in (THEMES, root / FOLDER)
            if themes.is_dir()
            for folder in sorted(themes.iterdir())
            if folder.is_dir() and not folder.name.startswith(".")
        )
        return cls({folder.name: folder for folder in folders}, root)

    def find(self, section: Section, problems: Problems) -> Path:
        """Return the theme that `section` names, and report one that does not exist."""
        name = section.text("theme")
        found = self.found.get(name)
        if found is None:
            message = f"no theme named '{name}'; {nearest(name, self.found)}"
            problems.add(section.location("theme"), section.label("theme"), message)
        elif found.parent == self.root / FOLDER and not found.resolve().is_relative_to(self.root):
            message = f"'themes/{name}' is outside the site's folder; copy the theme into it"
            problems.add(section.location("theme"), section.label("theme"), message)
        return found or self.root / FOLDER
