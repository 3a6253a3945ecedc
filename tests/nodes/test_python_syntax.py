"""Errors of syntax in Python programs, which a check and a build report with their lines."""

from __future__ import annotations

from pathlib import Path

import pytest

from sitegen.commands.build import build
from sitegen.commands.check import check
from sitegen.errors import SiteError
from sitegen.report import Report

FILES = {
    "site.yaml": """site: {title: Test}
nodes: {talker: {package: talk, executable: talker}}
pages: [{path: /, title: Test, content: [{console: talker}]}]
""",
    "src/talk/package.xml": """<package format="3"><name>talk</name><version>1.0.0</version>
<depend>rclpy</depend><export><build_type>ament_python</build_type></export></package>
""",
    "src/talk/setup.py": "from setuptools import setup\n"
    "setup(packages=['talk'], entry_points={'console_scripts': ['talker = talk.talker:main']})\n",
    "src/talk/talk/__init__.py": "",
    "src/talk/talk/talker.py": "from talk import words\n\n\ndef main():\n    words.say()\n",
    "src/talk/talk/words.py": "def say():\n    print('hello')\n",
    "src/talk/talk/unused.py": "def (:\n",
}


@pytest.fixture
def site(tmp_path: Path) -> Path:
    for name, text in FILES.items():
        (tmp_path / name).parent.mkdir(parents=True, exist_ok=True)
        (tmp_path / name).write_text(text)
    return tmp_path


def built(site: Path, report: Report) -> None:
    build(site, output=site / "dist", report=report)


@pytest.mark.parametrize(
    ("name", "source", "expected"),
    [
        (
            "talker",
            b"class A:\n    def f(self):\n        self.count +=\n",
            "3: syntax: invalid syntax",
        ),
        ("words", b"def say():\nprint('hello')\n", "2: syntax: expected an indented block"),
        ("words", b"return 1\n", "1: syntax: 'return' outside function"),
        ("words", b"x = '\xff'\n", "1: syntax: "),
        ("words", b"x = 1\0\n", "1: syntax: "),
    ],
)
def test_an_error_is_reported(site: Path, name: str, source: bytes, expected: str) -> None:
    (site / f"src/talk/talk/{name}.py").write_bytes(source)
    for run in (check, built):
        with pytest.raises(SiteError) as caught:
            run(site, Report())
        [line] = caught.value.lines
        assert line.startswith(f"src/talk/talk/{name}.py:{expected}")


def test_what_python_accepts_is_accepted(site: Path) -> None:
    words = site / "src/talk/talk/words.py"
    words.write_bytes(b"# -*- coding: latin-1 -*-\nWORD = '\xe9\\d'\ndef say(): ...\n")
    check(site, Report())
    # Newer than the oldest Python that sitegen runs with, and valid in the page.
    words.write_text('type Words = list[str]\ndef say(): print(f"{\', \'.join(["a"])}")\n')
    check(site, Report())
