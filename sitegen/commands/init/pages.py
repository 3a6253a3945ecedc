"""Decide on the pages of a site: one for partners, for each launch file and for each robot."""

from __future__ import annotations

import re
from collections import Counter
from collections.abc import Collection, Iterable, Iterator, Mapping, Sequence
from dataclasses import dataclass, replace
from pathlib import Path

from sitegen.commands.init.members import Member
from sitegen.commands.init.panels import Item, panels, robot_panels, robot_views, views
from sitegen.commands.init.partners import together
from sitegen.commands.init.robots import Robot, moving
from sitegen.commands.init.runs import Launched, Runs
from sitegen.commands.init.turtle import KEY
from sitegen.config.paths import segment
from sitegen.model import Argument, Package

ENDING = re.compile(r"[._]?launch\.(py|xml|yaml)$")
# What tools write into a package.xml, for the author to replace.
PLACEHOLDER = re.compile(r"\W*(todo\b.*|(the )?[\w-]+ package|package description)\W*", re.I)
SENTENCE = re.compile(r"(?<=[^.\s]{2}[.!?])\s+(?=[A-Z])")
# A longer sentence is no title.
TITLE = 60


@dataclass(frozen=True)
class Page:
    """A page of the site: its programs, or the launch file that starts them.

    `views` are the widgets at its top, `panels` those at its end. A launch file without them has
    the widgets that sitegen chooses. `also` are launch files that start the same nodes, and
    `chosen` the arguments of the launch file that it needs.
    """

    path: str
    title: str
    text: str
    members: Sequence[Member]
    views: Sequence[Item]
    panels: Sequence[Item]
    launch: Path | None = None
    also: tuple[Path, ...] = ()
    chosen: Sequence[Argument] = ()

    @property
    def programs(self) -> str:
        """The executables that it runs, in words; those of other packages come last."""
        own = self.members[-1].package
        ordered = sorted(self.members, key=lambda member: member.package != own)
        return _listed([member.shown for member in ordered])

    @property
    def autostart(self) -> bool:
        """Whether its nodes start with it."""
        return bool(self.launch) or any(member.urdf for member in self.members)


def pages(runs: Runs, packages: Mapping[str, Package]) -> list[Page]:
    """Return the pages of a site; if there is only one, it is the home page."""
    robots = [(robot, moving(robot, runs.programs, packages)) for robot in runs.robots]
    found = list(_package_pages(runs, {one.key for _, own in robots for one in own}, packages))
    found += _launch_pages(runs.launches, found, packages)
    found += list(_robot_pages(robots, [page.path for page in found], packages))
    if len(found) == 1:
        return [replace(found[0], path="")]
    titles = Counter(page.title for page in found)
    return [_told_apart(page) if titles[page.title] > 1 else page for page in found]


def _package_pages(
    runs: Runs, shown: Collection[tuple[str, str]], packages: Mapping[str, Package]
) -> Iterator[Page]:
    """Yield the pages of packages; those of a large package are named by their first programs.

    Pages of `shown` programs alone are left out: they are on the page of a robot.
    """
    folders = {name: package.path for name, package in packages.items()}
    groups = together(runs.programs, folders)
    groups = [
        group
        for group in groups
        if not _shown(group, runs.launches) and not {member.key for member in group} <= {*shown}
    ]
    counts = Counter(group[-1].package for group in groups)
    for group in groups:
        owner, members = group[-1].package, list(_named(group))
        if counts[owner] == 1:
            title, text = _introduction(packages[owner])
            yield _page(f"{segment(owner)}/", title, text, members, packages)
        else:
            names = [member.name for member in members if member.package == owner]
            path = f"{segment(owner)}/{segment(names[0])}/"
            yield _page(path, _listed(names), "", members, packages)


def _launch_pages(
    launches: Iterable[Launched], others: Sequence[Page], packages: Mapping[str, Package]
) -> list[Page]:
    """Return the pages of launch files; `others` are those of packages."""
    found: list[Page] = []
    alike = _alike(launches)
    owners = Counter(group[0].package.name for group in alike)
    owners.update(page.members[-1].package for page in others)
    for group in alike:
        package = group[0].package
        page = _launch_page(group[0], [page.path for page in (*others, *found)], packages)
        title, _ = _introduction(package)
        if owners[package.name] == 1 and title != package.name:
            page = replace(page, title=title)
        also = tuple(each.package.path / each.file for each in group[1:])
        found.append(replace(page, also=also, chosen=group[0].chosen))
    return found


def _robot_pages(
    robots: Sequence[tuple[Robot, Sequence[Member]]],
    taken: Collection[str],
    packages: Mapping[str, Package],
) -> Iterator[Page]:
    """Yield a page for each robot with the programs that move it.

    It has the path of its package if nothing else has.
    """
    counts = Counter(robot.package.name for robot, _ in robots)
    used = {*taken}
    for robot, movers in robots:
        folder = f"{segment(robot.package.name)}/"
        alone = counts[robot.package.name] == 1 and not any(
            path.startswith(folder) for path in used
        )
        title, text = _introduction(robot.package) if alone else (robot.name, "")
        name = segment(robot.file.name.partition(".")[0])
        paths = (f"{folder}{name}{'-' * number}/" for number in range(len(robots) + 1))
        path = folder if alone else next(path for path in paths if path not in used)
        used.add(path)
        members = [*_named([robot.member, *movers])]
        top, end = robot_views(robot, movers), robot_panels(robot, movers, packages)
        yield Page(path, title, text, members, top, end)


def _told_apart(page: Page) -> Page:
    """Return a page with its folder in the title."""
    return replace(page, title=f"{page.title} ({page.path.partition('/')[0]})")


def _page(
    path: str,
    title: str,
    text: str,
    members: Sequence[Member],
    packages: Mapping[str, Package],
    launch: Path | None = None,
) -> Page:
    top, end = list(views(members)), list(panels(members, packages))
    return Page(path, title, text, members, top, end, launch)


def _launch_page(launch: Launched, taken: Collection[str], packages: Mapping[str, Package]) -> Page:
    parts = (launch.package.name, *_stem(launch).split("/"))
    path = "/".join(segment(part) for part in parts) + "/"
    kind = Path(launch.file).suffix.removeprefix(".")
    path = path if path not in taken else f"{path.removesuffix('/')}-{kind}/"
    file = launch.package.path / launch.file
    title = parts[-1].replace("_", " ").capitalize()
    has_window = any(member.key == KEY for member in launch.members)
    if launch.static and not launch.windows and not has_window:
        return _page(path, title, "", launch.members, packages, file)
    return Page(path, title, "", launch.members, (), (), file)


def _alike(launches: Iterable[Launched]) -> list[list[Launched]]:
    """Return launch files with one name that start the same nodes, in several formats, together."""
    found: dict[tuple[object, ...], list[Launched]] = {}
    for launch in launches:
        nodes = tuple((member.name, *member.key) for member in launch.members)
        found.setdefault((launch.package.name, _stem(launch), nodes), []).append(launch)
    return list(found.values())


def _stem(launch: Launched) -> str:
    return ENDING.sub("", launch.file.removeprefix("launch/")) or "launch"


def _introduction(package: Package) -> tuple[str, str]:
    """Return the title of a page and its text, by the description of the package."""
    told = package.description
    if not told or PLACEHOLDER.fullmatch(told):
        return package.name, ""
    first, *rest = SENTENCE.split(told, maxsplit=1)
    if len(first) > TITLE:
        return package.name, told
    return first.removesuffix("."), "".join(rest)


def _named(group: Sequence[Member]) -> Iterator[Member]:
    """Yield programs with names of their own."""
    taken: set[str] = set()
    for member in group:
        name = member.name if member.name not in taken else f"{member.package}_{member.name}"
        taken.add(name)
        yield replace(member, name=re.sub(r"\W", "_", name))


def _shown(group: Sequence[Member], launches: Iterable[Launched]) -> bool:
    """Return whether a launch file starts the programs of a page, and opens windows for them."""
    own = {member.key for member in group}
    return any(
        launch.windows and own <= {member.key for member in launch.members} for launch in launches
    )


def _listed(names: Sequence[str]) -> str:
    """Return the names of programs in words, short enough for a title."""
    title = " and ".join(filter(None, (", ".join(names[:-1]), names[-1])))
    return title if len(title) <= TITLE else f"{names[0]} and {len(names) - 1} more"
