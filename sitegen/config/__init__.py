"""Read site.yaml, and the Markdown files that it names, into a Site."""

from __future__ import annotations

from typing import TYPE_CHECKING, Any

if TYPE_CHECKING:
    from sitegen.config.again import read_again
    from sitegen.config.jsonschema import json_schema
    from sitegen.config.site import check_exists, load

__all__ = ["check_exists", "json_schema", "load", "read_again"]


def __getattr__(name: str) -> Any:
    """Import what is asked for: the gateway checks its file with modules that need little."""
    if name in ("load", "check_exists"):
        from sitegen.config import site

        return getattr(site, name)
    if name == "json_schema":
        from sitegen.config.jsonschema import json_schema

        return json_schema
    if name == "read_again":
        from sitegen.config.again import read_again

        return read_again
    raise AttributeError(name)
