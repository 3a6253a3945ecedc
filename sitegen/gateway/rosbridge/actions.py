"""Operations of clients that offer actions: advertise_action, action_feedback, action_result."""

from __future__ import annotations

from typing import Any

from sitegen.gateway.rosbridge.actionserver import ABORTED, FINAL, SUCCEEDED, ActionServer
from sitegen.gateway.rosbridge.encode import to_json
from sitegen.gateway.rosbridge.operation import InvalidOperationError, graph_name, text
from sitegen.gateway.rosbridge.session import Operation, Session
from sitegen.gateway.rosbridge.typenames import full


class Actions:
    """The actions of one client, by name."""

    def __init__(self, session: Session) -> None:
        self._session = session
        self._offered: dict[str, ActionServer] = {}
        session.endings.append(self._end)

    async def advertise(self, message: dict[str, Any]) -> None:
        """Offer an action; one of the same name is replaced."""
        action = graph_name(message, "action")
        type_name = full(text(message, "type"), "action")
        self._session.allow("advertise_actions", action)
        if known := self._offered.pop(action, None):
            await known.close()
        limit = self._session.access.rules.limits.services
        if len(self._offered) >= limit:
            raise InvalidOperationError(f"advertise_action: {limit} actions are the limit")

        def begin(identity: str, goal: Any) -> None:
            self._session.send(
                {
                    "op": "send_action_goal",
                    "id": identity,
                    "action": action,
                    "action_type": type_name,
                    "args": to_json(goal),
                    "feedback": True,
                }
            )

        def stop(identity: str) -> None:
            self._session.send({"op": "cancel_action_goal", "id": identity, "action": action})

        server = ActionServer(action, type_name, begin, stop)
        try:
            await server.open(self._session.party)
        except Exception:
            await server.close()
            raise
        self._offered[action] = server

    async def unadvertise(self, message: dict[str, Any]) -> None:
        """Offer it no more."""
        action = graph_name(message, "action")
        known = self._offered.pop(action, None)
        if known is None:
            raise InvalidOperationError(f"unadvertise_action: {action} is not advertised")
        await known.close()

    async def feedback(self, message: dict[str, Any]) -> None:
        """Pass on the client's feedback."""
        server, identity = self._goal(message)
        await server.tell(identity, message.get("values"))

    async def result(self, message: dict[str, Any]) -> None:
        """Pass on the client's result."""
        server, identity = self._goal(message)
        if message.get("result") is False:
            await server.finish(identity, ABORTED, None)
            return
        status = message.get("status", SUCCEEDED)
        if status not in FINAL:
            raise InvalidOperationError("action_result: 'status' must be 4, 5 or 6")
        await server.finish(identity, status, message.get("values"))

    def _goal(self, message: dict[str, Any]) -> tuple[ActionServer, str]:
        server = self._offered.get(graph_name(message, "action"))
        identity = str(message.get("id"))
        if server is None or not server.under_way(identity):
            raise InvalidOperationError(f"{message['op']}: no goal with this 'id' is under way")
        return server, identity

    async def _end(self) -> None:
        for server in self._offered.values():
            await server.close()


def operations(session: Session) -> dict[str, Operation]:
    """Return the operations of this group."""
    actions = Actions(session)
    return {
        "advertise_action": actions.advertise,
        "unadvertise_action": actions.unadvertise,
        "action_feedback": actions.feedback,
        "action_result": actions.result,
    }
