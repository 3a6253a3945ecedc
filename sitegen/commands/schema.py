"""Write the JSON Schema of site.yaml for editors."""

from __future__ import annotations

import json
from pathlib import Path

from sitegen import config
from sitegen.errors import SiteError

FILE = "site.schema.json"
# The first line of site.yaml, which tells editors where the schema is, relative to it.
MODELINE = f"# yaml-language-server: $schema={FILE}"


def text() -> str:
    """Return the contents of the schema file."""
    return json.dumps(config.json_schema(), indent=2) + "\n"


def check_free(folder: Path) -> None:
    """Refuse to replace a file that is not a schema of sitegen.

    Raises: SiteError if there is one.
    """
    file = folder / FILE
    title = json.dumps(config.json_schema()["title"])
    if file.exists() and title not in file.read_text("utf-8", "replace"):
        raise SiteError([f"{file} already exists and was not written by sitegen; rename it"])


def write(folder: Path) -> Path:
    """Write the schema into `folder`, next to its site.yaml; return its file."""
    file = folder / FILE
    file.write_text(text(), encoding="utf-8")
    return file
