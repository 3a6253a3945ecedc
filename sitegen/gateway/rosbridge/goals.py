"""Operations of clients of actions: send_action_goal, cancel_action_goal."""

from __future__ import annotations

import asyncio
import uuid
from collections.abc import Callable
from dataclasses import dataclass, field
from typing import Any

from sitegen.gateway.native import (
    Client,
    NativeError,
    Qos,
    Sample,
    Subscription,
    from_cdr,
    load_type,
    to_cdr,
)
from sitegen.gateway.rosbridge.decode import from_json
from sitegen.gateway.rosbridge.encode import to_json
from sitegen.gateway.rosbridge.operation import (
    InvalidOperationError,
    flag,
    graph_name,
    number,
    text,
)
from sitegen.gateway.rosbridge.session import Operation, Session
from sitegen.gateway.rosbridge.typenames import full

# How long a goal waits for the action (s).
PATIENCE = 5.0
CANCEL = "action_msgs/srv/CancelGoal"
UNKNOWN = 0


@dataclass
class Action:
    """The clients of one action, which all goals of a client share."""

    name: str
    type: str
    send: Client
    result: Client
    cancel: Client
    feedback: Subscription
    # By the number of the goal: what gets its feedback.
    listeners: dict[bytes, Callable[[Any], None]] = field(default_factory=dict)

    async def ready(self) -> None:
        """Wait until the action is there. Raises: InvalidOperationError if it is not."""
        end = asyncio.get_running_loop().time() + PATIENCE
        while not all([await client.is_ready() for client in (self.send, self.result)]):
            if asyncio.get_running_loop().time() > end:
                raise InvalidOperationError(f"action {self.name} is not available")
            await asyncio.sleep(0.02)
        # Otherwise the first feedback might be missed.
        while not await self.feedback.matched():
            if asyncio.get_running_loop().time() > end:
                return
            await asyncio.sleep(0.02)


@dataclass
class Goal:
    """A goal under way."""

    action: Action
    number: bytes


class Goals:
    """The goals of one client, by id."""

    def __init__(self, session: Session) -> None:
        self._session = session
        self._actions: dict[tuple[str, str], Action] = {}
        self._goals: dict[str, Goal] = {}
        self._waiting: set[str] = set()
        self._lock = asyncio.Lock()
        session.endings.append(self._end)
        session.access.turned.append(lambda mine: None if mine else self._give_up())

    async def send(self, message: dict[str, Any]) -> None:
        """Send a goal; feedback and the result come later."""
        action = graph_name(message, "action")
        number(message, "fragment_size")
        text(message, "compression", "none")
        identity = message.get("id")
        answer: dict[str, Any] = {"op": "action_result", "action": message["action"]}
        if identity is not None:
            answer["id"] = identity
        # Without an id, it cannot be canceled.
        key = str(identity if identity is not None else uuid.uuid4())
        limit = self._session.access.rules.limits.calls
        if len(self._waiting) >= limit or key in self._waiting:
            why = f"{limit} goals at once are the limit"
            if key in self._waiting:
                why = f"the id '{key[:40]}' is in use"
            self._session.send({**answer, "values": why, "status": UNKNOWN, "result": False})
            return
        self._waiting.add(key)

        async def work() -> None:
            try:
                status, values = await self._result(action, message, key)
                done = {**answer, "values": values, "status": status, "result": True}
            except (NativeError, InvalidOperationError) as error:
                done = {**answer, "values": str(error), "status": UNKNOWN, "result": False}
            finally:
                self._waiting.discard(key)
                if goal := self._goals.pop(key, None):
                    goal.action.listeners.pop(goal.number, None)
            self._session.send(
                done,
                compression=text(message, "compression", "none"),
                fragment_size=int(number(message, "fragment_size")),
            )

        self._session.start(work(), identity)

    async def cancel(self, message: dict[str, Any]) -> None:
        """Ask the action to cancel a goal; its result then says whether it did."""
        graph_name(message, "action")
        goal = self._goals.get(str(message.get("id")))
        if goal is None:
            raise InvalidOperationError("cancel_action_goal: no goal with this 'id' is under way")
        self._session.start(self._cancel(goal), message.get("id"))

    async def _cancel(self, goal: Goal) -> None:
        request = load_type(CANCEL).Request()
        request.goal_info.goal_id.uuid = list(goal.number)
        async with asyncio.timeout(PATIENCE):
            await goal.action.cancel.call(to_cdr(request))

    async def _result(self, name: str, message: dict[str, Any], key: str) -> tuple[int, Any]:
        self._session.allow("send_goals", name)
        type_name = await self._type(name, message)
        kind = load_type(f"{type_name}_SendGoal")
        request = kind.Request()
        request.goal = from_json(message.get("args"), load_type(type_name).Goal)
        goal_number = uuid.uuid4().bytes
        request.goal_id.uuid = list(goal_number)
        action = await self._action(name, type_name)
        goal = self._goals[key] = Goal(action, goal_number)
        if flag(message, "feedback"):
            action.listeners[goal_number] = self._feedback(message)
        await action.ready()
        accepted = from_cdr(await action.send.call(to_cdr(request)), kind.Response)
        if not accepted.accepted:
            raise InvalidOperationError(f"{name} has rejected the goal")
        kind = load_type(f"{type_name}_GetResult")
        wanted = kind.Request()
        wanted.goal_id.uuid = list(goal.number)
        result = from_cdr(await action.result.call(to_cdr(wanted)), kind.Response)
        return result.status, to_json(result.result)

    def _feedback(self, message: dict[str, Any]) -> Callable[[Any], None]:
        answer = {"op": "action_feedback", "action": message["action"]}
        if message.get("id") is not None:
            answer["id"] = message["id"]
        return lambda feedback: self._session.send({**answer, "values": to_json(feedback)})

    async def _type(self, name: str, message: dict[str, Any]) -> str:
        there = await self._session.type_of("service", f"{name}/_action/send_goal", PATIENCE)
        if not there:
            raise InvalidOperationError(f"action {name} does not exist")
        there = there.removesuffix("_SendGoal")
        given = message.get("action_type")
        if given and full(given, "action") != there:
            raise InvalidOperationError(f"{name} has the type {there}")
        return there

    async def _action(self, name: str, type_name: str) -> Action:
        async with self._lock:
            known = self._actions.get((name, type_name))
            if known:
                return known
            party = self._session.party
            parts = {
                key: await party.client(f"{name}/_action/{part}", kind)
                for key, part, kind in (
                    ("send", "send_goal", f"{type_name}_SendGoal"),
                    ("result", "get_result", f"{type_name}_GetResult"),
                    ("cancel", "cancel_goal", CANCEL),
                )
            }
            kind = load_type(f"{type_name}_FeedbackMessage")

            def received(sample: Sample) -> None:
                feedback = from_cdr(sample.data, kind)
                if listener := made.listeners.get(bytes(feedback.goal_id.uuid)):
                    listener(feedback.feedback)

            topic = f"{name}/_action/feedback"
            subscription = await party.subscribe(
                topic, f"{type_name}_FeedbackMessage", Qos(depth=100), received
            )
            made = Action(
                name, type_name, parts["send"], parts["result"], parts["cancel"], subscription
            )
            self._actions[name, type_name] = made
            return made

    def _give_up(self) -> None:
        self._session.start(self._end())

    async def _end(self) -> None:
        """Cancel what the client has begun: nobody is there any more."""
        goals = [self._cancel(goal) for goal in self._goals.values()]
        await asyncio.gather(*goals, return_exceptions=True)


def operations(session: Session) -> dict[str, Operation]:
    """Return the operations of this group."""
    goals = Goals(session)
    return {"send_action_goal": goals.send, "cancel_action_goal": goals.cancel}
