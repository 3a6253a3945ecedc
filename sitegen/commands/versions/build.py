"""Build a version of a site into a folder with the others."""

from __future__ import annotations

import html
import time
from collections.abc import Iterable, Sequence
from dataclasses import replace
from pathlib import Path

from sitegen.build import MARKER, VERSIONS, Made, check_output, make, write
from sitegen.commands.summary import summary
from sitegen.commands.versions.listed import default, read, with_version, written
from sitegen.commands.versions.names import Version
from sitegen.model import Artifact
from sitegen.options import PUBLISH, Options
from sitegen.report import Report, count, shown
from sitegen.site.offline.worker import PATH as WORKER
from sitegen.site.offline.worker import RETIRED

HERE = Path(__file__).parent
# Hosts read these at the root only: there they are those of all versions, or of the default one.
SHARED, OF_DEFAULT = {MARKER, "CNAME"}, ("404.html", "robots.txt")


def build_version(
    folder: Path,
    version: Version,
    *,
    output: Path,
    report: Report,
    options: Options = PUBLISH,
    verbose: bool = False,
) -> None:
    """Build the site of `folder` as a version of it into `output`, which keeps the others.

    Raises: SiteError if anything is wrong; `output` stays as it was.
    """
    begun = time.monotonic()
    check_output(output)
    made, artifacts = assemble(folder, version, output, report, options)
    write(artifacts, output)
    for line in summary(made.site, made.programs, made.artifacts, verbose=verbose):
        report.say(line)
    report.say(
        f"built version {version.name} of {count(len(read(output)), 'version')} in"
        f" {time.monotonic() - begun:.1f} s → {shown(output / version.name)}"
        f" (python -m http.server --directory {shown(output)})",
        "good",
    )


def assemble(
    folder: Path, version: Version, before: Path, report: Report, options: Options = PUBLISH
) -> tuple[Made, list[Artifact]]:
    """Make the site of `folder` as a version of it, beside the other versions in `before`.

    What else is in `before`, such as a site without versions, does not stay.
    """
    versions = with_version(read(before), version)
    made = make(folder, report, options=replace(options, version=version.name))
    own = [each for each in made.artifacts if each.path not in SHARED]
    artifacts = [Artifact(f"{version.name}/{each.path}", each.source) for each in own]
    for other in versions:
        if other.name != version.name:
            artifacts += _kept(before, (other.name, *other.aliases))
    [this] = (each for each in versions if each.name == version.name)
    pages = [each.path.removesuffix("index.html") for each in own if _is_page(each.path)]
    for alias in this.aliases:
        for page in pages:
            up = "../" * (page.count("/") + 1)
            target = f"{up}{version.name}/{page}"
            artifacts.append(_redirect(made, f"{alias}/{page}index.html", target, root=up))
    first = default(versions)
    artifacts.append(_redirect(made, "index.html", f"{first.name}/", root=""))
    artifacts.append(Artifact("redirect.js", HERE / "redirect.js"))
    artifacts.append(Artifact(VERSIONS, written(versions)))
    artifacts += [each for each in made.artifacts if each.path in SHARED]
    at_root = {f"{first.name}/{name}": name for name in OF_DEFAULT}
    artifacts += [
        Artifact(at_root[each.path], each.source) for each in artifacts if each.path in at_root
    ]
    if any(each.path == WORKER for each in own):
        # Visitors may have one from before there were versions, which would keep its pages.
        artifacts.append(Artifact(WORKER, RETIRED))
    return made, artifacts


def _is_page(path: str) -> bool:
    return path == "index.html" or path.endswith("/index.html")


def _kept(before: Path, folders: Sequence[str]) -> Iterable[Artifact]:
    for folder in folders:
        for file in sorted(before.joinpath(folder).rglob("*")):
            if file.is_file():
                yield Artifact(file.relative_to(before).as_posix(), file)


def _redirect(made: Made, path: str, target: str, *, root: str) -> Artifact:
    text = (HERE / "redirect.html").read_text(encoding="utf-8")
    site = made.site
    names = {"language": site.language, "title": site.title, "target": target, "root": root}
    page = text.format_map({name: html.escape(value) for name, value in names.items()})
    return Artifact(path, page.encode())
