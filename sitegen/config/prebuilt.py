"""Read a prebuilt program in site.yaml."""

from __future__ import annotations

from pathlib import Path

from sitegen.cache.fetch import allowed
from sitegen.config.files import locate
from sitegen.config.section import Section
from sitegen.errors import Problems
from sitegen.model import Prebuilt


def read(section: Section, problems: Problems) -> Prebuilt | None:
    """Return the archive that the author names; report an unsafe URL or a missing hash."""
    given = section.get("compiled")
    if given is None:
        return None
    source: str | Path | None = given.text
    if "://" not in given.text:
        source = locate(given, problems)
    elif not allowed(given.text):
        message = f"'{given.text}' is not a secure address; use one that begins with https://"
        problems.add(given.location, given.key, message)
    elif not section.value.has("sha256"):
        message = (
            "missing; a download needs the hash that is printed by `sitegen compile` or `sha256sum`"
        )
        problems.add(given.location, section.label("sha256"), message)
    if source is None:
        return None
    sha256, package, executable = map(section.text, ("sha256", "package", "executable"))
    return Prebuilt(source, sha256, package, executable, given.location, given.key)
