"""An action in the graph whose goals a client reaches."""

from __future__ import annotations

import time
from collections.abc import Callable
from dataclasses import dataclass, field
from typing import Any

from sitegen.gateway.native import (
    Party,
    Publisher,
    Qos,
    Request,
    Server,
    from_cdr,
    load_type,
    to_cdr,
)
from sitegen.gateway.rosbridge.decode import from_json, now

EXECUTING, CANCELING, SUCCEEDED, CANCELED, ABORTED = 2, 3, 4, 5, 6
FINAL = (SUCCEEDED, CANCELED, ABORTED)
UNKNOWN_GOAL, TERMINATED = 2, 3
CANCEL, STATUS = "action_msgs/srv/CancelGoal", "action_msgs/msg/GoalStatusArray"
# How many goals are kept, and how long their results are after the end (s).
MOST, KEPT = 1000, 60.0


@dataclass
class Goal:
    """A goal that the client works on, or whose result is kept."""

    number: bytes
    stamp: Any
    status: int = EXECUTING
    result: Any = None
    ended: float = 0.0
    asked: list[Request] = field(default_factory=list)


class ActionServer:
    """The three services and two topics of an action."""

    def __init__(
        self,
        name: str,
        type_name: str,
        begin: Callable[[str, Any], None],
        stop: Callable[[str], None],
    ) -> None:
        self.name = name
        self.type = type_name
        self._begin = begin
        self._stop = stop
        self._goals: dict[str, Goal] = {}
        self._servers: list[Server] = []
        self._feedback: Publisher | None = None
        self._status: Publisher | None = None

    async def open(self, party: Party) -> None:
        """Offer the action. Raises: NativeError for an unknown type or an invalid name."""
        place = f"{self.name}/_action"
        latched = Qos(depth=1, transient_local=True)
        self._status = await party.advertise(f"{place}/status", STATUS, latched)
        self._feedback = await party.advertise(
            f"{place}/feedback", f"{self.type}_FeedbackMessage", Qos()
        )
        for part, kind, asked in (
            ("get_result", f"{self.type}_GetResult", self._asked_result),
            ("cancel_goal", CANCEL, self._asked_cancel),
            ("send_goal", f"{self.type}_SendGoal", self._asked_goal),
        ):
            self._servers.append(await party.serve(f"{place}/{part}", kind, asked))

    async def close(self) -> None:
        """Abort the goals under way, and offer the action no more."""
        for identity, goal in self._goals.items():
            if goal.status not in FINAL:
                await self.finish(identity, ABORTED, None)
        for part in (*self._servers, self._feedback, self._status):
            if part:
                await part.close()

    def under_way(self, identity: str) -> bool:
        """Return whether the client works on this goal."""
        goal = self._goals.get(identity)
        return goal is not None and goal.status not in FINAL

    async def tell(self, identity: str, values: Any) -> None:
        """Publish feedback. Raises: NativeError for values that do not fit."""
        message = load_type(f"{self.type}_FeedbackMessage")()
        message.goal_id.uuid = list(self._goals[identity].number)
        message.feedback = from_json(values, load_type(self.type).Feedback)
        if self._feedback:
            await self._feedback.publish(to_cdr(message))

    async def finish(self, identity: str, status: int, values: Any) -> None:
        """End a goal. Raises: NativeError for values that do not fit."""
        goal = self._goals[identity]
        goal.result = from_json(values, load_type(self.type).Result)
        goal.status, goal.ended = status, time.monotonic()
        for request in goal.asked:
            await request.respond(self._response(goal))
        goal.asked.clear()
        await self._publish_status()

    def _asked_goal(self, request: Request) -> None:
        kind = load_type(f"{self.type}_SendGoal")
        asked = from_cdr(request.data, kind.Request)
        number = bytes(asked.goal_id.uuid)
        identity = f"action_goal:{self.name}:{number.hex()}"
        response = kind.Response()
        self._forget()
        response.accepted = identity not in self._goals and len(self._goals) < MOST
        response.stamp = now(type(response.stamp))
        if response.accepted:
            self._goals[identity] = Goal(number, response.stamp)
        request.respond(to_cdr(response))
        if response.accepted:
            self._begin(identity, asked.goal)
            self._publish_status()

    def _asked_result(self, request: Request) -> None:
        kind = load_type(f"{self.type}_GetResult")
        number = bytes(from_cdr(request.data, kind.Request).goal_id.uuid)
        goal = self._goals.get(f"action_goal:{self.name}:{number.hex()}")
        if goal is None:
            request.respond(to_cdr(kind.Response()))
        elif goal.status in FINAL:
            request.respond(self._response(goal))
        elif len(goal.asked) < MOST:
            goal.asked.append(request)

    def _asked_cancel(self, request: Request) -> None:
        kind = load_type(CANCEL)
        wanted = from_cdr(request.data, kind.Request).goal_info
        number, before = bytes(wanted.goal_id.uuid), _nanoseconds(wanted.stamp)
        response = kind.Response()
        known = f"action_goal:{self.name}:{number.hex()}" in self._goals
        for identity, goal in self._goals.items():
            # All goals without number and time, one by its number, and all that are older.
            meant = goal.number == number if any(number) else not before
            meant = meant or bool(before and _nanoseconds(goal.stamp) <= before)
            if meant and goal.status == EXECUTING:
                goal.status = CANCELING
                response.goals_canceling.append(_info(type(wanted), goal))
                self._stop(identity)
        if any(number) and not response.goals_canceling:
            response.return_code = TERMINATED if known else UNKNOWN_GOAL
        request.respond(to_cdr(response))
        self._publish_status()

    def _response(self, goal: Goal) -> bytes:
        response = load_type(f"{self.type}_GetResult").Response()
        response.status, response.result = goal.status, goal.result
        return to_cdr(response)

    def _publish_status(self) -> Any:
        if self._status is None:
            return None
        message = load_type(STATUS)()
        status = load_type("action_msgs/msg/GoalStatus")
        info = load_type("action_msgs/msg/GoalInfo")
        message.status_list = [
            status(goal_info=_info(info, goal), status=goal.status) for goal in self._goals.values()
        ]
        return self._status.publish(to_cdr(message))

    def _forget(self) -> None:
        limit = time.monotonic() - KEPT
        old = [key for key, goal in self._goals.items() if goal.ended and goal.ended < limit]
        for key in old:
            del self._goals[key]


def _info(kind: Any, goal: Goal) -> Any:
    info = kind(stamp=goal.stamp)
    info.goal_id.uuid = list(goal.number)
    return info


def _nanoseconds(stamp: Any) -> int:
    return int(stamp.sec * 10**9 + stamp.nanosec)
