"""Load a theme: its template, and the files that its pages load."""

from __future__ import annotations

import re
from collections.abc import Iterable
from dataclasses import dataclass, field
from pathlib import Path
from types import SimpleNamespace
from typing import Any

import jinja2
from markupsafe import Markup, escape

from sitegen.errors import SiteError, nearest
from sitegen.model import Artifact, Look, Site
from sitegen.shipped import DEFAULT_THEME
from sitegen.site.pages.colours import shades
from sitegen.site.pages.texts import texts
from sitegen.site.prose import lasting_name

NOT_SERVED = {".html", ".yaml", ".md"}
# A string or an address, which may contain what looks like a comment; or a comment with the space
# around it. One that begins with "/*!" stays: it names a license.
_COMMENT = re.compile(
    r"""("(?:\\.|[^"\\])*"|'(?:\\.|[^'\\])*'|url\([^)]*\))|\s*/\*(?!!).*?\*/\s*""",
    re.DOTALL,
)


@dataclass(frozen=True)
class Sheet:
    """A style sheet that a template requested, and the sheets that it is joined from.

    `theme` is the folder of the theme; each of `parts` is the name of a sheet and its media, or "".
    """

    theme: Path
    name: str
    parts: tuple[tuple[str, str], ...]


@dataclass(frozen=True)
class Theme:
    """A theme: its folder, then that of the default theme; and its path in `dist/`."""

    folders: tuple[Path, ...]
    path: str
    template: jinja2.Template
    style: str
    _texts: dict[str, SimpleNamespace] = field(default_factory=dict)

    @classmethod
    def of(cls, folder: Path, site: Site) -> Theme:
        """Return the theme of a folder, with the look of the site."""
        folders = tuple(dict.fromkeys((DEFAULT_THEME, folder)))
        environment = jinja2.Environment(
            loader=jinja2.FileSystemLoader(folders[::-1], encoding="utf-8-sig"),
            autoescape=True,
            undefined=jinja2.StrictUndefined,
            trim_blocks=True,
            lstrip_blocks=True,
        )
        environment.filters["breakable"] = breakable
        path = "theme/" if folder == site.theme else f"theme-{folder.name}/"
        try:
            template = environment.get_template("page.html")
        except jinja2.TemplateSyntaxError as error:
            where = f"{error.filename or error.name}:{error.lineno}"
            raise SiteError([f"{where}: theme: {error.message}; correct the template"]) from error
        return cls(folders, path, template, _style(site.look))

    def html(self, /, **names: Any) -> str:
        """Return the HTML of a page."""
        try:
            return self.template.render(**names)
        except jinja2.TemplateError as error:
            where = f"themes/{self.folders[-1].name}"
            raise SiteError([f"{where}: theme: {error.message}; see docs/templates.md"]) from error

    def texts(self, language: str) -> SimpleNamespace:
        """Return the texts of the theme in a language."""
        if language not in self._texts:
            self._texts[language] = texts(self.folders, language)
        return self._texts[language]

    def artifacts(self) -> list[Artifact]:
        """Return all files that its pages load, without joined style sheets."""
        found = [Artifact(self.path + name, file) for name, file in sorted(self._files().items())]
        if self.style:
            found.append(Artifact(f"{self.path}site.css", self.style.encode()))
        return found

    def own_sheets(self, kinds: Iterable[str]) -> list[str]:
        """Return the style sheets of those widgets that have one of their own."""
        files = self._files()
        names = (f"widgets/{kind}.css" for kind in sorted(set(kinds)))
        return [name for name in names if name in files]

    def joined(self, sheet: Sheet) -> Artifact:
        """Return several style sheets joined to one, which a page loads with one request."""
        files = self._files()
        texts = []
        for name, media in sheet.parts:
            if name == "site.css":
                text = self.style
            elif name in files:
                text = _COMMENT.sub(_without, files[name].read_text(encoding="utf-8-sig"))
            else:
                where = f"themes/{self.folders[-1].name}: theme"
                known = nearest(name, (file for file in files if file.endswith(".css")))
                raise SiteError([f"{where}: no style sheet '{name}' to join; {known}"])
            texts.append(f"@media {media} {{\n{text}}}\n" if media else text)
        return Artifact(self.path + sheet.name, "".join(texts).encode())

    def _files(self) -> dict[str, Path]:
        """Return the files to serve: those of the theme replace those of the default theme."""
        return {
            file.relative_to(folder).as_posix(): file
            for folder in self.folders
            for file in sorted(folder.rglob("*"))
            if file.is_file() and file.suffix not in NOT_SERVED and not file.name.startswith(".")
        }


def look_files(look: Look) -> list[Artifact]:
    """Return the files that the look of a site names."""
    named = (look.font, look.code_font, look.logo)
    files = (file for file in named if isinstance(file, Path))
    return [Artifact(lasting_name(file), file) for file in files]


def breakable(text: str) -> Markup:
    """Return text with places where a line may end in long names, such as those of packages."""
    return Markup(re.sub(r"(?<=\w_)(?=\w)", "<wbr>", str(escape(text))))


def _without(found: re.Match[str]) -> str:
    """Return what stays of a part of a style sheet; a comment also separates words."""
    return found[1] or ("\n" if "\n" in found[0] else " ")


def _style(look: Look) -> str:
    """Return the CSS variables that the look of a site changes."""
    rules, variables = [], []
    if look.accent:
        variables.append("--accent: light-dark({}, {});".format(*shades(look.accent)))
    for variable, font in (("--font", look.font), ("--font-code", look.code_font)):
        if isinstance(font, Path):
            name = f"site{variable.removeprefix('--')}"
            source = f'url("../{lasting_name(font)}")'
            rules.append(
                f'@font-face {{ font-family: "{name}"; src: {source}; '
                "font-weight: 100 900; font-display: swap; }"
            )
            font = f'"{name}", system-ui, sans-serif'
        if font:
            variables.append(f"{variable}: {font};")
    if variables:
        rules.append(f":root {{ {' '.join(variables)} }}")
    return "".join(f"{rule}\n" for rule in rules)
