"""Appointments of calendars, without a gateway."""

from __future__ import annotations

import datetime
import threading
from http.server import BaseHTTPRequestHandler, ThreadingHTTPServer
from typing import ClassVar
from zoneinfo import ZoneInfo

import pytest
from gateways import run

from sitegen.gateway.rules import Reservations
from sitegen.gateway.turns import Turns, appointments

CALENDAR = """BEGIN:VCALENDAR
VERSION:2.0
PRODID:test
BEGIN:VTIMEZONE
TZID:Europe/Berlin
BEGIN:DAYLIGHT
TZOFFSETFROM:+0100
TZOFFSETTO:+0200
DTSTART:19700329T020000
RRULE:FREQ=YEARLY;BYDAY=-1SU;BYMONTH=3
END:DAYLIGHT
BEGIN:STANDARD
TZOFFSETFROM:+0200
TZOFFSETTO:+0100
DTSTART:19701025T030000
RRULE:FREQ=YEARLY;BYDAY=-1SU;BYMONTH=10
END:STANDARD
END:VTIMEZONE
BEGIN:VEVENT
UID:1
DTSTAMP:20261001T000000Z
DTSTART;TZID=Europe/Berlin:20261005T100000
DTEND;TZID=Europe/Berlin:20261005T110000
RRULE:FREQ=WEEKLY
EXDATE;TZID=Europe/Berlin:20261102T100000
SUMMARY:Ada
END:VEVENT
BEGIN:VEVENT
UID:2
DTSTAMP:20261001T000000Z
DTSTART:20261026T100000Z
DURATION:PT30M
SUMMARY:Lab course
ATTENDEE;CN=Bob Example:mailto:bob@example.org
END:VEVENT
BEGIN:VEVENT
UID:3
DTSTAMP:20261001T000000Z
DTSTART:20261026T100000Z
DTEND:20261026T120000Z
STATUS:CANCELLED
SUMMARY:Eve
END:VEVENT
END:VCALENDAR
""".replace("\n", "\r\n").encode()


def turns(now: datetime.datetime) -> Turns:
    """Return the appointments of the calendar at a time."""
    found = Turns(Reservations("x"), lambda line: None)
    found.__dict__["_appointments"] = appointments(CALENDAR, now)
    return found


def test_appointments_recur_in_their_time_zone() -> None:
    # Summer time ends between the first two, and one Monday is left out.
    now = datetime.datetime(2026, 10, 19, 0, 0, tzinfo=datetime.UTC)
    ada = [each for each in appointments(CALENDAR, now) if each.shown == "Ada"]
    berlin = ZoneInfo("Europe/Berlin")
    starts = [datetime.datetime.fromtimestamp(each.start, berlin) for each in ada]
    assert {(start.hour, start.weekday()) for start in starts} == {(10, 0)}
    days = [start.date().isoformat() for start in starts[:3]]
    assert days == ["2026-10-19", "2026-10-26", "2026-11-09"]
    assert ada[1].start - ada[0].start == 7 * 86400 + 3600


def test_whose_turn_it_is() -> None:
    now = datetime.datetime(2026, 10, 26, 9, 30, tzinfo=datetime.UTC)
    found, moment = turns(now), now.timestamp()
    ada = found.turn("ada", moment)
    assert ada.mine and ada.now == "Ada" and ada.now_left == 1800
    bob = found.turn("bob@example.org", moment)
    assert not bob.mine and bob.mine_in == 1800
    assert found.turn("Bob Example", moment + 1800).mine
    # Handed over at the same moment.
    assert not found.turn("Ada", moment + 1800).mine
    nobody = found.turn("Eve", moment + 5400)
    assert nobody.now == "" and nobody.mine_in is None


def test_a_calendar_that_is_none() -> None:
    with pytest.raises(ValueError):
        appointments(b"<html>", datetime.datetime.now(datetime.UTC))


class Feed(BaseHTTPRequestHandler):
    """A calendar of somewhere else, which can fail."""

    answers: ClassVar[list[tuple[int, bytes]]] = []

    def do_GET(self) -> None:
        status, body = self.answers.pop(0)
        self.send_response(status)
        self.end_headers()
        self.wfile.write(body)

    def log_message(self, format: str, *args: object) -> None:
        pass


def test_a_feed_that_fails_leaves_what_was_read() -> None:
    start = datetime.datetime.now(datetime.UTC)
    end = start + datetime.timedelta(hours=1)
    form = "%Y%m%dT%H%M%SZ"
    calendar = (
        "BEGIN:VCALENDAR\r\nVERSION:2.0\r\nPRODID:x\r\nBEGIN:VEVENT\r\nUID:1\r\nSUMMARY:Ada\r\n"
        f"DTSTAMP:{start:{form}}\r\nDTSTART:{start:{form}}\r\nDTEND:{end:{form}}\r\n"
        "END:VEVENT\r\nEND:VCALENDAR\r\n"
    ).encode()
    Feed.answers[:] = [(200, calendar), (500, b""), (200, b"<html>"), (200, b"x" * 11_000_000)]
    said: list[str] = []

    async def work(address: str) -> list[bool]:
        turns = Turns(Reservations(address), said.append)
        found = []
        for _ in range(4):
            await turns.refresh()
            found.append(turns.turn("Ada", start.timestamp() + 60).mine)
        return found

    with ThreadingHTTPServer(("127.0.0.1", 0), Feed) as server:
        threading.Thread(target=server.serve_forever, daemon=True).start()
        found = run(work(f"http://127.0.0.1:{server.server_port}/lab.ics"))
        server.shutdown()
    assert found == [True] * 4
    assert said[0] == "calendar: 1 appointments within 60 days"
    assert all(line.endswith("; the appointments read before remain") for line in said[1:])
    assert len(said) == 4
