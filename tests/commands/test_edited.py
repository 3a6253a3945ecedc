"""What is served after an edit is what a build from nothing would make, however it came about."""

from __future__ import annotations

import io
from pathlib import Path

import pytest

from sitegen.build import make
from sitegen.commands.serve.edited import edited
from sitegen.commands.serve.live import LiveSite
from sitegen.options import Options
from sitegen.report import Report

SITE = """\
site: {title: T, languages: [de]}
pages:
  - {path: /, file: index.md}
  - {path: guide/, folder: guide}
  - {path: both/, content: [{markdown: shared.md}, {topics: }]}
  - {path: again/, title: Again, content: [{markdown: shared.md}]}
"""
FILES = {
    "index.md": "# Home\n\nHello [one](guide/one.md).\n",
    "index.de.md": "# Start\n\nHallo.\n",
    "guide/one.md": "---\ntags: [a]\n---\n# One\n\nText.\n\n## Part\n\nMore.\n",
    "guide/panels.md": "# Panels\n\nText.\n\n```ros\ntopics: {echo: /chatter}\n```\n\nMore.\n",
    "shared.md": "# Shared\n\nText.\n",
}
# Each with whether the page alone is made again.
EDITS = {
    "text": ("index.md", FILES["index.md"] + "\nA new word.\n", True),
    "a translation": ("index.de.md", "# Start\n\nGuten Tag.\n", True),
    "a link": ("index.md", "# Home\n\nSee [panels](guide/panels.md).\n", True),
    "text around a widget": ("guide/panels.md", "\n" + FILES["guide/panels.md"] + "\nEnd.\n", True),
    "text below keys": ("guide/one.md", FILES["guide/one.md"] + "\nEnd.\n", True),
    "a heading that links need": ("guide/one.md", "---\ntags: [a]\n---\n# One\n\n## New\n", True),
    "a title": ("index.md", "# House\n\nHello.\n", False),
    "a key": ("guide/one.md", FILES["guide/one.md"].replace("[a]", "[b]"), False),
    "keys that go": ("guide/one.md", "# One\n\nText.\n", False),
    "a widget": ("guide/panels.md", FILES["guide/panels.md"].replace("/chatter", "/pose"), False),
    "a widget more": ("index.md", FILES["index.md"] + "\n```ros\nlog:\n```\n", False),
    "text of two pages": ("shared.md", "# Shared\n\nOther text.\n", False),
    "site.yaml": ("site.yaml", SITE.replace("title: T", "title: U"), False),
}


@pytest.fixture
def site(tmp_path: Path) -> Path:
    for name, text in {**FILES, "site.yaml": SITE}.items():
        file = tmp_path / name
        file.parent.mkdir(exist_ok=True)
        file.write_text(text)
    return tmp_path


def served(live: LiveSite) -> dict[str, object]:
    """Return all that a server has, the index of the search too."""
    paths = [*live._files, "search.en.json", "search.de.json"]
    return {path: found.source for path in paths if (found := live.file(path))}


@pytest.mark.parametrize("edit", EDITS)
def test_an_edit_makes_what_a_build_makes(site: Path, edit: str) -> None:
    name, text, alone = EDITS[edit]
    live, file = LiveSite(site, Report()), site / name
    live.rebuild()
    before = served(live)
    assert {"search.en.json", "search.de.json"} <= before.keys()
    made = make(site, Report(), options=Options(live=True))
    file.write_text(text)
    assert bool(edited(made, [file])) == alone
    live.rebuild([file])
    fresh = LiveSite(site, Report())
    fresh.rebuild()
    assert served(live) == served(fresh) != before


@pytest.mark.parametrize(
    ("name", "text", "problem"),
    [
        ("index.md", "# Home\n\n[x](nowhere.md)\n", "index.md:3: link"),
        ("guide/one.md", "---\ntags: [a]\n", "one.md:1: yaml: this front matter is not closed"),
        ("index.md", FILES["index.md"] + "\n```ros\ntopic:\n```\n", "did you mean 'topics'?"),
    ],
)
def test_what_is_wrong_after_an_edit_is_told(
    site: Path, name: str, text: str, problem: str
) -> None:
    said = io.StringIO()
    live = LiveSite(site, Report(said))
    live.rebuild()
    before = served(live)
    (site / name).write_text(text)
    live.rebuild([site / name])
    assert problem in said.getvalue()
    assert served(live) == before
    # Mended, it is as if nothing had been.
    (site / name).write_text(FILES[name])
    live.rebuild([site / name])
    assert served(live) == before
