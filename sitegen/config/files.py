"""Locate the files and folders that an author names."""

from __future__ import annotations

from pathlib import Path

from sitegen.config.document import Value
from sitegen.errors import Problems, nearest


def locate(
    value: Value, problems: Problems, *, folder: bool = False, page: Path | None = None
) -> Path | None:
    """Return the file or folder of the site that `value` names, and report one that is missing.

    It is looked for in the folder of site.yaml, then in that of the `page`.
    """
    root, text = problems.root, value.text
    try:
        path = (root / text).resolve()
        if page and not path.exists() and (page / text).exists():
            path = (page / text).resolve()
        fault = _fault(text, path, root, folder)
    except (OSError, RuntimeError, ValueError):
        path, fault = root, f"'{text}' cannot be opened; check the path"
    if fault:
        problems.add(value.location, value.label, fault)
        return None
    return path


def _fault(text: str, path: Path, root: Path, folder: bool) -> str:
    if "\\" in text:
        return f"'{text}' contains a backslash; write '{text.replace(chr(92), '/')}'"
    if Path(text).is_absolute():
        return f"'{text}' is an absolute path; make it relative to the folder of site.yaml"
    if not path.is_relative_to(root):
        return (
            f"'{text}' is outside the site's folder; keep all files below the folder of site.yaml"
        )
    if path.is_dir() if folder else path.is_file():
        return ""
    wanted, other = ("folder", "file") if folder else ("file", "folder")
    if path.exists():
        return f"'{text}' is a {other}; give a {wanted}"
    siblings = path.parent.iterdir() if path.parent.is_dir() else ()
    names = [
        (Path(text).parent / sibling.name).as_posix()
        for sibling in siblings
        if (sibling.is_dir() if folder else sibling.suffix == path.suffix)
        and not sibling.name.startswith(".")
    ]
    return f"no {wanted} '{text}'; {nearest(text, names)}"
