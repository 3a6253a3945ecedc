"""What nodes need is on their page, and waits for a button."""

from __future__ import annotations

import json
from pathlib import Path

from rendered import render_site

from sitegen.config import load

SITE = """\
site: {title: T}
nodes:
  turtlesim: {package: turtlesim, executable: turtlesim_node, needs: [clock]}
  clock: {package: turtlesim, executable: mimic, needs: [turtlesim]}
  star: {package: turtlesim, executable: draw_square, needs: [turtlesim]}
pages:
  - {path: /, title: Star, content: [{console: star}]}
"""


def test_a_page_has_what_its_nodes_need(tmp_path: Path) -> None:
    (tmp_path / "site.yaml").write_text(SITE)
    site = load(tmp_path / "site.yaml")
    assert list(site.pages[0].nodes) == ["star", "turtlesim", "clock"]
    files = {artifact.path: artifact.source for artifact in render_site(site)}
    entry = files["page.json"]
    assert isinstance(entry, bytes)
    nodes = json.loads(entry)["nodes"]
    assert {name: (node["autostart"], node["needs"]) for name, node in nodes.items()} == {
        "star": (True, ["turtlesim"]),
        "turtlesim": (False, ["clock"]),
        "clock": (False, ["turtlesim"]),
    }
