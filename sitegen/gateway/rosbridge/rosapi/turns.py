"""Say whose turn it is: the service /gateway/turn, which rosapi does not have."""

from __future__ import annotations

from typing import TYPE_CHECKING, Any

if TYPE_CHECKING:
    from sitegen.gateway.rosbridge.session import Session


async def turn(session: Session, _: Any) -> dict[str, Any]:
    """Return times in seconds from now, null where there is none."""
    access = session.access
    found = access.turn
    return {
        "reservations": found is not None,
        "person": access.person,
        "key_left": access.seconds_left,
        "now": found.now if found else "",
        "now_left": found.now_left if found else None,
        "mine": found.mine if found else True,
        "mine_in": found.mine_in if found else None,
        "mine_left": found.mine_left if found else None,
    }
