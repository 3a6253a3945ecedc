"""Pages become HTML that works from any folder, and page.json says what they run."""

from __future__ import annotations

import base64
import hashlib
import json
import re
import shutil
from dataclasses import replace
from pathlib import Path

import pytest
from author import Author, data, write
from browser import Serve
from playwright.sync_api import Browser, expect
from playwright.sync_api import Page as Tab
from rendered import render_site

from sitegen.model import Build, Cell, Effect, Event, Handler, Launch, Layout, Page
from sitegen.nodes.cpp.program import CppProgram
from sitegen.shipped import RUNTIME
from sitegen.site.pages import render

SVG = '<svg xmlns="http://www.w3.org/2000/svg" width="40" height="30"/>'


@pytest.fixture
def author(tmp_path: Path) -> Author:
    return Author(tmp_path)


def test_page_json_says_what_the_page_runs(author: Author) -> None:
    talker = author.node("talker", namespace="/a", remap={"chatter": "/b"}, arguments=("--loud",))
    content = (
        author.widget("buttons", "talker"),
        author.widget("console", "talker", lines=50),
        author.widget("console", "listener"),
    )
    nodes = {"talker": talker, "listener": author.node("listener")}
    author.pages.append(Page("a/demo/", "T", "", nodes, content, "I2", author.location()))
    text = author.built()["a/demo/page.json"]
    entry = json.loads(text)
    assert text == json.dumps(entry, sort_keys=True, separators=(",", ":"))
    stem = "../../nodes/cpp_pubsub/"
    assert entry["nodes"] == {
        "talker": {
            "package": "cpp_pubsub",
            "executable": "talker",
            "arguments": ["--loud", "--ros-args", "-r", "chatter:=/b", "-r", "__ns:=/a"],
            "autostart": False,
            "builds": {
                "jspi": {"script": f"{stem}talker.jspi.js", "wasm": f"{stem}talker.jspi.wasm"},
                "asyncify": {
                    "script": f"{stem}talker.asyncify.js",
                    "wasm": f"{stem}talker.asyncify.wasm",
                },
            },
        },
        "listener": {
            "package": "cpp_pubsub",
            "executable": "listener",
            "arguments": [],
            "autostart": True,
            "builds": {
                "jspi": {"script": f"{stem}listener.jspi.js", "wasm": f"{stem}listener.jspi.wasm"},
                "asyncify": {
                    "script": f"{stem}listener.asyncify.js",
                    "wasm": f"{stem}listener.asyncify.wasm",
                },
            },
        },
    }
    assert entry["widgets"] == [
        {"kind": "buttons", "element": "widget-buttons-talker", "target": "talker", "options": {}},
        {
            "kind": "console",
            "element": "widget-console-talker",
            "target": "talker",
            "options": {"lines": 50},
        },
        {
            "kind": "console",
            "element": "widget-console-listener",
            "target": "listener",
            "options": {},
        },
    ]


def test_page_json_says_what_the_launch_file_does(author: Author) -> None:
    """Of its nodes, those start with the page that neither it nor a visitor starts."""
    start = Effect("start", ("late",))
    inside = Handler(Event("time", after=0.5), (start, Effect("log", text="now")), most=1)
    handlers = (Handler(Event("exited", ("first",)), (Effect("handle", handler=inside),)),)
    names = ("first", "late", "pressed")
    content = (
        author.widget("launch", ""),
        author.widget("buttons", "late", autostart=True),
        author.widget("buttons", "pressed"),
    )
    nodes = {name: author.node(name) for name in names}
    launch = Launch("bringup", "x.launch.py", names, handlers)
    page = Page("", "T", "", nodes, content, "I3", author.location(), launch=launch)
    author.pages.append(page)
    entry = json.loads(author.built()["page.json"])
    found = {name: (one["autostart"], one.get("later")) for name, one in entry["nodes"].items()}
    assert found == {"first": (True, None), "late": (False, True), "pressed": (False, None)}
    later = {"kind": "time", "after": 0.5}
    effects = [{"kind": "start", "nodes": ["late"]}, {"kind": "log", "text": "now"}]
    inner = {"on": later, "effects": effects, "most": 1}
    assert entry["launch"] == {
        "package": "bringup",
        "file": "x.launch.py",
        "nodes": [*names],
        "first": ["first", "pressed"],
        "asked": ["pressed"],
        "handlers": [
            {
                "on": {"kind": "exited", "nodes": ["first"]},
                "effects": [{"kind": "handle", "handler": inner}],
                "most": -1,
            }
        ],
    }


@pytest.mark.parametrize("levels", [False, True])
def test_the_level_stands_above_the_title_if_the_author_wants_it(
    author: Author, levels: bool
) -> None:
    author.page("", author.widget("buttons", "talker"), level="I2")
    site = replace(author.site(), levels=levels)
    html = data(render_site(site))["index.html"].decode()
    [above] = re.findall(r'<p class="level">(.*?)</p>', html)
    assert above == f"{'<b>I2</b> ' if levels else ''}start and stop nodes"


def test_one_engine_when_the_site_wants_no_other(author: Author) -> None:
    author.page("", author.widget("console", "talker"))
    entry = json.loads(author.built(asyncify=False)["page.json"])
    builds = entry["nodes"]["talker"]["builds"]
    assert builds == {
        "jspi": {
            "script": "nodes/cpp_pubsub/talker.jspi.js",
            "wasm": "nodes/cpp_pubsub/talker.jspi.wasm",
        }
    }


def test_another_program_has_another_address(author: Author) -> None:
    author.page("a/", author.widget("console", "talker"))
    site = author.site(asyncify=False)
    script, wasm, types = (author.root / name for name in ("a.js", "a.wasm", "a.json"))
    script.touch()
    types.write_text("{}")

    def addresses(content: str) -> dict[str, str]:
        wasm.write_text(content)
        builds = [Build("jspi", script, wasm, types)]
        program = CppProgram("cpp_pubsub", "talker", ["jspi"], builds)
        sources = data(render(site, {("cpp_pubsub", "talker"): program}))
        entry = json.loads(sources["a/page.json"])
        found: dict[str, str] = entry["nodes"]["talker"]["builds"]["jspi"]
        return found

    one, other = addresses("one"), addresses("other")
    stem = re.escape("../nodes/cpp_pubsub/talker.jspi")
    assert re.fullmatch(rf"{stem}\.js\?v=[0-9a-f]{{10}}", one["script"])
    assert re.fullmatch(rf"{stem}\.wasm\?v=[0-9a-f]{{10}}", one["wasm"])
    assert one == addresses("one")
    assert not {*one.values()} & {*other.values()}


def test_buttons_may_ask_for_a_start(author: Author) -> None:
    author.page("", author.widget("buttons", "talker", autostart=True))
    assert json.loads(author.built()["page.json"])["nodes"]["talker"]["autostart"] is True


def test_the_policy_allows_the_inline_scripts(author: Author) -> None:
    author.page("", author.widget("console", "talker"))
    html = author.built()["index.html"]
    choice, note = re.findall(r"<script>(.*?)</script>", html, re.S)
    digests = [hashlib.sha256(script.encode()).digest() for script in (note, choice)]
    hashes = " ".join(f"'sha256-{base64.b64encode(digest).decode()}'" for digest in digests)
    policy = html.split('Content-Security-Policy" content="')[1].split('"')[0]
    rules = policy.replace("&#39;", "'").split("; ")
    assert sorted(rules) == sorted(
        [
            "default-src 'none'",
            f"script-src 'self' 'wasm-unsafe-eval' {hashes}",
            "style-src 'self'",
            "img-src 'self' data:",
            "connect-src 'self'",
            "worker-src 'self' blob:",
            "base-uri 'none'",
            "form-action 'none'",
        ]
    )


def test_a_page_without_nodes_loads_nothing_of_the_runtime(author: Author) -> None:
    author.page("", "Hello")
    built = author.built()
    assert list(built) == ["index.html", "404.html", "theme/all-text.css"]
    scripts = re.findall('<script.*?src="(.*?)"', built["index.html"])
    assert scripts == ["theme/colours.js", "theme/page.js"], "only those of the theme"
    assert "preload" not in built["index.html"]
    assert "wasm" not in built["index.html"]


def test_every_page_has_one_heading(author: Author) -> None:
    author.page("", "Text", title="Home")
    author.page("a/", "# My own", title="Other")
    built = author.built()
    assert re.findall("<h1.*?</h1>", built["index.html"]) == ["<h1>Home</h1>"]
    assert re.findall("<h1.*?</h1>", built["a/index.html"]) == ['<h1 id="my-own">My own</h1>']


def test_ids_are_unique_over_the_parts_of_a_page(author: Author) -> None:
    part = "## Über\n\ntext[^1]\n\n[^1]: note"
    author.page("", part, author.widget("console", "talker"), part)
    ids = re.findall(r'\bid="([^"]*)"', author.built()["index.html"])
    assert len(ids) == len(set(ids))
    assert {"über", "über_1"} <= set(ids)


def test_what_authors_write_is_escaped(author: Author) -> None:
    author.page("", author.widget("console", "<b>&"), title='<script>"x"')
    author.page("b/", "B", title="</a><i>")
    html = author.built(title="R&D <x>")["index.html"]
    assert "<title>&lt;script&gt;&#34;x&#34; · R&amp;D &lt;x&gt;</title>" in html
    assert "<i>" not in html
    assert "<b>&" not in html


def test_widgets_of_one_node_share_a_panel(author: Author) -> None:
    names = [("buttons", "a"), ("console", "a"), ("buttons", "b"), ("console", "b")]
    author.page("", "One", *(author.widget(*name) for name in names), "Two")
    html = author.built()["index.html"]
    row = html[html.index("One") : html.index("Two")]
    assert row.count('class="ros-row"') == 1
    panels = row.split("<section")[1:]
    assert [re.findall('data-ros-widget="(.*?)"', panel) for panel in panels] == [
        ["buttons", "console"],
        ["buttons", "console"],
    ]


def test_an_example_shows_its_yaml_beside_its_widgets(author: Author) -> None:
    location = author.location()
    code = author.text("```yaml\n- log:\n```")
    cells = (Cell((code,)), Cell((author.widget("log", ""),)))
    author.page("", "Text", Layout("example", cells, location))
    author.page("b/", "Text", author.widget("log", ""))
    built = author.built()
    html = built["index.html"]
    example = html[html.index('class="example"') : html.index("</main>")]
    assert example.index('class="code"') < example.index('data-ros-widget="log"')
    # The page is still one to read.
    assert '<body class="live"' not in html and 'class="level"' not in html
    assert '<body class="live"' in built["b/index.html"]
    assert 'class="level"' in built["b/index.html"]


def test_tables_keep_their_alignment_without_style_attributes(author: Author) -> None:
    author.page("", "|a|b|\n|--|--:|\n|1|2|")
    html = author.built()["index.html"]
    assert "style=" not in html
    assert '<div class="table" role="group" aria-label="' in html
    assert 'tabindex="0"><table>' in html
    assert '<td align="right">2</td>' in html


def test_the_menu_opens_the_branch_of_the_page(author: Author) -> None:
    for path in ("", "a/", "a/x/", "a/y/", "b/", "b/z/"):
        author.page(path, "Text")

    def shown(path: str) -> str:
        html = author.built()[f"{path}index.html"]
        menu = html[html.index('<nav class="menu"') : html.index("<main")]
        return " ".join(re.findall(r"<li><a.*?>(.*?)</a>|(?:</ul></li>)", menu)).replace(
            "  ", " - "
        )

    assert shown("") == "Home a/ b/"
    assert shown("a/") == shown("a/y/") == "Home a/ a/x/ a/y/ - b/"


def test_a_page_from_a_subfolder_of_a_server(
    author: Author, tab: Tab, serve: Serve, tmp_path: Path
) -> None:
    (author.root / "x.svg").write_text('<svg xmlns="http://www.w3.org/2000/svg"/>')
    author.page("", "![x](x.svg)")
    author.page("a/", "Text", author.widget("console", "talker"), level="I1")
    dist = write(render_site(author.site()), tmp_path / "dist")
    shutil.copytree(RUNTIME, dist / "runtime")
    (dist / "runtime/rosMain.js").write_text(
        'const page = await fetch(document.getElementById("ros-page").href);\n'
        "document.documentElement.dataset.nodes = Object.keys((await page.json()).nodes).join();\n"
    )
    (dist / "nodes/cpp_pubsub").mkdir(parents=True)
    for name in ("talker.jspi.js", "talker.jspi.wasm"):
        (dist / "nodes/cpp_pubsub" / name).touch()  # nothing runs it
    answers: dict[str, int] = {}
    tab.on("response", lambda response: answers.update({response.url: response.status}))
    url = serve(dist, "/me/robots/")
    tab.goto(url)
    tab.wait_for_function("() => document.querySelector('main img').complete")
    tab.get_by_role("link", name="Next").click()
    tab.wait_for_selector("html[data-nodes=talker]")
    assert tab.is_hidden("#file-note")
    tab.get_by_role("link", name="Previous").click()
    tab.wait_for_url(url)
    assert [url for url, status in answers.items() if status >= 400] == []


def test_long_names_stay_where_they_belong(
    author: Author, tab: Tab, serve: Serve, tmp_path: Path
) -> None:
    author.page("", "Text")
    author.page("a/", "Text", title="all_that_this_robot_has_to_say_about_itself_cpp")
    url = serve(write(render_site(author.site()), tmp_path / "dist"))
    tab.goto(f"{url}a/")
    current = tab.locator(".menu a[aria-current]")
    expect(current).to_be_visible()
    assert current.evaluate("(link) => link.scrollWidth <= link.clientWidth")
    tab.set_viewport_size({"width": 320, "height": 640})
    assert tab.evaluate("document.documentElement.scrollWidth <= innerWidth")


def test_a_page_opened_as_a_file_says_what_to_do(
    author: Author, browser: Browser, tmp_path: Path
) -> None:
    author.page("", "Text", author.widget("console", "talker"))
    dist = write(render_site(author.site()), tmp_path / "dist")
    tab = browser.new_page()
    tab.goto((dist / "index.html").as_uri())
    assert "python -m http.server --directory dist" in tab.inner_text("#file-note")
    assert tab.is_visible("#file-note")
    assert tab.evaluate("getComputedStyle(document.body).margin") == "0px"
    tab.close()
