"""Tell the media type of a file that a page may load."""

from __future__ import annotations

import mimetypes
from pathlib import PurePosixPath

# The table of the operating system differs between machines, and browsers refuse a module, a style
# sheet or a program with a wrong type.
_TYPES = {
    ".avif": "image/avif",
    ".css": "text/css; charset=utf-8",
    ".gif": "image/gif",
    ".glb": "model/gltf-binary",
    ".gltf": "model/gltf+json",
    ".html": "text/html; charset=utf-8",
    ".ico": "image/vnd.microsoft.icon",
    ".ipynb": "application/x-ipynb+json",
    ".jpeg": "image/jpeg",
    ".jpg": "image/jpeg",
    ".js": "text/javascript; charset=utf-8",
    ".json": "application/json",
    ".mcap": "application/x-mcap",
    ".mjs": "text/javascript; charset=utf-8",
    ".mp3": "audio/mpeg",
    ".mp4": "video/mp4",
    ".ogg": "audio/ogg",
    ".otf": "font/otf",
    ".pdf": "application/pdf",
    ".png": "image/png",
    ".svg": "image/svg+xml",
    ".ttf": "font/ttf",
    ".txt": "text/plain; charset=utf-8",
    ".wasm": "application/wasm",
    ".wav": "audio/wav",
    ".webm": "video/webm",
    ".webmanifest": "application/manifest+json",
    ".webp": "image/webp",
    ".woff": "font/woff",
    ".woff2": "font/woff2",
    ".xml": "application/xml",
    ".zip": "application/zip",
}
# Source files that a page shows or offers: they are read, not run.
_TEXT = (".cpp", ".h", ".hpp", ".launch", ".md", ".msg", ".py", ".srv", ".yaml", ".yml")


def media_type(path: str) -> str:
    """Return what Content-Type says about the file at `path`."""
    suffix = PurePosixPath(path).suffix.lower()
    if suffix in _TEXT:
        return "text/plain; charset=utf-8"
    guessed, encoding = mimetypes.guess_type(path)
    return _TYPES.get(suffix) or (not encoding and guessed) or "application/octet-stream"
