from __future__ import annotations

import io
import re
import subprocess
import sys
from collections.abc import Callable
from pathlib import Path
from types import ModuleType

import pytest

from sitegen import __version__
from sitegen.__main__ import main
from sitegen.errors import SiteError
from sitegen.options import PUBLISH, Options

Build = Callable[..., None]


@pytest.fixture
def build_with(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> Callable[[Build], None]:
    # A checkout whose site was just built has nothing to build.
    monkeypatch.chdir(tmp_path)

    def replace(build: Build) -> None:
        module = ModuleType("sitegen.commands.build")
        vars(module).update(build=build, Report=object)
        monkeypatch.setitem(sys.modules, "sitegen.commands.build", module)

    return replace


def test_it_builds_the_folder(build_with: Callable[[Build], None]) -> None:
    calls: list[tuple[Path, Path, Options, bool]] = []
    build_with(
        lambda folder, output, report, options, verbose: calls.append(
            (folder, output, options, verbose)
        )
    )
    assert main(["build"]) == 0
    assert main(["build", "demo"]) == 0
    assert main(["build", "demo", "--output", "public"]) == 0
    assert main(["build", "--debug"]) == 0
    assert main(["build", "--verbose"]) == 0
    assert main(["build", "--keep-going"]) == 0
    assert calls == [
        (Path(), Path("dist"), PUBLISH, False),
        (Path("demo"), Path("demo/dist"), PUBLISH, False),
        (Path("demo"), Path("public"), PUBLISH, False),
        (Path(), Path("dist"), Options(debug=True), False),
        (Path(), Path("dist"), PUBLISH, True),
        (Path(), Path("dist"), Options(keep_going=True), False),
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


COMMANDS = "build, check, compile, deploy, gateway, init, missing, new, schema, serve, theme, types"


@pytest.mark.parametrize(
    ("words", "said"),
    [
        (["serv"], "sitegen: unknown command 'serv'; did you mean 'serve'?"),
        (["--debug", "buidl"], "sitegen: unknown command 'buidl'; did you mean 'build'?"),
        (["xyz"], f"sitegen: unknown command 'xyz'; known: {COMMANDS}"),
        (["theme", "cpy"], "sitegen theme: unknown command 'cpy'; did you mean 'copy'?"),
        (
            ["serve", "--prot", "1"],
            "sitegen serve: unknown option '--prot'; did you mean '--port'?",
        ),
        (
            ["build", "--outptu=a"],
            "sitegen build: unknown option '--outptu'; did you mean '--output'?",
        ),
        (["--verison"], "sitegen: unknown option '--verison'; did you mean '--version'?"),
    ],
)
def test_what_is_misspelt_is_2_and_gets_a_suggestion(
    words: list[str], said: str, capsys: pytest.CaptureFixture[str]
) -> None:
    with pytest.raises(SystemExit) as caught:
        main(words)
    assert caught.value.code == 2
    assert capsys.readouterr() == ("", f"{said}\n")


@pytest.mark.parametrize("words", [["build", "a", "b"], ["build", "--output", "."], ["new"]])
def test_wrong_usage_is_2(words: list[str], capsys: pytest.CaptureFixture[str]) -> None:
    with pytest.raises(SystemExit) as caught:
        main(words)
    assert caught.value.code == 2
    assert capsys.readouterr().err.startswith(f"usage: sitegen {words[0]}")


def test_no_command_is_2_and_gets_help(capsys: pytest.CaptureFixture[str]) -> None:
    with pytest.raises(SystemExit) as caught:
        main([])
    out, err = capsys.readouterr()
    assert (caught.value.code, out) == (2, "")
    assert "Start with:  sitegen new my_robot" in err
    for name in COMMANDS.split(", "):
        assert f"\n    {name} " in err


class Terminal(io.StringIO):
    def isatty(self) -> bool:
        return True


@pytest.mark.parametrize(
    ("words", "out", "environment", "coloured"),
    [
        ([], Terminal, {}, True),
        ([], io.StringIO, {}, False),
        ([], Terminal, {"NO_COLOR": "1"}, False),
        ([], Terminal, {"NO_COLOR": ""}, True),
        ([], Terminal, {"TERM": "dumb"}, False),
        (["--color=always"], io.StringIO, {}, True),
        (["--color", "always"], Terminal, {"NO_COLOR": "1"}, True),
        (["--color=never"], Terminal, {}, False),
    ],
)
def test_colours_are_for_terminals(
    words: list[str],
    out: type[io.StringIO],
    environment: dict[str, str],
    coloured: bool,
    tmp_path: Path,
    monkeypatch: pytest.MonkeyPatch,
) -> None:
    monkeypatch.delenv("NO_COLOR", raising=False)
    monkeypatch.setenv("TERM", "xterm")
    for name, value in environment.items():
        monkeypatch.setenv(name, value)
    (tmp_path / "site.yaml").write_text(
        "site: {titel: A}\npages: [{path: /, title: A, content: []}]"
    )
    for command in ([*words, "check", str(tmp_path)], ["check", str(tmp_path), *words]):
        stream = out()
        monkeypatch.setattr(sys, "stderr", stream)
        assert main(command) == 1
        said = stream.getvalue()
        assert ("\x1b[31msite.yaml:1:\x1b[0m site.titel" in said) == coloured
        assert bool(re.search(r"\x1b\[\d+m", said)) == coloured
        assert environment != {"TERM": "dumb"} or "\x1b" not in said


def test_it_runs_as_a_module() -> None:
    command = [sys.executable, "-m", "sitegen", "--version"]
    assert subprocess.check_output(command, text=True) == f"sitegen {__version__}\n"
