"""Read what site.yaml says about the packages of Python nodes."""

from __future__ import annotations

from pathlib import Path

from sitegen.cache.fetch import allowed
from sitegen.config.document import Value
from sitegen.config.schema import PYODIDE
from sitegen.config.section import check
from sitegen.errors import Problems
from sitegen.model import Pyodide


def pyodide(given: Value | None, problems: Problems) -> Pyodide:
    """Return where packages come from, and report files that are missing."""
    if given is None:
        return Pyodide()
    section = check(given, PYODIDE, problems)
    written = section.text("requirements")
    requirements = (problems.root / written).resolve() if written else None
    if requirements and not (requirements.is_relative_to(problems.root) and requirements.is_file()):
        message = f"no file '{written}' in the folder of site.yaml"
        problems.add(section.location("requirements"), section.label("requirements"), message)
        requirements = None
    text = section.text("packages")
    packages: Path | str = text
    if text and "://" not in text:
        packages = (problems.root / text).resolve()
        if not packages.is_dir():
            message = f"no folder '{text}'; write it like 'vendor/pyodide', or an address"
            problems.add(section.location("packages"), section.label("packages"), message)
    elif text and not allowed(text):
        message = f"'{text}' is not a valid address; write it like 'https://…/'"
        problems.add(section.location("packages"), section.label("packages"), message)
    elif text and not text.endswith("/"):
        packages = f"{text}/"
    return Pyodide(packages, requirements)
