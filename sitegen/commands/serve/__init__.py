"""Serve a site while its author edits it: each change is built, and open pages are updated."""

from __future__ import annotations

from pathlib import Path

from sitegen import config
from sitegen.commands.serve.live import LiveSite
from sitegen.commands.serve.server import Server
from sitegen.commands.serve.watcher import changes
from sitegen.report import Report

__all__ = ["serve"]


def serve(folder: Path, *, port: int, report: Report, debug: bool = False) -> None:
    """Serve the site of `folder` on this computer until Ctrl-C.

    Only the files of `sitegen types` are written to it, if there are some. With `debug`, its C++
    nodes report source lines.

    Raises: SiteError if the folder has no site.yaml.
    """
    config.check_exists(folder / "site.yaml")
    live = LiveSite(folder, report, debug=debug)
    # Edits during the first build, which may take minutes, count.
    edits = changes(folder)
    live.rebuild()
    with Server(live, port) as server:
        if server.port != port:
            report.say(f"port {port} is in use")
        report.say(f"{server.url} (press Ctrl-C to stop)")
        for changed in edits:
            live.rebuild(changed)
