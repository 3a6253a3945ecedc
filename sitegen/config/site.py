"""Read site.yaml."""

from __future__ import annotations

import re
from collections.abc import Callable, Mapping, Sequence
from dataclasses import replace
from functools import cache
from pathlib import Path
from urllib.parse import urlsplit

from sitegen import workspace
from sitegen.config.beside import with_pages_beside
from sitegen.config.builds import build_settings, check_settings
from sitegen.config.connect import connect
from sitegen.config.deploy import deploy
from sitegen.config.document import Value, parse, read
from sitegen.config.files import locate
from sitegen.config.look import look
from sitegen.config.nav import NavReader
from sitegen.config.nodes import Declared, check_package, declare, with_description, with_kind
from sitegen.config.ownpanel import KIND as OWN
from sitegen.config.page import PageReader
from sitegen.config.pyodide import pyodide
from sitegen.config.schema import FILE, PAGE, SITE
from sitegen.config.section import Section, check
from sitegen.config.setupnotes import note_setups
from sitegen.config.themes import Themes
from sitegen.errors import Location, Problems, SiteError
from sitegen.model import Package, Page, Site, Widget

# A host name or an address, and a port.
ORIGIN = re.compile(r"https?://([a-z0-9-]+(\.[a-z0-9-]+)*|\[[0-9a-f:]+\])(:[1-9]\d*)?", re.I)
LANGUAGE = re.compile(r"[A-Za-z]{2,3}(-[A-Za-z0-9]{2,8})*")


def load(file: Path) -> Site:
    """Return the site that `file` describes.

    Raises: SiteError with all problems.
    """
    root = file.parent.resolve()
    file = root / file.name
    problems = Problems(root)
    check_exists(file)
    text = read(file, problems)
    empty = "the file is empty; start with 'site: {title: My robot}'"
    top = None if text is None else parse(text, Location(file, 1), problems, empty=empty)
    if top is None:
        raise SiteError(problems.lines)
    site = _site(check(top, FILE, problems), problems)
    problems.raise_if_any()
    return site


def check_exists(file: Path) -> None:
    """Refuse a folder without a site.yaml.

    Raises: SiteError if `file` does not exist.
    """
    if not file.exists():
        raise SiteError(
            [
                f"{file.name}: no such file in this folder; give the folder that contains it, or "
                "write one: 'sitegen init' for a workspace, 'sitegen new my_robot' to begin with"
            ]
        )


def _site(file: Section, problems: Problems) -> Site:
    """Return the site; invalid values are left out."""
    root = problems.root
    given = file.get("site")
    site = check(given, SITE, problems) if given else Section(file.value, SITE, {})
    nodes = file.get("nodes")
    themes = Themes.of(root)
    languages = _languages(site, problems)
    declared = declare(nodes, {}, problems) if nodes else {}
    folder = _workspace(file, problems)
    settings = build_settings(file.get("build"), problems)
    scanned = cache(lambda: workspace.scan(folder, settings, problems) if folder else {})
    joined = connect(file.get("connect"), problems)
    reader = PageReader(problems, declared, themes, languages, scanned, joined)
    pages = tuple(page for item in _page_items(file, problems) for page in reader.pages(item))
    pages = with_pages_beside(pages, problems)
    # Scripts and panels may use interfaces that no node does.
    wanted = folder and (reader.declared or any(map(_has_modules, pages)))
    packages = _packages(scanned, reader.declared, problems) if wanted else {}
    if settings:
        check_settings(settings, scanned(), problems)
    if folder and reader.declared:
        # A package that is not found may be behind such a link.
        workspace.report_outside(folder, problems if problems.found else reader.notes)
        note_setups((node for node, _ in reader.declared), packages, reader.notes)
        _note_replaced(scanned(), packages, reader.notes)
    pages = tuple(_with_kinds(page, packages, problems) for page in pages)
    nav = file.get("nav")
    return Site(
        root=root,
        title=site.text("title"),
        description=site.text("description"),
        url=_url("url", site, problems),
        language=_language(site, problems),
        theme=themes.find(site, problems),
        workspace=folder or root,
        asyncify=bool(site.option("asyncify")),
        pages=pages,
        packages=packages,
        notes=(*_notes(pages, reader.declared, root), *reader.notes.lines),
        look=look(site, problems),
        nav=tuple(NavReader({p.path: p for p in pages}, problems).items(nav)) if nav else (),
        languages=tuple(languages),
        repository=_url("repository", site, problems).removesuffix("/"),
        branch=site.text("branch"),
        feed=_feed(site, problems),
        levels=bool(site.option("levels")),
        pyodide=pyodide(file.get("pyodide"), problems),
        deploy=deploy(file.get("deploy"), problems),
        offline=bool(site.option("offline")) if site.get("offline") else None,
        isolate=bool(site.option("isolate")) if site.get("isolate") else None,
        messages_from=_origins(site, problems),
    )


def _url(name: str, site: Section, problems: Problems) -> str:
    url = site.text(name)
    try:
        parts = urlsplit(url)
        sound = parts.scheme in ("http", "https") and parts.hostname and parts.port != 0
    except ValueError:
        sound = False
    if url and not (sound and re.fullmatch(r"[^\s?#]+", url)):
        message = (
            f"'{url}' is not a valid http address; write it like 'https://me.github.io/robot/'"
        )
        problems.add(site.location(name), site.label(name), message)
    return url if not url or url.endswith("/") else f"{url}/"


def _origins(site: Section, problems: Problems) -> tuple[str, ...]:
    """Return the origins of `messages_from` as browsers write them."""
    given = site.get("messages_from")
    found = []
    for item in given.items() if given else ():
        origin = _origin(item.text)
        if not origin:
            message = (
                f"'{item.text}' is not an exact origin; write it like 'https://school.example', "
                "without a path or '*'"
            )
            problems.add(item.location, item.key, message)
        found.append(origin)
    return tuple(dict.fromkeys(found))


def _origin(text: str) -> str:
    """Return an origin as browsers write it, or nothing if `text` is not one."""
    if not ORIGIN.fullmatch(text):
        return ""
    try:
        parts = urlsplit(text.lower())
        port = parts.port
    except ValueError:
        return ""
    usual = {"http": 80, "https": 443}[parts.scheme]
    return f"{parts.scheme}://{parts.netloc.rpartition(':')[0]}" if port == usual else text.lower()


def _language(site: Section, problems: Problems) -> str:
    language = site.text("language")
    if not LANGUAGE.fullmatch(language):
        message = f"'{language}' is not a valid language tag; write it like 'en' or 'pt-BR'"
        problems.add(site.location("language"), site.label("language"), message)
    return language


def _languages(site: Section, problems: Problems) -> list[str]:
    given = site.get("languages")
    items = given.items() if given else []
    for item in items:
        if not LANGUAGE.fullmatch(item.text):
            message = f"'{item.text}' is not a valid language tag; write it like 'de' or 'pt-BR'"
            problems.add(item.location, item.key, message)
        elif item.text == site.text("language"):
            message = f"'{item.text}' is the site's own language; list only the others"
            problems.add(item.location, item.key, message)
    return list(dict.fromkeys(item.text for item in items))


def _feed(site: Section, problems: Problems) -> bool:
    if site.option("feed") and not site.get("url"):
        message = "a feed needs absolute links; set 'url' to the address of the site"
        problems.add(site.location("feed"), site.label("feed"), message)
    return bool(site.option("feed"))


def _page_items(file: Section, problems: Problems) -> list[Value]:
    given = file.get("pages")
    items = given.items() if given else []
    if given and not items:
        message = (
            "a site needs at least one page; write it like 'pages: [{path: /, file: index.md}]'"
        )
        problems.add(given.location, given.key, message)
    for item in items:
        if item.kind != "mapping":
            check(item, PAGE, problems)
    return [item for item in items if item.kind == "mapping"]


def _workspace(file: Section, problems: Problems) -> Path | None:
    given = file.get("workspace")
    if given:
        return locate(given, problems, folder=True)
    return None if file.value.has("workspace") else problems.root


def _has_modules(page: Page) -> bool:
    panels = (part for part in page.leaves if isinstance(part, Widget) and part.kind == OWN)
    return bool(page.scripts) or any(panels)


def _packages(
    scanned: Callable[[], Mapping[str, Package]],
    declared: Sequence[Declared],
    problems: Problems,
) -> Mapping[str, Package]:
    packages: Mapping[str, Package] = workspace.with_shipped(
        scanned(), (node.package for node, _ in declared)
    )
    if any(node.package == workspace.SITEGEN for node, _ in declared):
        packages = {**packages, workspace.SITEGEN: workspace.sitegen_package(packages)}
    for each in declared:
        check_package(each, packages, problems)
    return packages


def _note_replaced(
    scanned: Mapping[str, Package], packages: Mapping[str, Package], notes: Problems
) -> None:
    """Note the packages of the workspace in whose place pages run those of sitegen."""
    for name in workspace.replaced(scanned):
        if name in packages:
            message = f"'{name}' needs Qt, so pages run the {name} that comes with sitegen"
            notes.add(Location(scanned[name].path / "package.xml", 1), "package", message)


def _with_kinds(page: Page, packages: Mapping[str, Package], problems: Problems) -> Page:
    nodes = {name: with_kind(node, packages) for name, node in page.nodes.items()}
    described = {name: with_description(n, packages, problems) for name, n in nodes.items()}
    return replace(page, nodes=described)


def _notes(pages: Sequence[Page], declared: Sequence[Declared], root: Path) -> tuple[str, ...]:
    used = {(node.name, node.location) for page in pages for node in page.nodes.values()}
    notes = Problems(root)
    for node, section in declared:
        if section and (node.name, node.location) not in used:
            message = "no page uses this node; add a console or buttons for it, or remove it"
            notes.add(node.location, section.value.key, message)
    return tuple(notes.lines)
