"""Pack the modules, workers and programs of a page for start.js to unpack."""

from __future__ import annotations

import base64
import gzip
import json
import posixpath
from collections.abc import Callable, Iterable, Mapping, Sequence

from sitegen.site.single.imports import imports, references

TYPES = {
    ".css": "text/css",
    ".js": "text/javascript",
    ".json": "application/json",
    ".mjs": "text/javascript",
    ".png": "image/png",
    ".svg": "image/svg+xml",
    ".wasm": "application/wasm",
    ".zip": "application/zip",
}
OTHER = "application/octet-stream"
# The modules of an author's panels.
OWN = "panels/"

# Returns the contents of a file inside `dist/`.
Read = Callable[[str], bytes]


def bundle(
    paths: Sequence[str],
    entries: Sequence[str],
    workers: Mapping[str, Sequence[str]],
    page: bytes,
    read: Read,
) -> str:
    """Return the files `paths` and `page`, a page.json, as base64.

    `entries` are the modules that start.js runs; `workers` maps the worker scripts to the files
    that they load.
    """
    parts: dict[str, bytes] = {"page.json": page} if page else {}
    for path in [*paths, *entries]:
        _add(path, parts, read)
    loads = {}
    for worker, scripts in workers.items():
        own: dict[str, bytes] = {}
        for path in (*scripts, worker):
            _add(path, own, read)
        loads[worker] = list(own)
        parts |= own
    files = [
        {"path": path, "type": TYPES.get(posixpath.splitext(path)[1], OTHER), "size": len(content)}
        for path, content in parts.items()
    ]
    about = {"files": files, "entries": list(entries), "workers": loads}
    head = json.dumps(about, separators=(",", ":")).encode()
    return _packed(b"".join([len(head).to_bytes(4, "big"), head, *parts.values()]))


def packed_size(contents: Iterable[bytes]) -> int:
    """Return the size in bytes that the files `contents` take in the page."""
    return len(_packed(b"".join(contents)))


def _packed(content: bytes) -> str:
    return base64.b64encode(gzip.compress(content, mtime=0)).decode()


def _add(path: str, parts: dict[str, bytes], read: Read) -> None:
    """Add a file after the files that it imports; its imports then refer to these by path."""
    if path in parts:
        return
    content = read(path)
    if path.endswith(".js") or (path.startswith(OWN) and path.endswith(".mjs")):
        text, pieces, end = content.decode(), [], 0
        named = references(text) if path.startswith(OWN) else imports(text)
        for specifier in named:
            found = posixpath.normpath(posixpath.join(posixpath.dirname(path), specifier.name))
            _add(found, parts, read)
            pieces += [text[end : specifier.start], f'"sitegen:{found}"']
            end = specifier.end
        content = "".join([*pieces, text[end:]]).encode()
    parts[path] = content
