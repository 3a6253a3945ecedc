"""Whose turn it is: the appointments of a calendar."""

from __future__ import annotations

import asyncio
import datetime
from collections.abc import Callable
from dataclasses import dataclass
from pathlib import Path
from typing import Any

import aiohttp
import icalendar
import recurring_ical_events

from sitegen.gateway.rules import Reservations

# A calendar of more bytes is refused; appointments that begin later are not looked at (days).
LARGEST, AHEAD = 10_000_000, 60
# How long a feed may take (s).
PATIENCE = 20


@dataclass(frozen=True)
class Appointment:
    """A time that belongs to a person; the names of the person are in small letters."""

    start: float
    end: float
    shown: str
    names: frozenset[str]


@dataclass(frozen=True)
class Turn:
    """Whose turn it is now, and when that of one person is; times in seconds from now."""

    now: str
    now_left: float | None
    mine_in: float | None
    mine_left: float | None

    @property
    def mine(self) -> bool:
        """Whether it is that person's turn."""
        return self.mine_in == 0

    @property
    def next_change(self) -> float:
        """The time until it is another one's turn (s), or until this may be asked again."""
        times = (self.now_left, self.mine_in, self.mine_left)
        return max(0.02, min((each for each in times if each), default=1.0))

    def moments(self, now: float) -> tuple[object, ...]:
        """Return what stays the same while only the time goes on, with whole seconds since 1970."""
        times = (self.now_left, self.mine_in or None, self.mine_left)
        return (self.now, *(None if each is None else round(now + each) for each in times))


class Turns:
    """The appointments, read again from time to time; the last good state remains in force."""

    def __init__(self, rules: Reservations, write: Callable[[str], None]) -> None:
        self.rules = rules
        self._write = write
        self._appointments: list[Appointment] = []
        self._said = ""

    async def run(self) -> None:
        """Read the calendar, now and as often as the rules say."""
        while True:
            await self.refresh()
            await asyncio.sleep(self.rules.refresh)

    async def refresh(self) -> None:
        """Read the calendar; a fault is logged once."""
        try:
            data = await self._read()
            now = datetime.datetime.now(datetime.UTC)
            found = await asyncio.to_thread(appointments, data, now)
        except (OSError, aiohttp.ClientError, TimeoutError, ValueError, KeyError) as error:
            why = str(error).split("\n")[0] or type(error).__name__
            said = f"calendar: {why[:200]}; the appointments read before remain"
        else:
            self._appointments = found
            said = f"calendar: {len(found)} appointments within {AHEAD} days"
        if said != self._said:
            self._said = said
            self._write(said)

    async def _read(self) -> bytes:
        place = self.rules.calendar
        if "://" not in place:
            return await asyncio.to_thread(_content, Path(place))
        timeout = aiohttp.ClientTimeout(total=PATIENCE)
        async with (
            aiohttp.ClientSession(timeout=timeout) as session,
            session.get(place) as answer,
        ):
            answer.raise_for_status()
            data = b""
            async for part in answer.content.iter_chunked(65536):
                data += part
                if len(data) > LARGEST:
                    raise ValueError("the calendar is too large")
            return data

    def turn(self, person: str, now: float) -> Turn:
        """Return whose turn it is at `now` (s since 1970), and when that of `person` is."""
        own, current = None, None
        for each in self._appointments:
            if each.end <= now:
                continue
            if each.start <= now and current is None:
                current = each
            if person.lower() in each.names and own is None:
                own = each
        # Of two at the same time, the one that began first goes on.
        if own and own.start <= now and current is not own:
            own = Appointment(current.end, own.end, own.shown, own.names) if current else own
        return Turn(
            current.shown if current else "",
            current.end - now if current else None,
            max(0.0, own.start - now) if own else None,
            own.end - now if own else None,
        )


def _content(file: Path) -> bytes:
    if file.stat().st_size > LARGEST:
        raise ValueError("the calendar is too large")
    return file.read_bytes()


def appointments(data: bytes, now: datetime.datetime) -> list[Appointment]:
    """Return the appointments of a calendar around `now`, in order.

    A person is named by the summary, or by an attendee: by name, or by address of mail.

    Raises: ValueError if it is not a calendar.
    """
    calendar = icalendar.Calendar.from_ical(data)
    start, end = now - datetime.timedelta(days=1), now + datetime.timedelta(days=AHEAD)
    found = [
        _appointment(event)
        for event in recurring_ical_events.of(calendar).between(start, end)
        if str(event.get("STATUS", "")).upper() != "CANCELLED"
    ]
    return sorted(found, key=lambda each: (each.start, each.end))


def _appointment(event: Any) -> Appointment:
    start, end = event["DTSTART"].dt, event["DTEND"].dt
    summary = str(event.get("SUMMARY", "")).strip()
    attendees = event.get("ATTENDEE", [])
    names = {summary.lower()}
    for attendee in attendees if isinstance(attendees, list) else [attendees]:
        names.add(str(attendee).lower().removeprefix("mailto:"))
        names.add(str(attendee.params.get("CN", "")).lower())
    return Appointment(_seconds(start), _seconds(end), summary, frozenset(names - {""}))


def _seconds(moment: datetime.date) -> float:
    if isinstance(moment, datetime.datetime):
        # A time without zone is one of this computer.
        return moment.timestamp()
    return datetime.datetime(moment.year, moment.month, moment.day).timestamp()
