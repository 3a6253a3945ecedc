"""Write sitegen/workspace/repositories.txt from files of rosdistro.

`python tests/support/repositories.py kilted/distribution.yaml jazzy/distribution.yaml …`: where two
files have the same package, the first one counts.
"""

from __future__ import annotations

import sys
from collections.abc import Iterator, Sequence
from pathlib import Path

import yaml

from sitegen.workspace.repositories import TABLE

HEAD = """\
# Where the sources of ROS packages are: address, branch and packages of each repository.
# From rosdistro; written by tests/support/repositories.py.
"""


def lines(files: Sequence[Path]) -> Iterator[str]:
    known: set[str] = set()
    for file in files:
        content = yaml.load(file.read_text(encoding="utf-8"), yaml.CSafeLoader)
        for name, each in sorted(content["repositories"].items()):
            source = each.get("source") or each.get("doc") or {}
            packages = (each.get("release") or {}).get("packages") or [name]
            wanted = [package for package in packages if package not in known]
            url = str(source.get("url", "")).removesuffix(".git")
            if source.get("type") == "git" and url.startswith("https://") and wanted:
                known.update(wanted)
                yield " ".join([url, str(source["version"]), *wanted])


if __name__ == "__main__":
    found = sorted(lines([Path(file) for file in sys.argv[1:]]))
    TABLE.write_text(HEAD + "\n".join([*found, ""]), encoding="utf-8")
