"""roslib from npm, bundled as an author would bundle it, and put beside a built site."""

from __future__ import annotations

import json
import shutil
import subprocess
from pathlib import Path
from urllib.parse import urlsplit

from paths import ROOT

# What docs/roslib.md tells authors to run.
COMMAND = ["node_modules/.bin/esbuild", "roslib", "--bundle", "--format=esm", "--log-level=error"]


def with_roslib(dist: Path, folder: Path) -> Path:
    """Return a copy of a built site below `folder`, with `roslib.js`."""
    copy = folder / "dist"
    shutil.copytree(dist, copy)
    subprocess.run([*COMMAND, f"--outfile={copy / 'roslib.js'}"], cwd=ROOT, check=True)
    return copy


def allow(inside: Path, url: str) -> None:
    """Let the site be built as if `messages_from` named the origin of `url`."""
    parts = urlsplit(url)
    file = inside / "page.json"
    entry = json.loads(file.read_text())
    assert entry["messagesFrom"] == ["http://127.0.0.1:1"]
    file.write_text(json.dumps(entry | {"messagesFrom": [f"{parts.scheme}://{parts.netloc}"]}))
