"""The terminal that opens for the commands in the text of a page."""

from __future__ import annotations

from pathlib import Path

from launching import PACKAGE

from sitegen.config import load
from sitegen.model import Widget

SITE = """\
site: {title: A}
nodes:
  talk: {package: mine, executable: talk}
  other: {package: mine, executable: other}
pages:
  - {path: /, title: A, level: I1, content: [markdown: text.md, console: other]}
  - {path: text/, title: B, content: [markdown: text.md]}
  - {path: more/, title: C, content: [markdown: text.md, terminal: {docked: true}]}
  - {path: none/, title: D, content: [markdown: none.md]}
  - {path: plain/, title: E, content: [markdown: plain.md, console: other]}
  - {path: own/, file: own.md}
"""
COMMANDS = "ros2 run mine talk &\nros2 topic list\n```\n"
FILES = {
    "text.md": f"```ros2\n{COMMANDS}",
    "plain.md": f"```bash\n{COMMANDS}",
    # Without nodes, there is nothing that it could list.
    "none.md": "```ros2\nros2 topic list\n```\n",
    "own.md": """\
---
nodes: {its: {package: mine, executable: other}}
---
# Own

- In a list:

  ```console
  $ ros2 topic list
  /chatter
  ```
""",
    "src/mine/package.xml": PACKAGE.format("mine"),
    "src/mine/CMakeLists.txt": "add_executable(talk a.cpp)\nadd_executable(other b.cpp)",
}


def test_commands_in_the_text_get_a_terminal(tmp_path: Path) -> None:
    for name, text in {**FILES, "site.yaml": SITE}.items():
        file = tmp_path / name
        file.parent.mkdir(parents=True, exist_ok=True)
        file.write_text(text)
    shown = {}
    for page in load(tmp_path / "site.yaml").pages:
        found = [part for part in page.leaves if isinstance(part, Widget)]
        shown[page.path] = [(w.kind, w.is_docked, list(w.runs)) for w in found], [*page.nodes]
    assert shown == {
        "": ([("console", False, []), ("terminal", True, ["talk"])], ["other", "talk"]),
        "text/": ([("terminal", True, ["talk"])], ["talk"]),
        "more/": ([("terminal", True, [])], []),
        "none/": ([], []),
        "plain/": ([("console", False, [])], ["other"]),
        "own/": ([("terminal", True, ["its"])], ["its"]),
    }
