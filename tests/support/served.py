"""A site that is served while a test edits it."""

from __future__ import annotations

import io
import shutil
from pathlib import Path

from paths import ROOT

from sitegen.commands.serve.live import LiveSite
from sitegen.commands.serve.server import Server
from sitegen.report import Report

SITE = """\
site: {title: My robot}
pages:
  - {path: /, file: index.md}
  - {path: other/, title: Other, content: [{markdown: The other page.}]}
"""


class Serving:
    """A site in a folder that follows its author."""

    def __init__(self, folder: Path) -> None:
        self.folder = folder
        self.said = io.StringIO()
        self.live = LiveSite(folder, Report(self.said))
        self.server = Server(self.live, 0)

    @property
    def url(self) -> str:
        return self.server.url

    def write(self, path: str, text: str) -> None:
        (self.folder / path).write_text(text)


TEXT = """\
---
title: Two nodes
nodes:
  talker: {package: cpp_pubsub, executable: talker}
  listener: {package: cpp_pubsub, executable: listener}
---
# Two nodes

The first text.

```cpp
int first;
```

```ros
- buttons: talker
- console: talker
- topics: {echo: /chatter}
- publish: {topic: /chatter}
```

## Later

### Details

## Last

The end.
"""


def edited_site(tmp_path: Path) -> Path:
    site = tmp_path / "demo"
    shutil.copytree(ROOT / "demos/demo03", site, ignore=shutil.ignore_patterns("dist"))
    (site / "page.md").write_text(TEXT)
    return site
