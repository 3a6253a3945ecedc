"""Turn folders of notebooks into the listing that JupyterLite reads from a server of files."""

from __future__ import annotations

import json
import mimetypes
from collections.abc import Sequence
from pathlib import Path
from typing import Any

from sitegen.errors import SiteError
from sitegen.ignored import is_ignored
from sitegen.model import Artifact

NOTEBOOK = ".ipynb"
# The name of the listing of each folder.
LISTING = "all.json"
# A listing needs dates; these of the files would make each build another one.
DATE = "1980-01-01T00:00:00Z"


def artifacts(folders: Sequence[Path], target: str) -> list[Artifact]:
    """Return the files of `folders`, as JupyterLite in the folder `target` finds them.

    Raises: SiteError if two folders have different files with the same path.
    """
    files: dict[str, Path] = {}
    for folder in folders:
        for file in sorted(folder.rglob("*")):
            parts = file.relative_to(folder).parts
            if not file.is_file() or any(is_ignored(name, at_root=False) for name in parts):
                continue
            name = "/".join(parts)
            if files.setdefault(name, file).read_bytes() != file.read_bytes():
                raise SiteError(
                    [f"{file}: {files[name]} has the same path among the notebooks; rename one"]
                )
    found = [Artifact(f"{target}/files/{name}", file) for name, file in files.items()]
    names = {name.rpartition("/")[0] for name in files} | {""}
    names |= {"/".join(name.split("/")[:n]) for name in names for n in range(name.count("/") + 1)}
    for folder_name in sorted(names):
        listing = json.dumps(_folder(folder_name, files, names)).encode()
        path = "/".join(filter(None, (target, "api/contents", folder_name, LISTING)))
        found.append(Artifact(path, listing))
    return found


def _folder(name: str, files: dict[str, Path], folders: set[str]) -> dict[str, Any]:
    inside = [
        _model(one, "directory", "json") for one in sorted(folders) if one and _parent(one) == name
    ]
    for path, file in sorted(files.items()):
        if _parent(path) == name:
            inside.append(_file(path, file))
    return {**_model(name, "directory", "json"), "content": inside}


def _file(path: str, file: Path) -> dict[str, Any]:
    if path.endswith(NOTEBOOK):
        model = _model(path, "notebook", "json")
    else:
        kind = mimetypes.guess_type(path)[0] or "text/plain"
        text = kind.startswith("text/") or kind in ("application/json", "image/svg+xml")
        model = {**_model(path, "file", "text" if text else "base64"), "mimetype": kind}
    return {**model, "size": file.stat().st_size}


def _model(path: str, kind: str, form: str) -> dict[str, Any]:
    return {
        "name": path.rpartition("/")[2],
        "path": path,
        "type": kind,
        "format": form,
        "content": None,
        "created": DATE,
        "last_modified": DATE,
        "mimetype": None,
        "size": None,
        "writable": True,
    }


def _parent(path: str) -> str:
    return path.rpartition("/")[0]
