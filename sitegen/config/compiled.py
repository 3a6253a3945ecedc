"""Turn what the author wrote about a node that was compiled elsewhere into a Compiled."""

from __future__ import annotations

from pathlib import Path

from sitegen.cache.fetch import allowed
from sitegen.config.location import locate
from sitegen.config.section import Section
from sitegen.errors import Problems
from sitegen.model import Compiled


def read(section: Section, problems: Problems) -> Compiled | None:
    """Return the archive that is meant, noting an address that is not safe or lacks a hash."""
    given = section.get("compiled")
    if given is None:
        return None
    source: str | Path | None = given.text
    if "://" not in given.text:
        source = locate(given, problems)
    elif not allowed(given.text):
        message = f"'{given.text}' is not safe; use an address that begins with https://"
        problems.add(given.place, given.key, message)
    elif not section.value.has("sha256"):
        message = (
            "missing; what comes from elsewhere needs a hash, as `sitegen compile` prints it, or "
            "`sha256sum`"
        )
        problems.add(given.place, section.label("sha256"), message)
    if source is None:
        return None
    sha256, package, executable = map(section.text, ("sha256", "package", "executable"))
    return Compiled(source, sha256, package, executable, given.place, given.key)
