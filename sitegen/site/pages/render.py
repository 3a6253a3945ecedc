"""Render the pages of a Site to HTML, with a page.json for each page that runs nodes."""

from __future__ import annotations

import os
import sys
from collections.abc import Iterable, Mapping, Sequence
from dataclasses import dataclass, replace
from functools import cached_property, partial
from pathlib import Path
from typing import Any

from markupsafe import Markup

from sitegen.cache.folder import cache_folder
from sitegen.config.ipynb import SUFFIX as NOTEBOOK
from sitegen.config.notebooks import JAVASCRIPT
from sitegen.errors import Problems, nearest
from sitegen.interfaces.catalogue import as_artifact, as_json, catalogue, texts
from sitegen.interfaces.messages import MessageType, hashes_of, without_hashes
from sitegen.model import Artifact, Page, Programs, Site, Widget, leaves
from sitegen.site import assets
from sitegen.site.bags import bags
from sitegen.site.launches import reading
from sitegen.site.ownpanels import cell_modules, own_panels
from sitegen.site.pages import app, discovery, preview, search, tags
from sitegen.site.pages.abilities import abilities
from sitegen.site.pages.blocks import Block, blocks, flat, slots_of
from sitegen.site.pages.early import modules, programs
from sitegen.site.pages.editor import edited
from sitegen.site.pages.entry import TERMINAL, again_entry, page_entry, written
from sitegen.site.pages.history import changed_days, edit_link
from sitegen.site.pages.missing import missing
from sitegen.site.pages.nav import Link, Navigation
from sitegen.site.pages.policy import CHOICE, FILE_NOTE, policy
from sitegen.site.pages.theme import Sheet, Theme, look_files
from sitegen.site.prose import Anchor, Heading, Library, Prose, address, lasting_name
from sitegen.site.resources import resources

# With fewer pages, starting processes takes longer than they save.
MANY = 150
# The ids that every page has.
ALWAYS = frozenset({"main", "top"})


@dataclass(frozen=True)
class Rendered:
    """The result for one page: its artifacts, and what the whole site needs to know about it.

    `ids` are the targets for links into the page, `anchors` the links whose targets must exist,
    `sheets` the joined style sheets that it loads, `found` its problems in the form of Problems,
    `notes` hints about a page that has none.
    """

    page: Page
    artifacts: tuple[Artifact, ...]
    ids: frozenset[str]
    anchors: tuple[Anchor, ...]
    passages: tuple[search.Passage, ...]
    sheets: tuple[Sheet, ...]
    found: tuple[tuple[str, int, str], ...]
    notes: tuple[str, ...] = ()


def render(site: Site, programs: Programs | None = None) -> list[Artifact]:
    """Return the artifacts of all pages and of the themes."""
    renderer = Renderer(site, programs or {})
    rendered = renderer.every_page()
    return [*renderer.site_artifacts(rendered), *renderer.index(rendered)]


class Renderer:
    """Renders the pages of one site, all of them or one at a time."""

    def __init__(self, site: Site, programs: Programs) -> None:
        self.site = tags.with_tags(site)
        self._programs = programs
        self._library = Library.of(self.site)
        self._navigation = Navigation(site)
        self._tags = tags.links(self.site)
        self._files = look_files(site.look)
        self._themes = {
            folder: Theme.of(folder, site)
            for folder in dict.fromkeys([site.theme, *(p.theme for p in site.pages if p.theme)])
        }

    @cached_property
    def _changed(self) -> Mapping[Path, str]:
        return changed_days(self.site)

    @cached_property
    def _catalogue(self) -> Mapping[str, MessageType]:
        return catalogue(self.site, cache=cache_folder())

    @cached_property
    def _interfaces(self) -> bytes:
        return as_json(without_hashes(self._catalogue))

    @cached_property
    def _texts(self) -> bytes:
        return as_json(texts(self.site, cache=cache_folder()))

    def _definitions(self, page: Page) -> dict[str, Artifact]:
        """Return what terminals, cells and panels below these load: all interfaces.

        Terminals show their texts and hashes, too.
        """
        kinds = assets.shown_kinds(page)
        found = {}
        if kinds & {TERMINAL, *assets.CELLS, JAVASCRIPT}:
            found["interfaces"] = as_artifact(self._interfaces)
        if TERMINAL in kinds:
            found["texts"] = as_artifact(self._texts)
            found["hashes"] = as_artifact(as_json(hashes_of(self._catalogue)))
        return found

    def every_page(self) -> list[Rendered]:
        """Return all pages; if there are many, they are rendered in several processes."""
        pages, workers = self.site.pages, min(os.cpu_count() or 1, 8)
        # On other systems, fork() is unsafe or missing.
        if len(pages) < MANY or workers < 2 or sys.platform != "linux":
            return [self.page(page) for page in pages]
        # Imported only by sites that use several processes.
        from concurrent.futures import ProcessPoolExecutor
        from multiprocessing import get_context

        # What all pages need is computed once, before the fork.
        _ = self._changed
        global _forked
        _forked = self
        size = -(-len(pages) // (4 * workers))
        starts = range(0, len(pages), size)
        chunks = [range(start, min(start + size, len(pages))) for start in starts]
        with ProcessPoolExecutor(workers, mp_context=get_context("fork")) as pool:
            return [page for chunk in pool.map(_chunk, chunks) for page in chunk]

    def page(self, page: Page, *, alone: bool = False) -> Rendered:
        """Return one page; it may be a newer version of the site's page with the same path.

        With `alone`, it has no menu and no search.
        """
        problems = Problems(self.site.root)
        library = self._library
        if library.pages.get(page.path) is not page:
            library = replace(library, pages={**library.pages, page.path: page})
        theme = self._themes[page.theme or self.site.theme]
        language = page.language or self.site.language
        prose = Prose(library, page, problems, theme.texts(language).admonitions)
        parts = blocks(self.site, page, prose, problems)
        shown = list(flat(parts))
        entry = None
        notes: tuple[str, ...] = ()
        if page.scripts or any(panel.slots for block in shown for panel in block.panels):
            files = edited(self.site, page, problems)
            # A page opened as a file has no service worker.
            site = replace(self.site, isolate=None) if alone else self.site
            loaded = resources(site, page)
            notes = tuple(loaded.notes)
            played = bags(site, page)
            own = own_panels(site, page, problems, lambda: self._interfaces, lambda: self._texts)
            modules, imported = cell_modules(page, problems)
            defined = self._definitions(page)
            paths = {name: artifact.path for name, artifact in defined.items()}
            entry = page_entry(
                site, page, self._programs, files, loaded.paths, played.paths, own, modules, paths
            )
            # A page that is a single file does not contain Python for it.
            again = None if alone else reading(site, page)
            if again and page.launch:
                link = partial(address, page)
                entry["launch"]["again"] = again_entry(page.launch, again, link)
        html, sheets = self._html(page, parts, prose, entry, alone=alone)
        artifacts = [Artifact(page.html, html.encode())]
        if entry:
            artifacts.append(Artifact(f"{page.path}page.json", written(entry)))
            artifacts += [*loaded.artifacts, *played.artifacts, *own.artifacts]
            artifacts += [*defined.values(), *imported]
            artifacts += [again.reader, again.files] if again else []
        artifacts += [Artifact(path, file) for path, file in prose.links.files.items()]
        if self.site.url and not page.base:
            artifacts.append(preview.artifact(self.site, page))
        slots = {slot.id for _, slot in slots_of(page)}
        found, anchors = tuple(problems.found), tuple(prose.links.anchors)
        if page.location.file.suffix == NOTEBOOK and not slots:
            # It was written for Jupyter: what is wrong with it as a page must not stop a build.
            notes, found, anchors = (*notes, *problems.lines), (), ()
        return Rendered(
            page,
            tuple(artifacts),
            frozenset(prose.ids | slots | ALWAYS),
            anchors,
            tuple(search.passages(page, (block.html for block in shown))),
            tuple(sheets),
            found,
            notes,
        )

    def alone(self, page: Page) -> tuple[str, list[Artifact]]:
        """Return the HTML of one page without the site around it, and the files that it loads."""
        rendered = self.page(page, alone=True)
        first, *rest = rendered.artifacts
        assert isinstance(first.source, bytes)
        problems = Problems(self.site.root)
        problems.found += rendered.found
        problems.raise_if_any()
        theme = self._themes[page.theme or self.site.theme]
        sheets = (theme.joined(sheet) for sheet in rendered.sheets)
        return first.source.decode(), [*rest, *theme.artifacts(), *sheets, *self._files]

    def index(self, rendered: Iterable[Rendered]) -> list[Artifact]:
        """Return the search index."""
        return search.artifacts(self.site, ((each.page, each.passages) for each in rendered))

    def site_artifacts(self, rendered: Iterable[Rendered]) -> list[Artifact]:
        """Return the artifacts of the pages and of the whole site, without the search index.

        The index takes as long as all the others together.

        Raises: SiteError if pages have problems.
        """
        rendered = list(rendered)
        problems = Problems(self.site.root)
        for each in rendered:
            problems.found += each.found
        _check_anchors(rendered, problems)
        problems.raise_if_any()
        texts = self._themes[self.site.theme].texts(self.site.language)
        rendered.append(self.page(missing(self.site, texts)))
        artifacts = [artifact for each in rendered for artifact in each.artifacts]
        # Pages share images and previews.
        artifacts = list({artifact.path: artifact for artifact in artifacts}.values())
        for theme in self._themes.values():
            artifacts += theme.artifacts()
        sheets = dict.fromkeys(sheet for each in rendered for sheet in each.sheets)
        artifacts += (self._themes[sheet.theme].joined(sheet) for sheet in sheets)
        artifacts += self._files
        artifacts += discovery.artifacts(self.site, self._changed)
        artifacts += app.artifacts(self.site)
        return artifacts

    def _html(
        self,
        page: Page,
        parts: Sequence[Block],
        prose: Prose,
        entry: Mapping[str, Any] | None,
        *,
        alone: bool,
    ) -> tuple[str, Sequence[Sheet]]:
        """Return the HTML of a page, and the joined style sheets that it loads."""
        theme = self._themes[page.theme or self.site.theme]
        sheets: list[Sheet] = []

        def sheet(name: str, parts: Mapping[str, str]) -> str:
            sheets.append(Sheet(page.theme or self.site.theme, name, tuple(parts.items())))
            return address(page, f"{theme.path}{name}")

        html = theme.html(
            site=self.site,
            page=page,
            sheet=sheet,
            **self._content(page, parts, prose, theme),
            **self._around(page, alone=alone),
            **self._look(page, prose, theme),
            **self._runtime(page, parts, entry, alone=alone),
            **self._record(page),
        )
        return html, sheets

    def _content(
        self, page: Page, parts: Sequence[Block], prose: Prose, theme: Theme
    ) -> Mapping[str, object]:
        """Return what a template shows of the page itself."""
        language = page.language or self.site.language
        return {
            "language": language,
            "text": theme.texts(language),
            "blocks": parts,
            "has_heading": any(heading.level == 1 for heading in prose.headings),
            "toc": _toc(prose.headings),
            "can": abilities(page),
            "tags": [Link(name, address(page, path)) for name, path in self._tags(page)],
        }

    def _around(self, page: Page, *, alone: bool) -> Mapping[str, object]:
        """Return the links from the page to the others, if it is not `alone`."""
        site, navigation = self.site, self._navigation
        if alone:
            navigation = Navigation(replace(site, pages=(), nav=()))
        home = navigation.home(page)
        previous, following = navigation.around(page)
        language = page.language or site.language
        searched = search.wanted(site) and not alone
        return {
            "menu": navigation.menu(page),
            "trail": navigation.trail(page),
            "previous": previous,
            "next": following,
            "languages": navigation.languages(page, site),
            "root": address(page, ""),
            "home": address(page, home.path if home else ""),
            "versions": address(page, "../versions.json") if site.version and not alone else "",
            "search": address(page, search.path(language)) if searched else "",
        }

    def _look(self, page: Page, prose: Prose, theme: Theme) -> Mapping[str, object]:
        """Return what the author chose for the look of all pages."""
        look = self.site.look
        return {
            "theme": address(page, theme.path),
            "style": address(page, f"{theme.path}site.css") if theme.style else "",
            "widget_sheets": theme.own_sheets(assets.shown_kinds(page)),
            "logo": address(page, lasting_name(look.logo)) if look.logo else "",
            "footer": Markup(prose.html(look.footer) if look.footer else ""),
        }

    def _runtime(
        self,
        page: Page,
        parts: Sequence[Block],
        entry: Mapping[str, Any] | None,
        *,
        alone: bool,
    ) -> Mapping[str, object]:
        """Return what the page runs, and what its policy allows it."""
        live = entry is not None
        offline = bool(self.site.offline) and not alone and not page.base
        fonts = (self.site.look.font, self.site.look.code_font)
        html = "".join(block.html for block in flat(parts))
        own_fonts = any(isinstance(font, Path) for font in fonts)
        return {
            "live": live,
            "wide": any(
                isinstance(part, Widget) and not part.is_docked
                for part in leaves(page.content, examples=False)
            ),
            "share": live and not alone,
            "runtime": address(page, "runtime/"),
            "modules": modules(self.site, page, self._programs, entry),
            "programs": programs(entry),
            "offline": offline,
            "policy": policy(
                html,
                live=live,
                fonts=own_fonts,
                offline=offline,
                gltf=_has_gltf(entry),
                frames=any(widget.kind == "jupyter" for widget, _ in slots_of(page)),
                ros2wasm=_has_ros2wasm(entry),
                cells=any(widget.kind == JAVASCRIPT for widget, _ in slots_of(page)),
                gateways=page.connect.addresses if page.connect else (),
            ),
            "file_note": Markup("" if alone else FILE_NOTE),
            "choice": Markup(CHOICE),
        }

    def _record(self, page: Page) -> Mapping[str, object]:
        """Return where the page is published, and where and when it was written."""
        site = self.site
        # Nobody links to a page that is shown in place of others.
        public = site.url and not page.base
        return {
            "url": discovery.url(site, page) if public else "",
            "image": f"{site.url}{preview.path(site, page)}" if public else "",
            "feed": address(page, discovery.FEED) if site.feed else "",
            "edit": edit_link(site, page),
            "changed": self._changed.get(page.file, "") if page.file else "",
        }


_forked: Renderer


def _has_gltf(entry: Mapping[str, Any] | None) -> bool:
    """Return whether a 3D view of a page loads a glTF file."""
    widgets = entry["widgets"] if entry else ()
    urls = (url for widget in widgets for url in widget["options"].get("resources", ()))
    return any(url.lower().endswith((".gltf", ".glb")) for url in urls)


def _has_ros2wasm(entry: Mapping[str, Any] | None) -> bool:
    """Return whether a page has nodes that the ROS2WASM project compiled."""
    return entry is not None and any("ros2wasm" in node for node in entry["nodes"].values())


def _chunk(indexes: range) -> list[Rendered]:
    return [_forked.page(_forked.site.pages[index]) for index in indexes]


def _toc(headings: Sequence[Heading]) -> list[Heading]:
    """Return the headings for a table of contents, if there is more than one."""
    shown = [heading for heading in headings if heading.level in (2, 3)]
    return shown if len(shown) > 1 else []


def _check_anchors(rendered: Sequence[Rendered], problems: Problems) -> None:
    ids = {each.page.path: each.ids for each in rendered}
    for each in rendered:
        for path, name, location in each.anchors:
            if name not in ids[path]:
                where = "this page" if path == each.page.path else f"/{path}"
                message = f"no heading '#{name}' in {where}; {nearest(name, ids[path] - ALWAYS)}"
                problems.add(location, "link", message)
