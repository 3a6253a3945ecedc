"""The files that pages load of the runtime, and how a checkout keeps them right."""

from __future__ import annotations

import io
import json
import shutil
from pathlib import Path

import pytest
from paths import ROOT

from sitegen.config import load
from sitegen.errors import SiteError
from sitegen.nodes.prebuilt.resolve import Unpacked
from sitegen.nodes.programs import programs_of
from sitegen.options import Options
from sitegen.report import Report
from sitegen.shipped import RUNTIME
from sitegen.site import assets, bundles


@pytest.fixture
def checkout(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> Path:
    """A copy of what the bundles are made from, which a test may change."""
    left_out = shutil.ignore_patterns("pyodide")
    package = tmp_path / "sitegen"
    shutil.copytree(RUNTIME, package / "runtime", ignore=left_out)
    shutil.copy(ROOT / "bundle.mjs", tmp_path)
    (tmp_path / "node_modules").symlink_to(ROOT / "node_modules")
    monkeypatch.setattr(bundles, "BUNDLER", tmp_path / "bundle.mjs")
    monkeypatch.setattr(bundles, "RUNTIME", package / "runtime")
    monkeypatch.setattr(bundles, "BUNDLES", package / "bundles")
    return package


def refreshed() -> str:
    """Refresh the bundles, and return what is said about it."""
    out = io.StringIO()
    bundles.refresh(Report(out))
    return out.getvalue()


def test_an_edited_module_comes_to_the_pages(checkout: Path) -> None:
    assert refreshed() == "runtime: its modules have changed; bundling them again\n"
    assert refreshed() == ""
    module, bundle = checkout / "runtime/widgets/log.js", checkout / "bundles/widgets/log.js"
    before = bundle.read_bytes()
    module.write_text(module.read_text() + "export const added = 'by a test';\n")
    assert refreshed() != ""
    assert b"by a test" in bundle.read_bytes()
    assert b"by a test" not in before
    # Neither do bundles stay whose module is gone.
    module.unlink()
    assert refreshed() != ""
    assert not bundle.exists()
    assert "widgets/log.js" not in bundles.bundles()


def test_what_is_wrong_with_a_module_is_said(checkout: Path) -> None:
    (checkout / "runtime/place.js").write_text("export function place( {\n")
    with pytest.raises(SiteError) as wrong:
        refreshed()
    [line] = wrong.value.lines
    assert line == "node bundle.mjs failed:\nplace.js:2: Expected identifier but found end of file"
    # It is said until it is right again.
    with pytest.raises(SiteError):
        refreshed()


def test_without_node_it_is_said_who_needs_it(
    checkout: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    monkeypatch.setenv("PATH", "")
    with pytest.raises(SiteError) as wrong:
        refreshed()
    assert wrong.value.lines == ["node not found; the browser modules need Node.js 20 (nodejs.org)"]


def test_an_installed_sitegen_has_its_bundles(checkout: Path) -> None:
    (checkout.parent / "bundle.mjs").unlink()
    assert refreshed() == ""


def test_modules_that_a_page_has_twice_keep_nothing() -> None:
    known = bundles.bundles()
    started = {*known["rosMain.js"].modules}
    later = {
        module
        for name in bundles.with_imports(["page/pageClient.js"])
        for module in known[name].modules
    }
    twice = started & later
    assert "ui/elements.js" in twice
    for name in twice:
        lines = (RUNTIME / name).read_text().splitlines()
        kept = [line for line in lines if line.startswith(("let ", "export let "))]
        assert kept == [], f"{name} is in rosMain.js and in shared.js: each would have its own"


def test_a_debug_build_has_the_modules_for_the_tools_of_browsers() -> None:
    site = load(ROOT / "demos/demo01/site.yaml")
    programs = programs_of(
        site, Unpacked(), options=Options(compile=False), cache=ROOT, report=Report(io.StringIO())
    )
    plain = {artifact.path for artifact in assets.runtime(site, programs)}
    debug = {artifact.path: artifact for artifact in assets.runtime(site, programs, debug=True)}
    assert not any(path.endswith(".map") for path in plain)
    assert plain < {*debug}
    start, lines = (debug[f"runtime/rosMain.js{end}"].source for end in ("", ".map"))
    assert isinstance(start, bytes)
    assert isinstance(lines, Path)
    assert start.endswith(b"//# sourceMappingURL=rosMain.js.map\n")
    found = json.loads(lines.read_text())
    [text] = (
        text
        for name, text in zip(found["sources"], found["sourcesContent"], strict=True)
        if name.endswith("page/nodeProcess.js")
    )
    assert text == (RUNTIME / "page/nodeProcess.js").read_text()


def test_only_pages_that_show_images_load_what_decodes_them() -> None:
    decoder = "widgets/image/decode.js"
    known = bundles.bundles()
    assert decoder in known["widgets/image.js"].modules
    assert [name for name, one in known.items() if decoder in one.modules] == [
        decoder,
        "widgets/image.js",
    ]
    # A camera in a 3D view asks for it.
    site = load(ROOT / "demos/demo10/site.yaml")
    programs = programs_of(
        site, Unpacked(), options=Options(compile=False), cache=ROOT, report=Report(io.StringIO())
    )
    paths = {artifact.path for artifact in assets.runtime(site, programs)}
    assert f"runtime/{decoder}" in paths
