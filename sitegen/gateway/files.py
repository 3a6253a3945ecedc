"""Serve the files of a built site."""

from __future__ import annotations

import asyncio
from pathlib import Path
from urllib.parse import quote

from aiohttp import web

# Without these, browsers would show a file as something that it is not.
HEADERS = {"X-Content-Type-Options": "nosniff", "Cache-Control": "no-cache"}
TYPES = {
    ".html": "text/html; charset=utf-8",
    ".js": "text/javascript; charset=utf-8",
    ".mjs": "text/javascript; charset=utf-8",
    ".css": "text/css; charset=utf-8",
    ".json": "application/json",
    ".wasm": "application/wasm",
    ".svg": "image/svg+xml",
    ".txt": "text/plain; charset=utf-8",
    ".woff2": "font/woff2",
    ".webmanifest": "application/manifest+json",
}


class Files:
    """The files of a folder; nothing outside of it, and no hidden ones, can be asked for."""

    def __init__(self, folder: Path) -> None:
        self._folder = folder.resolve()

    async def answer(self, request: web.Request) -> web.StreamResponse:
        """Answer a GET or HEAD request."""
        path = request.path.removeprefix("/")
        # Files lie on a disk, which may be slow.
        file = await asyncio.to_thread(self._find, path)
        if isinstance(file, str):
            raise web.HTTPFound(quote(file))
        if file is None:
            missing = await asyncio.to_thread(self._find, "404.html")
            if not isinstance(missing, Path):
                raise web.HTTPNotFound(text="not found\n")
            text = await asyncio.to_thread(missing.read_bytes)
            return web.Response(
                body=text, status=404, headers={"Content-Type": TYPES[".html"], **HEADERS}
            )
        headers = dict(HEADERS)
        if kind := TYPES.get(file.suffix):
            headers["Content-Type"] = kind
        return web.FileResponse(file, headers=headers)

    def _find(self, path: str) -> Path | str | None:
        """Return the file of `path`, the path to go to instead, or None."""
        parts = path.split("/")
        if any(part.startswith(".") or "\\" in part or "\0" in part for part in parts):
            return None
        if path.endswith("/") or not path:
            path += "index.html"
        file = (self._folder / path).resolve()
        if not file.is_relative_to(self._folder):
            return None
        if file.is_dir():
            return f"/{path.lstrip('/')}/"
        return file if file.is_file() else None
