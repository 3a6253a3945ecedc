"""Find the files that the editors of a page edit."""

from __future__ import annotations

from pathlib import Path

from sitegen.errors import Problems, nearest, relative
from sitegen.model import Node, Package, Page, Python, Setup, Site, Widget
from sitegen.site.pages.blocks import slots_of

_LARGEST = 200_000


def edited(site: Site, page: Page, problems: Problems) -> dict[str, dict[str, str]]:
    """Return, by slot id, the installed path, the name and the text of each editor's file.

    Errors are reported.
    """
    found = {}
    for widget, slot in slots_of(page):
        if widget.kind == "editor":
            node = page.nodes[widget.target]
            known = _file(site, node, widget, problems)
            if known:
                found[slot.id] = known
    return found


def _file(site: Site, node: Node, widget: Widget, problems: Problems) -> dict[str, str] | None:
    package = site.packages.get(node.package)
    setup = node.kind.setup if isinstance(node.kind, Python) else None
    if not setup or not package or not package.path.is_relative_to(site.root):
        message = f"'{node.name}' has no Python source in this workspace; use 'source' instead"
        problems.add(widget.location, "editor", message)
        return None
    files = {relative(file, package.path): path for path, file in setup.files.items()}
    name = str(widget.options.get("file") or "") or _main(setup, node, package)
    if name not in files or not _is_python(package.path / name, files[name]):
        modules = [n for n, path in files.items() if _is_python(package.path / n, path)]
        message = (
            f"no Python file '{name}' of {package.name} is installed; {nearest(name, modules)}"
        )
        problems.add(widget.location, "editor", message)
        return None
    try:
        text = (package.path / name).read_text(encoding="utf-8-sig")
    except UnicodeDecodeError:
        problems.add(
            widget.location, "editor", f"'{name}' is not a UTF-8 text file; choose another"
        )
        return None
    if len(text) > _LARGEST:
        problems.add(widget.location, "editor", f"'{name}' is too large to edit; choose another")
        return None
    return {"file": name, "place": files[name], "text": text.replace("\r\n", "\n")}


def _main(setup: Setup, node: Node, package: Package) -> str:
    """Return the file with the entry point of a node's executable."""
    module, _, attribute = setup.scripts[node.executable].partition(":")
    if not attribute:
        return relative(setup.files[module], package.path)
    stem = f"python/{module.replace('.', '/')}"
    found = (setup.files.get(f"{stem}{end}") for end in (".py", "/__init__.py"))
    return next((relative(file, package.path) for file in found if file), f"{module}.py")


def _is_python(file: Path, path: str) -> bool:
    return file.suffix == ".py" or path.startswith("lib/")
