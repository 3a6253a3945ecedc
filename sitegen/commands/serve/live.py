"""The current state of the site: the files of its last good build, and the problems since then."""

from __future__ import annotations

import functools
import hashlib
import json
import re
import threading
import time
from collections.abc import Callable, Iterator, Mapping, Sequence
from dataclasses import replace
from fnmatch import fnmatch
from pathlib import Path
from urllib.parse import urlsplit

from sitegen.build import Made, make
from sitegen.commands.serve.edited import edited
from sitegen.commands.serve.keptypes import KeptTypes
from sitegen.errors import SiteError
from sitegen.model import BROWSERS, Artifact
from sitegen.options import Options
from sitegen.report import Report, count
from sitegen.site.pages import search

# A file and a line, as problems and compilers name them.
PLACE = re.compile(r"(?P<file>[^:\n]+):(?P<line>[0-9]{1,9})(:[0-9]+)?")
# The interval of messages on an idle connection (s), which detect that it is broken.
BEAT = 15


class LiveSite:
    """A site that is built again and again; threads read its files and wait for its events."""

    def __init__(self, folder: Path, report: Report, *, debug: bool = False) -> None:
        self._folder = folder
        self._report = report
        self._types = KeptTypes(report)
        # Programs are built for the browsers that are open; most of them have JSPI.
        self._options = Options(live=True, draft=True, debug=debug, engines=("jspi",))
        # Held while the site is built.
        self._building = threading.Lock()
        self._made: Made | None = None
        # The folder that its 404.html assumes for the site.
        self.base = "/"
        # Whether its pages are isolated.
        self.isolated = False
        self._files: Mapping[str, Artifact] = {}
        self._index: Callable[[], Sequence[Artifact]] = list
        self._digests: Mapping[str, str] = {}
        self._news: list[tuple[str, Sequence[str]]] = []
        # The number of news after each build.
        self._built: list[int] = []
        self._changed = threading.Condition()

    def rebuild(self, changed: Sequence[Path] = ()) -> None:
        """Build the site; if anything is wrong, keep the last good build and show the error."""
        with self._building:
            authored = [file for file in changed if not self._types.wrote(file)]
            if authored or not changed:
                self._rebuild(authored)

    def _rebuild(self, changed: Sequence[Path]) -> None:
        self._tell("building", ())
        begun = time.monotonic()
        try:
            same = edited(self._made, changed) if self._made else None
            made = same or self._make()
        except SiteError as error:
            for line in error.lines:
                self._report.say(line)
            self._report.say(f"{count(len(error.lines), 'problem')}; the pages are unchanged")
            self._tell("wrong", error.lines)
            self._made = None
            return
        self._made = made
        files = {artifact.path: artifact for artifact in made.artifacts}
        digests = {path: _digest(artifact) for path, artifact in files.items()}
        different = {path for path, _ in set(digests.items()) ^ set(self._digests.items())}
        # No open page has loaded a new file, or needs one that was removed.
        old = self._digests
        known = [p for p in different if (p in old and p in digests) or p.endswith(".html")]
        self._files, self._digests = files, digests
        # The index needs all pages, and authors seldom search while they write.
        self._index = functools.cache(lambda: made.renderer.index(made.rendered))
        self.base = urlsplit(made.site.url).path or "/"
        self.isolated = bool(made.site.isolate)
        names = ", ".join(file.name for file in changed[:3]) + (", …" if len(changed) > 3 else "")
        cause = f"{names}: " if names else ""
        seconds = time.monotonic() - begun
        self._report.say(f"{cause}built in {seconds:.1f} s, {count(len(different), 'file')} new")
        self._tell("built", sorted(known))
        if not same:
            # After the pages, which need not wait for an editor.
            self._types.renew(made)

    def _make(self) -> Made:
        return make(self._folder, self._report, options=self._options)

    def file(self, path: str) -> Artifact | None:
        """Return the file at `path` of the site."""
        if fnmatch(path, search.path("*")):
            return next((index for index in self._index() if index.path == path), None)
        return self._files.get(path)

    def place(self, text: str) -> tuple[Path, int] | None:
        """Return the file and the line that a problem names by `text`: `file:line` or with column.

        Of what compilers quote, only places in files of the site count.
        """
        with self._changed:
            kind, problems = self._news[-1] if self._news else ("", ())
        named = PLACE.fullmatch(text)
        lines = (line for problem in problems for line in problem.splitlines())
        if kind != "wrong" or not named or not any(one.startswith(f"{text}:") for one in lines):
            return None
        root = self._folder.resolve()
        path = (root / named["file"]).resolve()
        return (path, int(named["line"])) if path.is_relative_to(root) and path.is_file() else None

    @property
    def builds(self) -> int:
        """How often the site was built without an error."""
        with self._changed:
            return len(self._built)

    def news(self, engine: str, builds: int) -> Iterator[str]:
        """Yield server-sent events after so many builds: a page may be older than the site now.

        If `engine` is new, the C++ nodes are built for it, too.
        """
        with self._changed:
            seen = [0, *self._built][min(builds, len(self._built))]
        if engine in BROWSERS and engine not in self._options.engines:
            threading.Thread(target=self._add, args=(engine,), daemon=True).start()
        yield "retry: 500\n\n"
        while True:
            with self._changed:
                self._changed.wait_for(lambda: len(self._news) > seen, timeout=BEAT)  # noqa: B023
                news, seen = self._news[seen:], len(self._news)
            yield (
                "".join(f"event: {kind}\ndata: {json.dumps(what)}\n\n" for kind, what in news)
                or ":\n\n"
            )

    def _add(self, engine: str) -> None:
        with self._building:
            engines = self._options.engines
            if engine in engines:
                return
            self._options = replace(self._options, engines=(*engines, engine))
            self._report.say(f"building for {BROWSERS[engine]}, since one needs it")
            self._made = None
            self._rebuild(())

    def _tell(self, kind: str, what: Sequence[str]) -> None:
        with self._changed:
            self._news.append((kind, what))
            if kind == "built":
                self._built.append(len(self._news))
            self._changed.notify_all()


def _digest(artifact: Artifact) -> str:
    source = artifact.source
    if isinstance(source, bytes):
        return hashlib.sha256(source).hexdigest()
    about = source.stat()
    return _digest_of_file(source, about.st_mtime_ns, about.st_size)


@functools.lru_cache(maxsize=10_000)
def _digest_of_file(file: Path, time: int, size: int) -> str:
    """Return the digest of a file; it is cached by modification time and size."""
    return hashlib.sha256(file.read_bytes()).hexdigest()
