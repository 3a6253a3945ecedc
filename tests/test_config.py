from __future__ import annotations

from dataclasses import dataclass, field
from pathlib import Path
from textwrap import dedent

import pytest

from sitegen import theme
from sitegen.config import load
from sitegen.errors import Place, SiteError
from sitegen.model import Markdown, Site, Widget

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
    monkeypatch.setattr(theme, "THEMES", tmp_path / "no/package/themes")


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


@dataclass
class Wrong:
    """A site that is wrong, and everything that sitegen says about it."""

    name: str
    site: str | bytes
    lines: list[str]
    files: dict[str, str] = field(default_factory=dict)


WRONG = [
    Wrong(
        "unknown keys",
        """\
        site:
          titel: Robot
          title: Robot
        pages:
          - path: /
            title: Home
            content: []
            frobnicate: 1
        color: red
        """,
        [
            "site.yaml:2: site.titel: unknown key; did you mean 'title'?",
            "site.yaml:8: pages[0].frobnicate: unknown key; "
            "known: content, date, description, file, folder, launch, launch_arguments, level, "
            "nodes, path, tags, theme, title",
            "site.yaml:9: color: unknown key; known: deploy, nav, nodes, pages, pyodide, site, "
            "workspace",
        ],
    ),
    Wrong(
        "wrong types",
        """\
        site:
          title: 3
          language: no
          description: 2024-01-01
          url:
          asyncify: "false"
        nodes: [talker]
        pages:
          - path: /
            title: [Home]
            content: {console: talker}
          - about
        """,
        [
            'site.yaml:2: site.title: expected text, found the number 3; put it in quotes: "3"',
            "site.yaml:3: site.language: expected text, found the truth value no; "
            'put it in quotes: "no"',
            "site.yaml:4: site.description: expected text, found '2024-01-01', "
            'which is not text for YAML; put it in quotes: "2024-01-01"',
            "site.yaml:5: site.url: expected an address, found nothing; "
            "write it like 'url: https://me.github.io/my-robot/'",
            "site.yaml:6: site.asyncify: expected true or false, found the text 'false'; "
            "write it like 'asyncify: true'",
            "site.yaml:7: nodes: expected names with a node each, found a list; "
            "write it like 'nodes: {talker: {package: cpp_pubsub, executable: talker}}'",
            "site.yaml:10: pages[0].title: expected text, found a list; "
            "write it like 'title: Publisher and subscriber'",
            "site.yaml:11: pages[0].content: expected a list of text and widgets, "
            "found keys and values; write it like 'content: [{console: talker}]'",
            "site.yaml:12: pages[1]: expected keys and values, found the text 'about'; "
            "the keys are path, title, description, level, nodes, launch, launch_arguments, "
            "content, file, folder, tags, date, theme",
        ],
    ),
    Wrong(
        "wrong types in a node",
        """\
        site: {title: Robot}
        nodes:
          talker:
            package: cpp_pubsub
            executable: talker
            arguments: [--rate, 10, --on, yes]
            remap:
              chatter: 5
          listener: cpp_pubsub
        pages: [{path: /, title: Home, content: [{console: talker}]}]
        """,
        [
            "site.yaml:6: nodes.talker.arguments[1]: expected text, found the number 10; "
            'put it in quotes: "10"',
            "site.yaml:6: nodes.talker.arguments[3]: expected text, found the truth value yes; "
            'put it in quotes: "yes"',
            "site.yaml:8: nodes.talker.remap.chatter: expected text, found the number 5; "
            'put it in quotes: "5"',
            "site.yaml:9: nodes.listener: expected keys and values, found the text 'cpp_pubsub'; "
            "the keys are package, executable, namespace, remap, parameters, arguments, group",
        ],
    ),
    Wrong(
        "missing keys",
        """\
        nodes:
          talker: {package: cpp_pubsub}
        pages:
          - description: nothing here
        """,
        [
            "site.yaml:1: site: missing; write it like 'site: {title: My robot}'",
            "site.yaml:2: nodes.talker.executable: missing; write it like 'executable: talker'",
            "site.yaml:4: pages[0].path: missing; write it like 'path: demo03/'",
            "site.yaml:4: pages[0].content: missing; "
            "write it like 'content: [{console: talker}]', or name a 'file'",
        ],
    ),
    Wrong(
        "a page without a title",
        """\
        site: {title: Robot}
        pages:
          - path: /
            content:
              - markdown: |
                  ## Only a second level

                  ```
                  # not a heading
                  ```
        """,
        [
            "site.yaml:3: pages[0].title: missing; "
            "write it like 'title: My robot', or begin the text with '# My robot'",
        ],
    ),
    Wrong(
        "keys given twice",
        """\
        site:
          title: Robot
          title: Rover
        nodes:
          talker: {package: cpp_pubsub, executable: talker}
          talker: {package: cpp_pubsub, executable: listener}
        pages: [{path: /, title: Home, content: [{console: talker}]}]
        """,
        [
            "site.yaml:3: site.title: already given in line 2; remove one of the two",
            "site.yaml:6: nodes.talker: already given in line 5; remove one of the two",
        ],
    ),
    Wrong(
        "keys that are not text",
        """\
        site: {title: Robot, 3: three}
        pages: [{path: /, title: Home, content: []}]
        """,
        ["site.yaml:1: site: a key must be text, found the number 3; put it in quotes"],
    ),
    Wrong(
        "two pages on one path",
        """\
        site: {title: Robot}
        pages:
          - {path: /, title: Home, content: []}
          - {path: demo, title: One, content: []}
          - {path: demo/, title: Two, content: []}
          - {path: /, title: Three, content: []}
        """,
        [
            "site.yaml:5: pages[2].path: 'demo/' is taken by pages[1].path (site.yaml:4); "
            "choose another",
            "site.yaml:6: pages[3].path: '/' is taken by pages[0].path (site.yaml:3); "
            "choose another",
        ],
    ),
    Wrong(
        "paths that are no folders of a site",
        """\
        site: {title: Robot}
        pages:
          - {path: ../up/, title: A, content: []}
          - {path: /demo/, title: B, content: []}
          - {path: 'demo\\one', title: C, content: []}
          - {path: Demo 1/, title: D, content: []}
          - {path: a//b/, title: E, content: []}
          - {path: ./, title: F, content: []}
          - {path: .git/, title: G, content: []}
        """,
        [
            "site.yaml:3: pages[0].path: '../up/' leads out of the site; write 'up/'",
            "site.yaml:4: pages[1].path: '/demo/' is absolute; write 'demo/'",
            "site.yaml:5: pages[2].path: 'demo\\one' has a backslash; write 'demo/one'",
            "site.yaml:6: pages[3].path: 'Demo 1/' must be of lower-case letters, digits, "
            "'-', '_', '.' and '~'; write 'demo-1/'",
            "site.yaml:7: pages[4].path: 'a//b/' must be of lower-case letters, digits, "
            "'-', '_', '.' and '~'; write 'a/b/'",
            "site.yaml:8: pages[5].path: './' must be of lower-case letters, digits, "
            "'-', '_', '.' and '~'; write '/' for the first page",
            "site.yaml:9: pages[6].path: '.git/' must be of lower-case letters, digits, "
            "'-', '_', '.' and '~'; write 'git/'",
        ],
    ),
    Wrong(
        "a node that nobody defined",
        TALKERS
        + """\
    content:
      - buttons: talkr
      - console: {node: camera, lines: 10}
""",
        [
            "site.yaml:9: pages[0].content[0].buttons: no node 'talkr'; did you mean 'talker'?",
            "site.yaml:10: pages[0].content[1].console.node: no node 'camera'; "
            "known: listener, talker",
        ],
    ),
    Wrong(
        "a node defined twice",
        TALKERS
        + """\
    file: page.md
    nodes:
      talker: {package: cpp_pubsub, executable: listener}
      third: {package: cpp_pubsub, executable: listener}
""",
        [
            "page.md:3: nodes.third: 'third' is defined already (site.yaml:11); "
            "use that node or choose another name",
            "site.yaml:10: pages[0].nodes.talker: 'talker' is defined already (site.yaml:3); "
            "use that node or choose another name",
        ],
        {
            "page.md": dedent(
                """\
                ---
                nodes:
                  third: {package: cpp_pubsub, executable: talker}
                ---
                """
            )
        },
    ),
    Wrong(
        "packages and executables that are not there",
        """\
        site: {title: Robot}
        workspace: src
        nodes:
          one: {package: cpp_pubsubb, executable: talker}
          two:
            package: navigation
            executable: planner
          three:
            package: cpp_pubsub
            executable: taker
          four: {package: py_pubsub, executable: talker}
          five: {package: generated, executable: only_cmake_knows}
        pages:
          - path: /
            title: Home
            content: [console: one, console: two, console: three, console: four, console: five]
        """,
        [
            "site.yaml:4: nodes.one.package: no package 'cpp_pubsubb' in the workspace; "
            "did you mean 'cpp_pubsub'?",
            "site.yaml:6: nodes.two.package: no package 'navigation' in the workspace; "
            "known: cpp_pubsub, generated, py_pubsub",
            "site.yaml:10: nodes.three.executable: package 'cpp_pubsub' has no executable 'taker'; "
            "did you mean 'talker'?",
            "site.yaml:11: nodes.four.package: package 'py_pubsub' is of build type "
            "'catkin'; this release runs packages of ament_cmake and ament_python",
        ],
    ),
    Wrong(
        "names that ROS does not allow",
        """\
        site: {title: Robot}
        nodes:
          2nd-talker: {package: cpp_pubsub, executable: talker}
          one: {package: cpp_pubsub, executable: talker, namespace: demo}
          two: {package: cpp_pubsub, executable: talker, namespace: /demo/}
          three:
            package: cpp_pubsub
            executable: talker
            remap: {chat ter: chatter, chatter: /demo//chatter, __ns: /demo}
        pages:
          - path: /
            title: Home
            content: [console: 2nd-talker, console: one, console: two, console: three]
        """,
        [
            "site.yaml:3: nodes.2nd-talker: '2nd-talker' is no ROS node name; "
            "use letters, digits and '_', no digit first",
            "site.yaml:4: nodes.one.namespace: 'demo' is no ROS namespace; "
            "write it like '/demo' or '/demo/left'",
            "site.yaml:5: nodes.two.namespace: '/demo/' is no ROS namespace; "
            "write it like '/demo' or '/demo/left'",
            "site.yaml:9: nodes.three.remap.chat ter: 'chat ter' is no ROS name; "
            "write it like 'chatter' or '/demo/chatter'",
            "site.yaml:9: nodes.three.remap.chatter: '/demo//chatter' is no ROS name; "
            "write it like 'chatter' or '/demo/chatter'",
            "site.yaml:9: nodes.three.remap.__ns: '__ns' is not a name to remap; "
            "write 'namespace: /demo' beside 'remap'",
        ],
    ),
    Wrong(
        "a level above what the page has",
        TALKERS
        + """\
    level: I3
    content: [buttons: talker, console: talker, console: listener]
""",
        [
            "site.yaml:8: pages[0].level: the page offers I2 (buttons for one node), "
            "not I3 (buttons for several nodes); add buttons for another node, "
            "or write 'level: I2'",
        ],
    ),
    Wrong(
        "a level below what the page has",
        TALKERS
        + """\
    level: I1
    content: [buttons: talker, buttons: listener]
""",
        [
            "site.yaml:8: pages[0].level: the page offers I3 (buttons for several nodes), "
            "not I1 (consoles only); remove the buttons, or write 'level: I3'",
        ],
    ),
    Wrong(
        "a level below what panels offer",
        TALKERS
        + """\
    level: I3
    content: [buttons: talker, buttons: listener, topics: ]
""",
        [
            "site.yaml:8: pages[0].level: the page offers I4 (panels about the whole graph), "
            "not I3 (buttons for several nodes); remove the panels, or write 'level: I4'",
        ],
    ),
    Wrong(
        "a level that needs panels",
        TALKERS
        + """\
    level: I4
    content: [console: talker]
""",
        [
            "site.yaml:8: pages[0].level: the page offers I1 (consoles only), not I4 "
            "(panels about the whole graph); add a panel, like 'topics:', or write 'level: I1'",
        ],
    ),
    Wrong(
        "panels that are wrongly given",
        TALKERS
        + """\
    content:
      - topics
      - topics: /chatter
      - topics: {show: [chatter, 3]}
      - topics: {show: [chatter], echo: chatter/}
      - nodes: {show: [/a]}
      - publish: {topic: /a, type: String}
      - log: {line: 5}
""",
        [
            "site.yaml:9: pages[0].content[0]: expected one of markdown, buttons, console, source, "
            "prompt, editor, topics, nodes, services, publish, graph, log, robot, found the text "
            "'topics'; write it like 'topics:'",
            "site.yaml:10: pages[0].content[1].topics: expected its options (show, echo) or "
            "nothing, found the text '/chatter'; write it like 'topics:'",
            "site.yaml:11: pages[0].content[2].topics.show[0]: expected a name of the graph, found "
            "the text 'chatter'; write it like 'show: [/chatter]'",
            "site.yaml:11: pages[0].content[2].topics.show[1]: expected a name of the graph, found "
            "the number 3; write it like 'show: [/chatter]'",
            "site.yaml:12: pages[0].content[3].topics.show[0]: expected a name of the graph, found "
            "the text 'chatter'; write it like 'show: [/chatter]'",
            "site.yaml:12: pages[0].content[3].topics.echo: expected a name of the graph, found "
            "the text 'chatter/'; write it like 'echo: /chatter'",
            "site.yaml:13: pages[0].content[4].nodes: expected nothing, found keys and values; "
            "write it like 'nodes:'",
            "site.yaml:14: pages[0].content[5].publish.type: expected a message type, found the "
            "text 'String'; write it like 'type: std_msgs/msg/String'",
            "site.yaml:15: pages[0].content[6].log.line: unknown key; did you mean 'lines'?",
        ],
    ),
    Wrong(
        "robots that are wrongly given",
        TALKERS
        + """\
    content:
      - robot:
      - robot: vernie
      - robot: {twist: /cmd_vel}
      - robot: {kind: verne}
      - robot: {kind: diffdrive, color: /color}
      - robot: {kind: vernie, twist: cmd_vel, speed: 3}
""",
        [
            "site.yaml:9: pages[0].content[0].robot: expected keys and values, found nothing; "
            "the keys are kind, twist, color, sensors, odometry, window",
            "site.yaml:10: pages[0].content[1].robot: expected keys and values, found the text "
            "'vernie'; the keys are kind, twist, color, sensors, odometry, window",
            "site.yaml:11: pages[0].content[2].robot.kind: missing; write it like 'kind: vernie'",
            "site.yaml:12: pages[0].content[3].robot.kind: no robot is called 'verne'; "
            "did you mean 'vernie'?",
            "site.yaml:13: pages[0].content[4].robot.color: a diffdrive has no 'color'; "
            "it has twist and odometry",
            "site.yaml:14: pages[0].content[5].robot.twist: expected a name of the graph, found "
            "the text 'cmd_vel'; write it like 'twist: /cmd_vel'",
            "site.yaml:14: pages[0].content[5].robot.speed: unknown key; "
            "known: color, kind, odometry, sensors, twist, window",
        ],
    ),
    Wrong(
        "a level of another release",
        TALKERS
        + """\
    level: I6
    content: [console: talker]
""",
        [
            "site.yaml:8: pages[0].level: no level 'I6', the page offers I1 (consoles only); "
            "write 'level: I1'",
        ],
    ),
    Wrong(
        "a level without nodes, declared in the page",
        """\
        site: {title: Robot}
        pages:
          - {path: /, file: page.md}
        """,
        [
            "page.md:2: level: the page runs no node and has no level; "
            "add a console, or remove the key",
        ],
        {"page.md": "---\nlevel: I1\n---\n# Home\n"},
    ),
    Wrong(
        "files that do not exist",
        """\
        site: {title: Robot, theme: defualt}
        workspace: scr
        pages:
          - {path: /, file: docs/intor.md}
          - {path: a/, title: A, content: [markdown: docs]}
          - {path: b/, title: B, content: [markdown: absent.md]}
          - {path: c/, file: docs}
        """,
        [
            "site.yaml:1: site.theme: no theme named 'defualt'; did you mean 'default'?",
            "site.yaml:2: workspace: no folder 'scr'; did you mean 'src'?",
            "site.yaml:4: pages[0].file: no file 'docs/intor.md'; did you mean 'docs/intro.md'?",
            "site.yaml:6: pages[2].content[0].markdown: no file 'absent.md'; there are none",
            "site.yaml:7: pages[3].file: 'docs' is a folder; name a file",
        ],
        {"docs/intro.md": "# Hello"},
    ),
    Wrong(
        "paths that leave the site",
        """\
        site: {title: Robot, theme: ../themes}
        workspace: ..
        pages:
          - {path: /, file: ../page.md}
          - {path: a/, title: A, content: [markdown: /etc/page.md]}
          - {path: b/, title: B, content: [markdown: 'docs\\page.md']}
        """,
        [
            "site.yaml:1: site.theme: no theme named '../themes'; known: default",
            "site.yaml:2: workspace: '..' leads out of the site's folder; "
            "keep everything below site.yaml",
            "site.yaml:4: pages[0].file: '../page.md' leads out of the site's folder; "
            "keep everything below site.yaml",
            "site.yaml:5: pages[1].content[0].markdown: '/etc/page.md' is absolute; "
            "write it relative to the folder of site.yaml",
            "site.yaml:6: pages[2].content[0].markdown: 'docs\\page.md' has a backslash; "
            "write 'docs/page.md'",
        ],
    ),
    Wrong(
        "invalid YAML",
        "site:\n  title: Robot: the second\n",
        [
            "site.yaml:2: yaml: mapping values are not allowed here; "
            "check indentation and quotes here and above",
        ],
    ),
    Wrong(
        "two documents",
        "site: {title: A}\n---\nsite: {title: B}\n",
        [
            "site.yaml:2: yaml: expected a single document in the stream but found another "
            "document; check indentation and quotes here and above",
        ],
    ),
    Wrong(
        "a control character",
        "site:\n  title: a\x07b\n",
        ["site.yaml:2: yaml: YAML allows no character 0x07; remove it"],
    ),
    Wrong(
        "nesting without end",
        "site: " + "[" * 100_000,
        ["site.yaml:1: yaml: nested too deeply; flatten it"],
    ),
    Wrong(
        "an empty file",
        "# nothing yet\n",
        ["site.yaml:1: yaml: the file is empty; begin with 'site: {title: My robot}'"],
    ),
    Wrong(
        "a list",
        "- site\n",
        [
            "site.yaml:1: yaml: expected keys and values, found a list; "
            "the keys are site, workspace, nodes, pages, nav, pyodide, deploy",
        ],
    ),
    Wrong(
        "a file that is not UTF-8",
        "site:\n  title: Kühe\n".encode("latin-1"),
        ["site.yaml:2: text: not UTF-8 (byte 0xfc); save the file as UTF-8"],
    ),
    Wrong(
        "no pages",
        "site: {title: Robot}\npages: []\n",
        [
            "site.yaml:2: pages: a site needs a page; "
            "write it like 'pages: [{path: /, file: index.md}]'",
        ],
    ),
    Wrong(
        "an address and a language that are none",
        """\
        site:
          title: Robot
          url: ftp://example.org
          language: English!
        pages: [{path: /, title: Home, content: []}]
        """,
        [
            "site.yaml:3: site.url: 'ftp://example.org' is not an http address; "
            "write it like 'https://me.github.io/robot/'",
            "site.yaml:4: site.language: 'English!' is not a language tag; "
            "write it like 'en' or 'pt-BR'",
        ],
    ),
    Wrong(
        "content and a file",
        """\
        site: {title: Robot}
        pages:
          - path: /
            title: Home
            content: []
            file: page.md
        """,
        ["site.yaml:6: pages[0].file: given beside 'content'; keep one of the two"],
        {"page.md": "text"},
    ),
    Wrong(
        "items that are no widgets",
        TALKERS
        + """\
    content:
      - talker
      - plot: talker
      - {buttons: talker, console: talker}
      - console:
      - console: {node: talker, line: 10, lines: 0}
      - buttons: {autostart: 1}
""",
        [
            "site.yaml:9: pages[0].content[0]: expected one of markdown, buttons, console, source, "
            "prompt, editor, topics, nodes, services, publish, graph, log, robot, found the text "
            "'talker'; write it like 'console: talker'",
            "site.yaml:10: pages[0].content[1].plot: nothing is called 'plot' here; "
            "did you mean 'prompt'?",
            "site.yaml:11: pages[0].content[2]: expected one key, found 'buttons', 'console'; "
            "begin every widget with '- '",
            "site.yaml:12: pages[0].content[3].console: expected text, found nothing; "
            "write it like 'console: talker'",
            "site.yaml:13: pages[0].content[4].console.line: unknown key; did you mean 'lines'?",
            "site.yaml:13: pages[0].content[4].console.lines: expected a whole number above 0, "
            "found the number 0; write it like 'lines: 1000'",
            "site.yaml:14: pages[0].content[5].buttons.autostart: expected true or false, "
            "found the number 1; write it like 'autostart: false'",
            "site.yaml:14: pages[0].content[5].buttons.node: missing; write it like 'node: talker'",
        ],
    ),
    Wrong(
        "everything that can be wrong in a page file",
        """\
        site: {title: Robot}
        pages: [{path: /, file: page.md}]
        """,
        [
            "page.md:2: titel: unknown key; did you mean 'title'?",
            "page.md:4: nodes.talker.executable: package 'cpp_pubsub' has no executable 'tolker'; "
            "did you mean 'talker'?",
            "page.md:9: ros.console: no node 'camera'; known: talker",
            "page.md:13: ros[1].markdown: nothing is called 'markdown' here; "
            "known: buttons, console, editor, graph, log, nodes, prompt, publish, robot, services, "
            "source, topics",
            "page.md:17: yaml: mapping values are not allowed here; "
            "check indentation and quotes here and above",
            "page.md:20: ros: a block begins with 'ros' only, found 'ros console'; "
            "write the rest inside",
            "page.md:25: ros: this block is empty; write a widget, like 'console: talker'",
            "page.md:29: ros: this block has no end; close it with ```",
        ],
        {
            "page.md": dedent(
                """\
                ---
                titel: Talker
                nodes:
                  talker: {package: cpp_pubsub, executable: tolker}
                ---
                # Talker

                ```ros
                console: camera
                ```
                ```ros
                - console: talker
                - markdown: more.md
                ```

                ~~~ros
                console: a: b
                ~~~

                ```ros console
                node: talker
                ```

                ```ros
                # later
                ```
                The end.

                ```ros
                console: talker
                """
            )
        },
    ),
    Wrong(
        "front matter that is not YAML",
        "site: {title: Robot}\npages: [{path: /, file: page.md}]\n",
        [
            "page.md:3: yaml: found undefined alias 'b'; "
            "check indentation and quotes here and above",
        ],
        {"page.md": "---\ntitle: A\nlevel: *b\n---\n```ros\nconsole: talker\n```\n"},
    ),
    Wrong(
        "front matter without an end",
        "site: {title: Robot}\npages: [{path: /, file: page.md}]\n",
        ["page.md:1: yaml: this front matter has no end; close it with ---"],
        {"page.md": "---\ntitle: A\n"},
    ),
    Wrong(
        "blocks in text that stands in site.yaml",
        TALKERS
        + """\
    content:
      - markdown: |
          Watch it:

          ```ros
          console: talkre
          ```
""",
        ["site.yaml:13: ros.console: no node 'talkre'; did you mean 'talker'?"],
    ),
    Wrong(
        "a package.xml that is broken",
        TALKERS + "    content: [console: talker, console: listener]\n",
        ["src/broken/package.xml:3: xml: mismatched tag; check the tags here and above"],
        {"src/broken/package.xml": "<package>\n<name>\n</package>\n"},
    ),
    Wrong(
        "groups that cannot be",
        """
        site: {title: Robot}
        nodes:
          talker: {package: cpp_pubsub, executable: talker, group: all}
          listener: {package: cpp_pubsub, executable: listener, group: "all of them"}
        pages:
          - path: /
            title: Robot
            content: [console: talker, console: listener]
        """,
        [
            "site.yaml:4: nodes.talker.group: only Python nodes can share an interpreter, and this "
            "one is in C++; leave it out",
            "site.yaml:5: nodes.listener.group: 'all of them' is no name of a group; use letters, "
            "digits, '_' and '-'",
            "site.yaml:5: nodes.listener.group: only Python nodes can share an interpreter, and "
            "this one is in C++; leave it out",
        ],
    ),
    Wrong(
        "an alias that contains itself",
        "site: {title: Robot}\npages: &all\n  - *all\n",
        [
            "site.yaml:2: pages[0]: expected keys and values, found a list; "
            "the keys are path, title, description, level, nodes, launch, launch_arguments, "
            "content, file, folder, tags, date, theme",
        ],
    ),
]


@pytest.mark.parametrize("case", WRONG, ids=lambda case: case.name)
def test_all_that_is_wrong_is_said_at_once(tmp_path: Path, case: Wrong) -> None:
    site = case.site if isinstance(case.site, bytes) else dedent(case.site)
    assert problems(write(tmp_path, site, case.files)) == case.lines


def test_a_folder_without_site_yaml_is_said(tmp_path: Path) -> None:
    assert problems(tmp_path / "site.yaml") == [
        "site.yaml: no such file in this folder; name the folder that has one"
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
    way = "leads out of the site's folder; keep everything below site.yaml"
    assert problems(file) == [
        "site.yaml:1: site.theme: 'themes/mine' leads out of the site's folder; "
        "copy the theme there",
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
    place = Place(tmp_path / "site.yaml", 17)
    assert (page.path, page.title, page.level, page.place) == ("", "Home", "I2", place)
    hello, buttons, console, end = page.content
    assert hello == Markdown("Hello.", tmp_path, Place(tmp_path / "site.yaml", 20))
    assert buttons == Widget(
        "buttons", "talker", {"autostart": True}, Place(tmp_path / "site.yaml", 21)
    )
    assert console == Widget(
        "console", "talker", {"lines": 1000}, Place(tmp_path / "site.yaml", 22)
    )
    assert end == Markdown("The end.\n", tmp_path / "docs", Place(tmp_path / "docs/end.md", 1))
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
    assert before == Markdown("# Heading\n", file.parent, Place(file, 8))
    assert isinstance(buttons, Widget) and buttons.place == Place(file, 11)
    assert isinstance(console, Widget) and console.options == {"lines": 5}
    assert isinstance(after, Markdown) and after.place == Place(file, 14)
    assert "console: an example" in after.text


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
        "give it a console or buttons, or remove it",
    )


def test_a_theme_of_the_site_goes_before_one_of_sitegen(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    brought = tmp_path / "package/themes"
    for name in ("default", "plain"):
        (brought / name).mkdir(parents=True)
        (brought / name / "page.html").touch()
    monkeypatch.setattr(theme, "THEMES", brought)
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


def load_text(folder: Path, site: str, files: dict[str, str] | None = None) -> Site:
    return load(write(folder, dedent(site), files))
