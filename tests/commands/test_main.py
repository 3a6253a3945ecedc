from __future__ import annotations

import subprocess
import sys
from collections.abc import Callable
from pathlib import Path
from types import ModuleType

import pytest

from sitegen import __version__
from sitegen.__main__ import main
from sitegen.errors import SiteError

Build = Callable[..., None]


@pytest.fixture
def build_with(monkeypatch: pytest.MonkeyPatch) -> Callable[[Build], None]:
    def replace(build: Build) -> None:
        module = ModuleType("sitegen.commands.build")
        vars(module).update(build=build, Report=object)
        monkeypatch.setitem(sys.modules, "sitegen.commands.build", module)

    return replace


def test_it_builds_the_folder(build_with: Callable[[Build], None]) -> None:
    calls: list[tuple[Path, Path, bool]] = []
    build_with(lambda folder, output, report, debug: calls.append((folder, output, debug)))
    assert main(["build"]) == 0
    assert main(["build", "demo"]) == 0
    assert main(["build", "demo", "--output", "public"]) == 0
    assert main(["build", "--debug"]) == 0
    assert calls == [
        (Path(), Path("dist"), False),
        (Path("demo"), Path("demo/dist"), False),
        (Path("demo"), Path("public"), False),
        (Path(), Path("dist"), True),
    ]


@pytest.mark.parametrize(
    ("lines", "count"), [(["a: wrong"], "1 problem"), (["a: wrong", "b: wrong"], "2 problems")]
)
def test_a_wrong_site_is_1(
    build_with: Callable[[Build], None],
    capsys: pytest.CaptureFixture[str],
    lines: list[str],
    count: str,
) -> None:
    def build(*_: object, **__: object) -> None:
        raise SiteError(lines)

    build_with(build)
    assert main(["build"]) == 1
    assert capsys.readouterr() == ("", "\n".join([*lines, f"{count}, nothing was built\n"]))

    for debug in (["--debug", "build"], ["build", "--debug"]):
        assert main(debug) == 1
        assert "Traceback" in capsys.readouterr().err


def test_a_bug_keeps_its_traceback(
    build_with: Callable[[Build], None], capsys: pytest.CaptureFixture[str]
) -> None:
    def build(*_: object, **__: object) -> None:
        raise KeyError("oops")

    build_with(build)
    assert main(["build"]) == 70
    lines = capsys.readouterr().err.splitlines()
    assert lines[0].startswith("Traceback")
    assert lines[-2:] == ["KeyError: 'oops'", "this is a bug in sitegen, please report it"]


@pytest.mark.parametrize(
    "words", [[], ["biuld"], ["build", "--frobnicate"], ["build", "--output", "."]]
)
def test_wrong_usage_is_2(words: list[str], capsys: pytest.CaptureFixture[str]) -> None:
    with pytest.raises(SystemExit) as caught:
        main(words)
    assert caught.value.code == 2
    assert capsys.readouterr().err.startswith("usage: sitegen")


def test_it_runs_as_a_module() -> None:
    command = [sys.executable, "-m", "sitegen", "--version"]
    assert subprocess.check_output(command, text=True) == f"sitegen {__version__}\n"
