"""Sites whose files all begin with a byte order mark and have the line ends of Windows."""

from __future__ import annotations

import json
from pathlib import Path

import pytest

from sitegen.build import make
from sitegen.errors import SiteError
from sitegen.interfaces import definitions
from sitegen.options import Options
from sitegen.report import Report

MARK = "\ufeff"
PACKAGE = """<?xml version="1.0"?>
<package format="3"><name>{name}</name><version>1.0.0</version><depend>rclpy</depend>
<export><build_type>{kind}</build_type></export></package>
"""
FILES = {
    "site.yaml": """site: {title: Notes, theme: own}
nodes:
  plain: {package: notepad, executable: probe}
  installed: {package: yard, executable: one.py}
pages:
  - {path: /, file: page.md}
  - {path: yaml/, title: YAML, launch: src/notepad/launch/two.launch.yaml}
  - {path: xml/, title: XML, launch: src/notepad/launch/three.launch.xml}
  - {path: programs/, title: Programs, content: [{console: installed}, {console: plain}]}
  - {path: notebook/, title: Notes, content: [{notebook: notes.ipynb}]}
""",
    "page.md": """---
title: Written on Windows
launch: src/notepad/launch/one.launch.py
---

```ros
editor: from_windows
```

```ros
source: from_windows
```
""",
    "notes.ipynb": json.dumps(
        {
            "nbformat": 4,
            "metadata": {"kernelspec": {"language": "python"}},
            "cells": [{"cell_type": "code", "source": "1 + 1", "metadata": {}, "outputs": []}],
        }
    ),
    "themes/own/page.html": "{% include 'head.html' %}<b>own</b>",
    "themes/own/site.css": "body { color: teal }",
    "src/notepad/package.xml": PACKAGE.format(name="notepad", kind="ament_python"),
    "src/notepad/setup.cfg": "[options.entry_points]\nconsole_scripts = probe=notepad.probe:main\n",
    "src/notepad/pyproject.toml": '[tool.setuptools]\npackages = ["notepad"]\n',
    "src/notepad/setup.py": "from setuptools import setup\n\nsetup(packages=['notepad'])\n",
    "src/notepad/notepad/__init__.py": "",
    "src/notepad/notepad/probe.py": '"""Writes."""\nimport numpy_of_nobody\n\n\ndef main(): ...\n',
    "src/notepad/launch/one.launch.py": """from launch import LaunchDescription
from launch_ros.actions import Node


def generate_launch_description():
    return LaunchDescription([Node(package="notepad", executable="probe", name="from_windows")])
""",
    "src/notepad/launch/two.launch.yaml": "launch: [node: {pkg: notepad, exec: probe, name: a}]\n",
    "src/notepad/launch/three.launch.xml": """<launch>
<node pkg="notepad" exec="probe" name="b"/>
</launch>
""",
    "src/yard/package.xml": PACKAGE.format(name="yard", kind="ament_cmake"),
    "src/yard/CMakeLists.txt": "install(PROGRAMS one.py DESTINATION lib/yard)\n",
    "src/yard/one.py": "import rclpy\n",
}


def written(folder: Path) -> Path:
    for name, text in FILES.items():
        file = folder / name
        file.parent.mkdir(parents=True, exist_ok=True)
        file.write_bytes((MARK + text).replace("\n", "\r\n").encode())
    return folder


def test_marks_change_nothing(tmp_path: Path) -> None:
    site = written(tmp_path)
    with pytest.raises(SiteError) as caught:
        make(site, Report(), options=Options(compile=False))
    # An import is found behind the mark of its module.
    assert [line.partition(":")[0] for line in caught.value.lines] == [
        "src/notepad/notepad/probe.py"
    ]
    assert "numpy_of_nobody" in caught.value.lines[0]

    probe = site / "src/notepad/notepad/probe.py"
    probe.write_bytes(probe.read_bytes().replace(b"numpy_of_nobody", b"rclpy"))
    made = make(site, Report(), options=Options(compile=False))
    texts = {one.path: one.source for one in made.artifacts if isinstance(one.source, bytes)}
    assert {page.path: sorted(page.nodes) for page in made.site.pages} == {
        "": ["from_windows"],
        "yaml/": ["a"],
        "xml/": ["b"],
        "programs/": ["installed", "plain"],
        "notebook/": ["cells"],
    }
    shown = {path: text for path, text in texts.items() if path.endswith((".html", ".json"))}
    assert [path for path, text in shown.items() if MARK.encode() in text] == []
    assert [path for path, text in shown.items() if b"\\ufeff" in text] == []
    assert b"Writes." in shown["page.json"]
    assert b"<title>Written on Windows" in shown["index.html"]


def test_a_mark_in_a_definition_is_said(tmp_path: Path) -> None:
    (tmp_path / "msg").mkdir()
    file = tmp_path / "msg/Note.msg"
    file.write_bytes(f"{MARK}string text\n".encode())
    assert definitions.check("notes", tmp_path, ["msg/Note.msg"], {}) == [
        f"{file}:1: ROS reads no byte order mark; save the file as UTF-8 without it"
    ]
