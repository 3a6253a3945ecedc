"""Read the content of a page: Markdown and widgets."""

from __future__ import annotations

import re
from collections.abc import Iterator, Mapping
from dataclasses import dataclass, replace
from pathlib import Path

from sitegen.config import notebooks, scene
from sitegen.config.bag import KIND as BAG
from sitegen.config.bag import bag
from sitegen.config.blocks import CELL, EXAMPLE, NEARLY_EXAMPLE, Block, misplaced, split
from sitegen.config.document import Value, parse, read
from sitegen.config.files import locate
from sitegen.config.layout import layout
from sitegen.config.ownpanel import WORD, own_panel
from sitegen.config.panel import panel
from sitegen.config.section import Section, check, conforms
from sitegen.config.widgetkeys import LAYOUTS, MARKDOWN, ROBOTS, WIDGETS
from sitegen.errors import Location, Problems, nearest
from sitegen.model import Cell, Layout, Markdown, Node, Part, Source, Widget


@dataclass(frozen=True)
class Reader:
    """Reads the content of one page, whose widgets may use `nodes`; `folder` is the page's own."""

    nodes: Mapping[str, Node]
    problems: Problems
    notes: Problems
    folder: Path

    def items(self, value: Value) -> Iterator[Part]:
        """Yield the parts that `content` in site.yaml describes; it is a list or a single item."""
        for item in value.items() if value.kind == "list" else [value]:
            kind = self._kind(item, (MARKDOWN.name, *LAYOUTS, *WIDGETS))
            if kind:
                yield from self._part(*kind)

    def _part(self, kind: str, value: Value) -> Iterator[Part]:
        if kind == MARKDOWN.name:
            yield from self._markdown_item(value)
        elif kind in LAYOUTS:
            found = layout(kind, value, self.items, self._known, self.problems)
            if found:
                yield found
        else:
            yield from self._widget(kind, value)

    def markdown(self, text: str, start: Location, folder: Path) -> Iterator[Part]:
        """Yield the prose and the widgets of Markdown text."""
        for block in split(text):
            location = replace(start, line=start.line + block.line)
            if block.info is None:
                for line in misplaced(block.text):
                    place = replace(location, line=location.line + line)
                    message = (
                        "a block of widgets cannot stand in a list, a tab or a quotation; "
                        "begin its lines at the margin, or show it as code in a longer fence"
                    )
                    self.problems.add(place, "ros", message)
                yield Markdown(block.text, folder, location)
            else:
                yield from self._block(block, location)

    def jupyter(self, value: Value) -> Iterator[Widget]:
        """Yield JupyterLab, with the options in `value`."""
        found = notebooks.jupyter(value, self.problems, self.folder)
        if found:
            yield found

    def _markdown_item(self, value: Value) -> Iterator[Part]:
        if not conforms(value, MARKDOWN, self.problems):
            return
        if "\n" in value.text or not value.text.endswith(".md"):
            yield from self.markdown(value.text, value.text_start, self.problems.root)
            return
        file = locate(value, self.problems)
        text = read(file, self.problems) if file else None
        if file and text is not None:
            yield from self.markdown(text, Location(file, 1), file.parent)

    def _block(self, block: Block, location: Location) -> Iterator[Part]:
        fence = replace(location, line=location.line - 1)
        if not block.closed:
            self.problems.add(fence, "ros", "this block is not closed; close it with ```")
            return
        info = block.info or ""
        if cell := CELL.match(info):
            name = "Python" if cell["language"] == "python" else "JavaScript"
            if rest := info[cell.end() :].strip():
                message = f"a cell must begin with '{cell[0]}' alone, found '{rest}'; remove it"
                self.problems.add(fence, "ros", message)
            elif not block.text.strip():
                self.problems.add(fence, "ros", f"this cell is empty; write {name} into it")
            elif name == "Python":
                yield notebooks.cell(block.text, location)
            else:
                yield Widget(notebooks.JAVASCRIPT, "", {"text": block.text}, location)
            return
        example = EXAMPLE.match(info)
        if not example and info.split()[:1] != ["ros"]:
            wanted = "```yaml ros" if NEARLY_EXAMPLE.match(info) else "```ros"
            message = (
                f"a block of widgets begins with {wanted}, found '{info}'; "
                f"write {wanted}, or choose another language for code"
            )
            self.problems.add(fence, "ros", message)
            return
        if not example and info != "ros":
            message = (
                f"a block must begin with 'ros' alone, found '{info}'; "
                "move the rest inside the block"
            )
            self.problems.add(fence, "ros", message)
            return
        widgets = tuple(self._widgets(block, location))
        if not example:
            yield from widgets
        elif widgets:
            # A fence that no line of the YAML can close.
            edge = max(re.findall("`{3,}", block.text), key=len, default="``") + "`"
            code = f"{edge}yaml{info[example.end() :]}\n{block.text}\n{edge}"
            cells = (Cell((Markdown(code, self.folder, fence),)), Cell(widgets))
            yield Layout("example", cells, fence)

    def _widgets(self, block: Block, location: Location) -> Iterator[Part]:
        empty = "this block is empty; add a widget, like 'console: talker'"
        value = parse(block.text, location, self.problems, key="ros", empty=empty)
        widgets = value.items() if value and value.kind == "list" else [value]
        for item in filter(None, widgets):
            kind = self._kind(item, (*WIDGETS, *LAYOUTS))
            if kind:
                yield from self._part(*kind)

    def _kind(self, item: Value, known: tuple[str, ...]) -> tuple[str, Value] | None:
        if item.kind != "mapping":
            message = f"expected one of {', '.join(known)}, found {item.found}"
            like = f"{item.text}:" if item.text in WIDGETS else "console: talker"
            self.problems.add(item.location, item.label, f"{message}; write it like '{like}'")
            return None
        entries = item.entries(self.problems)
        if len(entries) != 1:
            given = ", ".join(f"'{name}'" for name in entries) or "none"
            message = f"expected one key, found {given}; begin every widget with '- '"
            self.problems.add(item.location, item.label, message)
            return None
        name, value = next(iter(entries.items()))
        if name not in known:
            message = f"unknown widget '{name}'; {nearest(name, known)}"
            self.problems.add(value.location, value.key, message)
            return None
        return name, value

    def _widget(self, kind: str, value: Value) -> Iterator[Part]:
        if kind == scene.KIND:
            found = scene.scene(value, self.problems, self.notes, self.folder)
            if found:
                yield found
            return
        if kind == notebooks.KIND:
            yield from self.jupyter(value)
            return
        if kind == notebooks.CELLS:
            yield from notebooks.notebook(value, self.problems, self.folder)
            return
        if kind == BAG:
            found = bag(value, self.problems, self.folder)
            if found:
                yield found
            return
        if kind == WORD:
            own = own_panel(value, self.problems, self.folder)
            if own:
                yield own
            return
        if kind == "robot":
            yield from self._robot(value)
            return
        if kind == "source":
            yield from self._source(value)
            return
        keys = WIDGETS[kind]
        if not any(key.name == "node" for key in keys):
            yield from self._panel(kind, value)
            return
        if value.kind == "mapping":
            section = check(value, keys, self.problems)
            node = section.get("node")
            options = {key.name: section.option(key.name) for key in keys if not key.required}
        else:
            short = replace(keys[0], example=f"{kind}: talker")
            node = value if conforms(value, short, self.problems) else None
            options = {key.name: key.default for key in keys if not key.required}
        if node and self._known(node):
            yield Widget(kind, node.text, options, value.location)

    def _known(self, node: Value) -> bool:
        if node.text in self.nodes:
            return True
        message = f"no node '{node.text}'; {nearest(node.text, self.nodes)}"
        self.problems.add(node.location, node.key, message)
        return False

    def _source(self, value: Value) -> Iterator[Source]:
        """Yield a source file to show; it is located later, when the files of nodes are known."""
        keys = WIDGETS["source"]
        if value.kind == "mapping":
            section = check(value, keys, self.problems)
            node = section.get("node")
        else:
            section = Section(value, keys, {})
            short = replace(keys[0], example="source: talker")
            node = value if conforms(value, short, self.problems) else None
        if node and not self._known(node):
            return
        file, region, lines = map(section.text, ("file", "region", "lines"))
        if not node and not file:
            if value.kind == "mapping" and not value.has("node", "file"):
                message = "needs a node or a file; write it like 'source: talker'"
                self.problems.add(value.location, value.key, message)
            return
        if lines and region:
            message = "cannot be combined with 'region'; keep one of the two"
            self.problems.add(value.location, f"{value.key}.lines", message)
        first, _, last = lines.partition("-")
        yield Source(
            target=node.text if node else "",
            file=file,
            folder=self.folder,
            location=value.location,
            lines=(int(first), int(last)) if lines else None,
            region=region,
            node=self.nodes[node.text] if node else None,
        )

    def _panel(self, kind: str, value: Value) -> Iterator[Widget]:
        """Yield a widget that is about the whole page."""
        options = panel(kind, value, self.problems)
        if options is None:
            return
        # Those that a terminal starts; what is no list has been reported.
        given = value.entries(self.problems).get("nodes") if value.kind == "mapping" else None
        if kind == "terminal" and given and given.kind == "list":
            for node in given.items():
                self._known(node)
        yield Widget(kind, "", options, value.location)

    def _robot(self, value: Value) -> Iterator[Widget]:
        """Yield a robot; its kind decides which options it has."""
        section = check(value, WIDGETS["robot"], self.problems)
        kind = section.get("kind")
        if not kind:
            return
        if kind.text not in ROBOTS:
            message = f"unknown robot '{kind.text}'; {nearest(kind.text, ROBOTS)}"
            self.problems.add(kind.location, kind.key, message)
            return
        own = ROBOTS[kind.text]
        for name, entry in section.entries.items():
            if name not in ("kind", *own):
                message = f"a {kind.text} has no '{name}'; it has {' and '.join(own)}"
                self.problems.add(entry.location, entry.key, message)
        given = {name: section.option(name) for name in ("kind", *own)}
        yield Widget("robot", "", given, value.location)
