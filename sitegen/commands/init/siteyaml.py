"""Write the text of a site.yaml, with comments that explain it."""

from __future__ import annotations

import json
import re
from collections.abc import Collection, Iterable, Iterator, Mapping, Sequence
from pathlib import Path

import yaml

from sitegen.commands import schema
from sitegen.commands.init.members import Member
from sitegen.commands.init.pages import Page
from sitegen.commands.init.panels import Item
from sitegen.commands.init.partners import needed
from sitegen.commands.init.robots import PATTERNS
from sitegen.commands.init.runs import files
from sitegen.commands.wiring.endpoint import OPTIONS
from sitegen.errors import relative
from sitegen.model import Package

# At most this many of each kind are listed.
LISTED = 12
# More panels than this are in tabs, of which there are at most eight.
BESIDE, TABS = 2, 8
_MARKS = re.compile(r"[\\`*<\[\]]|^[#>+-]")


def text(
    root: Path, pages: Sequence[Page], packages: Collection[Package], faults: Sequence[str]
) -> str:
    """Return the text of a site.yaml with these pages; `faults` are listed in comments."""
    title = root.name.replace("_", " ").replace("-", " ").capitalize()
    return "\n".join(
        [
            schema.MODELINE,
            "# The contents of the site. docs/site-yaml.md of sitegen describes every key;",
            "# `sitegen serve` shows the site while you edit it, and reports any errors.",
            "site:",
            f"  title: {_name(title)}",
            "  # The address of the site, for link previews:",
            "  # url: https://me.github.io/my-robot/",
            "workspace: .",
            "",
            "# The pages, in navigation order; `markdown` is text or the name of a file (.md).",
            "pages:",
            *(_home(pages, title) if pages[0].path else ()),
            *(line for page in pages for line in _page(page, root, pages)),
            *_also(packages, faults),
            "",
        ]
    )


def _home(pages: Sequence[Page], title: str) -> Iterator[str]:
    yield "  - path: /"
    yield f"    title: {_name(title)}"
    yield "    content:"
    yield "      - markdown: |"
    yield '          <div class="cards" markdown="1">'
    yield ""
    for page in pages:
        yield f"          - [{_plain(page.title)}]({page.path}) {page.programs}"
    yield from ("", "          </div>")


def _page(page: Page, root: Path, pages: Sequence[Page]) -> Iterator[str]:
    first = next(each for each in pages if bool(each.launch) == bool(page.launch))
    explains = page is first
    if page is not pages[0] or page.path:
        yield ""
    yield f"  - path: {page.path or '/'}"
    yield f"    title: {_name(page.title)}"
    if page.launch:
        if explains:
            yield "    # Every node that this file starts is a node of the page. Its arguments:"
            yield "    #   launch_arguments: {robot_name: fox}"
        for other in page.also:
            yield f"    # {relative(other, root)} starts the same nodes."
        yield f"    launch: {_name(relative(page.launch, root))}"
        if page.chosen:
            yield "    launch_arguments:"
        for argument in page.chosen:
            value, *others = map(_name, argument.choices)
            instead = f"  # or: {', '.join(others)}" if others else ""
            yield f"      {_name(argument.name)}: {value}{instead}"
        if not page.views and not page.panels:
            return
    else:
        yield from _nodes(page.members, explains=explains)
    yield "    content:"
    yield from _content(page, explains=explains)


def _nodes(members: Sequence[Member], *, explains: bool) -> Iterator[str]:
    if explains:
        yield "    # The nodes that the page runs. A node can have more keys:"
        yield "    #   {package: …, executable: …, namespace: /demo, remap: {chatter: /chatter}}"
    yield "    nodes:"
    for member in members:
        keys = f"package: {_name(member.package)}, executable: {_name(member.executable)}"
        read = member.told.arguments
        if read and all(read.values()):
            # Numbers that are as good as any.
            values = [str(position) for position in range(1, max(read) + 1)]
            keys += f", arguments: {json.dumps(values)}"
        if member.urdf:
            keys += f", urdf: {_name(member.urdf)}"
        if others := [other.name for other in needed(member, members)]:
            keys += f", needs: [{', '.join(others)}]"
        if OPTIONS in member.told.uses or (read and not all(read.values())):
            values = ["…"] * max(read, default=1)
            like = json.dumps(values, ensure_ascii=False)
            yield f"      # It takes command-line arguments; add them like this: arguments: {like}"
        yield f"      {member.name}: {{{keys}}}"


def _content(page: Page, *, explains: bool) -> Iterator[str]:
    if page.text:
        yield f"      - markdown: {_text(_plain(page.text))}"
    if explains and not page.launch:
        yield "      # A node without buttons starts when the page opens."
        if any(member.source == "Python" for member in page.members):
            yield "      # `editor` in place of `source` and `buttons` lets visitors change Python."
    yield from _stage(page) if page.views else _consoles(page)
    if len(page.panels) <= BESIDE:
        yield from (f"      - {_item(item)}".rstrip() for item in page.panels)
        return
    if explains:
        yield "      # Panels show what all nodes exchange; `log`, `nodes` and `tf` are others."
    yield "      - tabs:"
    for title, items in _tabs(page.panels).items():
        yield f"          {title}: {_items(items)}"


def _consoles(page: Page) -> Iterator[str]:
    """Yield each node with its source and its console."""
    for member in page.members:
        if member.source:
            yield f"      - source: {member.name}"
        start = f"{{node: {member.name}, autostart: true}}" if page.launch else member.name
        yield f"      - buttons: {start}"
        yield f"      - console: {member.name}"


def _stage(page: Page) -> Iterator[str]:
    """Yield the robot with the buttons and the consoles of its nodes, and then the sources."""
    yield "      - stage:"
    yield f"          nodes: [{', '.join(member.name for member in page.members)}]"
    if page.autostart:
        yield "          autostart: true"
    yield "          consoles: beside"
    yield f"          show: {_items([_item(item) for item in page.views])}"
    for member in page.members:
        if member.source:
            yield f"      - source: {member.name}"


def _tabs(items: Iterable[Item]) -> dict[str, list[str]]:
    """Return the items of each tab, by its title."""
    tabs: dict[str, list[str]] = {}
    for item in items:
        tabs.setdefault(item[0].capitalize(), []).append(_item(item))
    return dict(list(tabs.items())[:TABS])


def _items(items: Sequence[str]) -> str:
    """Return items in one line."""
    shown = [f"{{{item}}}" for item in items]
    return shown[0] if len(shown) == 1 else f"[{', '.join(shown)}]"


def _item(item: Item) -> str:
    kind, options = item
    if options is None:
        return f"{kind}: "
    if isinstance(options, Mapping):
        pairs = (f"{key}: {_value(value)}" for key, value in options.items())
        return f"{kind}: {{{', '.join(pairs)}}}"
    return f"{kind}: {_value(options)}"


def _value(value: object) -> str:
    if isinstance(value, list):
        return f"[{', '.join(map(_value, value))}]"
    return _name(value) if isinstance(value, str) else json.dumps(value)


def _also(packages: Collection[Package], faults: Sequence[str]) -> Iterator[str]:
    """Yield comments about the parts of the workspace that do not run."""
    robots = {package.name: files(package, PATTERNS) for package in packages}
    interfaces = {package.name: sorted(package.interfaces) for package in packages}
    if faults:
        yield from ("", "# Skipped, because it cannot run in the browser as it is:")
        yield from (f"#   {fault}" for fault in faults)
    yield from _list(robots, "# Robot descriptions, for nodes such as robot_state_publisher:")
    yield from _list(interfaces, "# Messages, services and actions that all nodes can use:")


def _list(found: Mapping[str, Sequence[str]], *heading: str) -> Iterator[str]:
    if any(found.values()):
        yield from ("", *heading)
    for name, names in found.items():
        if names:
            more = f" and {len(names) - LISTED} more" if len(names) > LISTED else ""
            yield f"#   {name}: {', '.join(names[:LISTED])}{more}"


def _plain(text: str) -> str:
    """Return text as Markdown, without the meaning of its signs."""
    return _MARKS.sub(lambda found: f"\\{found[0]}", text)


def _name(name: str) -> str:
    """Return a name as YAML, in quotes only if it needs them."""
    plain = re.fullmatch(r"[A-Za-z/][\w./ +()-]*", name, re.ASCII) and yaml.safe_load(name) == name
    return name if plain else _text(name)


def _text(text: str) -> str:
    """Return text as a YAML string."""
    return json.dumps(text, ensure_ascii=False)
