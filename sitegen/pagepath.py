"""Turn the path of a page into its file in `dist/`, and back.

A path is a folder ("demo/"), empty for the first page, or a file ("404.html").
"""

from __future__ import annotations

INDEX = "index.html"


def normalized(text: str) -> str:
    """Return a path that an author wrote in the form that sitegen uses: "/demo" is "demo/"."""
    return f"{text.strip('/')}/".removeprefix("/")


def file_of(path: str) -> str:
    """Return the file of the page at `path`; a path that names a file is returned unchanged."""
    return f"{path}{INDEX}" if not path or path.endswith("/") else path


def path_of(file: str) -> str:
    """Return the path at which a web server serves `file`."""
    folder, _, name = file.rpartition("/")
    if name != INDEX:
        return file
    return f"{folder}/" if folder else ""
