"""Build one page of a site as one HTML file."""

from __future__ import annotations

import tempfile
from dataclasses import replace
from pathlib import Path

from sitegen import config, pagepath
from sitegen.build import make
from sitegen.errors import Problems, SiteError, nearest
from sitegen.model import Node, Page, Python, Ros2wasm, Site
from sitegen.report import Report, shown, size
from sitegen.site import assets, pages, single


def build_single(folder: Path, path: str, *, output: Path | None, report: Report) -> None:
    """Build one page of the site of `folder` as one HTML file, which works without a server.

    Raises: SiteError if the page cannot be one file, or if `output` must not be replaced.
    """
    site = config.load(folder / "site.yaml")
    page = check_single(site, path)
    name = page.path.strip("/").replace("/", "-") or "index"
    output = output or folder / f"{name}.html"
    if output.is_dir() or (
        output.exists() and single.HELD not in output.read_text("utf-8", "replace")
    ):
        raise SiteError([f"{output} was not written by sitegen; choose another --output"])
    made = make(folder, report)
    text, artifacts = pages.Renderer(made.site, made.programs).alone(page)
    if "<iframe" in text:
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
    report.say(f"built /{page.path} → {shown(output)}, {size(len(content))}")


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
        if why := _needs_server(node):
            problems.add(node.location, f"nodes.{name}", f"does not work in a single file: {why}")
    problems.raise_if_any()
    return page


def _needs_server(node: Node) -> str:
    if isinstance(node.kind, Python):
        return "Python nodes need a web server; remove the node or build the whole site"
    if isinstance(node.kind, Ros2wasm):
        return "ROS2WASM programs need a web server; remove the node or build the whole site"
    return ""
