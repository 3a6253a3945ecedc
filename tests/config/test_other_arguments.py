"""The programs that a launch file starts with other arguments."""

from __future__ import annotations

from pathlib import Path

from launching import PACKAGE

from sitegen.config import load
from sitegen.model import Argument

SITE = """\
site: {title: A}
pages:
  - {path: /, title: A, launch: src/mine/launch/a.launch.xml, content: [terminal: ]}
  - path: quiet/
    title: B
    launch: src/mine/launch/b.launch.xml
    launch_arguments: {which: three}
    content: [terminal: {nodes: []}, nodes: ]
  - {path: plain/, title: C, launch: src/mine/launch/c.launch.xml, content: [nodes: ]}
"""
LAUNCH = """\
<launch>
  <arg name="loud" default="false"/>
  <arg name="which" default="one">
    <choice value="one"/>
    <choice value="two"/>
    <choice value="three"/>
    <choice value="missing"/>
  </arg>
  <arg name="free" default="x"/>
  <node pkg="mine" exec="$(var which)" name="{}_first"/>
  <node pkg="mine" exec="loud" name="{}_first" if="$(var loud)"/>
  <node pkg="mine" exec="free" name="{}_free" if="$(eval '\\'$(var free)\\' != \\'x\\'')"/>
</launch>
"""
FILES = {
    "site.yaml": SITE,
    **{f"src/mine/launch/{name}.launch.xml": LAUNCH.replace("{}", name) for name in "abc"},
    "src/mine/package.xml": PACKAGE.format("mine"),
    "src/mine/CMakeLists.txt": "\n".join(
        f"add_executable({name} a.cpp)" for name in ("one", "two", "three", "loud", "free")
    ),
}


def test_choices_and_flags_bring_their_programs(tmp_path: Path) -> None:
    for name, text in FILES.items():
        file = tmp_path / name
        file.parent.mkdir(parents=True, exist_ok=True)
        file.write_text(text)
    page, quiet, plain = load(tmp_path / "site.yaml").pages
    found = {name: node.executable for name, node in page.nodes.items()}
    # What a page cannot have is no error before somebody wants it.
    assert found == {
        "a_first": "one",
        "a_first_2": "loud",
        "a_first_3": "two",
        "a_first_4": "three",
    }
    assert page.launch
    assert page.launch.nodes == ("a_first",)
    assert page.launch.others == ("a_first_2", "a_first_3", "a_first_4")
    assert page.launch.path == "launch/a.launch.xml"
    assert page.launch.arguments[1] == Argument(
        "which", "one", choices=("one", "two", "three", "missing")
    )
    found = {name: node.executable for name, node in quiet.nodes.items()}
    assert found == {
        "b_first": "three",
        "b_first_2": "loud",
        "b_first_3": "one",
        "b_first_4": "two",
    }
    assert quiet.launch
    assert quiet.launch.given == {"which": "three"}
    # Nobody can launch it there.
    assert [*plain.nodes] == ["c_first"]
