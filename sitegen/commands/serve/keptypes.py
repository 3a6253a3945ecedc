"""Keep the files of `sitegen types` current while their site is edited."""

from __future__ import annotations

from pathlib import Path

from sitegen.build import Made
from sitegen.commands.types import outdated
from sitegen.errors import SiteError, relative
from sitegen.report import Report


class KeptTypes:
    """The types in the folder of a site; they are written again, but none are added.

    A file counts if `sitegen types` wrote it: who never called that wants no files, and who wrote
    declarations of the same name keeps them.
    """

    def __init__(self, report: Report) -> None:
        self._report = report
        self._written: dict[Path, bytes] = {}

    def renew(self, made: Made) -> None:
        """Write the files again whose types have changed."""
        try:
            found = outdated(made)
        except SiteError as error:
            # The build reads no interfaces that nothing uses.
            for line in error.lines:
                self._report.say(line)
            return
        written = []
        for file, text in found.items():
            name = relative(file, made.site.root)
            # Noted first: the watcher may see the file before this goes on.
            self._written[file.resolve()] = text.encode()
            try:
                file.write_bytes(text.encode())
            except OSError as error:
                self._report.say(f"{name}: cannot be written: {error.strerror}")
            else:
                written.append(name)
        if written:
            self._report.say(f"wrote {', '.join(written)}: the types have changed")

    def wrote(self, file: Path) -> bool:
        """Return whether `file` is as this wrote it, so that no author has changed it."""
        content = self._written.get(file.resolve())
        return content is not None and file.is_file() and file.read_bytes() == content
