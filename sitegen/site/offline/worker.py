"""Write the service worker of a site, which knows every file by its hash."""

from __future__ import annotations

import hashlib
import json
import re
from collections.abc import Iterable, Mapping, Sequence
from pathlib import Path, PurePosixPath
from urllib.parse import unquote, urljoin, urlsplit

from sitegen import pagepath
from sitegen.mediatype import media_type
from sitegen.model import Artifact, Site
from sitegen.nodes import share
from sitegen.site.engine import ENGINE

PATH = "sw.js"
HERE = Path(__file__).parent
RETIRED = (HERE / "retired.js").read_bytes()
# A site up to this size in bytes is cached as a whole; the programs and images of a larger site are
# cached with the first page that needs them.
WHOLE = 8_000_000
LAB = "jupyter/"
LATER = (LAB, "nodes/", "ros2wasm/", "media/", "runtime/vendor/pyodide/")
# Of a larger bag, a page loads the parts that it plays, which no cache has.
BAGS = "bags/"
# Files that are useless without a network.
LEFT_OUT = {".nojekyll", "CNAME", "feed.xml", "robots.txt", "sitemap.xml"}
SOURCE = re.compile(r'\s(?:src|poster)="([^"]+)"')


def artifacts(site: Site, made: Iterable[Artifact]) -> list[Artifact]:
    """Return the service worker for all files of a site, if the site has one."""
    if site.offline is None and site.isolate is None:
        return []
    if not site.offline and not site.isolate:
        # Visitors of an earlier version have its service worker, which would serve the old pages
        # forever.
        return [Artifact(PATH, RETIRED)]
    if not site.offline:
        return [Artifact(PATH, _written({"isolate": True}, "passing.js"))]
    contents = {
        artifact.path: _bytes(artifact)
        for artifact in made
        if artifact.path not in LEFT_OUT and not _is_large_bag(artifact)
    }
    return [Artifact(PATH, _worker(site, contents))]


def _worker(site: Site, contents: Mapping[str, bytes]) -> bytes:
    files = {pagepath.path_of(path): _hash(content) for path, content in sorted(contents.items())}
    total = sum(len(content) for content in contents.values())
    later = [name for name in files if name.startswith(LATER)] if total > WHOLE else []
    pages = {page.path: _needs(page.path, contents, set(later)) for page in site.pages}
    build = {
        "version": _hash(json.dumps(files).encode()),
        "files": files,
        "types": _types(contents),
        "later": later,
        "pages": {path: needs for path, needs in pages.items() if needs},
        "isolate": bool(site.isolate),
    }
    return _written(build, "worker.js")


def _types(paths: Iterable[str]) -> dict[str, str]:
    """Return the media types of the files of a site, by suffix."""
    suffixes = {PurePosixPath(path).suffix for path in paths} - {""}
    return {suffix: media_type(f"file{suffix}") for suffix in sorted(suffixes)}


def _written(build: Mapping[str, object], *names: str) -> bytes:
    about = json.dumps(build, separators=(",", ":"), ensure_ascii=False)
    scripts = ((HERE / name).read_text(encoding="utf-8") for name in ("headers.js", *names))
    return "\n".join([f"const BUILD = {about};", ENGINE, *scripts]).encode()


def _needs(path: str, contents: Mapping[str, bytes], later: set[str]) -> Sequence[str]:
    """Return the files that the page at `path` needs and that are not cached with the site."""
    if not later:
        return []
    addresses = SOURCE.findall(contents[pagepath.file_of(path)].decode())
    found = set()
    entry = json.loads(contents.get(f"{path}page.json", b'{"nodes": {}, "widgets": []}'))
    if any(widget["kind"] == "jupyter" for widget in entry["widgets"]):
        found |= {name for name in later if name.startswith(LAB)}
    for node in entry["nodes"].values():
        for build in node.get("builds", {}).values():
            addresses += build.values()
        if "share" in node:
            listing = _inside(path, node["share"])
            found |= {listing, *share.listed(contents[listing])}
        if "python" in node:
            addresses += node["python"]["bundles"]
            found |= {name for name in later if name.startswith("runtime/vendor/pyodide/")}
        if "ros2wasm" in node:
            script = _inside(path, node["ros2wasm"]["script"])
            folder = script.rpartition("/")[0]
            found |= {name for name in later if name.startswith(f"{folder}/")}
    found |= {_inside(path, address) for address in addresses}
    return sorted(found & later)


def _inside(path: str, address: str) -> str:
    """Return the path inside `dist/` for a URL in the page at `path`."""
    base = "http://site/"
    return unquote(urlsplit(urljoin(f"{base}{path}", address)).path).removeprefix("/")


def _hash(content: bytes) -> str:
    return hashlib.sha256(content).hexdigest()[:32]


def _is_large_bag(artifact: Artifact) -> bool:
    if not artifact.path.startswith(BAGS):
        return False
    source = artifact.source
    return (len(source) if isinstance(source, bytes) else source.stat().st_size) > WHOLE


def _bytes(artifact: Artifact) -> bytes:
    source = artifact.source
    return source if isinstance(source, bytes) else source.read_bytes()
