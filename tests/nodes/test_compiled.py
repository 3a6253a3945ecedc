"""A site whose nodes were compiled elsewhere: one side compiles, the other has no compiler."""

from __future__ import annotations

import hashlib
import json
import re
import shutil
from pathlib import Path

import pytest
from browser import Serve
from paths import ROOT
from playwright.sync_api import Page, expect

from sitegen.__main__ import main
from sitegen.nodes.cpp.toolchain import Toolchain

SITE = """\
site: {title: Far}
nodes:
  talker: {compiled: nodes.zip, executable: talker}
  listener: {compiled: URL, sha256: HASH, package: cpp_pubsub, executable: listener, remap: {a: b}}
pages:
  - path: /
    title: Far
    content:
      - console: talker
      - console: listener
      - topics: {echo: /chatter}
"""


@pytest.fixture(scope="module")
def archive(tmp_path_factory: pytest.TempPathFactory) -> Path:
    """What `sitegen compile` makes of the nodes of a demo."""
    file = tmp_path_factory.mktemp("archive") / "nodes.zip"
    workspace = str(ROOT / "demos" / "demo03")
    assert main(["compile", "cpp_pubsub", "-o", str(file), "--workspace", workspace]) == 0
    return file


@pytest.fixture
def without_compiler(monkeypatch: pytest.MonkeyPatch, tmp_path: Path) -> None:
    def find() -> None:
        raise AssertionError("asked for a compiler")

    monkeypatch.setattr(Toolchain, "find", find)
    monkeypatch.setenv("SITEGEN_CACHE", str(tmp_path / "cache"))


def write(folder: Path, archive: Path, site: str = SITE, url: str = "https://example.org/") -> Path:
    folder.mkdir(exist_ok=True)
    digest = hashlib.sha256(archive.read_bytes()).hexdigest()
    (folder / "site.yaml").write_text(site.replace("URL", f"{url}").replace("HASH", digest))
    shutil.copyfile(archive, folder / "nodes.zip")
    return folder


@pytest.mark.usefixtures("without_compiler")
def test_nodes_from_a_file_and_from_a_server(
    archive: Path, tmp_path: Path, serve: Serve, tab: Page
) -> None:
    """Nodes of both hear each other, and what was fetched once is not asked for again."""
    served = tmp_path / "served"
    served.mkdir()
    shutil.copyfile(archive, served / "x.zip")
    folder = write(tmp_path / "site", archive, url=f"{serve(served)}x.zip")
    assert main(["build", str(folder)]) == 0
    assert main(["check", "--strict", str(folder)]) == 0
    (served / "x.zip").unlink()
    assert main(["build", str(folder)]) == 0
    names = {
        f.relative_to(folder / "dist").as_posix() for f in folder.rglob("dist/nodes/**/*.wasm")
    }
    assert names == {
        f"nodes/cpp_pubsub/{name}.{engine}.wasm"
        for name in ("talker", "listener")
        for engine in ("jspi", "asyncify")
    }
    nodes = json.loads((folder / "dist/page.json").read_text())["nodes"].values()
    assert [node["foreign"] for node in nodes] == [True, True]
    tab.goto(serve(folder / "dist"))
    expect(tab.locator("body")).to_contain_text("I heard: 'Hello, world!")
    # The types came along, too.
    expect(tab.locator("body")).to_contain_text("std_msgs/msg/String")
    expect(tab.locator("body")).to_contain_text(re.compile("data: '?Hello"))


def test_what_compile_says_can_be_pasted(
    archive: Path, tmp_path: Path, capsys: pytest.CaptureFixture[str]
) -> None:
    file, workspace = tmp_path / "nodes.zip", str(ROOT / "demos" / "demo03")
    words = ["compile", "cpp_pubsub/talker", "cpp_pubsub", "-o", str(file)]
    assert main([*words, "--workspace", workspace]) == 0
    assert file.read_bytes() == archive.read_bytes()
    said = capsys.readouterr().out
    said = said[said.index("nodes:\n") :]
    pages = "pages: [{path: /, title: A, content: [{console: talker}, {console: listener}]}]\n"
    (tmp_path / "site.yaml").write_text(f"site: {{title: A}}\n{pages}{said}")
    assert main(["build", str(tmp_path)]) == 0


@pytest.mark.parametrize(
    ("names", "lines"),
    [
        (["cpp_pubsb"], ["no package 'cpp_pubsb' in the workspace; did you mean 'cpp_pubsub'?"]),
        (
            ["cpp_pubsub/talkr", "x"],
            [
                "package 'cpp_pubsub' has no executable 'talkr'; did you mean 'talker'?",
                "no package 'x' in the workspace; known: cpp_pubsub",
            ],
        ),
    ],
)
def test_names_that_cannot_be_compiled(
    names: list[str], lines: list[str], tmp_path: Path, capsys: pytest.CaptureFixture[str]
) -> None:
    workspace = str(ROOT / "demos" / "demo03")
    file = tmp_path / "nodes.zip"
    assert main(["compile", *names, "-o", str(file), "--workspace", workspace]) == 1
    assert capsys.readouterr().err.splitlines()[:-1] == lines
    assert not file.exists()


def test_python_is_not_compiled(tmp_path: Path, capsys: pytest.CaptureFixture[str]) -> None:
    words = ["compile", "py_pubsub", "py_pubsub/talker", "-o", str(tmp_path / "nodes.zip")]
    assert main([*words, "--workspace", str(ROOT / "demos" / "demo06")]) == 1
    why = "is written in Python, which is not compiled; add the package to the site's workspace"
    lines = capsys.readouterr().err.splitlines()[:-1]
    assert lines == [f"package 'py_pubsub' {why}", f"'py_pubsub/talker' {why}"]


@pytest.mark.usefixtures("without_compiler")
@pytest.mark.parametrize(
    ("node", "line"),
    [
        (
            "compiled: http://example.org/x.zip",
            "site.yaml:2: nodes.x.compiled: 'http://example.org/x.zip' is not a secure address; "
            "use one that begins with https://",
        ),
        (
            "compiled: https://example.org/x.zip",
            "site.yaml:2: nodes.x.sha256: missing; a download needs the hash that is"
            " printed by `sitegen compile` or `sha256sum`",
        ),
        (
            "compiled: node.zip",
            "site.yaml:2: nodes.x.compiled: no file 'node.zip'; did you mean 'nodes.zip'?",
        ),
        (
            "compiled: ../nodes.zip",
            "site.yaml:2: nodes.x.compiled: '../nodes.zip' is outside the site's folder; keep"
            " all files below the folder of site.yaml",
        ),
        (
            "compiled: nodes.zip, sha256: 'no'",
            "site.yaml:2: nodes.x.sha256: expected 64 hexadecimal digits, found the text 'no';"
            " write it like 'sha256: "
            "72a66436beb4c95047286bc22bc7295cd1168bc8b3309ef35897a6802a22a2fb'",
        ),
        (
            "compiled: nodes.zip",
            "site.yaml:2: nodes.x.compiled: the archive has more than one node; set 'package'"
            " and 'executable' to one of: cpp_pubsub/listener, cpp_pubsub/talker",
        ),
        (
            "compiled: nodes.zip, executable: talkr",
            "site.yaml:2: nodes.x.compiled: the archive has no such node; set 'package' and"
            " 'executable' to one of: cpp_pubsub/listener, cpp_pubsub/talker",
        ),
        (
            "compiled: bad.zip",
            "site.yaml:2: nodes.x.compiled: bad.zip cannot be used: it is not a valid zip archive",
        ),
        (
            "compiled: nodes.zip, executable: talker, sha256: " + "0" * 64,
            "site.yaml:2: nodes.x.sha256: expected 64 hexadecimal digits, found the number "
            + "0" * 64
            + '; put it in quotes: "'
            + "0" * 39
            + '…"',
        ),
        (
            f'compiled: nodes.zip, executable: talker, sha256: "{"0" * 64}"',
            "site.yaml:2: nodes.x.compiled: 'nodes.zip' does not have the expected hash; "
            "if you trust it, write 'sha256: HASH'",
        ),
        (
            "compiled: nodes.zip, executable: talker, executble: x",
            "site.yaml:2: nodes.x.executble: unknown key; did you mean 'executable'?",
        ),
    ],
)
def test_what_is_wrong_is_one_line(
    node: str, line: str, archive: Path, tmp_path: Path, capsys: pytest.CaptureFixture[str]
) -> None:
    page = "pages: [{path: /, title: A, content: [{console: x}]}]\n"
    site = f"site: {{title: A}}\nnodes: {{x: {{{node}}}}}\n{page}"
    folder = write(tmp_path / "site", archive, site)
    (folder / "bad.zip").write_bytes(b"no archive")
    assert main(["build", str(folder)]) == 1
    line = line.replace("HASH", hashlib.sha256(archive.read_bytes()).hexdigest())
    assert capsys.readouterr().err == f"{line}\n1 problem, nothing was built\n"
    assert not (folder / "dist").exists()


def test_two_programs_of_one_name(
    archive: Path, tmp_path: Path, capsys: pytest.CaptureFixture[str]
) -> None:
    site = SITE.replace("{compiled: URL, sha256: HASH, ", "{").replace(
        "executable: listener", "executable: talker"
    )
    folder = write(tmp_path / "site", archive, site)
    shutil.copytree(ROOT / "demos" / "demo03" / "src", folder / "src")
    assert main(["build", str(folder)]) == 1
    assert capsys.readouterr().err.startswith(
        "site.yaml:3: nodes.talker.compiled: another 'cpp_pubsub/talker' is already on the site;"
    )
