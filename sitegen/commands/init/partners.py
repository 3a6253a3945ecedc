"""Decide which programs stand on one page: partners do, in one package or in several."""

from __future__ import annotations

from collections.abc import Iterator, Mapping, Sequence
from itertools import groupby
from pathlib import Path

from sitegen.commands.init.members import Member
from sitegen.commands.init.turtle import KEY, TURTLESIM, turtlesim
from sitegen.commands.wiring.endpoint import (
    ACTION_CLIENT,
    CLIENT,
    OPPOSITE,
    PUBLISHER,
    SUBSCRIPTION,
    Endpoint,
)

# A page has all programs of a package, up to this number.
MANY = 6
# A page has at most this many programs of other packages.
GUESTS = 3
# A program with one of these waits for another program. Commands are the exception: visitors give
# them, and who gives them waits for a robot.
WAITS = (SUBSCRIPTION, CLIENT, ACTION_CLIENT)
COMMANDS = ("geometry_msgs/msg/Twist", "geometry_msgs/msg/TwistStamped")


def together(programs: Sequence[Member], folders: Mapping[str, Path]) -> list[list[Member]]:
    """Return the programs of each page; `folders` are those of their packages.

    The programs of a large package are on several pages, those that communicate on one. Programs of
    other packages that a page cannot do without come first on it. A page whose programs are all on
    another one is left out.
    """
    found: list[list[Member]] = []
    for _, package in groupby(programs, lambda each: each.package):
        own = list(package)
        groups = [own] if len(own) <= MANY else list(_communicating(own))
        near = sorted(programs, key=lambda each: -_shared(folders, each.package, own[0].package))
        found += [[*_guests(group, near), *group] for group in groups]
    return [page for place, page in enumerate(found) if not _elsewhere(place, found)]


def needed(member: Member, page: Sequence[Member]) -> list[Member]:
    """Return a program of a page for each service and action that `member` calls."""
    found: dict[str, Member] = {}
    for asked in member.endpoints(CLIENT, ACTION_CLIENT):
        servers = [other for other in page if other.answers(asked)]
        if servers and member not in servers:
            found[servers[0].name] = servers[0]
    return list(found.values())


def waiting(page: Sequence[Member], *kinds: str) -> Iterator[Endpoint]:
    """Yield the endpoints of these kinds for which a page has no counterpart."""
    for member in page:
        for endpoint in member.endpoints(*kinds):
            if not any(other.answers(endpoint) for other in page):
                yield endpoint


def _communicating(programs: Sequence[Member]) -> Iterator[list[Member]]:
    """Yield groups of programs that communicate with each other, in the order of `programs`."""
    left = list(programs)
    while left:
        group, unseen = [left[0]], [left[0]]
        while unseen:
            one = unseen.pop()
            ends = list(one.endpoints(*OPPOSITE))
            more = [each for each in left if each not in group and any(map(each.answers, ends))]
            group += more
            unseen += more
        left = [each for each in left if each not in group]
        yield [each for each in programs if each in group]


def _guests(page: Sequence[Member], programs: Sequence[Member]) -> list[Member]:
    """Return the programs of other packages for which those of a page wait.

    Of several in question, it is the first of `programs`.
    """
    guests: list[Member] = []
    hosts = list(programs)
    if not any(each.package == TURTLESIM for each in programs):
        hosts.append(Member(TURTLESIM, *KEY, turtlesim()))
    while len(guests) < GUESTS:
        asked = [
            *(each for each in waiting([*guests, *page], *WAITS) if each.type not in COMMANDS),
            *(each for each in waiting([*guests, *page], PUBLISHER) if each.type in COMMANDS),
        ]
        guest = next((each for one in asked for each in hosts if each.answers(one)), None)
        if guest is None:
            break
        guests.insert(0, guest)
    return guests


def _shared(folders: Mapping[str, Path], one: str, other: str) -> int:
    """Return how many folders contain both packages."""
    return len(set(folders[one].parents) & set(folders[other].parents))


def _elsewhere(place: int, pages: Sequence[Sequence[Member]]) -> bool:
    """Return whether another page has all programs of the page at `place`.

    Of pages with the same programs, the first is kept; so is one whose robot visitors drive.
    """
    if any(each.type in COMMANDS for each in waiting(pages[place], SUBSCRIPTION)):
        return False
    own = {each.key for each in pages[place]}
    for other, page in enumerate(pages):
        keys = {each.key for each in page}
        if other != place and (own < keys or (own == keys and other < place)):
            return True
    return False
