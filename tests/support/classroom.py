"""The page of a class that shares one gateway."""

from __future__ import annotations

from pathlib import Path

SITE = """
site: {{title: Class, language: {language}}}
connect: {{addresses: [{address}], autoconnect: true, namespace: {namespace}}}
pages:
  - path: /
    title: Class
    content:
      - topics:
      - connect:
"""


def classroom(folder: Path, address: str, namespace: str, language: str = "en") -> Path:
    """Write the site of a student to a new folder or an empty one, and return it."""
    folder.mkdir(exist_ok=True)
    text = SITE.format(language=language, address=address, namespace=namespace)
    folder.joinpath("site.yaml").write_text(text, encoding="utf-8")
    return folder
