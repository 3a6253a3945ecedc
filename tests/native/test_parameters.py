"""Parameters are read as native rclpy reads them: from files, from `-p`, and from site.yaml."""

from __future__ import annotations

import json
import math
import random
import shutil
from collections.abc import Iterator, Sequence
from pathlib import Path
from typing import Any

import pytest
import yaml
from browser import Built, Serve
from native import Native
from paths import SITES
from playwright.sync_api import BrowserContext

from sitegen.config import parameters
from sitegen.config.document import parse
from sitegen.errors import Location, Problems
from sitegen.rclyaml import EVERYWHERE, Overrides, ParameterError, matches, value, written
from sitegen.workspace import parameterfiles
from tests.native.test_rclpy import printed, run

SITE = SITES / "parameters"
# Command lines that are compared in one run, and how often a random one is made anew.
RANDOM = 1500

WORDS = [
    *("y", "Y", "yes", "Yes", "YES", "yEs", "n", "N", "no", "No", "NO", "nO", "on", "On", "ON"),
    *("oN", "off", "Off", "OFF", "true", "True", "TRUE", "tRUE", "false", "False", "FALSE"),
    *("null", "Null", "NULL", "~", "none", "hello", "a b", "=", "<<", "odom_b", "/ros/share"),
    *("package://a/b.stl", "$(x)", "${x}", "2024-01-01", "2024-01-01T00:00:00Z", "\u0661", "é"),
]
WHOLE = [
    *("0", "1", "-1", "+5", "00", "-0", "007", "08", "0089", "0483", "1915", "0x1F", "0X1f"),
    *("-0x10", "0x", "0x1g", "0b101", "0o17", "1_000", "0_1", "+", "--1", "+-1", "1L", "1 2"),
    *("12:30", "2:1", "-12:30", "1:30:00", "9223372036854775807", "9223372036854775808"),
    *("-9223372036854775808", "-9223372036854775809", "99999999999999999999999"),
    *("0x7fffffffffffffff", "0xffffffffffffffff", "4104488519", "1,5"),
]
REAL = [
    *(
        "1e3",
        "1E3",
        "1.5e3",
        "2E+3",
        "1e-3",
        "1.",
        "0.5",
        ".5",
        "-.5",
        "+.5",
        "5.",
        ".",
        "1e",
        "e1",
    ),
    *(".", "1.2.3", "0.0", "-0.0", "0e0", "1e+", "1e1.5", "12E5", "1f", "1d", "1e400", "-1e400"),
    *("1e-400", "1e-310", "2.3e-308", "5e-324", "3.4028236e38", "1.7976931348623157e308"),
    *("1.7976931348623159e308", "0x1p3", "0x1.8p3", "0x.8", "0x1.8", "0x1p5000", "1e22", "1e-7"),
    *(".inf", "-.inf", "+.inf", ".Inf", "+.Inf", ".INF", ".iNf", ".nan", ".NaN", ".NAN", "-.nan"),
    *("inf", "-inf", "Infinity", "infinit", "nan", "NaN", "-nan", "nan(1)"),
]
PLAIN = [*WORDS, *WHOLE, *REAL]
SCALARS = [
    *PLAIN,
    *(f"'{text}'" for text in PLAIN),
    *(f'"{text}"' for text in PLAIN),
    *(f"!!str {text}" for text in PLAIN if text[0] not in "=<"),
]
# In brackets, libyaml of ROS refuses colons inside of words, as later releases of it do not.
LISTS = [
    *(f"[{text}]" for text in SCALARS if ":" not in text),
    *("[1, 2]", "[1.0, 2.5]", "[a, 'b', \"c\"]", "[true, no]", "[y, 'y']", "[1, 2.0]", "[1e3, 2.]"),
    *("[]", "[ 1 , 2 ]", "[1, 2,]"),
]
VALUES = [*SCALARS, *LISTS]


@pytest.fixture(scope="module")
def native() -> Native:
    return Native()


@pytest.fixture(scope="module")
def valid(native: Native) -> dict[str, tuple[str, Any]]:
    """The values that rclpy does not refuse, by the names of parameters: as text, and as it is."""
    answers = natively(native, [["-p", f"a:={text}"] for text in VALUES])
    return {
        f"v{number}": (text, answer["a"])
        for number, (text, answer) in enumerate(zip(VALUES, answers, strict=True))
        if isinstance(answer, dict) and answer["a"] is not None
    }


def natively(native: Native, lines: Sequence[Sequence[str]]) -> list[Any]:
    """What each command line gives to the node /q/n, or the reason why rclpy refuses it."""
    given = "\n".join(json.dumps(words) for words in lines)
    return [json.loads(line) for line in native.run("overrides.py", stdin=given)]


def same(found: Any) -> Any:
    """A value in a form that is equal only if its type is, and that not-a-number equals."""
    if isinstance(found, dict):
        return {name: same(one) for name, one in found.items()}
    if isinstance(found, list):
        return [same(one) for one in found]
    return (type(found).__name__, "nan" if found != found else found)


def read(words: Sequence[str], node: str = "/q/n") -> dict[str, Any] | str:
    """What sitegen makes of a command line, as a node's arguments and in a page."""
    found = Overrides()
    try:
        for option, text in zip(words[::2], words[1::2], strict=True):
            if option == "-p":
                name, _, given = text.partition(":=")
                found.add(name, given)
            else:
                parameterfiles.add(found, Path(text))
    except (ValueError, yaml.YAMLError) as error:
        return str(error)
    again = Overrides()
    for one in found:
        again.add(one.name, written(one.value), one.pattern)
    of_node = {one.name: one.value for one in found if matches(one.pattern, node)}
    assert same({one.name: one.value for one in again if matches(one.pattern, node)}) == same(
        of_node
    )
    return of_node


def differences(lines: Sequence[Sequence[str]], answers: Sequence[Any]) -> list[str]:
    """The command lines that sitegen reads otherwise, or refuses when rclpy does not."""
    found = []
    for words, theirs in zip(lines, answers, strict=True):
        ours = read(words)
        both_refuse = isinstance(ours, str) and isinstance(theirs, str)
        if not both_refuse and same(ours) != same(theirs):
            texts = [Path(word).read_text() if "/" in word[:1] else word for word in words]
            found.append(f"{texts}: {ours!r}, natively {theirs!r}")
    return found


def test_scalars_and_lists_of_a_command_line(native: Native) -> None:
    lines = [["-p", f"a:={text}"] for text in VALUES]
    assert differences(lines, natively(native, lines)) == []


def test_scalars_and_lists_of_files_and_of_site_yaml(
    native: Native, tmp_path: Path, valid: dict[str, tuple[str, Any]]
) -> None:
    assert len(valid) > 800
    listed = "".join(f"{name}: {text}\n" for name, (text, _) in valid.items())
    file = tmp_path / "all.yaml"
    file.write_text(
        "/**:\n  ros__parameters:\n" + "".join(f"    {s}\n" for s in listed.split("\n"))
    )
    expected = {name: answer for name, (_, answer) in valid.items()}
    assert same(natively(native, [["--params-file", str(file)]])) == same([expected])
    assert same(read(["--params-file", str(file)])) == same(expected)
    problems = Problems(tmp_path)
    section = parse(listed, Location(tmp_path / "site.yaml", 1), problems, key="parameters")
    assert section
    given = parameters.read(section, problems)
    assert problems.lines == []
    assert same({name: value(text) for name, text in given.items()}) == same(expected)


PATTERNS = ["/**", "/q/n", "/q/*", "/*/n", "/**/n", "q/n", "n", "/other/n"]


class Chance:
    """Makes command lines with files of parameters."""

    def __init__(self, seed: int, folder: Path) -> None:
        self._random = random.Random(seed)
        self._folder = folder
        self._files = 0

    def line(self) -> list[str]:
        """A command line: files and values, which overlap in names and types."""
        return [word for _ in range(self._random.randint(1, 4)) for word in self._option()]

    def _option(self) -> tuple[str, str]:
        if self._random.random() < 0.5:
            return "-p", f"{self._random.choice(['a', 'b', 'a.b', 'a.b.c'])}:={self._value()}"
        self._files += 1
        file = self._folder / f"{self._files}.yaml"
        file.write_text("".join(self._sections()))
        return "--params-file", str(file)

    def _sections(self) -> Iterator[str]:
        for _ in range(self._random.randint(1, 3)):
            yield f"{self._random.choice(PATTERNS)}:\n  ros__parameters: {self._mapping(0)}\n"

    def _mapping(self, depth: int) -> str:
        names = self._random.sample("abc", self._random.randint(1, 3))
        return f"{{{', '.join(f'{name}: {self._entry(depth)}' for name in names)}}}"

    def _entry(self, depth: int) -> str:
        if depth < 2 and self._random.random() < 0.25:
            return self._mapping(depth + 1)
        return self._value()

    def _value(self) -> str:
        if self._random.random() < 0.3:
            return self._random.choice([text for text in VALUES if ":" not in text])
        return self._random.choice(
            ["1", "2.5", "x", "true", "[1]", "[a, b]", "[2.5]", "'q'", "yes"]
        )


def test_random_files_and_values_take_precedence_as_natively(
    native: Native, tmp_path: Path
) -> None:
    seed = random.randrange(2**32)
    print(f"seed {seed}")
    chance = Chance(seed, tmp_path)
    lines = [chance.line() for _ in range(RANDOM)]
    assert differences(lines, natively(native, lines)) == []


def test_a_pattern_matches_the_full_name_of_a_node() -> None:
    assert matches(EVERYWHERE, "/n")
    assert matches("n", "/n")
    assert not matches("n", "/q/n")
    assert not matches("/q/*", "/q/r/n")


@pytest.mark.parametrize(
    ("text", "expected"),
    [
        ("/**:\n  ros__parameters:\n    a: [1, 2.0]\n", (3, "found integer and double")),
        ("/**:\n  ros__parameters:\n    a:\n", (3, "write '' for an empty string")),
        ("/**:\n  ros__parameters:\n", (2, "'ros__parameters' of '/**' has no parameters")),
        ("a: 1\n", (1, "'a' has a value, but is not below 'ros__parameters'")),
        ("ros__parameters: {a: 1}\n", (1, "expected the name of a node above 'ros__parameters'")),
        ("a b: {ros__parameters: {a: 1}}\n", (1, "'a b' is not a valid name of a node")),
        ("/q: {/n: {ros__parameters: {a: 1}}}\n", (1, "'/q//n' is not a valid name of a node")),
        ("n: {ros__parameters: {a: [[1]]}}\n", (1, "the items of a list must be scalars")),
    ],
)
def test_what_rcl_refuses_is_told_with_its_line(text: str, expected: tuple[int, str]) -> None:
    with pytest.raises(ParameterError) as caught:
        Overrides().file(yaml.parse(text))
    assert (caught.value.line, expected[1]) == (expected[0], expected[1])
    assert str(caught.value).endswith(expected[1])


@pytest.fixture(scope="module")
def probes(
    tmp_path_factory: pytest.TempPathFactory, native: Native, valid: dict[str, tuple[str, Any]]
) -> tuple[Path, list[str]]:
    """A site with a node in each language that gets all values, and the lines that are right."""
    folder = tmp_path_factory.mktemp("site") / "site"
    shutil.copytree(SITE, folder)
    # A page drops lines when more than a thousand come at once.
    texts = {name: text for name, (text, _) in valid.items() if '"' not in text}
    words = [word for name, text in texts.items() for word in ("-p", f"{name}:={text}")]
    # Patterns and types in an order in which the last value does not always count.
    for rule in ("both:=2", "both:=2.5", "both:=x", "one:=[1]", "one:=3"):
        words += ["-p", rule]
    [answer] = natively(native, [words])
    lines = sorted(line(name, found) for name, found in answer.items())
    # Only sitegen's own command lines may name a node with its namespace.
    words = ["-p", "/q/probe:late:=1", *words, "-p", "late:=2", "-p", "/q/probe:late:=3"]
    words += ["-p", "probe:elsewhere:=1", "-p", "/other/*:elsewhere:=1"]
    node = {"executable": "probe", "arguments": ["--ros-args", *words]}
    site = {
        "site": {"title": "Parameters"},
        "workspace": ".",
        "nodes": {"cpp": {"package": "probe", **node}, "python": {"package": "probe_py", **node}},
        "pages": [
            {
                "path": "/",
                "title": "Parameters",
                # With buttons, they do not start before the test listens to them.
                "content": [{"buttons": "cpp"}, {"buttons": "python"}],
            }
        ],
    }
    (folder / "site.yaml").write_text(yaml.safe_dump(site, allow_unicode=True))
    return folder, sorted([*lines, "late integer 2"])


def line(name: str, found: Any) -> str:
    """What the nodes of the site print for a parameter."""
    kinds = {bool: "bool", int: "integer", float: "double", str: "string"}
    items = found if isinstance(found, list) else [found]
    kind = kinds[type(items[0])] + ("_array" if isinstance(found, list) else "")
    return f"{name} {kind} {'|'.join(map(shown, items))}"


def shown(item: Any) -> str:
    if isinstance(item, float):
        return "nan" if math.isnan(item) else f"{item:.17g}"
    return str(item)


@pytest.mark.parametrize("name", ["cpp", "python"])
def test_nodes_of_a_page_read_their_command_line_as_natively(
    context: BrowserContext, serve: Serve, built: Built, probes: tuple[Path, list[str]], name: str
) -> None:
    folder, expected = probes
    page = context.new_page()
    page.goto(serve(built(folder)))
    state, lines = run(page, name)
    found = printed(lines)
    assert sorted({*found} - {*expected}) == []
    assert sorted(found) == expected
    assert state == "stopped"
