"""Build a web site from a folder that contains a site.yaml."""

from __future__ import annotations

import shutil
import tempfile
from collections.abc import Sequence
from dataclasses import dataclass, replace
from pathlib import Path

from sitegen import config
from sitegen.cache.folder import cache_folder
from sitegen.errors import SiteError
from sitegen.model import Artifact, Programs, Site
from sitegen.nodes.prebuilt.resolve import resolve
from sitegen.nodes.programs import left_out, programs_of
from sitegen.options import PUBLISH, Options
from sitegen.report import Report
from sitegen.site import assets, bags, bundles, jupyter, offline, pages

# GitHub Pages also takes this file as the request to serve all files unchanged.
MARKER = ".nojekyll"
# Names the versions of a site, where there are several side by side.
VERSIONS = "versions.json"
FOREIGN = "contains files that sitegen did not write; empty it or choose another --output"
ONE_OF_MANY = "build another with --version, or choose another --output"


@dataclass(frozen=True)
class Made:
    """The result of a build: the site, its programs, and the files of `dist/`."""

    site: Site
    programs: Programs
    renderer: pages.Renderer
    rendered: Sequence[pages.Rendered]
    # The artifacts that belong to no page.
    others: Sequence[Artifact]
    artifacts: Sequence[Artifact]


def make(
    folder: Path, report: Report, *, output: Path | None = None, options: Options = PUBLISH
) -> Made:
    """Make all files of the site of `folder`.

    Raises: SiteError if anything is wrong with the site, or if `output` must not be replaced.
    """
    # In a checkout, the bundles may be older than the modules of the runtime.
    bundles.refresh(report)

    # Load site.yaml into a Site and scan the workspace that it names.
    with report.during("site.yaml", "reading it, and the workspace"):
        site = config.load(folder / "site.yaml")
    if options.live:
        site = replace(site, offline=None)
    if options.version:
        url = f"{site.url}{options.version}/" if site.url else ""
        site = replace(site, version=options.version, url=url)
    if output:
        check_output(output)
        if (output / VERSIONS).exists():
            raise SiteError([f"{output} contains versions of a site; {ONE_OF_MANY}"])

    # Compile C++ nodes to WebAssembly, pack Python nodes into archives, fetch prebuilt nodes.
    site, prebuilt = resolve(site, cache=cache_folder(), report=report)
    programs = programs_of(site, prebuilt, options=options, cache=cache_folder(), report=report)

    # Convert the bags that pages cannot read, and put panels beside those with a page of their own.
    bags.convert(site, report)
    site = bags.with_views(site)
    # Show each notebook of a JupyterLab as a page, too.
    site = jupyter.with_pages(site)

    # Render Markdown pages to HTML, each with its page.json.
    with report.during("pages", f"rendering {len(site.pages)}"):
        renderer = pages.Renderer(site, programs)
        rendered = renderer.every_page()
        artifacts = renderer.site_artifacts(rendered)
    notes = [*left_out(programs), *site.notes, *(note for page in rendered for note in page.notes)]
    site = replace(site, notes=tuple(dict.fromkeys(notes)))

    # These artifacts, and the files that they refer to, make up the site.
    others = assets.runtime(site, programs, debug=options.debug)
    others += assets.search(site)
    others += jupyter.artifacts(site, cache_folder(), report)
    if not options.live:
        with report.during("search", "writing the index"):
            others += renderer.index(rendered)
    others += {file.path: file for one in programs.values() for file in one.files}.values()
    others.append(Artifact(MARKER, b"written by sitegen\n"))
    if site.deploy.cname:
        others.append(Artifact("CNAME", f"{site.deploy.cname}\n".encode()))
    # `sitegen serve` sends the headers that isolate pages.
    others += [] if options.live else offline.artifacts(site, [*artifacts, *others])
    artifacts += others
    check_paths(artifacts)
    return Made(site, programs, renderer, rendered, others, artifacts)


def check_output(output: Path) -> None:
    """Refuse to replace a folder that sitegen did not write.

    Raises: SiteError if `output` is such a folder, or a file.
    """
    if output.exists() and not output.is_dir():
        raise SiteError([f"{output} is a file; choose another --output"])
    if output.is_dir() and any(output.iterdir()) and not (output / MARKER).exists():
        raise SiteError([f"{output} {FOREIGN}"])


def check_paths(artifacts: Sequence[Artifact]) -> None:
    """Refuse two artifacts with the same path.

    Raises: SiteError that names both sources of each such path.
    """
    first: dict[str, Artifact] = {}
    problems = []
    for artifact in artifacts:
        other = first.setdefault(artifact.path, artifact)
        if other.source != artifact.source:
            sources = f"{origin(other)} and {origin(artifact)}"
            problems.append(f"{artifact.path}: two files of the site have this path: {sources}")
    if problems:
        raise SiteError(problems)


def origin(artifact: Artifact) -> str:
    """Return where an artifact comes from, for messages."""
    source = artifact.source
    return str(source) if isinstance(source, Path) else "a file that sitegen writes"


def write(artifacts: Sequence[Artifact], output: Path) -> None:
    """Write all artifacts to a new folder, then put it in place of the old one."""
    output = output.resolve()
    output.parent.mkdir(parents=True, exist_ok=True)
    with tempfile.TemporaryDirectory(dir=output.parent, prefix=f".{output.name}-") as temporary:
        fresh = Path(temporary) / "new"
        for artifact in artifacts:
            file = fresh / artifact.path
            file.parent.mkdir(parents=True, exist_ok=True)
            if isinstance(artifact.source, Path):
                shutil.copyfile(artifact.source, file)
            else:
                file.write_bytes(artifact.source)
        if output.exists():
            output.rename(Path(temporary) / "old")
        fresh.rename(output)
