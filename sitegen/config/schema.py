"""Say what site.yaml may hold: every key, as data."""

from __future__ import annotations

import re
from collections.abc import Mapping
from dataclasses import dataclass


@dataclass(frozen=True)
class Key:
    """One key: its type, whether it must be given, what it is without, and how it is written."""

    name: str
    type: str
    help: str
    example: str
    required: bool = False
    default: str | bool | int | None = None


# What each type is made of (a kind of Value), and its name in a message.
TYPES = {
    "text": ("text", "text"),
    "path": ("text", "a path"),
    "url": ("text", "an address"),
    "flag": ("flag", "true or false"),
    "number": ("number", "a whole number above 0"),
    "name": ("text", "a name of the graph"),
    "type": ("text", "a message type"),
    "list of text": ("list", "a list of text"),
    "list of names": ("list", "a list of names of the graph"),
    "date": ("other", "a date like 2026-11-21"),
    "colour": ("text", 'a colour like "#2b4bd8"'),
    "range": ("text", "lines like 10-20"),
    "nav": ("list", "a list of pages and groups"),
    "text by name": ("mapping", "names with a text each"),
    "parameters": ("mapping or list", "names with a value each, or a list of these and of files"),
    "digest": ("text", "64 hexadecimal digits"),
    "interface": ("text", "the type of a message or a service"),
    "interface by name": ("mapping", "names of the graph with a type each"),
    "site": ("mapping", "keys and values"),
    "nodes": ("mapping", "names with a node each"),
    "pages": ("list", "a list of pages"),
    "content": ("list", "a list of text and widgets"),
    "deploy": ("mapping", "keys and values"),
    "pyodide": ("mapping", "keys and values"),
}

# What text of some types looks like.
FORMS = {
    "name": re.compile(r"(/[A-Za-z_]\w*)+", re.ASCII),
    "type": re.compile(r"[a-z]\w*/msg/[A-Z]\w*", re.ASCII),
    "date": re.compile(r"\d{4}-(0[1-9]|1[0-2])-(0[1-9]|[12]\d|3[01])"),
    "colour": re.compile(r"#[0-9a-fA-F]{6}"),
    "range": re.compile(r"[1-9]\d*-[1-9]\d*"),
    "digest": re.compile(r"[0-9a-f]{64}"),
    "interface": re.compile(r"[a-z]\w*/(msg|srv)/[A-Z]\w*", re.ASCII),
}

FILE = (
    Key("site", "site", "what the whole site has in common", "site: {title: My robot}", True),
    Key(
        "workspace",
        "path",
        "the colcon workspace: packages anywhere below this folder",
        "workspace: .",
        default=".",
    ),
    Key(
        "nodes",
        "nodes",
        "the nodes that every page may use, by name",
        "nodes: {talker: {package: cpp_pubsub, executable: talker}}",
    ),
    Key("pages", "pages", "the pages, in order", "pages: [{path: /, file: index.md}]", True),
    Key(
        "nav",
        "nav",
        "the navigation, where the paths of the pages are not it",
        "nav: [/, {Demos: [demo01/, demo02/]}]",
    ),
    Key(
        "pyodide",
        "pyodide",
        "what Python nodes need beside ROS",
        "pyodide: {requirements: requirements.txt}",
    ),
    Key("deploy", "deploy", "where `sitegen deploy` puts it", "deploy: {branch: gh-pages}"),
)

SITE = (
    Key("title", "text", "the name of the site", "title: My robot", True),
    Key("description", "text", "one sentence for previews", "description: A robot to try out"),
    Key(
        "url",
        "url",
        "where the site will live; for absolute links and previews",
        "url: https://me.github.io/my-robot/",
    ),
    Key("language", "text", "the language of the text", "language: en", default="en"),
    Key("languages", "list of text", "languages it is translated to", "languages: [de]"),
    Key(
        "theme",
        "text",
        "a folder of `themes/` beside site.yaml, or a theme that sitegen brings",
        "theme: default",
        default="default",
    ),
    Key("accent", "colour", "the colour of links and of what is current", 'accent: "#2b4bd8"'),
    Key("font", "text", "the letters of text: a font file, or names", "font: fonts/own.woff2"),
    Key("code_font", "text", "the letters of code", "code_font: fonts/code.woff2"),
    Key("logo", "path", "an image beside the title", "logo: images/logo.svg"),
    Key("footer", "text", "what stands below every page, Markdown", "footer: Example University"),
    Key(
        "repository",
        "url",
        "where the sources are; for a link to edit a page",
        "repository: https://github.com/me/my-robot",
    ),
    Key("branch", "text", "the branch to edit", "branch: main", default="main"),
    Key("feed", "flag", "write a feed of the pages with a date", "feed: true", default=False),
    Key(
        "offline",
        "flag",
        "work without a network after the first visit, and be installed",
        "offline: true",
        default=False,
    ),
    Key(
        "asyncify",
        "flag",
        "build every node a second time, for browsers without JSPI",
        "asyncify: true",
        default=True,
    ),
)

PYODIDE = (
    Key(
        "requirements",
        "path",
        "packages of pure Python, with their versions and hashes, as pip reads them",
        "requirements: requirements.txt",
    ),
    Key(
        "packages",
        "text",
        "a folder or an address with the Pyodide distribution, for compiled packages",
        "packages: vendor/pyodide",
    ),
)

DEPLOY = (
    Key("branch", "text", "the branch that is served", "branch: gh-pages", default="gh-pages"),
    Key("remote", "text", "the remote of git to push to", "remote: origin", default="origin"),
    Key("cname", "text", "a domain of your own", "cname: robot.example.org"),
)

# How any node is started.
_HOW = (
    Key("namespace", "text", "the namespace it starts in", "namespace: /demo"),
    Key(
        "remap",
        "text by name",
        "names that it uses, and what they become",
        "remap: {chatter: /demo/chatter}",
    ),
    Key("parameters", "parameters", "its parameters, by name", "parameters: {speed: 2.5}"),
    Key("arguments", "list of text", "what its `main` is given", "arguments: [--foo]"),
)

NODE = (
    Key("package", "text", "the package of the workspace", "package: cpp_pubsub", True),
    Key("executable", "text", "the executable of that package", "executable: talker", True),
    *_HOW,
    Key("group", "text", "Python nodes of a group share an interpreter", "group: robot"),
)

COMPILED = (
    Key(
        "compiled",
        "text",
        "an archive of compiled nodes: an address, or a file",
        "compiled: nodes.zip",
        True,
    ),
    Key(
        "sha256",
        "digest",
        "its SHA-256, needed for an address",
        "sha256: 72a66436beb4c95047286bc22bc7295cd1168bc8b3309ef35897a6802a22a2fb",
    ),
    Key("package", "text", "which node of it: its package", "package: cpp_pubsub"),
    Key("executable", "text", "which node of it: its executable", "executable: talker"),
    *_HOW,
)

ROS2WASM = (
    Key("ros2wasm", "path", "the worker script of such a node", "ros2wasm: nodes/talker.js", True),
    Key(
        "types",
        "interface by name",
        "what its topics and services carry",
        "types: {/chatter: std_msgs/msg/String}",
        True,
    ),
)

PAGE = (
    Key("path", "text", "its folder in the site; `/` is the first page", "path: demo03/", True),
    Key(
        "title",
        "text",
        "its name; without it, the first `# heading` of its text",
        "title: Publisher and subscriber",
    ),
    Key("description", "text", "one sentence for previews", "description: Two nodes that talk"),
    Key("level", "text", "what a visitor can do, checked against the widgets", "level: I3"),
    Key(
        "nodes",
        "nodes",
        "nodes of this page only, by name",
        "nodes: {talker: {package: cpp_pubsub, executable: talker}}",
    ),
    Key(
        "launch",
        "path",
        "a launch file, whose nodes start with the page",
        "launch: src/my_bringup/launch/demo.launch.xml",
    ),
    Key(
        "launch_arguments",
        "text by name",
        "the arguments of that launch file",
        "launch_arguments: {speed: fast}",
    ),
    Key("content", "content", "what the page shows, in order", "content: [{console: talker}]"),
    Key("file", "path", "a Markdown file instead of `content`", "file: demos/demo01/page.md"),
    Key("folder", "path", "a folder of Markdown files, a page each", "folder: docs"),
    Key("tags", "list of text", "what it is about, in words", "tags: [topics, C++]"),
    Key("date", "date", "the day it is of, for the feed", "date: 2026-11-21"),
    Key("theme", "text", "its own theme", "theme: slides"),
)

IN_FILE = (
    *("title", "description", "level", "nodes", "launch", "launch_arguments", "tags", "date"),
    "theme",
)
FRONT_MATTER = tuple(key for key in PAGE if key.name in IN_FILE)

MARKDOWN = Key("markdown", "text", "a file ending in .md, or the text itself", "markdown: intro.md")

_NODE = Key("node", "text", "the node it is about", "node: talker", True)

WIDGETS: Mapping[str, tuple[Key, ...]] = {
    "buttons": (
        _NODE,
        Key(
            "autostart",
            "flag",
            "start the node when the page opens",
            "autostart: false",
            default=False,
        ),
    ),
    "console": (
        _NODE,
        Key("lines", "number", "how many lines it keeps", "lines: 1000", default=1000),
    ),
    "source": (
        Key("node", "text", "the node whose source it is", "node: talker"),
        Key("file", "text", "another file of the package", "file: src/talker.cpp"),
        Key("lines", "range", "only these lines", "lines: 10-20"),
        Key("region", "text", "only the part between #region and #endregion", "region: timer"),
    ),
    "prompt": (
        _NODE,
        Key("lines", "number", "how many lines it keeps", "lines: 1000", default=1000),
    ),
    "editor": (
        _NODE,
        Key("file", "text", "another Python file of the package", "file: py_pubsub/words.py"),
    ),
    # Those without a node look at all of the page.
    "topics": (
        Key("show", "list of names", "only these topics", "show: [/chatter]"),
        Key("echo", "name", "the topic whose messages it shows at first", "echo: /chatter"),
    ),
    "nodes": (),
    "services": (Key("show", "list of names", "only these services", "show: [/add_two_ints]"),),
    "publish": (
        Key("topic", "name", "publish there, without a choice", "topic: /chatter"),
        Key(
            "type",
            "type",
            "the type of its messages, where no node has the topic yet",
            "type: std_msgs/msg/String",
        ),
    ),
    "graph": (),
    "log": (Key("lines", "number", "how many lines it keeps", "lines: 1000", default=1000),),
    "robot": (
        Key("kind", "text", "which robot it is", "kind: vernie", True),
        Key("twist", "name", "the topic of its commands", "twist: /cmd_vel", default="/cmd_vel"),
        Key("color", "name", "the topic of its colours", "color: /color", default="/color"),
        Key("sensors", "name", "where it publishes", "sensors: /vernie", default="/vernie"),
        Key("odometry", "name", "the topic of where it is", "odometry: /odom"),
        Key(
            "window",
            "name",
            "the topic of what a turtlesim_node shows",
            "window: /sim/window",
            default="/turtlesim/window",
        ),
    ),
}

# The kinds of robots, and which keys of `robot` each has.
ROBOTS: Mapping[str, tuple[str, ...]] = {
    "vernie": ("twist", "color", "sensors"),
    "diffdrive": ("twist", "odometry"),
    "turtlesim": ("window",),
}
