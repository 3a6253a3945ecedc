"""Check a site without compiling anything."""

from __future__ import annotations

from collections.abc import Sequence
from pathlib import Path

from sitegen.build import make
from sitegen.cache.folder import cache_folder
from sitegen.commands import notebooks, wiring
from sitegen.errors import Problems, SiteError, relative
from sitegen.interfaces.descriptions import described
from sitegen.model import Markdown, Site
from sitegen.nodes.cpp.jobs import Job
from sitegen.nodes.cpp.libraries import not_installed
from sitegen.nodes.programs import jobs_of, nodes_of
from sitegen.options import Options
from sitegen.report import Report
from sitegen.site.prose import without_text
from sitegen.workspace.absent import absent, clone, without
from sitegen.workspace.libraries import UNAVAILABLE
from sitegen.workspace.unsupported import unsupported_libraries


def check(folder: Path, report: Report, *, strict: bool = False) -> tuple[Site, list[str]]:
    """Return the site of `folder` and its warnings, each a complete line.

    Raises: SiteError if a build would fail, or if `strict` and there are warnings.
    """
    site = make(folder, report, options=Options(compile=False)).site
    jobs = jobs_of(site, nodes_of(site), cache=cache_folder())
    warnings = [*site.notes, *_absent(site, jobs), *_libraries(site, jobs)]
    warnings += [*_definitions(site, jobs), *_images(site)]
    warnings += wiring.warnings(site)
    warnings += notebooks.warnings(site, report)
    warnings = list(dict.fromkeys(warnings))
    if strict and warnings:
        raise SiteError(warnings)
    return site, warnings


def _absent(site: Site, jobs: Sequence[Job]) -> list[str]:
    """Return the packages that C++ nodes need and that have to be added to the workspace.

    They are warnings, because CMake may find them where the site is built.
    """
    # Jobs share most of what they need.
    packages = {each.path: each for job in jobs for each in (*job.needs, job.package)}
    return [
        f"{relative(path / 'CMakeLists.txt', site.root)}: '{package.name}' needs '{name}', "
        f"{clone(name)}"
        for path, package in packages.items()
        for name in absent(package, site.packages)
    ]


def _libraries(site: Site, jobs: Sequence[Job]) -> list[str]:
    """Return the programs that need libraries which no page can have or that are not installed.

    They are warnings, because a source may include a header only in builds for other platforms.
    """
    packages = {job.package.path: job.package for job in jobs}
    lacking = (*UNAVAILABLE, *not_installed())
    needs = {
        path: unsupported_libraries(each, site.packages, lacking) for path, each in packages.items()
    }
    return [
        f"{relative(job.package.path, site.root)}: '{name}' needs '{library.name}', "
        f"{without(library)}"
        for job in jobs
        for name in job.executables
        if (library := needs[job.package.path].get(name))
    ]


def _definitions(site: Site, jobs: Sequence[Job]) -> list[str]:
    """Return the errors in interfaces that C++ nodes may use.

    They are warnings, because a build succeeds if no program needs these interfaces.
    """
    names = [job.package.name for job in jobs if job.package.name in site.packages]
    try:
        described(site, names, cache=cache_folder())
    except SiteError as error:
        return error.lines
    return []


def _images(site: Site) -> list[str]:
    problems = Problems(site.root)
    texts = [part for page in site.pages for part in page.leaves if isinstance(part, Markdown)]
    texts += [site.look.footer] if site.look.footer else []
    for text in texts:
        for url, location in without_text(text):
            message = f"'{url}' has no alternative text; write ![what it shows](…)"
            problems.add(location, "image", message)
    return problems.lines
