"""Define the keys of site.yaml as data."""

from __future__ import annotations

import re
from dataclasses import dataclass


@dataclass(frozen=True)
class Key:
    """One key: its type, its description, an example, and its default."""

    name: str
    type: str
    help: str
    example: str
    required: bool = False
    default: str | bool | int | None = None


# For each type: the kind of Value it is made of, and its name in messages.
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
    "color": ("text", 'a color like "#2b4bd8"'),
    "range": ("text", "lines like 10-20"),
    "nav": ("list", "a list of pages and groups"),
    "mapping of texts": ("mapping", "names with a text each"),
    "parameters": ("mapping or list", "names with a value each, or a list of these and of files"),
    "message path": ("text", "a message path"),
    "message paths": ("text or list", "a message path or a list of these"),
    "decimal": ("number or other", "a number"),
    "thresholds": ("list", "a list of thresholds"),
    "data": ("mapping", "names with any values"),
    "digest": ("text", "64 hexadecimal digits"),
    "interface": ("text", "the type of a message or a service"),
    "mapping of interfaces": ("mapping", "names of the graph with a type each"),
    "site": ("mapping", "keys and values"),
    "settings": ("mapping", "keys and values"),
    "nodes": ("mapping", "names with a node each"),
    "pages": ("list", "a list of pages"),
    "content": ("list", "a list of text and widgets"),
    "displays": ("list", "a list of displays"),
    "mapping of names": ("mapping", "names with a name of the graph each"),
    "items": ("mapping or list", "a list of text and widgets, or one of them"),
    "deploy": ("mapping", "keys and values"),
    "pyodide": ("mapping", "keys and values"),
    "connect": ("mapping", "keys and values"),
    "builds": ("mapping", "packages with keys and values each"),
    "names": ("mapping", "lists of names"),
    "list of patterns": ("list", "a list of names, with * and **"),
    "mapping of decimals": ("mapping", "names with a number each"),
    "pattern": ("text", "a name of the graph, with * and **"),
}

# The patterns of types that are text.
FORMS = {
    "name": re.compile(r"(/[A-Za-z_]\w*)+", re.ASCII),
    "type": re.compile(r"[a-z]\w*/msg/[A-Z]\w*", re.ASCII),
    "date": re.compile(r"\d{4}-(0[1-9]|1[0-2])-(0[1-9]|[12]\d|3[01])"),
    "color": re.compile(r"#[0-9a-fA-F]{6}"),
    "range": re.compile(r"[1-9]\d*-[1-9]\d*"),
    "message path": re.compile(
        r"(/[A-Za-z_]\w*)+(\.[A-Za-z]\w*(\[-?\d+\]|\[(-?\d+)?:(-?\d+)?\](\{\w+\})?)?)*"
        r"(\.@derivative)?",
        re.ASCII,
    ),
    "pattern": re.compile(r"(/[\w*]+)+", re.ASCII),
    "decimal": re.compile(r"[-+]?(\d+\.?\d*|\.\d+)"),
    "digest": re.compile(r"[0-9a-f]{64}"),
    "interface": re.compile(r"[a-z]\w*/(msg|srv)/[A-Z]\w*", re.ASCII),
}

FILE = (
    Key("site", "site", "settings of the whole site", "site: {title: My robot}", True),
    Key("workspace", "path", "the colcon workspace", "workspace: .", default="."),
    Key(
        "nodes",
        "nodes",
        "nodes available to every page, by name",
        "nodes: {talker: {package: cpp_pubsub, executable: talker}}",
    ),
    Key(
        "pages",
        "pages",
        "the pages in navigation order; at least one",
        "pages: [{path: /, file: index.md}]",
        True,
    ),
    Key(
        "nav",
        "nav",
        "navigation order; defaults to the page paths",
        "nav: [/, {Demos: [demo01/, demo02/]}]",
    ),
    Key(
        "pyodide",
        "pyodide",
        "packages for Python nodes besides ROS",
        "pyodide: {requirements: requirements.txt}",
    ),
    Key(
        "connect",
        "connect",
        "[gateways](gateway.md) that pages can join",
        "connect: {addresses: [ws://localhost:9090]}",
    ),
    Key(
        "build",
        "builds",
        "[how CMake builds a package](cpp-packages.md#settings-of-a-package), by name",
        "build: {my_robot: {cmake: [-DWITH_CAMERA=OFF]}}",
    ),
    Key("deploy", "deploy", "where `sitegen deploy` publishes", "deploy: {branch: gh-pages}"),
)

SITE = (
    Key("title", "text", "name of the site", "title: My robot", True),
    Key(
        "description",
        "text",
        "one sentence for link previews",
        "description: A robot to try out",
    ),
    Key(
        "url",
        "url",
        "public address; required for previews, sitemap and feed",
        "url: https://me.github.io/my-robot/",
    ),
    Key(
        "language", "text", "language tag of the text: `de`, `pt-BR`", "language: en", default="en"
    ),
    Key("languages", "list of text", "languages of the translations", "languages: [de]"),
    Key(
        "theme",
        "text",
        "a folder in `themes/`, or a theme included in sitegen",
        "theme: default",
        default="default",
    ),
    Key("accent", "color", "color of links and of the current item", 'accent: "#2b4bd8"'),
    Key("font", "text", "font of the text: a file, or font names", "font: fonts/own.woff2"),
    Key("code_font", "text", "font of code and consoles", "code_font: fonts/code.woff2"),
    Key("logo", "path", "image beside the title, also the icon", "logo: images/logo.svg"),
    Key("footer", "text", "Markdown below every page", "footer: Example University"),
    Key(
        "repository",
        "url",
        "source repository; adds links to it and to edit pages",
        "repository: https://github.com/me/my-robot",
    ),
    Key("branch", "text", "branch of the edit links", "branch: main", default="main"),
    Key(
        "levels",
        "flag",
        "show the interaction level of each page above its title",
        "levels: true",
        default=False,
    ),
    Key("feed", "flag", "write an Atom feed of dated pages", "feed: true", default=False),
    Key(
        "offline",
        "flag",
        "make the site an installable app that works offline",
        "offline: true",
        default=False,
    ),
    Key(
        "isolate",
        "flag",
        "share memory between pages and their Python nodes",
        "isolate: true",
        default=False,
    ),
    Key(
        "asyncify",
        "flag",
        "also build C++ nodes for browsers without JSPI",
        "asyncify: true",
        default=True,
    ),
    Key(
        "messages_from",
        "list of text",
        "origins whose pages may [use the graph](roslib.md#from-another-page)",
        'messages_from: ["https://school.example"]',
    ),
)

PYODIDE = (
    Key(
        "requirements",
        "path",
        "pip requirements file with versions and hashes",
        "requirements: requirements.txt",
    ),
    Key(
        "packages",
        "text",
        "folder or address of the Pyodide distribution",
        "packages: vendor/pyodide",
    ),
)

CONNECT = (
    Key(
        "addresses",
        "list of text",
        "addresses of gateways; `self` is the server of the page",
        "addresses: [ws://localhost:9090]",
        True,
    ),
    Key("autoconnect", "flag", "join when the page opens", "autoconnect: true", default=False),
    Key("namespace", "name", "namespace of the page in the remote graph", "namespace: /student1"),
    Key("send", "names", "what the page offers; defaults to all", "send: {topics: [/cmd_vel]}"),
    Key(
        "receive", "names", "what the page gets; defaults to all", "receive: {topics: [/camera/**]}"
    ),
    Key(
        "rates",
        "mapping of decimals",
        "maximum messages per second, by topic",
        "rates: {/camera/image_raw: 5}",
    ),
)

# The lists of `send` and `receive`.
NAMES = (
    Key("topics", "list of patterns", "topics", "topics: [/cmd_vel]"),
    Key("services", "list of patterns", "services", "services: [/reset]"),
    Key("actions", "list of patterns", "actions", "actions: [/navigate_*]"),
)

BUILD = (
    Key("cmake", "list of text", "definitions for CMake", "cmake: [-DWITH_CAMERA=OFF]"),
    Key(
        "environment",
        "mapping of texts",
        "environment variables of CMake",
        "environment: {ROBOT: arm}",
    ),
)

DEPLOY = (
    Key("branch", "text", "branch that is served", "branch: gh-pages", default="gh-pages"),
    Key("remote", "text", "git remote to push to", "remote: origin", default="origin"),
    Key("cname", "text", "custom domain, written to `CNAME`", "cname: robot.example.org"),
)

PAGE = (
    Key("path", "text", "folder of the page; `/` is the home page", "path: demo03/", True),
    Key(
        "title",
        "text",
        "title; defaults to the first `# heading`",
        "title: Publisher and subscriber",
    ),
    Key(
        "description",
        "text",
        "one sentence for link previews",
        "description: Two nodes that talk",
    ),
    Key("level", "text", "interaction level, checked against the widgets", "level: I3"),
    Key(
        "nodes",
        "nodes",
        "nodes of this page only, by name",
        "nodes: {talker: {package: cpp_pubsub, executable: talker}}",
    ),
    Key(
        "launch",
        "path",
        "launch file whose nodes run on the page",
        "launch: src/my_bringup/launch/demo.launch.xml",
    ),
    Key(
        "launch_arguments",
        "mapping of texts",
        "arguments of the launch file",
        "launch_arguments: {speed: fast}",
    ),
    Key(
        "environment",
        "mapping of texts",
        "environment variables of the launch file and its nodes",
        "environment: {MODEL: fox}",
    ),
    Key("content", "content", "text and widgets, in order", "content: [{console: talker}]"),
    Key(
        "jupyter",
        "data",
        "options of [JupyterLab](notebooks.md#jupyter) below the content",
        "jupyter: {notebooks: notebooks}",
    ),
    Key(
        "layout",
        "text",
        "`page`, or `dashboard`: panels fill the window",
        "layout: dashboard",
        default="page",
    ),
    Key("file", "path", "Markdown file instead of `content`", "file: demos/demo01/page.md"),
    Key("folder", "path", "folder of Markdown files, one page each", "folder: docs"),
    Key(
        "connect",
        "connect",
        "[gateways](gateway.md) that the page can join",
        "connect: {addresses: [ws://localhost:9090]}",
    ),
    Key(
        "tags", "list of text", "tags; each gets a page that lists its pages", "tags: [topics, C++]"
    ),
    Key("date", "date", "date of the page, for the feed", "date: 2026-11-21"),
    Key("theme", "text", "theme of this page; defaults to the site's", "theme: slides"),
    Key(
        "start_from_links",
        "list of text",
        "nodes that a [shared link](sharing.md) starts without asking",
        "start_from_links: [talker]",
    ),
    Key(
        "script",
        "path",
        "[JavaScript module](javascript.md) that runs on the page",
        "script: scripts/drive.js",
    ),
    Key(
        "scripts",
        "list of text",
        "several of them, which run in order",
        "scripts: [scripts/map.js, scripts/drive.js]",
    ),
)

IN_FILE = (
    *("title", "description", "level", "nodes", "launch", "launch_arguments", "environment"),
    *("tags", "date", "layout", "theme", "start_from_links", "script", "scripts", "connect"),
)
FRONT_MATTER = tuple(key for key in PAGE if key.name in IN_FILE)

# Keys that are valid elsewhere: where each of them belongs.
PLACES = (
    (FILE, "at the top level of site.yaml; move it there"),
    (SITE, "under 'site' in site.yaml; indent it below 'site:'"),
    (PAGE, "to a page; move it to an item of 'pages' in site.yaml"),
    (DEPLOY, "under 'deploy' in site.yaml; indent it below 'deploy:'"),
    (CONNECT, "under 'connect' in site.yaml; indent it below 'connect:'"),
    (PYODIDE, "under 'pyodide' in site.yaml; indent it below 'pyodide:'"),
)

# What others call a key of `site`.
MEANT = {"embed": "messages_from", "embedding": "messages_from", "origins": "messages_from"}


def belongs(name: str, keys: tuple[Key, ...]) -> str:
    """Return where the unknown key `name` belongs, and how it is written there; else ""."""
    if keys not in (FRONT_MATTER, *(place for place, _ in PLACES)):
        return ""
    return next((how for place, how in PLACES if name in {key.name for key in place}), "")


def meant(name: str, keys: tuple[Key, ...]) -> str:
    """Return the end of a message about the unknown key `name` if it has another name; else ""."""
    if keys not in (FILE, SITE, PAGE, FRONT_MATTER) or name not in MEANT:
        return ""
    key = next(key for key in SITE if key.name == MEANT[name])
    where = "write" if keys == SITE else "under 'site' in site.yaml, write"
    return f"did you mean '{key.name}'? {where} '{key.example}'"
