"""Reservations at a gateway with a native robot behind it."""

from __future__ import annotations

import datetime
from pathlib import Path
from typing import Any

import gateways
from gateways import Client, Gateway, client, enter, key, run

from sitegen.gateway.keys import make_secret

HOUR = 3600.0


def write_calendar(folder: Path, *appointments: tuple[str, float, float]) -> None:
    """Write the appointments of persons, with begin and end in seconds from now.

    The gateways here read it every second, so that a test decides when time goes on.
    """
    now = datetime.datetime.now(datetime.UTC)

    def moment(seconds: float) -> str:
        return (now + datetime.timedelta(seconds=seconds)).strftime("%Y%m%dT%H%M%SZ")

    events = "".join(
        f"BEGIN:VEVENT\r\nUID:{person}@x\r\nDTSTAMP:{moment(0)}\r\nDTSTART:{moment(begin)}\r\n"
        f"DTEND:{moment(end)}\r\nSUMMARY:{person}\r\nEND:VEVENT\r\n"
        for person, begin, end in appointments
    )
    text = f"BEGIN:VCALENDAR\r\nVERSION:2.0\r\nPRODID:x\r\n{events}END:VCALENDAR\r\n"
    (folder / "new.ics").write_text(text)
    (folder / "new.ics").replace(folder / "lab.ics")


def test_appointments(robot: gateways.Process, tmp_path: Path) -> None:
    write_calendar(tmp_path, ("Ada", -60, HOUR), ("Bob", HOUR, 2 * HOUR))
    make_secret(tmp_path / "gateway.secret")
    (tmp_path / "gateway.yaml").write_text(
        "keys: {secret: gateway.secret}\n"
        "reservations: {calendar: lab.ics, refresh: 1, watch: true}\nstop: [/cmd_vel]\n"
    )

    async def turn(page: Client) -> dict[str, Any]:
        found: dict[str, Any] = (await page.call("/gateway/turn"))["values"]
        return found

    async def work(running: Gateway) -> None:
        async with client(running) as ada, client(running) as bob, client(running) as eve:
            for page, name in ((ada, "Ada"), (bob, "Bob"), (eve, "Eve")):
                await enter(page, key(tmp_path, name))
            mine, other, none = await turn(ada), await turn(bob), await turn(eve)
            assert mine["mine"] and mine["now"] == "Ada" and HOUR - 60 < mine["now_left"] <= HOUR
            assert not other["mine"] and other["now"] == "Ada"
            assert abs(other["mine_in"] - mine["now_left"]) < 1
            assert none["mine_in"] is None
            await ada.send(op="advertise", topic="/tell", type="std_msgs/String")
            await ada.send(op="publish", topic="/tell", msg={"data": "of Ada"})
            await bob.send(op="subscribe", topic="/heard", type="std_msgs/String")
            await bob.send(op="publish", topic="/tell", msg={"data": "too early"})
            refused = (await bob.until("status", level="error"))["msg"]
            assert refused.startswith("it is the turn of Ada; yours begins in ")
            await eve.send(op="publish", topic="/tell", msg={"data": "never"})
            refused = (await eve.until("status", level="error"))["msg"]
            assert refused == "it is the turn of Ada; you have no appointment"
            write_calendar(tmp_path, ("Ada", -60, 2), ("Bob", 2, HOUR))
            await bob.until("status", msg="your turn begins")
            await ada.until("status", msg="your turn has ended")
            await ada.send(op="publish", topic="/tell", msg={"data": "too late"})
            await ada.until("status", msg="it is the turn of Bob; you have no appointment")
            await bob.settle()
            heard = {one["msg"]["data"] for one in bob.passed if one["op"] == "publish"}
            assert not heard & {"too early", "never", "too late"}

    with gateways.gateway(folder=tmp_path) as running:
        run(work(running))


def test_pages_are_told_whose_turn_it_is(robot: gateways.Process, tmp_path: Path) -> None:
    write_calendar(tmp_path, ("Ada", HOUR, 2 * HOUR))
    make_secret(tmp_path / "gateway.secret")
    (tmp_path / "gateway.yaml").write_text(
        "keys: {secret: gateway.secret}\nreservations: {calendar: lab.ics, refresh: 1}\n"
    )

    async def work(running: Gateway) -> None:
        async with client(running, protocols=["sitegen.1"]) as page:
            assert (await page.next())["op"] == "challenge"
            await page.send(op="hello", version=1, page="p", key=key(tmp_path))
            await page.until("welcome")
            waiting = await page.until("turn")
            assert waiting["now"] == "" and HOUR - 60 < waiting["mineIn"] <= HOUR
            write_calendar(tmp_path, ("Ada", 2, HOUR))
            mine = await page.until("turn", now="Ada")
            assert mine["mineIn"] == 0 and HOUR - 60 < mine["mineLeft"] <= HOUR

    with gateways.gateway(folder=tmp_path) as running:
        run(work(running))
