"""Text that is not YAML: what is wrong, in which line, and that the advice mends it."""

from __future__ import annotations

from pathlib import Path

import pytest
import yaml

from sitegen.config import load
from sitegen.errors import SiteError

# What an author wrote; the line of the mistake and what is said; what the advice makes of it.
CASES = {
    "tab": (
        "site:\n\ttitle: A\n",
        "2: a tab before 'title: A'; indent with spaces",
        "site:\n  title: A\n",
    ),
    "tab after a key": (
        "title: A\ndescription:\tB: c\n",
        "2: a tab in 'description: B: c'; use spaces",
        "title: A\ndescription: 'B: c'\n",
    ),
    "colon": (
        "title: Robot: the second\n",
        "1: ': ' in the text of 'title: Robot: the second'; "
        'put it in quotes: title: "Robot: the second"',
        'title: "Robot: the second"\n',
    ),
    "colon in an item": (
        "pages:\n  - title: Part 1: wheels # first\n",
        "2: ': ' in the text of '- title: Part 1: wheels # first'; "
        'put it in quotes: title: "Part 1: wheels"',
        'pages:\n  - title: "Part 1: wheels"\n',
    ),
    "no space after the colon": (
        "site:\n  title:A\n  theme: plain\n",
        "2: no space after ':' in 'title:A'; write 'title: A'",
        "site:\n  title: A\n  theme: plain\n",
    ),
    "no colon": (
        "site:\n  title\n  theme: plain\n",
        "2: no ':' after 'title'; write it like 'title: …'",
        "site:\n  title: …\n  theme: plain\n",
    ),
    "no colon at the end": (
        "title: A\ntheme\n",
        "2: no ':' after 'theme'; write it like 'theme: …'",
        "title: A\ntheme: …\n",
    ),
    "two commas": (
        "site: {title: A,, language: de}\n",
        "1: nothing stands before ',' in 'site: {title: A,, language: de}'; "
        "remove the comma, or write a value",
        "site: {title: A, language: de}\n",
    ),
    "a dash in brackets": (
        "nav: [demo01/,- demo02/]\n",
        "1: '-' between '[' and ']' in 'nav: [demo01/,- demo02/]'; write only the comma",
        "nav: [demo01/, demo02/]\n",
    ),
    "another bracket than is open, before a value": (
        "site: {title: ]\n",
        "1: '{' is closed with ']' in 'site: {title: ]'; write '}'",
        "site: {title: }\n",
    ),
    "the file ends in braces": (
        "pages:\n  - path: /\n    content: [{a: [1], launch:\n",
        "3: '{' is not closed in 'content: [{a: [1], launch:'; close it with '}'",
        "pages:\n  - path: /\n    content: [{a: [1], launch: }]\n",
    ),
    "key too far in": (
        "site:\n  title: A\n    theme: plain\n",
        "3: 'theme: plain' is indented further than 'title: A' above; indent it with 2 spaces",
        "site:\n  title: A\n  theme: plain\n",
    ),
    "key too far in below a comment": (
        "site:\n  title: A\n    # of this robot\n    theme: plain\n",
        "4: 'theme: plain' is not in line with 'title: A' on line 2; indent it with 2 spaces",
        "site:\n  title: A\n  theme: plain\n",
    ),
    "key not far enough in": (
        "site:\n    title: A\n  theme: plain\n",
        "3: 'theme: plain' is not in line with 'title: A' on line 2; indent it with 4 spaces",
        "site:\n    title: A\n    theme: plain\n",
    ),
    "key of an item not far enough in": (
        "pages:\n  - path: /\n  title: A\n",
        "3: 'title: A' is in line with a '-' above; indent it with 2 spaces more",
        "pages:\n  - path: /\n    title: A\n",
    ),
    "item not far enough in": (
        "pages:\n  - path: /\n    title: A\n - path: b/\n",
        "4: '- path: b/' is not in line with '- path: /' on line 2; indent it with 2 spaces",
        "pages:\n  - path: /\n    title: A\n  - path: b/\n",
    ),
    "item too far in": (
        "pages:\n  - path: /\n    title: A\n      - path: b/\n",
        "4: '- path: b/' is indented further than 'title: A' above; indent it with 2 spaces",
        "pages:\n  - path: /\n    title: A\n  - path: b/\n",
    ),
    "item among keys": (
        "site:\n  title: A\n  - theme: plain\n",
        "3: '- theme: plain' is a list item among keys; remove the '-', or give it a key",
        "site:\n  title: A\n  theme: plain\n",
    ),
    "item after a key": (
        "tags: - a\n",
        "1: a list item after a key in 'tags: - a'; begin the list on the next line, "
        'or put it in quotes: tags: "- a"',
        "tags:\n  - a\n",
    ),
    "double quote": (
        'title: "A\ntheme: plain\n',
        "1: a quote is not closed in 'title: \"A'; end the text with \"",
        'title: "A"\ntheme: plain\n',
    ),
    "double quote, closed by the next": (
        'title: "A\ndescription: "B"\n',
        "1: a quote is not closed in 'title: \"A'; end the text with \"",
        'title: "A"\ndescription: "B"\n',
    ),
    "single quote": (
        "site:\n  title: 'A\n  theme: plain\n",
        "2: a quote is not closed in 'title: 'A'; end the text with '",
        "site:\n  title: 'A'\n  theme: plain\n",
    ),
    "apostrophe": (
        "title: 'Robot's page'\n",
        "1: the text goes on after its second ' in 'title: 'Robot's page''; use double quotes",
        'title: "Robot\'s page"\n',
    ),
    "text after a quote": (
        'title: "A" and B\n',
        '1: the text goes on after its second " in \'title: "A" and B\'; '
        "put the whole text in quotes",
        "title: '\"A\" and B'\n",
    ),
    "backslash": (
        'title: "C:\\docs"\n',
        "1: '\\d' means nothing in double quotes in 'title: \"C:\\docs\"'; "
        "write '\\\\d', or use single quotes",
        'title: "C:\\\\docs"\n',
    ),
    "brace": (
        "site: {title: A\npages: []\n",
        "1: '{' is not closed in 'site: {title: A'; close it with '}'",
        "site: {title: A}\npages: []\n",
    ),
    "brace before one that is closed": (
        "nodes:\n  talker: {package: a, executable: b\n  listener: {package: a, executable: c}\n",
        "2: '{' is not closed in 'talker: {package: a, executable: b'; close it with '}'",
        "nodes:\n  talker: {package: a, executable: b}\n  listener: {package: a, executable: c}\n",
    ),
    "bracket": (
        "site:\n  languages: [de, en\n  theme: plain\n",
        "2: '[' is not closed in 'languages: [de, en'; close it with ']'",
        "site:\n  languages: [de, en]\n  theme: plain\n",
    ),
    "bracket at the end": (
        "tags: [a, b\n",
        "1: '[' is not closed in 'tags: [a, b'; close it with ']'",
        "tags: [a, b]\n",
    ),
    "bracket closed twice": (
        "tags: [a, b]]\n",
        "1: ']' closes nothing in 'tags: [a, b]]'; remove it",
        "tags: [a, b]\n",
    ),
    "bracket closed by a brace": (
        "tags: [a, b}\n",
        "1: '[' is closed with '}' in 'tags: [a, b}'; write ']'",
        "tags: [a, b]\n",
    ),
    "comma": (
        "talker: {package: a executable: b}\n",
        "1: no comma before 'executable:' in 'talker: {package: a executable: b}'; add it, "
        "or put text that contains ': ' in quotes",
        "talker: {package: a, executable: b}\n",
    ),
    "text in brackets": (
        "title: [WIP] Robot\n",
        "1: '[' begins the text of 'title: [WIP] Robot'; put it in quotes: title: \"[WIP] Robot\"",
        'title: "[WIP] Robot"\n',
    ),
    "at sign": (
        "title: @home\n",
        "1: '@' begins the text of 'title: @home'; put it in quotes: title: \"@home\"",
        'title: "@home"\n',
    ),
    "bold text": (
        "title: **Robot** A\n",
        "1: '*' begins the text of 'title: **Robot** A'; put it in quotes: title: \"**Robot** A\"",
        'title: "**Robot** A"\n',
    ),
    "stars for a list": (
        "tags:\n  * a\n",
        "2: '*' at the beginning of '* a'; begin list items with '-'",
        "tags:\n  - a\n",
    ),
    "greater than": (
        "title: >A\n",
        "1: text after '>' in 'title: >A'; begin it on the next line, "
        'or put it in quotes: title: ">A"',
        'title: ">A"\n',
    ),
    "block that ends early": (
        "footer: |\n    First line\n  second line\n",
        "3: 'second line' is indented less than the text above; "
        "indent it like that text, or like a key",
        "footer: |\n    First line\n    second line\n",
    ),
    "percent sign": (
        "title: A\n%b\n",
        "2: '%' begins the line '%b'; put it in quotes",
        "title: A\n'%b': c\n",
    ),
}


def said(file: Path) -> list[str]:
    with pytest.raises(SiteError) as caught:
        load(file)
    return caught.value.lines


@pytest.mark.parametrize("case", CASES)
def test_a_mistake_in_site_yaml_is_said_with_its_mend(tmp_path: Path, case: str) -> None:
    text, message, mended = CASES[case]
    line, _, what = message.partition(": ")
    file = tmp_path / "site.yaml"
    file.write_text(text)
    assert said(file) == [f"site.yaml:{line}: yaml: {what}"]
    yaml.safe_load(mended)


@pytest.mark.parametrize("case", CASES)
def test_a_mistake_in_front_matter_is_said_with_its_mend(tmp_path: Path, case: str) -> None:
    text, message, _ = CASES[case]
    line, _, what = message.partition(": ")
    (tmp_path / "page.md").write_text(f"---\n{text}---\n# A page\n")
    file = tmp_path / "site.yaml"
    file.write_text("site: {title: Robot}\npages: [{path: /, file: page.md}]\n")
    assert said(file) == [f"page.md:{int(line) + 1}: yaml: {what}"]
