"""Archives of compiled nodes: what is packed comes out again, and nothing else does."""

from __future__ import annotations

import contextlib
import json
import random
import stat
import tracemalloc
import warnings
import zipfile
from pathlib import Path
from typing import Any

import pytest

from sitegen.model import Build
from sitegen.nodes.prebuilt import archive
from sitegen.nodes.prebuilt.archive import ArchiveError, members, pack, unpack

MANIFEST: dict[str, Any] = {
    "format": 1,
    "nodes": [{"package": "p", "executable": "talker", "engines": ["jspi", "asyncify"]}],
}
FILES = {
    "manifest.json": json.dumps(MANIFEST),
    "p/talker.types.json": "{}",
    "p/talker.jspi.js": "js",
    "p/talker.jspi.wasm": "wasm",
    "p/talker.asyncify.js": "js",
    "p/talker.asyncify.wasm": "wasm",
}


def zipped(to: Path, files: dict[str, str], *more: tuple[zipfile.ZipInfo | str, str]) -> Path:
    file = to / "nodes.zip"
    with warnings.catch_warnings(), zipfile.ZipFile(file, "w", zipfile.ZIP_DEFLATED) as made:
        warnings.simplefilter("ignore")  # of two files of one name
        for name, text in [*files.items(), *more]:
            made.writestr(name, text)
    return file


def refused(file: Path, to: Path) -> str:
    before = set(to.rglob("*"))
    with pytest.raises(ArchiveError) as caught:
        unpack(file, to / "unpacked")
    assert set(to.rglob("*")) == before
    return str(caught.value)


def test_what_is_packed_comes_out(tmp_path: Path) -> None:
    def build(engine: str) -> Build:
        files = [tmp_path / f"{engine}.{suffix}" for suffix in ("js", "wasm", "json")]
        for file in files:
            file.write_text(f"{{}} {file.name}" if file.suffix != ".json" else "{}")
        return Build(engine, *files)

    builds = {("p", "talker"): [build("jspi"), build("asyncify")]}
    (tmp_path / "hall #1.json").write_text("[")
    share = {"share/rooms/maps/hall #1.json": tmp_path / "hall #1.json"}
    pack(builds, share, tmp_path / "out" / "nodes.zip")
    pack(builds, share, tmp_path / "again.zip")
    file = tmp_path / "out" / "nodes.zip"
    assert [path.name for path in file.parent.iterdir()] == ["nodes.zip"]
    assert file.read_bytes() == (tmp_path / "again.zip").read_bytes()

    unpack(file, tmp_path / "unpacked")
    [node] = members(tmp_path / "unpacked")
    assert (node.package, node.executable) == ("p", "talker")
    assert [form.engine for form in node.builds] == ["jspi", "asyncify"]
    assert [form.wasm.read_text() for form in node.builds] == ["{} jspi.wasm", "{} asyncify.wasm"]
    assert [form.script.read_text() for form in node.builds] == ["{} jspi.js", "{} asyncify.js"]
    written = {path for path in (tmp_path / "unpacked").rglob("*") if path.is_file()}
    assert len(written) == 7
    [(path, unpacked)] = node.share.items()
    assert (path, unpacked.read_text()) == (*share, "[")


def test_those_without_files_can_be_read_by_earlier_versions(tmp_path: Path) -> None:
    pack({}, {}, tmp_path / "nodes.zip")
    with zipfile.ZipFile(tmp_path / "nodes.zip") as made:
        assert json.loads(made.read("manifest.json"))["format"] == 1


def test_folders_may_stand_in_it(tmp_path: Path) -> None:
    """As GitHub packs them."""
    unpack(zipped(tmp_path, {"p/": "", **FILES}), tmp_path / "unpacked")
    assert len(members(tmp_path / "unpacked")) == 1


def link(name: str) -> zipfile.ZipInfo:
    entry = zipfile.ZipInfo(name)
    entry.external_attr = (stat.S_IFLNK | 0o777) << 16
    return entry


@pytest.mark.parametrize(
    "name",
    ["../evil.js", "/tmp/evil.js", "p/../../evil.js", "p\\evil.js", "p/more.js", "C:evil", "q/"],
)
def test_other_members_are_refused(name: str, tmp_path: Path) -> None:
    file = zipped(tmp_path, FILES, (name, ""))
    assert "it contains the unexpected file" in refused(file, tmp_path)


def test_links_are_refused(tmp_path: Path) -> None:
    rest = {name: text for name, text in FILES.items() if name != "p/talker.jspi.js"}
    file = zipped(tmp_path, rest, (link("p/talker.jspi.js"), "/etc/passwd"))
    assert "it contains the unexpected file 'p/talker.jspi.js'" in refused(file, tmp_path)
    file = zipped(tmp_path, FILES, (link("p/"), "/etc"))
    assert "it contains the unexpected file 'p/'" in refused(file, tmp_path)


def test_two_of_one_name_are_refused(tmp_path: Path) -> None:
    file = zipped(tmp_path, FILES, ("p/talker.jspi.js", "other"))
    assert refused(file, tmp_path) == "it contains two files with the same name"


@pytest.mark.parametrize("name", FILES)
def test_all_has_to_be_there(name: str, tmp_path: Path) -> None:
    file = zipped(tmp_path, {key: text for key, text in FILES.items() if key != name})
    expected = "it has no manifest.json" if name == "manifest.json" else f"'{name}' is missing"
    assert refused(file, tmp_path).startswith(expected)


def changed(**node: object) -> str:
    return json.dumps({**MANIFEST, "nodes": [{**MANIFEST["nodes"][0], **node}]})


def shared(*paths: object) -> str:
    return json.dumps({**MANIFEST, "format": 2, "share": paths})


@pytest.mark.parametrize(
    ("manifest", "expected"),
    [
        ("{", "its 'manifest.json' is not valid JSON"),
        ("[" * 100_000, "its 'manifest.json' is not valid JSON"),
        ("[]", "has no format"),
        (
            json.dumps({**MANIFEST, "format": 3}),
            "has format 3, this version of sitegen reads formats up to 2",
        ),
        (shared("share/p/../../x"), "lists an invalid file: 'share/p/../../x'"),
        (shared("share/p/.."), "lists an invalid file"),
        (shared("/share/p/x"), "lists an invalid file"),
        (shared("share/p\\x/y"), "lists an invalid file"),
        (shared("share/p/\n"), "lists an invalid file"),
        (shared("share/p/" + "ä" * 200), "lists an invalid file"),
        (shared("share/x"), "lists an invalid file"),
        (shared(1), "lists an invalid file"),
        (json.dumps({**MANIFEST, "format": 2, "share": {}}), "lists an invalid file: {}"),
        (shared("share/p/x", "share/p/x/y"), "lists a file that is a folder: 'share/p/x'"),
        (shared("share/p/x"), "'share/p/x' is missing"),
        (json.dumps({**MANIFEST, "nodes": []}), "lists no nodes"),
        (json.dumps({**MANIFEST, "nodes": MANIFEST["nodes"] * 2}), "lists a node twice"),
        (changed(package=".."), "lists an invalid node"),
        (changed(package="../p"), "lists an invalid node"),
        (changed(package="manifest.json"), "lists an invalid node"),
        (changed(executable="../talker"), "lists an invalid node"),
        (changed(executable="a/b"), "lists an invalid node"),
        (changed(engines=["jspi", "other"]), "lists an invalid node"),
        (changed(engines=[]), "lists an invalid node"),
        (json.dumps({**MANIFEST, "nodes": [1]}), "lists an invalid node"),
    ],
)
def test_manifests_that_lie(manifest: str, expected: str, tmp_path: Path) -> None:
    assert expected in refused(zipped(tmp_path, {**FILES, "manifest.json": manifest}), tmp_path)


def test_types_have_to_be_types(tmp_path: Path) -> None:
    file = zipped(tmp_path, {**FILES, "p/talker.types.json": "[]"})
    assert refused(file, tmp_path) == "its 'p/talker.types.json' does not contain a JSON object"


def test_what_unpacks_to_too_much(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr(archive, "LARGEST_UNPACKED", 10_000)
    file = zipped(tmp_path, {**FILES, "p/talker.jspi.wasm": "0" * 20_000})
    assert refused(file, tmp_path) == "it is larger than 10,000 bytes when unpacked"
    # All together count, too.
    half = {name: "0" * 4_000 for name in FILES if name.endswith((".js", ".wasm"))}
    assert "larger than 10,000" in refused(zipped(tmp_path, {**FILES, **half}), tmp_path)
    monkeypatch.setattr(archive, "LARGEST", 100)
    assert refused(file, tmp_path) == "it is larger than 100 bytes"


def test_a_head_that_lies_about_the_size(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr(archive, "LARGEST_UNPACKED", 10_000)
    file = zipped(tmp_path, {**FILES, "p/talker.jspi.wasm": "0" * 20_000})
    data = file.read_bytes()
    assert data.count((20_000).to_bytes(4, "little")) == 2
    file.write_bytes(data.replace((20_000).to_bytes(4, "little"), (20).to_bytes(4, "little")))
    assert refused(file, tmp_path)


def test_a_manifest_that_unpacks_to_gigabytes(tmp_path: Path) -> None:
    file = zipped(tmp_path, {**FILES, "manifest.json": "[" + "0," * 20_000_000 + "0]"})
    assert file.stat().st_size < 200_000
    tracemalloc.start()
    try:
        assert refused(file, tmp_path) == "its 'manifest.json' is larger than 4,000,000 bytes"
        assert tracemalloc.get_traced_memory()[1] < 50_000_000
    finally:
        tracemalloc.stop()


def test_too_many_files(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr(archive, "LARGEST_LIST", 10_000)
    many = {f"p/{number}": "" for number in range(200)}
    assert refused(zipped(tmp_path, {**FILES, **many}), tmp_path) == "it contains too many files"


@pytest.mark.parametrize("method", [zipfile.ZIP_BZIP2, zipfile.ZIP_LZMA])
def test_other_compressions(method: int, tmp_path: Path) -> None:
    """What unpacks them raises errors of its own for damaged data, and takes any memory."""
    script = zipfile.ZipInfo("p/talker.jspi.js")
    script.compress_type = method
    rest = {name: text for name, text in FILES.items() if name != script.filename}
    file = tmp_path / "nodes.zip"
    with zipfile.ZipFile(file, "w") as made:
        for name, text in rest.items():
            made.writestr(name, text)
        made.writestr(script, "js" * 100, method)
    said = "its 'p/talker.jspi.js' is not compressed with 'deflate'"
    assert refused(file, tmp_path) == said


def test_names_are_no_commands_for_a_terminal(tmp_path: Path) -> None:
    said = refused(zipped(tmp_path, FILES, ("p/\x1b[2J" + "x" * 1000, "")), tmp_path)
    assert said.startswith("it contains the unexpected file 'p/\\x1b[2Jx")
    assert len(said) < 200


@pytest.mark.parametrize("seed", range(20))
def test_any_damage_is_an_archive_error(seed: int, tmp_path: Path) -> None:
    chance = random.Random(seed)
    whole = zipped(tmp_path, FILES).read_bytes()
    file = tmp_path / "damaged.zip"
    for number in range(50):
        data = bytearray(whole)
        for _ in range(chance.randint(1, 8)):
            data[chance.randrange(len(data))] = chance.choice((0, 1, 127, 128, 255))
        file.write_bytes(data)
        folder = tmp_path / str(number)
        with contextlib.suppress(ArchiveError), warnings.catch_warnings():
            warnings.simplefilter("ignore")
            unpack(file, folder)


def test_damaged_archives(tmp_path: Path) -> None:
    whole = zipped(tmp_path, FILES).read_bytes()
    file = tmp_path / "damaged.zip"
    broken = bytearray(whole)
    broken[whole.index(b"p/talker.jspi.js") + 20] ^= 0xFF
    for data in (b"", b"no archive", whole[: len(whole) // 2], bytes(broken)):
        file.write_bytes(data)
        assert refused(file, tmp_path) == "it is not a valid zip archive"
