"""The command: look at the workspace, decide on pages, write site.yaml."""

from __future__ import annotations

from collections.abc import Iterator, Mapping
from dataclasses import replace
from pathlib import Path

from sitegen import workspace
from sitegen.commands import installed, schema
from sitegen.commands.github import workflows
from sitegen.commands.init import siteyaml
from sitegen.commands.init.pages import pages
from sitegen.commands.init.runs import runs
from sitegen.errors import Problems, SiteError, relative
from sitegen.model import Package
from sitegen.report import Report
from sitegen.workspace.absent import CATKIN, absent, clone

FILE = "site.yaml"


def init(folder: Path, report: Report, *, github: bool = False) -> None:
    """Write a site.yaml and its schema; existing files are left unchanged.

    For `github`, also write workflows; then a site.yaml may exist already.
    """
    # Errors are reported before anything is written.
    what = installed.requirement() if github else None
    files = workflows(folder.resolve(), what) if what else {}
    if not github or not (folder / FILE).exists():
        _write_site(folder, report)
    for file, text in files.items():
        file.parent.mkdir(parents=True, exist_ok=True)
        file.write_text(text, encoding="utf-8")
        report.say(f"wrote {file}")
    if what:
        report.say(f"the workflows install {what.text}")
    if what and what.note:
        report.say(f"check SITEGEN in both workflows: {what.note}", "warning")
    source = "Settings → Pages of the repository"
    then = f"push, and choose GitHub Actions at {source}" if github else "sitegen serve"
    report.say(f"now: {then}")


def _write_site(folder: Path, report: Report) -> None:
    file = folder / FILE
    if file.exists():
        raise SiteError([f"{file} already exists; remove or edit it"])
    schema.check_free(folder)
    root = folder.resolve()
    problems = Problems(root)
    packages = workspace.with_replaced(workspace.scan(root, {}, problems))
    problems.raise_if_any()
    links = Problems(root)
    workspace.report_outside(root, links)
    found = runs(root, packages)
    found = replace(found, faults=[*found.faults, *links.lines])
    if not found.programs and not found.launches and not found.robots:
        raise SiteError([_nothing(root, packages), *found.faults, *_unmet(packages)])
    shown = pages(found, packages)
    text = siteyaml.text(root, shown, packages.values(), found.faults)
    file.write_text(text, encoding="utf-8")
    for page in shown:
        launch = ", ".join(relative(each, root) for each in filter(None, (page.launch, *page.also)))
        report.say(f"  /{page.path}  {launch or page.programs}")
    for name in workspace.replaced(packages):
        report.say(f"  {name}: needs Qt, so pages run the {name} that comes with sitegen")
    for name, package in packages.items():
        if package.build_type != CATKIN and package.executables is None:
            report.say(f"  {name}: its executables are known only to CMake; add the ones you want")
    for fault in found.faults:
        report.say(f"  skipped: {fault}")
    for line in _unmet(packages):
        report.say(f"  {line}", "warning")
    report.say(f"wrote {file}")
    report.say(f"wrote {schema.write(folder)}")


def _unmet(packages: Mapping[str, Package]) -> Iterator[str]:
    """Yield what packages need that the workspace lacks, and which are for ROS 1."""
    for name, package in packages.items():
        if package.build_type == CATKIN:
            yield f"{name}: is for ROS 1 (catkin); use its version for ROS 2"
        for need in absent(package, packages):
            yield f"{name}: needs '{need}', {clone(need)}"


def _nothing(folder: Path, packages: Mapping[str, Package]) -> str:
    if not packages:
        return f"{folder}: no ROS package found in this folder; give the folder of a workspace"
    names = ", ".join(packages)
    return f"{folder}: no package has an executable that can run in the browser: {names}"
