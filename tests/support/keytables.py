"""Turn the schema of site.yaml into the tables of its keys in docs/.

`python tests/support/keytables.py` writes them; tests/project/test_docs.py compares them.
"""

from __future__ import annotations

import re
from collections.abc import Mapping, Sequence

from paths import ROOT

from sitegen.config.displays import Kind, kinds
from sitegen.config.nodekeys import COMPILED, NODE, ROS2WASM
from sitegen.config.schema import (
    BUILD,
    CONNECT,
    DEPLOY,
    FILE,
    NAMES,
    PAGE,
    PYODIDE,
    SITE,
    Key,
)
from sitegen.config.widgetkeys import COLUMN, ROW, STAGE, THRESHOLD, WIDGETS
from sitegen.gateway import schema

# The widgets of one node; all others are panels.
OF_NODES = ("buttons", "console", "source", "prompt", "editor")
OF_GRAPH = ("topics", "services", "actions", "publish", "tf")
ABOUT_NODES = ("parameters", "lifecycle", "diagnostics", "log")
# Those that move a robot.
ROBOTS = ("joints", "teleop", "robot")
# Those that show what nodes measure, and what cameras see.
PLOTS = ("plot", "value")
IMAGES = ("image", "camera")
NOTEBOOKS = ("notebook", "jupyter")
BAGS = ("bag",)
# Those that an author writes.
OWN = ("panel",)
# The keys below each heading of a page.
TABLES: Mapping[str, Mapping[str, Sequence[Key]]] = {
    "site-yaml.md": {
        "The file": FILE,
        "site": SITE,
        "deploy": DEPLOY,
        "pyodide": PYODIDE,
    },
    "nodes.md": {
        "A node": NODE,
        "A node compiled elsewhere": COMPILED,
        "A node of ROS2WASM": ROS2WASM,
    },
    "cpp-packages.md": {"Settings of a package": BUILD},
    "pages.md": {"A page": PAGE},
    "gateway.md": {"The key connect": CONNECT, "What meets": NAMES},
    "gateway-yaml.md": {
        "The file": schema.FILE,
        "allow": schema.ALLOW,
        "limits": schema.LIMITS,
        "keys": schema.KEYS,
        "reservations": schema.RESERVATIONS,
        "record": schema.RECORD,
    },
    "rowe-gateway.md": {
        "The key rowe": schema.ROWE,
        "A topic": schema.ROWE_TOPIC,
        "A service": schema.ROWE_SERVICE,
        "A reply": schema.ROWE_REPLY,
    },
    "widgets.md": {kind: WIDGETS[kind] for kind in OF_NODES},
    "layouts.md": {"stage": STAGE, "columns": COLUMN, "rows": ROW},
    "panels.md": {kind: WIDGETS[kind] for kind in OF_GRAPH},
    "node-panels.md": {kind: WIDGETS[kind] for kind in ABOUT_NODES},
    "notebooks.md": {kind: WIDGETS[kind] for kind in NOTEBOOKS},
    "robots.md": {kind: WIDGETS[kind] for kind in ROBOTS},
    "terminal.md": {"terminal": WIDGETS["terminal"]},
    "views.md": {"3d": WIDGETS["3d"]},
    "plots.md": {**{kind: WIDGETS[kind] for kind in PLOTS}, "A threshold": THRESHOLD},
    "cameras.md": {kind: WIDGETS[kind] for kind in IMAGES},
    "bags.md": {kind: WIDGETS[kind] for kind in BAGS},
    "own-panels.md": {kind: WIDGETS[kind] for kind in OWN},
}
LINKS = {
    "site": "site-yaml.md#site",
    "connect": "gateway.md#the-key-connect",
    "names": "gateway.md#what-meets",
    "deploy": "site-yaml.md#deploy",
    "pyodide": "site-yaml.md#pyodide",
    "nodes": "nodes.md#a-node",
    "parameters": "nodes.md#parameters",
    "pages": "pages.md#a-page",
    "nav": "writing.md#navigation",
    "content": "widgets.md#content",
    "items": "widgets.md#content",
}
DISPLAYS = re.compile(r"^(\| display \|.*\n\|[-|]+\|\n)(?:\|.*\n)*", re.MULTILINE)
HEAD = ("| key | type, default | meaning |", "|---|---|---|")


def table(keys: Sequence[Key]) -> str:
    """Return the Markdown table of `keys`."""
    return "\n".join((*HEAD, *(row(key) for key in keys)))


def row(key: Key) -> str:
    """Return the row of `key`."""
    kind = f"[{key.type}]({LINKS[key.type]})" if key.type in LINKS else key.type
    if key.required:
        kind += ", required"
    elif key.default is not None:
        kind += f", `{str(key.default).lower()}`"
    return f"| `{key.name}` | {kind} | {key.help} |"


def display_row(name: str, kind: Kind) -> str:
    """Return the row of a kind of display."""
    messages = ", ".join(f"`{each.rpartition('/')[2]}`" for each in kind.types)
    options = ", ".join(key for key in kind.defaults if key != "topic")
    return f"| `{name}` | {messages} | `{options}` |"


def with_tables(page: str, text: str) -> str:
    """Return the `text` of a page with the tables of the schema in place of its own."""
    for heading, keys in TABLES[page].items():
        # The first table below the heading, if no other heading or table comes before it.
        found = re.search(
            rf"^#+ {re.escape(heading)}\n(?:(?!#|\|).*\n)*?(\| key \|.*\n(?:\|.*\n)*)",
            text,
            re.MULTILINE,
        )
        assert found, f"docs/{page}: no table of keys below the heading '{heading}'"
        text = f"{text[: found.start(1)]}{table(keys)}\n{text[found.end(1) :]}"
    rows = "\n".join(display_row(name, kind) for name, kind in kinds().items())
    return DISPLAYS.sub(lambda head: f"{head[1]}{rows}\n", text)


if __name__ == "__main__":
    for name in TABLES:
        file = ROOT / "docs" / name
        file.write_text(with_tables(name, file.read_text(encoding="utf-8")), encoding="utf-8")
