"""Embed the files that a page loads in its HTML."""

from __future__ import annotations

import base64
import hashlib
import html
import json
import mimetypes
import posixpath
import re
from collections.abc import Mapping
from dataclasses import dataclass, field
from html.parser import HTMLParser
from pathlib import Path
from urllib.parse import unquote, urljoin, urlsplit

from sitegen import pagepath
from sitegen.model import Artifact, Page, Site
from sitegen.nodes import share
from sitegen.site.prose import resourced
from sitegen.site.single.bundle import bundle

# Marks a file that sitegen wrote.
HELD = '<script type="application/octet-stream" id="sitegen-files">'
START = Path(__file__).with_name("start.js")
URL = re.compile(r"""url\(\s*["']?([^"')]+)["']?\s*\)""")
# The assumed URL of the page, against which its links are resolved.
HERE = "site:/"
# Placeholder for the policy until it is known.
POLICY = "sitegen:policy"
# Python itself, and the workers that load it.
PYTHON = "runtime/vendor/pyodide/"
# Modules that workers load when they need them.
LATER = (
    *("runtime/messages/filter/", "runtime/bag/", "runtime/workers/environment.js"),
    "runtime/workers/cpp/packageFiles.js",
)
PYTHON_WORKERS = "runtime/workers/python/"
CPP_WORKER = "runtime/workers/cpp/cppNode.js"
JAVASCRIPT_WORKER = "runtime/workers/javascript/javascriptNode.js"
GATEWAY_WORKER = "runtime/workers/gateway/gatewayNode.js"
# What it loads if a server speaks rosbridge.
BRIDGE = "runtime/rosbridge/robot/bridge.js"
# The modules that cells of JavaScript may import.
CLIENTS = ("runtime/client/", "runtime/rosbridge/", "runtime/vendor/roslib.js")
# Files that are useless without a server.
DROPPED = {"modulepreload", "canonical", "alternate", "preload"}


def single_file(site: Site, page: Page, text: str, artifacts: Mapping[str, Artifact]) -> str:
    """Return `page` as one HTML file; `text` is its HTML in the site.

    `artifacts` are those of the page and of everything that it may load, by path.
    """
    writer = _Writer(site, page, artifacts)
    writer.feed(text)
    writer.close()
    return writer.finished()


@dataclass
class _Writer(HTMLParser):
    site: Site
    page: Page
    artifacts: Mapping[str, Artifact]
    out: list[str] = field(default_factory=list)
    entries: list[str] = field(default_factory=list)
    # Hashes for the policy.
    scripts: list[str] = field(default_factory=list)
    styles: list[str] = field(default_factory=list)
    inside: str = ""

    def __post_init__(self) -> None:
        super().__init__(convert_charrefs=False)

    def finished(self) -> str:
        """Return the page with its policy and its files."""
        start = START.read_text(encoding="utf-8")
        files = f'{HELD}{self._files()}</script>\n<script type="module">{start}</script>\n'
        self.scripts.append(_hash(start))
        text = "".join(self.out).replace("</body>", f"{files}</body>")
        return text.replace(POLICY, html.escape(self._policy()), 1)

    def handle_starttag(self, tag: str, attrs: list[tuple[str, str | None]]) -> None:
        given = {name: value or "" for name, value in attrs}
        written = self.get_starttag_text() or ""
        if tag == "meta" and given.get("http-equiv") == "Content-Security-Policy":
            written = f'<meta http-equiv="Content-Security-Policy" content="{POLICY}">'
        elif tag == "link":
            written = self._link(given, written)
        elif tag == "script":
            written = self._script(given, written)
        else:
            for name in ("src", "poster", "href"):
                if name in given:
                    written = self._attribute(tag, name, given[name], written)
            if "srcset" in given:
                sources = html.escape(resourced(given["srcset"], self._inside))
                written = written.replace(html.escape(given["srcset"]), sources, 1)
        self.out.append(written)

    handle_startendtag = handle_starttag

    def handle_endtag(self, tag: str) -> None:
        if tag == "script" and self.inside == "module":
            self.inside = ""
            return
        self.inside = ""
        self.out.append(f"</{tag}>")

    def handle_data(self, data: str) -> None:
        if self.inside == "script":
            self.scripts.append(_hash(data))
        self.out.append(data)

    def handle_entityref(self, name: str) -> None:
        self.out.append(f"&{name};")

    def handle_charref(self, name: str) -> None:
        self.out.append(f"&#{name};")

    def handle_decl(self, decl: str) -> None:
        self.out.append(f"<!{decl}>")

    def handle_comment(self, data: str) -> None:
        self.out.append(f"<!--{data}-->")

    def _link(self, given: Mapping[str, str], written: str) -> str:
        if given.get("id") == "ros-page":
            return '<link id="ros-page">'
        if given.get("rel") in DROPPED:
            return ""
        path = self._path(given.get("href", ""))
        if path is None:
            return written
        if given.get("rel") != "stylesheet":
            return written.replace(html.escape(given["href"]), self._data(path))
        style = self._style(path)
        self.styles.append(_hash(style))
        media = f' media="{given["media"]}"' if "media" in given else ""
        return f"<style{media}>{style}</style>"

    def _script(self, given: Mapping[str, str], written: str) -> str:
        path = self._path(given["src"]) if "src" in given else None
        if path is None:
            self.inside = "script"
            return written
        if given.get("type") == "module":
            self.entries.append(path)
            self.inside = "module"
            return ""
        script = self._read(path).decode()
        self.scripts.append(_hash(script))
        return f"<script>{script}"

    def _attribute(self, tag: str, name: str, value: str, written: str) -> str:
        path = self._path(value)
        if path is None or value.startswith("#"):
            return written
        if path in self.artifacts and not path.endswith(".html"):
            found = self._data(path)
        else:
            # Another page: its URL on the web, or no link.
            found = self.site.url + self._absolute(value).removeprefix(HERE)
            if not self.site.url:
                return re.sub(rf"""\s{name}=("[^"]*"|'[^']*'|[^\s>]+)""", "", written, count=1)
        return written.replace(html.escape(value), html.escape(found), 1)

    def _inside(self, address: str) -> str:
        """Return a file of the site as a URL that contains it; other URLs are unchanged."""
        path = self._path(address)
        return self._data(path) if path and path in self.artifacts else address

    def _absolute(self, address: str) -> str:
        # urljoin resolves relative paths of http URLs only.
        base = f"http://site/{self.page.path}"
        return urljoin(base, address).replace("http://site/", HERE, 1)

    def _path(self, address: str) -> str | None:
        """Return the path inside `dist/` for a URL in the page, if it has one."""
        absolute = self._absolute(address)
        if not address or not absolute.startswith(HERE):
            return None
        path = unquote(urlsplit(absolute.removeprefix(HERE)).path)
        return pagepath.file_of(path)

    def _read(self, path: str) -> bytes:
        source = self.artifacts[path].source
        return source if isinstance(source, bytes) else source.read_bytes()

    def _data(self, path: str) -> str:
        type_ = mimetypes.guess_type(path)[0] or "application/octet-stream"
        return f"data:{type_};base64,{base64.b64encode(self._read(path)).decode()}"

    def _style(self, path: str) -> str:
        def inlined(match: re.Match[str]) -> str:
            name = posixpath.normpath(posixpath.join(posixpath.dirname(path), match[1]))
            return f'url("{self._data(name)}")' if name in self.artifacts else match[0]

        return URL.sub(inlined, self._read(path).decode("utf-8-sig"))

    def _files(self) -> str:
        entry = self.artifacts.get(f"{self.page.path}page.json")
        if entry is None:
            return bundle([], self.entries, {}, b"", self._read)
        run = json.loads(self._read(entry.path))
        programs = []
        shared: list[str] = []
        python: list[str] = []
        for node in run["nodes"].values():
            for build in node.get("builds", {}).values():
                for name, address in build.items():
                    path = self._path(address) or ""
                    programs.append(path)
                    build[name] = f"sitegen:{path}"
            if "share" in node:
                listing = self._path(node["share"]) or ""
                shared += [listing, *share.listed(self._read(listing))]
                node["share"] = f"sitegen:{listing}"
            if "python" in node:
                archives = [self._path(address) or "" for address in node["python"]["bundles"]]
                python += archives
                node["python"]["bundles"] = [f"sitegen:{path}" for path in archives]
        meshes, own = [], []
        for widget in run["widgets"]:
            for url, address in widget["options"].get("resources", {}).items():
                meshes.append(self._path(address) or "")
                widget["options"]["resources"][url] = f"sitegen:{meshes[-1]}"
            if widget["kind"] == "bag" and "file" in widget["options"]:
                meshes.append(self._path(widget["options"]["file"]) or "")
                widget["options"]["file"] = f"sitegen:{meshes[-1]}"
            for name, address in widget["options"].get("bags", {}).items():
                meshes.append(self._path(address) or "")
                widget["options"]["bags"][name] = f"sitegen:{meshes[-1]}"
            for name in {"interfaces", "texts", "hashes"} & widget["options"].keys():
                # A connection has its hashes in the page.
                if isinstance(widget["options"][name], dict):
                    continue
                meshes.append(self._path(widget["options"][name]) or "")
                widget["options"][name] = f"sitegen:{meshes[-1]}"
            if "module" in widget["options"]:
                own.append(self._path(widget["options"]["module"]) or "")
                widget["options"]["module"] = f"sitegen:{own[-1]}"
        for script in run.get("scripts", ()):
            own.append(self._path(script["module"]) or "")
            script["module"] = f"sitegen:{own[-1]}"
        for name in ("interfaces", "texts"):
            if name in run:
                meshes.append(self._path(run[name]) or "")
                run[name] = f"sitegen:{meshes[-1]}"
        if python:
            python += (path for path in self.artifacts if path.startswith(PYTHON))
        modules = [path for path in self.artifacts if path.startswith("runtime/")]
        modules = [path for path in modules if path.endswith(".js")]
        workers = [path for path in modules if path.startswith("runtime/workers/")]
        scripts = [path for path in programs if path.endswith(".js")]
        wasm = [path for path in programs if path.endswith(".wasm")]
        # Each worker has its own bundle, including modules that it loads on demand.
        later = [path for path in modules if path.startswith(LATER)]
        begun = [path for path in workers if path.endswith("Node.js")]
        starts = {
            path: [*dict.fromkeys(python), *later]
            if path.startswith(PYTHON_WORKERS)
            else [*scripts, *later]
            for path in begun
        }
        if CPP_WORKER in starts:
            starts[CPP_WORKER] += dict.fromkeys(shared)
        if GATEWAY_WORKER in starts:
            starts[GATEWAY_WORKER].append(BRIDGE)
            modules.remove(BRIDGE)
        if JAVASCRIPT_WORKER in starts:
            defined = [path for path in meshes if path.startswith("interfaces")]
            starts[JAVASCRIPT_WORKER] = [path for path in modules if path.startswith(CLIENTS)]
            starts[JAVASCRIPT_WORKER] += dict.fromkeys(defined)
        paths = [path for path in modules if path not in (*workers, *later)] + wasm
        paths += dict.fromkeys([*meshes, *own])
        return bundle(paths, self.entries, starts, json.dumps(run).encode(), self._read)

    def _policy(self) -> str:
        def listed(hashes: list[str]) -> str:
            return " ".join(f"'{one}'" for one in dict.fromkeys(hashes))

        joined = self.page.connect.addresses if self.page.connect else ()
        # A file has no server of its own.
        gateways = "".join(f" {address}" for address in joined if address != "self")
        return "; ".join(
            [
                "default-src 'none'",
                f"script-src {listed(self.scripts)} blob: 'wasm-unsafe-eval'",
                f"style-src {listed(self.styles)}",
                "img-src data: blob:",
                "media-src data:",
                "font-src data:",
                f"connect-src data: blob:{gateways}",
                "worker-src blob:",
                "base-uri 'none'",
                "form-action 'none'",
            ]
        )


def _hash(text: str) -> str:
    return f"sha256-{base64.b64encode(hashlib.sha256(text.encode()).digest()).decode()}"
