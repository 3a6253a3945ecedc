"""Build one page of a site as one HTML file."""

from __future__ import annotations

import tempfile
from collections.abc import Collection, Iterable, Iterator
from dataclasses import replace
from pathlib import Path

from sitegen import config, pagepath
from sitegen.build import make
from sitegen.errors import Problems, SiteError, nearest
from sitegen.model import Layout, Markdown, Page, Part, Python, Ros2wasm, Site, Widget
from sitegen.nodes.python import pyodide
from sitegen.options import PUBLISH, Options
from sitegen.report import Report, shown, size
from sitegen.shipped import DEFAULT_THEME
from sitegen.site import assets, pages, single
from sitegen.site.pages import discovery
from sitegen.site.pages.texts import texts


def build_single(
    folder: Path,
    path: str,
    *,
    output: Path | None,
    report: Report,
    with_python: bool = False,
    options: Options = PUBLISH,
) -> None:
    """Build one page of the site of `folder` as one HTML file, which needs no server.

    Its Python nodes are left out unless `with_python`.

    Raises: SiteError if the page cannot be one file, or if `output` must not be replaced.
    """
    site = config.load(folder / "site.yaml")
    page = check_single(site, path)
    python = [name for name, node in page.nodes.items() if isinstance(node.kind, Python)]
    name = page.path.strip("/").replace("/", "-") or "index"
    output = output or folder / f"{name}.html"
    if output.is_dir() or (
        output.exists() and single.HELD not in output.read_text("utf-8", "replace")
    ):
        raise SiteError([f"{output} was not written by sitegen; choose another --output"])
    if python and not with_python:
        page = _without(page, python, _notice(site, page, python))
    made = make(folder, report, options=options)
    text, artifacts = pages.Renderer(made.site, made.programs).alone(page)
    if "<iframe" in text or any(isinstance(p, Widget) and p.kind == "jupyter" for p in page.leaves):
        line = Problems(site.root).where(page.location)
        raise SiteError([f"{line}: a single file cannot embed another page; link to it instead"])
    artifacts += assets.runtime(replace(made.site, pages=(page,)), made.programs)
    artifacts += (file for program in made.programs.values() for file in program.files)
    known = {artifact.path: artifact for artifact in artifacts}
    content = single.single_file(made.site, page, text, known).encode()
    with tempfile.TemporaryDirectory(dir=output.resolve().parent, prefix=".sitegen-") as temporary:
        fresh = Path(temporary) / output.name
        fresh.write_bytes(content)
        fresh.replace(output)
    if not site.url:
        report.say("site.yaml has no url, so links to other pages do not work in the file")
    if python:
        interpreter = single.packed_size(file.read_bytes() for file in pyodide.files())
        names = ", ".join(python)
        if with_python:
            report.say(f"Python for {names}: {size(interpreter)} of the file, without packages")
        else:
            how = f"--with-python embeds Python ({size(interpreter)} and the packages of the nodes)"
            report.say(f"left out: {names}; {how}", "warning")
    report.say(f"built /{page.path} → {shown(output)}, {size(len(content))}", "good")


def check_single(site: Site, path: str) -> Page:
    """Return the page with that path.

    Raises: SiteError if there is none, or if it cannot be a single file.
    """
    wanted = pagepath.normalized(path)
    known = {page.path: page for page in site.pages}
    if wanted not in known:
        names = [page.path or "/" for page in site.pages]
        raise SiteError([f"no page '{path}' in site.yaml; {nearest(path, names)}"])
    page = known[wanted]
    problems = Problems(site.root)
    for name, node in page.nodes.items():
        if isinstance(node.kind, Ros2wasm):
            why = "ROS2WASM programs need a web server; remove the node or build the whole site"
            message = f"does not work in a single file: {why}"
            problems.add(node.location, f"nodes.{name}", message)
    problems.raise_if_any()
    return page


def _notice(site: Site, page: Page, names: Collection[str]) -> Markdown:
    """Return the text that replaces the widgets of nodes that are left out."""
    said = texts((DEFAULT_THEME, page.theme or site.theme), page.language or site.language)
    text = said.left_out.format(", ".join(f"`{name}`" for name in names))
    if site.url:
        text += f" [{said.left_out_where}]({discovery.url(site, page)})"
    return Markdown(f"!!! note\n    {text}\n", site.root, page.location)


def _without(page: Page, names: Collection[str], notice: Markdown) -> Page:
    """Return the page without the nodes `names`; the notice replaces their first widget."""
    nodes = {name: node for name, node in page.nodes.items() if name not in names}
    return replace(page, nodes=nodes, content=tuple(_kept(page.content, names, [notice])))


def _kept(
    content: Iterable[Part], names: Collection[str], notices: list[Markdown]
) -> Iterator[Part]:
    for part in content:
        if isinstance(part, Layout):
            cells = (
                replace(cell, content=tuple(_kept(cell.content, names, notices)))
                for cell in part.cells
            )
            yield replace(part, cells=tuple(cells))
        elif not isinstance(part, Widget) or part.target not in names:
            yield part
        elif notices:
            yield notices.pop()
