"""Files that packages install to share/, opened by programs that do not use ament_index_cpp."""

from __future__ import annotations

import json
import shutil
from pathlib import Path

import pytest
from browser import WITHOUT_JSPI, Built, Serve, serving
from panel import Panel
from paths import SITES
from playwright.sync_api import Browser, Page, Route
from programs import options_of
from waiting import until

from sitegen.__main__ import main
from sitegen.build import make, write
from sitegen.commands.single import build_single
from sitegen.nodes.cpp.program import CppProgram
from sitegen.nodes.prebuilt.archive import pack
from sitegen.report import Report
from sitegen.site.offline import worker

SITE = SITES / "files"
LIST = "nodes/share-*.json"
# The page is cached when all of its files are.
KEPT = """async () => {
  const found = [];
  for (const name of await caches.keys()) {
    found.push(...(await (await caches.open(name)).keys()).map(({ url }) => url));
  }
  const wanted = [".jspi.wasm", ".jspi.js", "limits.yaml.bin", "panel.js.bin"];
  return wanted.every((end) => found.some((url) => url.endsWith(end)));
}"""
HALL = "hall & stairs #1.txt"
READ = [
    "empty.txt 0",
    "hall & stairs #1.txt 20",
    "panel.js 23",
    "a hall with 3 doors",
    "a hall with 3 doors",
    "empty: ''",
    "speed: 0.5",
    "cannot open: No such file or directory",
    'import "./nothing.js";',
    '<package format="3">',
    "replaced",
    "speed: 0.5",
    "speed: 2.0",
    "west",
    "done",
]


def read(tab: Page) -> list[str]:
    """Return what the program prints."""
    panel = Panel(tab, "reader")
    panel.start()
    panel.wait_for("done")
    panel.expect_state("stopped")
    return panel.lines()


def test_programs_read_them(built: Built, serve: Serve, tab: Page) -> None:
    """Own ones, and those of a package that only a parameter names."""
    loaded: list[str] = []
    tab.on("request", lambda request: loaded.append(request.url.rpartition("/")[2]))
    tab.goto(serve(built(SITE)))
    assert read(tab) == READ
    # What two threads open is loaded once, and what nobody opens, never.
    assert len([name for name in loaded if name.startswith("hall")]) == 1
    assert not [name for name in loaded if name.startswith("empty")]


def test_programs_without_jspi_read_them(built: Built, serve: Serve, browser: Browser) -> None:
    tab = browser.new_page()
    tab.add_init_script(WITHOUT_JSPI)
    tab.goto(serve(built(SITE)))
    assert read(tab) == READ
    tab.close()


def test_they_are_in_a_page_that_is_a_single_file(browser: Browser, tmp_path: Path) -> None:
    file = tmp_path / "files.html"
    options = options_of(SITE, everything=False)
    build_single(SITE, "/", output=file, report=Report(), options=options)
    tab = browser.new_page()
    tab.goto(file.as_uri())
    assert read(tab) == READ
    tab.close()


def test_they_come_with_programs_that_were_compiled_elsewhere(
    browser: Browser, serve: Serve, tmp_path: Path
) -> None:
    """That of another package comes, too: the program was given it where it was compiled."""
    made = make(SITE, Report(), options=options_of(SITE, everything=False))
    program = made.programs["reader", "reader"]
    assert isinstance(program, CppProgram)
    assert program.share
    pack({("reader", "reader"): program.builds}, program.share.files, tmp_path / "reader.zip")
    text = (SITE / "site.yaml").read_text()
    text = text.replace("package: reader\n    executable: reader", "compiled: reader.zip")
    (tmp_path / "site.yaml").write_text(text)
    assert main(["build", str(tmp_path), "--output", str(tmp_path / "dist")]) == 0
    tab = browser.new_page()
    tab.goto(serve(tmp_path / "dist"))
    assert read(tab) == READ
    tab.close()


def test_a_large_site_that_works_without_a_network_keeps_them_with_the_page(
    browser: Browser, tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    monkeypatch.setattr(worker, "WHOLE", 100_000)
    shutil.copytree(SITE, tmp_path / "site")
    text = (SITE / "site.yaml").read_text()
    text = text.replace("title: Files of packages", "title: Files, offline: true")
    (tmp_path / "site" / "site.yaml").write_text(text)
    made = make(tmp_path / "site", Report(), options=options_of(SITE, everything=False))
    write(made.artifacts, tmp_path / "dist")
    tab = browser.new_page()
    with serving(tmp_path / "dist", "/files/") as url:
        tab.goto(url)
        until(lambda: tab.evaluate(KEPT))
    tab.reload()
    assert read(tab) == READ
    tab.close()


def test_what_cannot_be_loaded_is_said(built: Built, serve: Serve, browser: Browser) -> None:
    """Opening fails, as on a disk that is broken; the next attempt may succeed."""
    tab = browser.new_page()
    missing = ["404"]

    def answer(route: Route) -> None:
        if missing:
            route.fulfill(status=int(missing.pop()), body="")
        else:
            route.continue_()

    tab.route("**/limits.yaml*", answer)
    tab.goto(serve(built(SITE)))
    lines = read(tab)
    assert "/ros/share/reader/config/limits.yaml: the server answered 404" in lines
    assert "cannot open: I/O error" in lines
    assert lines[-4:] == READ[-4:]
    tab.close()


@pytest.mark.parametrize(
    ("what", "said"),
    [
        (LIST, "the list of the files of packages could not be loaded: the server answered 503"),
        ("packageFiles.js", "packageFiles.js"),
    ],
)
def test_a_program_does_not_start_without_the_list(
    what: str, said: str, built: Built, serve: Serve, browser: Browser
) -> None:
    tab = browser.new_page()
    tab.route(f"**/{what}", lambda route: route.fulfill(status=503, body=""))
    tab.goto(serve(built(SITE)))
    panel = Panel(tab, "reader")
    panel.start()
    panel.expect_state("failed")
    panel.wait_for(said)
    tab.close()


def test_sites_have_what_their_programs_open(built: Built) -> None:
    dist = built(SITE)
    [listing] = dist.glob(LIST)
    listed = json.loads(listing.read_text())
    index = "share/ament_index/resource_index/packages"
    assert list(listed) == [
        *(f"{index}/reader", f"{index}/rooms"),
        *("share/reader/config/limits.yaml", "share/reader/package.xml"),
        *(f"share/rooms/floors/{name}" for name in ("empty.txt", HALL, "panel.js")),
        "share/rooms/package.xml",
    ]
    for path, (size, _) in listed.items():
        assert (dist / "nodes" / f"{path}.bin").stat().st_size == size
    # Programs that open no files come without.
    others = json.loads((built(SITES / "shapes") / "page.json").read_text())["nodes"]
    assert "share" not in others["plain"]
    assert "share" in others["edges"]
