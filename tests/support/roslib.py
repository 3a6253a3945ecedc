"""roslib from npm, bundled as an author would bundle it, and put beside a built site."""

from __future__ import annotations

import shutil
import subprocess
from pathlib import Path

from paths import ROOT

# What docs/roslib.md tells authors to run.
COMMAND = ["node_modules/.bin/esbuild", "roslib", "--bundle", "--format=esm", "--log-level=error"]


def with_roslib(dist: Path, folder: Path) -> Path:
    """Return a copy of a built site below `folder`, with `roslib.js`."""
    copy = folder / "dist"
    shutil.copytree(dist, copy)
    subprocess.run([*COMMAND, f"--outfile={copy / 'roslib.js'}"], cwd=ROOT, check=True)
    return copy
