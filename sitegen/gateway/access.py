"""What one client may do, until when, and what is written about it."""

from __future__ import annotations

import asyncio
import secrets
import time
from collections.abc import Callable
from dataclasses import dataclass, field

from sitegen.gateway.keys import Keys, RefusedError
from sitegen.gateway.names import Use, subject
from sitegen.gateway.people import People
from sitegen.gateway.recorder import Recorder
from sitegen.gateway.rules import Rules
from sitegen.gateway.stopping import Stopping
from sitegen.gateway.turns import Turn, Turns

__all__ = ["Access", "Guard", "RefusedError"]

# A client may send what its rate allows in this time at once (s).
BURST = 2.0
# What those may do who only watch.
WATCHING: tuple[Use, ...] = ("subscribe", "get_parameters")
# Different refusals that are logged for one client.
MOST_REFUSALS = 1000


@dataclass(frozen=True)
class Guard:
    """What all clients share; None for what gateway.yaml does not ask for."""

    keys: Keys | None = None
    turns: Turns | None = None
    stopping: Stopping | None = None
    # Returns the text that defines a type, for recordings.
    definition: Callable[[str], str] | None = None
    people: People = field(default_factory=People)


class Access:
    """The rights of one connection.

    A handler calls `enter` with the client's key, or None if it has none, before anything else;
    then `refusal` for each name and each message to it, `pace` for each message that comes, and
    `published` and `delivered` for those that went on. When `ended` is done, its result says why
    the client has to go.
    """

    def __init__(
        self,
        rules: Rules,
        address: str,
        write: Callable[[str], None],
        guard: Guard | None = None,
    ) -> None:
        self.rules = rules
        self.address = address
        self.session = secrets.token_hex(4)
        # Who the key belongs to, as the log sees it, and as other clients do: "" if it is unknown.
        self.person = ""
        self.name = ""
        # Set by the handler of pages, which lists them.
        self.is_page = False
        self.entered = False
        self.ended: asyncio.Future[str] = asyncio.get_running_loop().create_future()
        # Called when the client's turn begins (True) and ends (False).
        self.turned: list[Callable[[bool], None]] = []
        # Called when something else is to be shown: somebody's turn, or another calendar.
        self.shown: list[Callable[[Turn], None]] = []
        self._guard = guard or Guard()
        self._write = write
        self._budget = _Budget(rules.limits.messages_per_second, rules.limits.bytes_per_second)
        self._refused: set[str] = set()
        self._until: float | None = None
        self._tasks: set[asyncio.Task[None]] = set()
        self._recorder: Recorder | None = None
        # The topics to stop that the client has published on.
        self._driven: set[str] = set()

    @property
    def people(self) -> People:
        """Who else is at the gateway."""
        return self._guard.people

    @property
    def needs_key(self) -> bool:
        """Whether a client has to give a key."""
        return self._guard.keys is not None

    @property
    def seconds_left(self) -> float | None:
        """How long the key is good for; None if there is no end."""
        return None if self._until is None else max(0.0, self._until - time.monotonic())

    @property
    def turn(self) -> Turn | None:
        """Whose turn it is, and when that of this client is; None without reservations."""
        turns = self._guard.turns
        return turns.turn(self.person, time.time()) if turns and self.entered else None

    async def enter(self, key: object = None) -> None:
        """Let the client in. Raises: RefusedError."""
        if self.entered:
            return
        key_id = ""
        if self._guard.keys:
            try:
                grant = await self._guard.keys.check(key, self.address)
            except RefusedError as error:
                self.say(f"refused: {error}")
                raise
            self.person, key_id = grant.person, grant.key_id
            # Others see neither the id of a key nor where to send mail.
            self.name = "" if grant.person == f"key {key_id}" else grant.person.partition("@")[0]
            self._until = time.monotonic() + grant.seconds
            self._start(self._end_at(grant.seconds))
            self.say(f"granted for {grant.seconds:.0f} s with the key {key_id}")
        else:
            self.say("entered")
        self.entered = True
        if not self.is_page:
            self.people.enter(self)
        if self._guard.turns:
            self._start(self._watch_turn())
        if self.rules.recording and self._guard.definition:
            who = {
                "session": self.session,
                "person": self.person,
                "address": self.address,
                "key": key_id,
            }
            definition = self._guard.definition
            self._recorder = Recorder(self.rules.recording, who, definition, self.say)

    def refusal(self, use: Use, name: str) -> str:
        """Return why the client may not use `name` now, "" if it may; refusals are logged once."""
        return self.forbidden(use, name) or self.postponed(use, name)

    def forbidden(self, use: Use, name: str) -> str:
        """Return why the client may never use `name`, "" if it may when it is its turn."""
        why = self.rules.refusal(use, name)
        if why:
            self.refused(why)
        return why

    def postponed(self, use: Use, name: str) -> str:
        """Return why it is not the client's turn, "" if it is, or if no turn is needed."""
        turns = self._guard.turns
        if turns is None or (turns.rules.watch and subject(use, name)[0] in WATCHING):
            return ""
        why = self._not_now()
        if why:
            self.refused(why)
        return why

    def refused(self, why: str) -> None:
        """Log a refusal, unless it was logged before."""
        # Without times, which change.
        known = why.partition(";")[0]
        if known not in self._refused and len(self._refused) < MOST_REFUSALS:
            self._refused.add(known)
            self.say(f"refused: {why}")

    async def pace(self, size: int) -> None:
        """Wait as long as a message of `size` bytes exceeds the client's rate.

        Meanwhile its connection is not read, so that it has to wait, too.
        """
        late = self._budget.spend(size)
        if late > 0:
            self.refused("messages faster than the limit; they wait")
            await asyncio.sleep(late)

    def published(self, topic: str, type_name: str, data: bytes) -> None:
        """Note a message of the client, in CDR."""
        if topic in self.rules.stop and self._guard.stopping and topic not in self._driven:
            self._driven.add(topic)
            self._start(self._guard.stopping.prepare(topic, type_name))
        if self._recorder:
            self._recorder.add("from client", topic, type_name, data, time.time_ns())

    def delivered(self, topic: str, type_name: str, data: bytes, sent: int) -> None:
        """Note a message for the client, in CDR, and when it was sent (ns since 1970)."""
        if self._recorder:
            self._recorder.add("to client", topic, type_name, data, sent)

    def end(self, why: str) -> None:
        """Make the client go."""
        if not self.ended.done():
            self.ended.set_result(why)

    async def close(self, why: str) -> None:
        """Stop what the client drove, and end its recording; its endpoints have gone."""
        self.people.leave(self)
        for task in self._tasks:
            task.cancel()
        await asyncio.gather(*self._tasks, return_exceptions=True)
        await self._stop()
        if self._recorder:
            await asyncio.to_thread(self._recorder.close, why)

    def say(self, what: str) -> None:
        """Write a line about this client."""
        who = f"{self.address} {self.person}".strip()
        line = "".join(char if char.isprintable() else "�" for char in f"{who}: {what}")
        self._write(f"[{self.session}] {line[:500]}")

    def _start(self, work: object) -> None:
        task = asyncio.ensure_future(work)  # type: ignore[call-overload]
        self._tasks.add(task)
        task.add_done_callback(self._tasks.discard)

    async def _end_at(self, seconds: float) -> None:
        await asyncio.sleep(seconds)
        self.end("the key has ended")

    async def _stop(self) -> None:
        driven, self._driven = self._driven, set()
        for topic in sorted(driven):
            if self._guard.stopping and await self._guard.stopping.stop(topic):
                self.say(f"stopped {topic}")

    def _not_now(self) -> str:
        turn = self.turn
        if turn is None or turn.mine:
            return ""
        whose = f"it is the turn of {turn.now}" if turn.now else "it is nobody's turn"
        if turn.mine_in is None:
            return f"{whose}; you have no appointment"
        return f"{whose}; yours begins in {turn.mine_in:.0f} s"

    async def _watch_turn(self) -> None:
        """Follow the appointments; when the client's turn ends, what it moved stops."""
        mine = False
        shown: object = None
        while True:
            turn = self.turn
            if turn and shown != (shown := turn.moments(time.time())):
                for show in self.shown:
                    show(turn)
            if turn and turn.mine != mine:
                mine = turn.mine
                self.say("the turn begins" if mine else "the turn ends")
                for listener in self.turned:
                    listener(mine)
                if not mine:
                    await self._stop()
                    if self._guard.turns and not self._guard.turns.rules.watch:
                        self.end("your appointment has ended")
            # The calendar may have changed within a second.
            await asyncio.sleep(min(1.0, turn.next_change if turn else 1.0))


class _Budget:
    """Messages and bytes that may come now; they grow with the time, up to a burst."""

    def __init__(self, messages: int, size: int) -> None:
        self._rates = (messages, size)
        self._left = [messages * BURST, size * BURST]
        self._last = time.monotonic()

    def spend(self, size: int) -> float:
        """Take one message of `size` bytes; return how long to wait before the next (s)."""
        now = time.monotonic()
        waits = [0.0]
        for i, (rate, cost) in enumerate(zip(self._rates, (1, size), strict=True)):
            self._left[i] = min(rate * BURST, self._left[i] + (now - self._last) * rate) - cost
            waits.append(-self._left[i] / rate)
        self._last = now
        return max(waits)
