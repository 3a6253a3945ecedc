"""What Markdown becomes, and what is said of what cannot become anything."""

from __future__ import annotations

import re
from pathlib import Path

import pytest
from browser import Serve
from playwright.sync_api import Page as Tab

from sitegen.commands.build import build
from sitegen.config import load
from sitegen.errors import SiteError
from sitegen.report import Report
from sitegen.site.pages import render
from sitegen.site.prose import resourced


def written(folder: Path, text: str, **files: str) -> Path:
    """A site of one page, and other files."""
    (folder / "page.md").write_text(text, encoding="utf-8")
    for name, content in files.items():
        (folder / name.replace("__", ".")).write_text(content, encoding="utf-8")
    (folder / "site.yaml").write_text("site: {title: T}\npages: [{path: /, file: page.md}]\n")
    return folder


def html(folder: Path, text: str) -> str:
    site = load(written(folder, f"# T\n\n{text}") / "site.yaml")
    (page,) = (a.source for a in render(site) if a.path == "index.html")
    assert isinstance(page, bytes)
    body = page.decode()
    return body[body.index("</h1>") : body.index("</main>")]


def problems(folder: Path, text: str) -> list[str]:
    site = load(written(folder, f"# T\n\n{text}") / "site.yaml")
    with pytest.raises(SiteError) as wrong:
        render(site)
    return wrong.value.lines


def test_code_is_coloured_by_classes(tmp_path: Path) -> None:
    found = html(tmp_path, '```cpp\nint x = 1;  // "<"\n```')
    assert '<code class="language-cpp"><span class="t">int</span> x = <span class="n">1</span>;'
    assert '<span class="c">// &#34;&lt;&#34;</span>' in found
    assert "style=" not in found


def test_lines_of_code_are_numbered_and_marked(tmp_path: Path) -> None:
    found = html(tmp_path, '```py title="a.py" linenums="7" hl_lines="2-3 5"\na\n\nb\nc\nd\n```')
    assert '<p class="code-title">a.py</p>' in found
    lines = re.findall(r'<span class="(line.*?)" data-line="(\d+)">', found)
    marked = [int(number) for name, number in lines if name == "line marked"]
    assert [int(number) for _, number in lines] == [7, 8, 9, 10, 11]
    assert marked == [8, 9, 11]


def test_code_of_a_language_that_nobody_knows_is_shown_as_it_is(tmp_path: Path) -> None:
    found = html(tmp_path, "```klingon\nnuqneH <b>\n```")
    assert '<code class="language-klingon">nuqneH &lt;b&gt;' in found


def test_fences_stand_in_lists_and_tabs(tmp_path: Path) -> None:
    text = '- one\n\n    ```py\n    a = 1\n    ```\n\n=== "A"\n\n    ```py\n    b = 2\n    ```\n'
    found = html(tmp_path, text)
    assert found.count('<div class="code">') == 2
    assert found.index("<li>") < found.index('<div class="code">') < found.index("</li>")


def test_tabs_of_two_parts_of_a_page_are_apart(tmp_path: Path) -> None:
    tabs = '=== "A"\n\n    a\n\n=== "B"\n\n    b\n'
    (tmp_path / "part.md").write_text(tabs + "\ntext[^1]\n\n[^1]: note\n")
    (tmp_path / "site.yaml").write_text(
        "site: {title: T}\npages:\n  - path: /\n    title: T\n"
        "    content: [{markdown: part.md}, {markdown: part.md}]\n"
    )
    (page,) = (a.source for a in render(load(tmp_path / "site.yaml")) if a.path == "index.html")
    assert isinstance(page, bytes)
    ids = re.findall(r'\sid="([^"]*)"', page.decode())
    assert len(ids) == len(set(ids))
    assert len(set(re.findall(r'name="(tab_.*?)"', page.decode()))) == 2


@pytest.mark.parametrize(
    ("text", "classes"),
    [
        ("!!! tip\n    x", "admonition tip"),
        ("> [!WARNING]\n> x", "admonition warning"),
        ("??? note\n    x", "note"),
    ],
)
def test_admonitions(tmp_path: Path, text: str, classes: str) -> None:
    assert f'class="{classes}"' in html(tmp_path, text)


def test_formulas_are_mathml(tmp_path: Path) -> None:
    found = html(
        tmp_path, "It costs $3.00 and $x^2 < y$.\n\n$$\n\\begin{aligned} a &= b \\end{aligned}\n$$"
    )
    assert "costs $3.00 and <math><msup><mi>x</mi><mn>2</mn></msup>" in found
    assert '<math display="block"><mtable' in found
    assert '<mtd class="right close-right">' in found
    assert "style=" not in found.replace("displaystyle=", "")


def test_a_formula_that_is_none_is_told_by_its_line(tmp_path: Path) -> None:
    assert problems(tmp_path, "Text\n\n$$\n\\frac{a\n$$\n\nand $\\foo$") == [
        'page.md:6: formula: Expected closing token "}", but reached end of input; '
        "write it as TeX does",
        "page.md:9: formula: Unknown command \"\\foo\" at '\\foo'; write it as TeX does",
    ]


def test_headings_have_ids_that_links_reach(tmp_path: Path) -> None:
    text = "## Über uns\n\n## Über uns\n\n## Other {#own}\n\n"
    text += "[a](#über-uns_1) [b](#own) [c](#%C3%BCber-uns)"
    found = html(tmp_path, text)
    assert re.findall(r'<h2 id="(.*?)"', found) == ["über-uns", "über-uns_1", "own"]


def test_a_link_to_a_heading_that_is_not_there_is_told(tmp_path: Path) -> None:
    assert problems(tmp_path, "[a](#instal)\n\n## Install") == [
        "page.md:3: link: no heading '#instal' in this page; did you mean 'install'?"
    ]


@pytest.mark.parametrize(
    ("text", "fault"),
    [
        (
            "<script>alert(1)</script>",
            "html: '<script>' is not allowed: pages cannot run their own scripts",
        ),
        (
            '<p onclick="x()">a</p>',
            "html: 'onclick=' is not allowed: pages cannot run their own scripts",
        ),
        (
            '<p style="color: red">a</p>',
            "html: 'style=' is not allowed: pages cannot have their own styles",
        ),
        (
            "<style>p {}</style>",
            "html: '<style>' is not allowed: pages cannot have their own styles",
        ),
        ("[a](javascript:alert(1))", "link: a link cannot run a script"),
        ('<iframe src="https://a.b/"></iframe>', "frame: 'https://a.b/' is on another site"),
        ('<form action="x"></form>', "html: '<form>' is not allowed: pages cannot submit forms"),
    ],
)
def test_what_the_policy_would_stop_is_told(tmp_path: Path, text: str, fault: str) -> None:
    (line,) = problems(tmp_path, f"Text\n\n{text}")
    assert line.startswith(f"page.md:5: {fault}")


def test_words_of_html_in_text_and_code_are_text(tmp_path: Path) -> None:
    text = 'Write `<script>` and `style="x"`, or onclick="y" here.\n\n```html\n<p style="a">\n```'
    assert "onclick" in html(tmp_path, text)


def test_tabs_work_by_keyboard_and_without_scripts(tmp_path: Path, tab: Tab, serve: Serve) -> None:
    written(tmp_path, '# T\n\n=== "C++"\n\n    first\n\n=== "Python"\n\n    second\n')
    build(tmp_path, output=tmp_path / "dist", report=Report())
    tab.route("**/*.js", lambda route: route.fulfill(body="", content_type="text/javascript"))
    tab.goto(serve(tmp_path / "dist"))
    assert tab.is_visible("text=first")
    tab.get_by_role("radio", name="C++").focus()
    tab.keyboard.press("ArrowRight")
    assert tab.is_visible("text=second")
    assert tab.is_hidden("text=first")
    tab.get_by_text("C++").click()
    assert tab.is_visible("text=first")


def test_commands_have_buttons_that_a_terminal_shows(tmp_path: Path) -> None:
    text = (
        "```ros2\n# Who talks?\n$ ros2 topic list -t\n\nros2 topic pub \\\n  /a b/msg/C '<d>'\n```"
    )
    found = html(tmp_path, text)
    assert '<code class="language-ros2">' in found
    buttons = re.findall(
        r'<button type="button" class="run" data-ros-run="(.*?)" hidden>', found, re.DOTALL
    )
    assert buttons == [
        "ros2 topic list -t",
        "ros2 topic pub \\\n  /a b/msg/C &#39;&lt;d&gt;&#39;",
    ]
    assert found.count('<span class="command">') == 2
    assert "$ ros2 topic list" in re.sub(r"<[^>]*>", "", found)


def test_commands_of_a_console_have_buttons_and_what_they_print_has_none(tmp_path: Path) -> None:
    text = (
        "```console\n$ ros2 topic list\n/chatter\n$ sudo apt install x\n$ ros2 node \\\n  list\n```"
    )
    found = html(tmp_path, text)
    runs = re.findall(r'data-ros-run="([^"]*)"', found)
    assert runs == ["ros2 topic list", "ros2 node \\\n  list"]
    plain = re.sub(r"<[^>]*>", "", found)
    assert "$ ros2 topic list\n/chatter\n$ sudo apt install x" in plain
    # Without commands of ros2, it is code as before.
    assert "data-ros-run" not in html(tmp_path, "```console\n$ ls\n```")


PICTURE = """<picture>
<source media="(prefers-color-scheme: dark)" srcset="{dark}">
<img alt="Logo" src="light.svg" srcset="light.svg 1x,
  {dark} 2x">
</picture>
"""
LIGHT = '<svg xmlns="http://www.w3.org/2000/svg" width="9" height="9"/>'
DARK = LIGHT.replace("9", "8")


def test_pictures_of_srcset_are_copied_and_named(tmp_path: Path) -> None:
    files = {"light__svg": LIGHT, "dark, two__svg": DARK}
    folder = written(tmp_path, "# T\n\n" + PICTURE.format(dark="dark,%20two.svg"), **files)
    (folder / "site.yaml").write_text("site: {title: T}\npages: [{path: a/, file: page.md}]\n")
    found = {one.path: one.source for one in render(load(folder / "site.yaml"))}
    light, dark = sorted(path for path in found if path.startswith("media/"))[::-1]
    assert (found[light], found[dark]) == (folder / "light.svg", folder / "dark, two.svg")
    page = found["a/index.html"]
    assert isinstance(page, bytes)
    text = page.decode()
    assert f'media="(prefers-color-scheme: dark)" srcset="../{dark}"' in text
    assert f'src="../{light}" srcset="../{light}, ../{dark} 2x"'.replace(",", " 1x,", 1) in text


@pytest.mark.parametrize(
    ("written_as", "expected"),
    [
        ("a.png", "[a.png]"),
        ("a.png 1x, b.png 2x", "[a.png] 1x, [b.png] 2x"),
        (" a,b.png 1.5x,c.png 100w ", "[a,b.png] 1.5x, [c.png] 100w"),
        ("a.png, b.png", "[a.png], [b.png]"),
        (", a.png ,\n b.png 2x,", "[a.png], [b.png] 2x"),
        ("data:image/png;base64,AA== 1x", "[data:image/png;base64,AA==] 1x"),
        ("", ""),
    ],
)
def test_a_srcset_is_read_as_browsers_read_it(written_as: str, expected: str) -> None:
    assert resourced(written_as, lambda url: f"[{url}]") == expected


@pytest.mark.parametrize(
    ("url", "fault"),
    [
        ("drak.svg", "no file 'drak.svg' in .; did you mean 'dark.svg'?"),
        ("https://example.org/a.svg", "is on another site; copy the file into this site"),
        ("../a.svg", "is outside the site's folder; move it below the folder of site.yaml"),
    ],
)
def test_a_picture_of_srcset_that_is_missing_is_told(tmp_path: Path, url: str, fault: str) -> None:
    (tmp_path / "dark.svg").write_text(DARK)
    found = problems(tmp_path, f'<img alt="" srcset="dark.svg 1x, {url} 2x">')
    assert len(found) == 1
    assert found[0].startswith("page.md:3: image: ")
    assert found[0].endswith(fault)
