from __future__ import annotations

import shutil
from pathlib import Path
from textwrap import dedent

import pytest

from sitegen.config import load, themes
from sitegen.errors import Location, SiteError
from sitegen.model import Layout, Markdown, Site, Widget

# Sites that are wrong, each with all lines that sitegen says about it.
WRONG = Path(__file__).parent / "wrong"

PACKAGE = """\
<package format="3">
  <name>{name}</name>
  <version>1.0.0</version>
  <export><build_type>{build_type}</build_type></export>
</package>
"""

FILES = {
    "themes/default/page.html": "",
    "src/cpp_pubsub/package.xml": PACKAGE.format(name="cpp_pubsub", build_type="ament_cmake"),
    "src/cpp_pubsub/CMakeLists.txt": "add_executable(talker a.cpp)\nadd_executable(listener b.cpp)",
    "src/py_pubsub/package.xml": PACKAGE.format(name="py_pubsub", build_type="catkin"),
    "src/generated/package.xml": PACKAGE.format(name="generated", build_type="ament_cmake"),
    "src/generated/CMakeLists.txt": "add_executable(${NAME} a.cpp)",
}

# Two nodes and the beginning of a page, for cases that are about something else: 7 lines.
TALKERS = """\
site: {title: Robot}
nodes:
  talker: {package: cpp_pubsub, executable: talker}
  listener: {package: cpp_pubsub, executable: listener}
pages:
  - path: demo/
    title: Demo
"""


@pytest.fixture(autouse=True)
def no_packaged_themes(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr(themes, "THEMES", tmp_path / "no/package/themes")


def write(folder: Path, site: str | bytes, files: dict[str, str] | None = None) -> Path:
    for name, text in {**FILES, **(files or {})}.items():
        file = folder / name
        file.parent.mkdir(parents=True, exist_ok=True)
        file.write_text(text, encoding="utf-8")
    file = folder / "site.yaml"
    file.write_bytes(site if isinstance(site, bytes) else site.encode())
    return file


def problems(file: Path) -> list[str]:
    with pytest.raises(SiteError) as caught:
        load(file)
    return caught.value.lines


@pytest.mark.parametrize("name", sorted(case.name for case in WRONG.iterdir()))
def test_all_that_is_wrong_is_said_at_once(tmp_path: Path, name: str) -> None:
    said = (WRONG / name / "said.txt").read_text(encoding="utf-8").splitlines()
    site = (WRONG / name / "site.yaml").read_bytes()
    shutil.copytree(WRONG / name, tmp_path, dirs_exist_ok=True)
    assert problems(write(tmp_path, site)) == said


def test_nesting_has_an_end(tmp_path: Path) -> None:
    assert problems(write(tmp_path, "site: " + "[" * 100_000)) == [
        "site.yaml:1: yaml: nested too deeply; flatten it"
    ]


def test_a_folder_without_site_yaml_is_said(tmp_path: Path) -> None:
    assert problems(tmp_path / "site.yaml") == [
        "site.yaml: no such file in this folder; give the folder that contains it, or write one: "
        "'sitegen init' for a workspace, 'sitegen new my_robot' to begin with"
    ]


def test_links_do_not_lead_out_of_the_site(tmp_path: Path) -> None:
    file = write(
        tmp_path / "site",
        dedent(
            """\
            site: {title: Robot, theme: mine}
            workspace: ws
            pages:
              - {path: /, file: page.md}
              - {path: a/, title: A, content: [markdown: page.md]}
            """
        ),
    )
    write(tmp_path / "other", "", {"page.md": "# Other"})
    (file.parent / "ws").symlink_to(tmp_path / "other/src")
    (file.parent / "page.md").symlink_to(tmp_path / "other/page.md")
    (file.parent / "themes/mine").symlink_to(tmp_path / "other/themes/default")
    way = "is outside the site's folder; keep all files below the folder of site.yaml"
    assert problems(file) == [
        "site.yaml:1: site.theme: 'themes/mine' is outside the site's folder; "
        "copy the theme into it",
        f"site.yaml:2: workspace: 'ws' {way}",
        f"site.yaml:4: pages[0].file: 'page.md' {way}",
        f"site.yaml:5: pages[1].content[0].markdown: 'page.md' {way}",
    ]


def test_a_whole_site(tmp_path: Path) -> None:
    site = load_text(
        tmp_path,
        """\
        site:
          title: My robot
          description: A robot to try out
          url: https://me.github.io/my-robot
          language: de
          theme: plain
          asyncify: false
        workspace: src
        nodes:
          talker:
            package: cpp_pubsub
            executable: talker
            namespace: /demo
            remap: {chatter: /demo/chatter}
            arguments: [--foo]
        pages:
          - path: /
            title: Home
            content:
              - markdown: Hello.
              - buttons: {node: talker, autostart: true}
              - console: talker
              - markdown: docs/end.md
        """,
        {"themes/plain/page.html": "", "docs/end.md": "The end.\n"},
    )
    assert (site.title, site.description, site.language) == ("My robot", "A robot to try out", "de")
    assert site.url == "https://me.github.io/my-robot/"
    assert (site.theme, site.workspace) == (tmp_path / "themes/plain", tmp_path / "src")
    assert not site.asyncify
    assert sorted(site.packages) == ["cpp_pubsub", "generated", "py_pubsub"]
    assert site.notes == ()

    (page,) = site.pages
    location = Location(tmp_path / "site.yaml", 17)
    assert (page.path, page.title, page.level, page.location) == ("", "Home", "I2", location)
    hello, buttons, console, end = page.content
    assert hello == Markdown("Hello.", tmp_path, Location(tmp_path / "site.yaml", 20))
    assert buttons == Widget(
        "buttons", "talker", {"autostart": True}, Location(tmp_path / "site.yaml", 21)
    )
    assert console == Widget(
        "console", "talker", {"lines": 1000}, Location(tmp_path / "site.yaml", 22)
    )
    assert end == Markdown("The end.\n", tmp_path / "docs", Location(tmp_path / "docs/end.md", 1))
    assert page.nodes["talker"].command_line() == [
        *["--foo", "--ros-args", "-r", "chatter:=/demo/chatter", "-r", "__ns:=/demo"]
    ]


def test_what_is_not_written_has_a_default(tmp_path: Path) -> None:
    site = load_text(
        tmp_path, "site: {title: Robot}\npages: [{path: demo, title: Demo, content: []}]\n"
    )
    assert (site.description, site.url, site.language, site.asyncify) == ("", "", "en", True)
    assert (site.theme, site.workspace) == (tmp_path / "themes/default", tmp_path)
    assert (site.pages[0].path, site.pages[0].level) == ("demo/", "")


def test_a_page_may_be_a_markdown_file(tmp_path: Path) -> None:
    page = load_text(
        tmp_path,
        "site: {title: Robot}\npages: [{path: /, file: demo/page.md, title: From site.yaml}]\n",
        {
            "demo/page.md": dedent(
                """\
                ---
                title: From the page
                description: It talks
                level: I2
                nodes:
                  talker: {package: cpp_pubsub, executable: talker}
                ---
                # Heading

                ```ros
                - buttons: talker
                - console: {node: talker, lines: 5}
                ```

                ````markdown
                ```ros
                console: an example, not a console
                ```
                ````
                """
            )
        },
    ).pages[0]
    assert (page.title, page.description, page.level) == ("From site.yaml", "It talks", "I2")
    before, buttons, console, after = page.content
    file = tmp_path / "demo/page.md"
    assert before == Markdown("# Heading\n", file.parent, Location(file, 8))
    assert isinstance(buttons, Widget) and buttons.location == Location(file, 11)
    assert isinstance(console, Widget) and console.options == {"lines": 5}
    assert isinstance(after, Markdown) and after.location == Location(file, 14)
    assert "console: an example" in after.text


def test_an_example_is_its_yaml_and_its_widgets(tmp_path: Path) -> None:
    page = load_text(
        tmp_path,
        "site: {title: Robot}\npages: [{path: /, file: page.md}]\n",
        {
            "page.md": dedent(
                """\
                ---
                title: T
                nodes:
                  talker: {package: cpp_pubsub, executable: talker}
                ---
                ```yaml ros title="page.md"
                - console: talker
                - grid:
                  - markdown: |
                      ````
                      text
                      ````
                  - buttons: talker
                ```
                """
            )
        },
    ).pages[0]
    [example] = page.content
    assert isinstance(example, Layout) and example.kind == "example"
    code, widgets = (cell.content for cell in example.cells)
    assert isinstance(code[0], Markdown) and code[0].location == Location(tmp_path / "page.md", 6)
    lines = code[0].text.split("\n")
    # Longer than each fence in the YAML.
    assert (lines[0], lines[1], lines[-1]) == (
        '`````yaml title="page.md"',
        "- console: talker",
        "`````",
    )
    assert [part.kind for part in widgets if isinstance(part, Widget | Layout)] == [
        "console",
        "grid",
    ]


@pytest.mark.parametrize(
    ("text", "title"),
    [
        ("# Plain\n", "Plain"),
        ("Text first\n\n#   With `code` and [a link](x.md) ##\n", "With code and a link"),
        ("```sh\n# a comment\n```\n# After\n", "After"),
        ("\ufeff# Windows\r\n", "Windows"),
    ],
)
def test_the_first_heading_is_the_title(tmp_path: Path, text: str, title: str) -> None:
    site = load_text(
        tmp_path, "site: {title: Robot}\npages: [{path: /, file: page.md}]\n", {"page.md": text}
    )
    assert site.pages[0].title == title


@pytest.mark.parametrize(
    ("content", "level", "nodes"),
    [
        ("[]", "", []),
        ("[console: listener, console: talker, console: listener]", "I1", ["listener", "talker"]),
        ("[console: listener, buttons: talker]", "I2", ["listener", "talker"]),
        ("[buttons: talker, buttons: talker]", "I2", ["talker"]),
        ("[buttons: talker, buttons: listener]", "I3", ["talker", "listener"]),
        ("[buttons: talker, topics: ]", "I4", ["talker"]),
        ("[log: ]", "I4", []),
        ("[console: talker, robot: {kind: vernie}]", "I4", ["talker"]),
    ],
)
def test_the_widgets_make_the_level(
    tmp_path: Path, content: str, level: str, nodes: list[str]
) -> None:
    page = load_text(tmp_path, f"{TALKERS}    content: {content}\n").pages[0]
    assert (page.level, list(page.nodes)) == (level, nodes)


def test_a_panel_is_given_options_or_nothing(tmp_path: Path) -> None:
    page = load_text(
        tmp_path,
        TALKERS
        + """\
    content:
      - topics:
      - topics: {show: [/chatter, /robot/cmd_vel], echo: /chatter}
      - publish: {topic: /chatter, type: std_msgs/msg/String}
      - log: {lines: 5}
      - nodes:
""",
    ).pages[0]
    assert [(w.kind, w.target, w.options) for w in page.content if isinstance(w, Widget)] == [
        ("topics", "", {"show": None, "echo": None}),
        ("topics", "", {"show": ["/chatter", "/robot/cmd_vel"], "echo": "/chatter"}),
        ("publish", "", {"topic": "/chatter", "type": "std_msgs/msg/String"}),
        ("log", "", {"lines": 5}),
        ("nodes", "", {}),
    ]


def test_a_robot_has_the_options_of_its_kind(tmp_path: Path) -> None:
    content = "[robot: {kind: vernie, color: /led}, robot: {kind: diffdrive, odometry: /odom}]"
    page = load_text(tmp_path, f"{TALKERS}    content: {content}\n").pages[0]
    assert [(w.kind, w.target, w.options) for w in page.content if isinstance(w, Widget)] == [
        (
            "robot",
            "",
            {"kind": "vernie", "twist": "/cmd_vel", "color": "/led", "sensors": "/vernie"},
        ),
        ("robot", "", {"kind": "diffdrive", "twist": "/cmd_vel", "odometry": "/odom"}),
    ]


def test_a_node_that_no_page_uses_is_a_note(tmp_path: Path) -> None:
    site = load_text(tmp_path, f"{TALKERS}    content: [console: talker]\n")
    assert site.notes == (
        "site.yaml:4: nodes.listener: no page uses this node; "
        "add a console or buttons for it, or remove it",
    )


def test_a_theme_of_the_site_goes_before_one_of_sitegen(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    brought = tmp_path / "package/themes"
    for name in ("default", "plain"):
        (brought / name).mkdir(parents=True)
        (brought / name / "page.html").touch()
    monkeypatch.setattr(themes, "THEMES", brought)
    pages = "pages: [{path: /, title: Home, content: []}]\n"
    folder = tmp_path / "site"
    assert load_text(folder, f"site: {{title: A}}\n{pages}").theme == folder / "themes/default"
    assert load_text(folder, f"site: {{title: A, theme: plain}}\n{pages}").theme == (
        brought / "plain"
    )


def test_pages_may_have_nodes_of_the_same_name(tmp_path: Path) -> None:
    site = load_text(
        tmp_path,
        """\
        site: {title: Robot}
        pages:
          - path: a/
            title: A
            nodes: {node: {package: cpp_pubsub, executable: talker}}
            content: [console: node]
          - path: b/
            title: B
            nodes: {node: {package: cpp_pubsub, executable: listener}}
            content: [console: node]
        """,
    )
    executables = [page.nodes["node"].executable for page in site.pages]
    assert (executables, site.notes) == (["talker", "listener"], ())


def test_a_page_of_text_needs_no_workspace(tmp_path: Path) -> None:
    site = load_text(
        tmp_path,
        "site: {title: Robot}\npages: [{path: /, title: Home, content: []}]\n",
        {"src/broken/package.xml": "<package>"},
    )
    assert site.packages == {}


@pytest.mark.parametrize(("place", "shown"), [("below", True), ("beside", False), ("none", False)])
def test_a_stage_shows_what_its_folded_consoles_say(
    tmp_path: Path, place: str, shown: bool
) -> None:
    site = load_text(
        tmp_path,
        f"""\
        site: {{title: Robot}}
        workspace: .
        nodes:
          talker: {{package: cpp_pubsub, executable: talker}}
        pages:
          - path: /
            title: Home
            content:
              - stage:
                  show: [{{robot: {{kind: vernie}}}}, {{graph: }}]
                  nodes: [talker]
                  consoles: {place}
        """,
    )
    [stage] = site.pages[0].content
    assert isinstance(stage, Layout)
    robot, graph = stage.cells[1].content
    assert isinstance(robot, Widget)
    assert isinstance(graph, Widget)
    assert robot.options.get("captions") == (["talker"] if shown else None)
    assert "captions" not in graph.options


def load_text(folder: Path, site: str, files: dict[str, str] | None = None) -> Site:
    return load(write(folder, dedent(site), files))
