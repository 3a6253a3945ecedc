"""Collect the definitions of all interfaces that scripts of a site can use."""

from __future__ import annotations

import hashlib
import json
from collections.abc import Iterator, Mapping
from pathlib import Path

from sitegen.interfaces import typesupport
from sitegen.interfaces.descriptions import described
from sitegen.interfaces.generator import shares
from sitegen.interfaces.messages import MessageType, types
from sitegen.model import Artifact, Site
from sitegen.shipped import ROS

# For the tests of client libraries.
LEFT_OUT = {"test_msgs"}
# The action of ROS's tutorials and of roslib's examples, and one that differs in a name only.
TUTORIAL, SIMILAR = (
    f"{one}/action/Fibonacci" for one in ("action_tutorials_interfaces", "example_interfaces")
)


def catalogue(site: Site, *, cache: Path) -> dict[str, MessageType]:
    """Return the message types of ROS, sitegen and the workspace, by name.

    A script may use any interface, not only those of the nodes on its page. See MessageType in
    protocol.js.

    Raises: SiteError if definitions of the workspace are wrong.
    """
    prefix = _prefix(site, cache)
    found = types(_names(prefix), [prefix])
    return {**_tutorial(found), **found}


def texts(site: Site, *, cache: Path) -> dict[str, str]:
    """Return the text of the .msg, .srv and .action files of the same interfaces, by name.

    Raises: SiteError if definitions of the workspace are wrong.
    """
    return {
        f"{share.name}/{kind}/{file.stem}": file.read_text(encoding="utf-8-sig")
        for share in shares([ROS, _prefix(site, cache)])
        if share.name not in LEFT_OUT
        for kind in ("msg", "srv", "action")
        for file in sorted((share / kind).glob(f"*.{kind}"))
    }


def _prefix(site: Site, cache: Path) -> Path:
    own = [name for name, package in site.packages.items() if package.interfaces]
    return described(site, own, cache=cache)


def as_artifact(content: bytes) -> Artifact:
    """Return the file of a site with definitions, whose name says whether they have changed."""
    return Artifact(f"interfaces/{hashlib.sha256(content).hexdigest()[:10]}.json", content)


def as_json(found: Mapping[str, object]) -> bytes:
    """Return message types, or their texts, as the text of a file."""
    return json.dumps(found, sort_keys=True, separators=(",", ":"), ensure_ascii=False).encode()


def _tutorial(found: dict[str, MessageType]) -> dict[str, MessageType]:
    """Return the types of the action of ROS's tutorials, which no wheel contains."""
    own = {name: one for name, one in found.items() if name.startswith(f"{SIMILAR}_")}
    renamed: dict[str, MessageType] = json.loads(json.dumps(own).replace(SIMILAR, TUTORIAL))
    renamed[f"{TUTORIAL}_Feedback"]["fields"][0]["name"] = "partial_sequence"
    return renamed


def _names(prefix: Path) -> Iterator[str]:
    for share in shares([ROS, prefix]):
        if share.name in LEFT_OUT:
            continue
        for description in sorted(share.glob("*/*.json")):
            for message in typesupport.read_description(description):
                if not message.name.endswith("_Event"):
                    yield message.name
