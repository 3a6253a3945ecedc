"""Files of authors may begin with a byte order mark, as editors of Windows write it."""

from __future__ import annotations

import re

from paths import ROOT

READ = re.compile(r"""(?:read_text\((?:encoding=)?|parser\.read\(.*?encoding=)["']utf-8["']""")
# The modules whose texts were written by sitegen or by a program, not by an author.
OWN = {
    *("cache/durations.py", "cache/unchanged.py", "commands/new.py", "commands/schema.py"),
    *(
        "commands/single.py",
        "commands/types.py",
        "commands/versions/build.py",
        "commands/versions/listed.py",
    ),
    *("config/displays.py", "gateway/native/descriptions.py", "gateway/native/types.py"),
    *("interfaces/declarations.py", "nodes/cpp/cmake.py", "nodes/cpp/diagnosis.py"),
    *(
        "nodes/cpp/leftout.py",
        "nodes/cpp/loadable.py",
        "nodes/cpp/plugins.py",
        "nodes/cpp/sourcemap.py",
        "nodes/python/archives.py",
        "site/bundles.py",
        "site/engine.py",
    ),
    *("site/assets.py", "site/jupyter/lab.py", "site/offline/worker.py", "site/single/page.py"),
    # rosidl refuses the mark, and this module says so.
    "interfaces/definitions.py",
    "workspace/repositories.py",
}
# These run in the page.
CLIENTS = "clients/"


def test_files_of_authors_are_read_with_or_without_a_mark() -> None:
    sitegen = ROOT / "sitegen"
    plain = {
        name
        for file in sitegen.rglob("*.py")
        if not (name := file.relative_to(sitegen).as_posix()).startswith((CLIENTS, "ros/"))
        and READ.search(file.read_text(encoding="utf-8"))
    }
    assert plain == OWN, "read files of authors as 'utf-8-sig', and Python sources as bytes"
