"""The same input makes the same bytes: in another folder, another process, in any order."""

from __future__ import annotations

import io
import os
import shutil
import subprocess
import sys
from pathlib import Path

import pytest
from paths import SITES

from sitegen.commands.build import build
from sitegen.config import load
from sitegen.model import Artifact
from sitegen.report import Report
from sitegen.site.pages import Renderer, render

EVERYTHING = SITES / "prose"


def content(folder: Path) -> dict[str, bytes]:
    files = (file for file in folder.rglob("*") if file.is_file())
    return {file.relative_to(folder).as_posix(): file.read_bytes() for file in files}


def test_a_build_elsewhere_has_the_same_bytes(tmp_path: Path) -> None:
    # Outside of git, so that both know the same of the last change: nothing.
    built = []
    for name, seed in (("a", "1"), ("another/folder", "2")):
        site = tmp_path / name / "site"
        shutil.copytree(EVERYTHING, site, ignore=shutil.ignore_patterns("dist"))
        environment = {**os.environ, "PYTHONHASHSEED": seed, "TZ": f"UTC{seed}"}
        command = [sys.executable, "-m", "sitegen", "build", str(site)]
        subprocess.run(command, check=True, env=environment, capture_output=True)
        built.append(content(site / "dist"))
    first, second = built
    assert first.keys() == second.keys()
    assert [path for path in first if first[path] != second[path]] == []


@pytest.fixture
def many(tmp_path: Path) -> Path:
    """A site of so many pages that several processes share them."""
    for number in range(200):
        text = f"# Page {number}\n\n## One\n\n[next](page{(number + 1) % 200}.md#one) and `code`.\n"
        (tmp_path / f"page{number}.md").write_text(text + "\n```cpp\nint x = 1;\n```\n" * 3)
    (tmp_path / "image.svg").write_text('<svg xmlns="http://www.w3.org/2000/svg"/>')
    (tmp_path / "page7.md").write_text(
        "# Seven\n\n## One\n\n![i](image.svg)\n\ntext[^1]\n\n[^1]: n\n"
    )
    (tmp_path / "site.yaml").write_text("site: {title: T}\npages: [{path: /, folder: .}]\n")
    return tmp_path / "site.yaml"


def data(artifacts: list[Artifact]) -> dict[str, bytes | Path]:
    return {artifact.path: artifact.source for artifact in artifacts}


def test_several_processes_make_what_one_makes(many: Path) -> None:
    renderer = Renderer(load(many), {})
    shared = renderer.every_page()
    alone = [renderer.page(page) for page in reversed(renderer.site.pages)][::-1]
    assert shared == alone
    assert data(renderer.site_artifacts(shared)) == data(renderer.site_artifacts(alone))


def test_problems_of_all_processes_are_told(many: Path) -> None:
    for number in (3, 150):
        many.with_name(f"page{number}.md").write_text("# P\n\n## One\n\n[a](#gone)\n")
    with pytest.raises(Exception, match=r"page150\.md:5: link: no heading '#gone'") as wrong:
        build(many.parent, output=many.parent / "dist", report=Report(io.StringIO()))
    assert "page3.md:5: link: no heading '#gone'" in str(wrong.value)


def test_one_edit_costs_one_page(many: Path) -> None:
    site = load(many)
    renderer = Renderer(site, {})
    rendered = renderer.every_page()
    before = data([*renderer.site_artifacts(rendered), *renderer.index(rendered)])
    many.with_name("page42.md").write_text("# Page 42\n\n## One\n\nEdited.\n")
    place, page = next((i, p) for i, p in enumerate(load(many).pages) if p.path == "page42/")
    rendered[place] = renderer.page(page)
    after = data([*renderer.site_artifacts(rendered), *renderer.index(rendered)])
    changed = {path for path in after if after[path] != before.get(path)}
    assert changed == {"page42/index.html", "search.en.json"}
    assert after == data(render(load(many)))
