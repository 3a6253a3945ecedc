"""Nodes of the ROS2WASM project in a site: what is copied, what pages are told, what is refused."""

from __future__ import annotations

import io
import json
from pathlib import Path
from textwrap import dedent
from typing import Any

import pytest

from sitegen.commands.build import build
from sitegen.errors import SiteError
from sitegen.report import Report

SITE = """\
site: {title: Old nodes}
pages:
  - path: /
    title: Home
    nodes:
      old:
        ros2wasm: nodes/talker.js
        types: {/chatter: std_msgs/msg/String, /ask: my_interfaces/srv/Ask}
      twin: {ros2wasm: nodes/talker.js, types: {}}
      adder: {ros2wasm: nodes/adder.js, types: {/add: example_interfaces/srv/AddTwoInts}}
    content:
      - console: old
      - buttons: twin
      - console: adder
"""
FILES = {
    "nodes/talker.js": (
        """importScripts("helper.js"); const file = 'talker.wasm', no = "gone.data";"""
    ),
    "nodes/talker.wasm": "wasm",
    "nodes/helper.js": "load(`more.data`); importScripts('talker.js');",
    "nodes/more.data": "data",
    "nodes/adder.js": "",
    "nodes/other.wasm": "not named by anybody",
    "src/my_interfaces/package.xml": (
        "<package><name>my_interfaces</name><depend>std_msgs</depend></package>"
    ),
    "src/my_interfaces/CMakeLists.txt": (
        'rosidl_generate_interfaces(my_interfaces "srv/Ask.srv" "msg/Part.msg" '
        "DEPENDENCIES std_msgs)"
    ),
    "src/my_interfaces/srv/Ask.srv": "Part[] parts\nstring<=5 word hey\n---\nbool ok\n",
    "src/my_interfaces/msg/Part.msg": "uint8 BIG=3\nstd_msgs/Header header\nuint8 size 3\n",
}


def write(folder: Path, site: str = SITE, **files: str) -> Path:
    for name, text in {**FILES, **files, "site.yaml": site}.items():
        file = folder / name
        file.parent.mkdir(parents=True, exist_ok=True)
        file.write_text(text)
    return folder


def problems(folder: Path) -> list[str]:
    with pytest.raises(SiteError) as wrong:
        build(folder, output=folder / "dist", report=Report(io.StringIO()))
    assert not (folder / "dist").exists()
    return wrong.value.lines


@pytest.fixture(autouse=True)
def own_cache(tmp_path_factory: pytest.TempPathFactory, monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setenv("SITEGEN_CACHE", str(tmp_path_factory.mktemp("cache")))


def test_a_site_has_what_its_scripts_need_and_no_more(
    tmp_path: Path, capsys: pytest.CaptureFixture[str]
) -> None:
    said = io.StringIO()
    for _ in range(2):  # the second finds the types described
        build(write(tmp_path), output=tmp_path / "dist", report=Report(said))
    dist = tmp_path / "dist"
    assert sorted(f.relative_to(dist).as_posix() for f in dist.glob("ros2wasm/**/*.*")) == [
        "ros2wasm/nodes/adder.js",
        "ros2wasm/nodes/helper.js",
        "ros2wasm/nodes/more.data",
        "ros2wasm/nodes/talker.js",
        "ros2wasm/nodes/talker.wasm",
    ]
    # No node of its own, no panel: neither what runs those nor what a page needs for panels.
    workers = sorted(file.name for file in (dist / "runtime/workers").iterdir())
    assert workers == ["ros2wasm"]
    assert not (dist / "runtime/page/pageClient.js").exists()
    assert (
        "  nodes/talker.js: ROS2WASM, 0 kB\n  nodes/adder.js: ROS2WASM, 0 kB\n" in said.getvalue()
    )
    assert "built 1 page, 2 nodes, " in said.getvalue()
    assert capsys.readouterr().out == ""


def test_a_page_knows_the_types_of_its_scripts(tmp_path: Path) -> None:
    build(write(tmp_path), output=tmp_path / "dist", report=Report(io.StringIO()))
    page: dict[str, Any] = json.loads((tmp_path / "dist/page.json").read_text())
    assert "types" not in page, "nothing but the nodes takes part in the graph"
    old = page["nodes"]["old"]
    types = old["ros2wasm"].pop("types")
    assert old == {
        "package": "ros2wasm",
        "executable": "talker.js",
        "arguments": [],
        "autostart": True,
        "ros2wasm": {
            "script": "ros2wasm/nodes/talker.js",
            "topics": {"/chatter": "std_msgs/msg/String", "/ask": "my_interfaces/srv/Ask"},
        },
    }
    assert sorted(types) == [
        "builtin_interfaces/msg/Time",
        "my_interfaces/msg/Part",
        "my_interfaces/srv/Ask_Request",
        "my_interfaces/srv/Ask_Response",
        "rcl_interfaces/msg/Log",
        "std_msgs/msg/Header",
        "std_msgs/msg/String",
    ]
    assert types["my_interfaces/srv/Ask_Request"]["fields"] == [
        {"name": "parts", "type": "my_interfaces/msg/Part[]"},
        {"name": "word", "type": "string<=5", "default": "hey"},
    ]
    assert types["my_interfaces/msg/Part"]["constants"] == [
        {"name": "BIG", "type": "uint8", "value": 3}
    ]
    assert page["nodes"]["twin"]["autostart"] is False
    adder = page["nodes"]["adder"]["ros2wasm"]["types"]["example_interfaces/srv/AddTwoInts_Request"]
    assert [field["type"] for field in adder["fields"]] == ["int64", "int64"]


def test_panels_know_these_types_too(tmp_path: Path) -> None:
    folder = write(tmp_path, SITE + "      - topics:\n")
    build(folder, output=tmp_path / "dist", report=Report(io.StringIO()))
    types = json.loads((tmp_path / "dist/page.json").read_text())["types"]
    assert {"std_msgs/msg/String", "my_interfaces/srv/Ask_Request"} <= types.keys()


def test_all_that_is_wrong_is_said_at_once(tmp_path: Path) -> None:
    site = """\
    site: {title: Old nodes}
    nodes:
      a: {ros2wasm: nodes/talkre.js, types: {/chatter: std_msgs/msg/Strin}}
      b: {ros2wasm: nodes/talker.wasm, types: {chatter: std_msg/msg/String}}
      c: {ros2wasm: nodes/alone.js, types: {/fibonacci: example_interfaces/action/Fibonacci}}
      d: {ros2wasm: ../talker.js, package: cpp_pubsub, types: [/chatter]}
      e: {ros2wasm: nodes/talker.js}
      f: {ros2wasm: nodes/linked.js, types: {/ask: my_interfaces/srv/Asks, /n: 5}}
    pages: [{path: /, title: Home, content: [{console: e}]}]
    """
    folder = write(
        tmp_path / "site",
        dedent(site),
        **{"nodes/alone.js": "fetch('alone.wasm')", "nodes/linked.js": "fetch('out.wasm')"},
    )
    (tmp_path / "out.wasm").write_text("")
    (folder / "nodes/out.wasm").symlink_to(tmp_path / "out.wasm")
    assert problems(folder) == [
        "site.yaml:3: nodes.a.ros2wasm: no file 'nodes/talkre.js'; did you mean 'nodes/talker.js'?",
        "site.yaml:3: nodes.a.types./chatter: no type 'std_msgs/msg/Strin'; "
        "did you mean 'std_msgs/msg/String'?",
        "site.yaml:4: nodes.b.ros2wasm: 'nodes/talker.wasm' is not a script; "
        "give the .js file that the compiler wrote",
        "site.yaml:4: nodes.b.types.chatter: 'chatter' is not a valid topic or service name; "
        "write it like '/chatter'",
        "site.yaml:4: nodes.b.types.chatter: no package 'std_msg' with interfaces; "
        "did you mean 'std_msgs'?",
        "site.yaml:5: nodes.c.types./fibonacci: expected the type of a message or a service, found "
        "the text 'example_interfaces/action/Fibonacci'; "
        "write it like 'types: {/chatter: std_msgs/msg/String}'",
        "site.yaml:5: nodes.c.ros2wasm: it loads 'alone.wasm', which does not exist; "
        "copy it next to the script",
        "site.yaml:6: nodes.d.package: unknown key; known: needs, ros2wasm, types",
        "site.yaml:6: nodes.d.types: expected names of the graph with a type each, found a list; "
        "write it like 'types: {/chatter: std_msgs/msg/String}'",
        "site.yaml:6: nodes.d.ros2wasm: '../talker.js' is outside the site's folder; "
        "keep all files below the folder of site.yaml",
        "site.yaml:7: nodes.e.types: missing; "
        "write it like 'types: {/chatter: std_msgs/msg/String}'",
        "site.yaml:8: nodes.f.types./n: expected the type of a message or a service, "
        "found the number 5; write it like 'types: {/chatter: std_msgs/msg/String}'",
        "site.yaml:8: nodes.f.ros2wasm: 'out.wasm', which the script loads, is outside the site's "
        "folder; copy it into the folder",
    ]


def test_a_definition_that_is_wrong_is_told_by_its_line(tmp_path: Path) -> None:
    folder = write(tmp_path, **{"src/my_interfaces/srv/Ask.srv": "int64 a\n---\nnumber b\n"})
    [line] = problems(folder)
    assert line.startswith("src/my_interfaces/srv/Ask.srv:3: no type 'number'; ")
