"""Turn a folder with a site.yaml into a folder with a web site."""

from __future__ import annotations

import hashlib
import json
import shutil
import tempfile
import time
from collections.abc import Sequence
from dataclasses import dataclass, replace
from pathlib import Path

from sitegen import config, workspace
from sitegen.cache import unchanged
from sitegen.cache.folder import cache_folder
from sitegen.errors import Problems, SiteError, nearest
from sitegen.model import Artifact, Node, Page, Site
from sitegen.nodes.cpp import compiler
from sitegen.nodes.prebuilt import resolve, ros2wasm
from sitegen.nodes.python import archives as python
from sitegen.report import Report, size
from sitegen.site import assets, offline, pages, single
from sitegen.workspace import containers

# Also tells GitHub Pages to serve the files as they are.
MARKER = ".nojekyll"
# So many pages that run nothing are named; the others are counted.
SHOWN = 20
FOREIGN = "holds files that sitegen did not write; empty it or choose another --output"


@dataclass(frozen=True)
class Made:
    """What a folder with a site.yaml becomes: its site, its programs, the files of dist/."""

    site: Site
    builds: compiler.Builds
    bundles: python.Bundles
    programs: pages.Programs
    renderer: pages.Renderer
    rendered: Sequence[pages.Rendered]
    # Those that are not of pages.
    others: Sequence[Artifact]
    artifacts: Sequence[Artifact]


def build(folder: Path, *, output: Path, report: Report, debug: bool = False) -> None:
    """Build the site of `folder` into `output`, which stays as it was when anything is wrong.

    With `debug`, its C++ nodes tell where they failed.
    """
    begun = time.monotonic()
    made = make(folder, report, output=output, debug=debug)
    write(made.artifacts, output)
    summarize(made, report)
    pages, nodes = count(len(made.site.pages), "page"), count(len(nodes_of(made.site)), "node")
    report.say(
        f"built {pages}, {nodes} in {time.monotonic() - begun:.1f} s"
        f" → {shown(output)} (python -m http.server --directory {shown(output)})"
    )
    theirs = (page.theme for page in made.site.pages if page.theme)
    shelf = made.site.pyodide.packages
    shelves = [shelf] if isinstance(shelf, Path) else []
    roots = (made.site.workspace, made.site.theme, *theirs, *shelves)
    unchanged.note(folder, roots, output, cache_folder(), report.said[:-1], debug=debug)


def build_single(folder: Path, path: str, *, output: Path | None, report: Report) -> None:
    """Build one page of the site of `folder` as one HTML file, which works without a server."""
    site = config.load(folder / "site.yaml")
    page = check_single(site, path)
    name = page.path.strip("/").replace("/", "-") or "index"
    output = output or folder / f"{name}.html"
    if output.is_dir() or (
        output.exists() and single.HELD not in output.read_text("utf-8", "replace")
    ):
        raise SiteError([f"{output} is there and not of sitegen; choose another --output"])
    made = make(folder, report)
    text, artifacts = pages.Renderer(made.site, made.programs).alone(page)
    if "<iframe" in text:
        line = Problems(site.root).where(page.place)
        raise SiteError(
            [f"{line}: a single file shows no frame of another page; link to it instead"]
        )
    artifacts += assets.runtime(replace(made.site, pages=(page,)))
    artifacts += assets.programs(made.builds.items())
    known = {artifact.path: artifact for artifact in artifacts}
    content = single.single_file(made.site, page, text, known).encode()
    with tempfile.TemporaryDirectory(dir=output.resolve().parent, prefix=".sitegen-") as temporary:
        fresh = Path(temporary) / output.name
        fresh.write_bytes(content)
        fresh.replace(output)
    if not site.url:
        report.say("site.yaml has no url: links to other pages lead nowhere in the file")
    report.say(f"built /{page.path} → {shown(output)}, {size(len(content))}")


def check_single(site: Site, path: str) -> Page:
    """Return the page of that path, if it can be a single file."""
    wanted = f"{path.strip('/')}/".removeprefix("/")
    known = {page.path: page for page in site.pages}
    if wanted not in known:
        names = [page.path or "/" for page in site.pages]
        raise SiteError([f"no page '{path}' in site.yaml; {nearest(path, names)}"])
    page = known[wanted]
    problems = Problems(site.root)
    for name, node in page.nodes.items():
        if site.setup_of(node):
            message = "Python comes as files that look for each other on a server; leave it out"
        elif node.ros2wasm:
            message = "programs of ROS2WASM look for their files on a server; leave it out"
        else:
            continue
        problems.add(node.place, f"nodes.{name}", f"no node for a single file: {message}")
    problems.raise_if_any()
    return page


def make(
    folder: Path,
    report: Report,
    *,
    output: Path | None = None,
    compiling: bool = True,
    edited: bool = False,
    debug: bool = False,
    draft: bool = False,
) -> Made:
    """Make all files of the site of `folder`; refuse early an `output` not to be replaced.

    Without `compiling`, all is checked as always, and only the programs in C++ are missing. A site
    that is being `edited` is kept by no browser, and its index is for who serves it to make. As a
    `draft`, its programs are there sooner, and larger.
    """
    # site.yaml is loaded into a Site, and the workspace it names is scanned.
    site = config.load(folder / "site.yaml")
    if edited:
        site = replace(site, offline=None)
    if output:
        check_output(output)

    # Of nodes that the ROS2WASM project compiled, the types are looked up.
    foreign = ros2wasm.types_of(site, cache=cache_folder())

    # Nodes that were compiled elsewhere are fetched.
    site, given = resolve.resolve(site, cache=cache_folder(), report=report)

    # Python nodes become archives; what is wrong there is told before anything takes minutes.
    bundles = python.bundle(site, nodes_of(site), cache=cache_folder(), say=report.say)

    # C++ nodes become WebAssembly.
    engines = ["jspi", "asyncify"] if site.asyncify else ["jspi"]
    own = compiler.compile_nodes(
        jobs_of(site, nodes_of(site)) if compiling else [],
        engines,
        root=site.root,
        cache=cache_folder(),
        report=report,
        debug=debug,
        draft=draft and not debug,
    )
    builds = {**own, **given}

    # Markdown pages become HTML with a page.json each.
    types = {
        page.path: types_of(site, page, builds, bundles, foreign)
        for page in site.pages
        if assets.takes_part(page)
    }
    archives = assets.archives(bundles.archives)
    programs = pages.Programs(
        modules=assets.preloads(site),
        types=types,
        foreign=foreign,
        versions=assets.versions(builds.items()),
        archives=digests(archives),
        needed=bundles.needed,
        sizes={"": assets.python_size(), **bundles.sizes()},
        own=bundles.own,
        lines=assets.lines(builds.items()),
    )
    renderer = pages.Renderer(site, programs)
    rendered = renderer.every_page()
    artifacts = renderer.site_artifacts(rendered)

    # These, and what they use, are the site.
    others = assets.runtime(site, debug=debug)
    others += assets.search(site)
    others += [] if edited else renderer.index(rendered)
    others += assets.programs(builds.items())
    others += archives
    others += assets.scripts(site)
    others.append(Artifact(MARKER, b"written by sitegen\n"))
    if site.deploy.cname:
        others.append(Artifact("CNAME", f"{site.deploy.cname}\n".encode()))
    # The server of an author who edits isolates by itself.
    others += [] if edited else offline.artifacts(site, [*artifacts, *others])
    artifacts += others
    check_paths(artifacts)
    return Made(site, builds, bundles, programs, renderer, rendered, others, artifacts)


def nodes_of(site: Site) -> list[Node]:
    """Return the nodes that the pages run, each program once."""
    found = {
        n.ros2wasm.script if n.ros2wasm else (n.package, n.executable): n
        for page in site.pages
        for n in page.nodes.values()
    }
    return list(found.values())


def jobs_of(site: Site, nodes: Sequence[Node]) -> list[compiler.Job]:
    """Return what to compile, a job for each package."""
    executables: dict[str, list[str]] = {}
    jobs = []
    for node in nodes:
        if node.components:
            made = containers.package(node, site.packages, cache_folder())
            needed = (workspace.with_dependencies(site.packages, name) for name in made.depends)
            needs = {package.name: package for each in needed for package in each}
            jobs.append(compiler.Job(made, (node.executable,), tuple(needs.values())))
        elif not node.ros2wasm and not node.compiled and not site.setup_of(node):
            executables.setdefault(node.package, []).append(node.executable)
    for name, wanted in executables.items():
        *before, package = workspace.with_plugins(site.packages, name)
        jobs.append(compiler.Job(package, tuple(wanted), tuple(before)))
    return jobs


def types_of(
    site: Site,
    page: Page,
    builds: compiler.Builds,
    bundles: python.Bundles,
    foreign: ros2wasm.Types,
) -> dict[str, object]:
    """Return the message types that the nodes of `page` use, by name."""
    types: dict[str, object] = {}
    for name, node in page.nodes.items():
        if node.ros2wasm:
            types |= foreign[page.path][name]
        elif site.setup_of(node):
            types |= bundles.types[node.package]
        elif forms := builds.get((node.package, node.executable)):
            types |= json.loads(forms[0].types.read_text())
    return types


def digests(archives: Sequence[Artifact]) -> dict[str, str]:
    """Return a digest of the bytes of each archive, by its path."""
    return {
        artifact.path: hashlib.sha256(artifact.source).hexdigest()[:10]
        for artifact in archives
        if isinstance(artifact.source, bytes)
    }


def check_output(output: Path) -> None:
    """Refuse to replace a folder that sitegen did not write."""
    if output.exists() and not output.is_dir():
        raise SiteError([f"{output} is a file; choose another --output"])
    if output.is_dir() and any(output.iterdir()) and not (output / MARKER).exists():
        raise SiteError([f"{output} {FOREIGN}"])


def check_paths(artifacts: Sequence[Artifact]) -> None:
    """Refuse two artifacts on one path."""
    first: dict[str, Artifact] = {}
    problems = []
    for artifact in artifacts:
        other = first.setdefault(artifact.path, artifact)
        if other.source != artifact.source:
            sources = f"{origin(other)} and {origin(artifact)}"
            problems.append(f"{artifact.path}: two files of the site want this path: {sources}")
    if problems:
        raise SiteError(problems)


def origin(artifact: Artifact) -> str:
    """Say where an artifact comes from."""
    return str(artifact.source) if isinstance(artifact.source, Path) else "one that sitegen writes"


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


def summarize(made: Made, report: Report) -> None:
    """Say what the site consists of."""
    site = made.site
    for note in site.notes:
        report.say(note)
    untold = {page.path for page in [p for p in site.pages if not p.level][SHOWN:]}
    told = [page for page in site.pages if page.path not in untold]
    width = max(len(page.path) for page in told) + 1
    for page in told:
        report.say(f"  /{page.path:{width}} {page.level or '  '}  {page.title}")
    if untold:
        report.say(f"  … and {count(len(untold), 'page')} more, of text only")
    sizes = made.bundles.sizes()
    for node in nodes_of(site):
        if node.ros2wasm:
            total = sum(file.stat().st_size for file in node.ros2wasm.files)
            script = node.ros2wasm.script.relative_to(site.root).as_posix()
            report.say(f"  {script}: ROS2WASM {size(total)}")
            continue
        if site.setup_of(node):
            total = sum(sizes[path] for path in made.bundles.needed[node.package, node.executable])
            report.say(f"  {node.package}/{node.executable}: Python {size(total)}")
            continue
        forms = made.builds[node.package, node.executable]
        engines = ", ".join(f"{b.engine} {size(b.wasm.stat().st_size)}" for b in forms)
        report.say(f"  {node.package}/{node.executable}: {engines}")


def count(number: int, noun: str) -> str:
    """Write `number` of `noun`."""
    return f"{number} {noun}{'s'[: number != 1]}"


def shown(folder: Path) -> str:
    """Write a folder as one would type it here."""
    here = Path.cwd()
    path = folder.resolve()
    return f"{path.relative_to(here)}" if path.is_relative_to(here) and path != here else str(path)
