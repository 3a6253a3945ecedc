"""Serve programs that speak rowe: their messages become those of rosbridge, and back.

So keys, allow-lists, limits and recordings are the same for both.
"""

from __future__ import annotations

import json
import math
from collections.abc import AsyncIterator, Mapping
from typing import Any, cast

from aiohttp import WSMessage, WSMsgType, web

from sitegen.gateway.access import Access
from sitegen.gateway.fieldmap import FieldError
from sitegen.gateway.native import Native
from sitegen.gateway.rosbridge import run as rosbridge
from sitegen.gateway.rules import Named
from sitegen.rowe.message import Body, InvalidMessage, Message, decode, encode

# What a message asks for, by the one of these fields that it has.
OPERATIONS = ("key", "subscribe", "unsubscribe", "serve", "topic", "service")
# Requests that a program may leave without a reply, as many as rosbridge keeps.
MOST = 1000


async def run(socket: web.WebSocketResponse, access: Access, native: Native) -> None:
    """Serve a program until it leaves or `access` ends."""
    translated = Translated(socket, access)
    # It has what rosbridge uses of a socket.
    await rosbridge(cast(web.WebSocketResponse, translated), access, native)


class Translated:
    """A socket of rowe as rosbridge sees it."""

    def __init__(self, socket: web.WebSocketResponse, access: Access) -> None:
        self._socket = socket
        self._access = access
        rules = access.rules
        # By kind, and by the names that programs use.
        self._names: dict[str, Mapping[str, Named]] = {
            "topic": rules.rowe_topics,
            "service": rules.rowe_services,
        }
        self._kind = rules.rowe_kind
        # By the ids of requests to this program: the service.
        self._asked: dict[str, str] = {}

    @property
    def closed(self) -> bool:
        """Whether the connection has ended."""
        return self._socket.closed

    async def __aiter__(self) -> AsyncIterator[WSMessage]:
        """Yield what the program asks for, as messages of rosbridge."""
        async for frame in self._socket:
            if frame.type not in (WSMsgType.TEXT, WSMsgType.BINARY):
                continue
            try:
                if frame.type == WSMsgType.BINARY:
                    raise InvalidMessage("not a text frame")
                message = decode(frame.data, "")
                operations = self._operations(message)
            except (InvalidMessage, FieldError) as error:
                if self._access.entered:
                    await self._access.pace(len(frame.data))
                    await self._send({"error": str(error)})
                    continue
                # Without a key, nobody is told what gateway.yaml names; rosbridge refuses this.
                operations = [{"op": "invalid"}]
            for operation in operations:
                yield WSMessage(WSMsgType.TEXT, json.dumps(operation), None)

    async def send_str(self, text: str) -> None:
        """Send a message of rosbridge to the program, as one of rowe."""
        message = json.loads(text)
        op = message["op"]
        if op == "publish":
            name, named = self._own("topic", message["topic"])
            body = named.fields.to_program(message["msg"])
            await self._send({**body, self._kind or "topic": name})
        elif op == "service_response":
            await self._answer(message)
        elif op == "call_service":
            name, named = self._own("service", message["service"])
            self._asked[message["id"]] = message["service"]
            if len(self._asked) > MOST:
                del self._asked[next(iter(self._asked))]
            body = named.fields.to_program(message["args"])
            await self._send({**body, self._kind or "service": name}, message_id=message["id"])
        elif op == "status":
            kind = "error" if message["level"] == "error" else "status"
            asked = message.get("id")
            await self._send({kind: message["msg"]}, in_reply_to=asked and str(asked))

    async def _answer(self, message: Body) -> None:
        asked, values = message.get("id"), message["values"]
        if message["result"] and asked is None:
            # A request without an id expects no reply.
            return
        name, named = self._own("service", message["service"])
        given = named.reply.to_program(values) if message["result"] else {"error": values}
        await self._send({**given, self._kind or "service": name}, in_reply_to=asked)

    async def _send(self, body: Body, **fields: str | None) -> None:
        try:
            text = encode(body, **cast(dict[str, Any], fields))
        except InvalidMessage as error:
            # For example an image, which is too long.
            text = encode({"error": f"not sent: {error}"})
        await self._socket.send_str(text)

    def _operations(self, message: Message) -> list[Body]:
        """Return the operations of rosbridge that a message is."""
        body = dict(message.body)
        if message.in_reply_to is not None:
            service = self._asked.pop(message.in_reply_to, None)
            if service is None:
                raise InvalidMessage("in_reply_to: there is no request with this id")
            known = {"service": service, "id": message.in_reply_to}
            error = body.pop("error", None)
            reply = self._own("service", service)[1].reply
            values = reply.to_ros(body) if error is None else str(error)
            return [{"op": "service_response", **known, "result": error is None, "values": values}]
        kind, given = self._taken(body)
        asked = {"id": message.message_id} if message.message_id else {}
        if kind == "key":
            return [{"op": "auth", "key": given, **asked}]
        named = self._named("service" if kind in ("serve", "service") else "topic", given)
        typed = {"type": named.type} if named.type else {}
        if kind == "subscribe":
            return [{"op": "subscribe", "topic": named.name, **typed, "queue_length": 1}]
        if kind == "unsubscribe":
            return [{"op": "unsubscribe", "topic": named.name}]
        if kind == "serve":
            return [{"op": "advertise_service", "service": named.name, **typed}]
        if kind == "service":
            if not message.time_to_live:
                return []
            limit = {} if message.time_to_live == math.inf else {"timeout": message.time_to_live}
            call = {
                "op": "call_service",
                "service": named.name,
                "args": named.fields.to_ros(body),
                **typed,
            }
            return [{**call, **asked, **limit}]
        return [{"op": "publish", "topic": named.name, "msg": named.fields.to_ros(body), **typed}]

    def _taken(self, body: Body) -> tuple[str, str]:
        """Remove the field that says what a message is. Return what it is, and the value."""
        if self._kind and self._kind in body:
            given = body.pop(self._kind)
            for each, names in self._names.items():
                if isinstance(given, str) and given in names:
                    return each, given
            known = ", ".join(name for names in self._names.values() for name in names) or "none"
            shown = str(given)[:80]
            raise InvalidMessage(f"unknown {self._kind} '{shown}'; gateway.yaml names {known}")
        kind = next((name for name in OPERATIONS if name in body), None)
        if kind is None:
            own = [self._kind] if self._kind else []
            choices = f"{', '.join([*own, *OPERATIONS[:-1]])} or {OPERATIONS[-1]}"
            raise InvalidMessage(f"say what it is: {choices}")
        given = body.pop(kind)
        if not isinstance(given, str):
            raise InvalidMessage(f"{kind}: must be text")
        return kind, given

    def _named(self, kind: str, name: str) -> Named:
        """Return the name in ROS of what the program calls `name`."""
        if known := self._names[kind].get(name):
            return known
        if name.startswith("/"):
            return Named(name)
        names = ", ".join(self._names[kind]) or "none"
        raise InvalidMessage(f"unknown {kind} '{name[:80]}'; gateway.yaml names {names}")

    def _own(self, kind: str, name: str) -> tuple[str, Named]:
        """Return what the program calls a name in ROS, and what gateway.yaml says about it."""
        found = (pair for pair in self._names[kind].items() if pair[1].name == name)
        return next(found, (name, Named(name)))
