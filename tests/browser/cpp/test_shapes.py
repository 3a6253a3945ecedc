"""The shapes that C++ packages come in."""

from __future__ import annotations

import re

from browser import Built, Serve
from panel import Panel
from paths import SITES
from playwright.sync_api import Page


def test_packages_of_many_shapes_run(built: Built, serve: Serve, tab: Page) -> None:
    """Libraries of their own and others, interfaces, old and new CMake, C and three C++s."""
    expected = {
        "beside": [
            "front 4 wheels, 0.25 m, -2 of Räder & Söhne",
            "corner 7 -1",
            "1.5 kg 6.25 m",
        ],
        "plain": ["rolls on 4, holds front, 254"],
        "report": ["4 tools, [9-kilted]"],
        "edges": [
            "node, lifecycle node managed",
            "2 left",
            "refused",
            "7 in robot_tools",
            "heard words",
        ],
        "modern": ["hello after 294: holds left, 4 wheels, 2 spare"],
        "libraries": [
            "Boost trims and 2 listen",
            '{"kind":"json"}',
            "fmt has 3 words",
            "spdlog has level warning",
            "Eigen has 6",
            "g++ includes 1 2 3",
            "yaml-cpp reads 0.5",
            "and fails at line 1",
            "TinyXML2 reads arm",
            "libuuid writes 36 characters",
            "robot_joints 0.3.1 turns 180",
            "and says so when it ends",
        ],
        # The same lines as on a robot, but for the format that pages lack.
        "images": [
            "0 205 254 254 254 0 in all",
            *["127 63 and some are transparent"] * 3,
            "Magick: Read Exception (spoiled.png) reported by coders/png.c (png_get_data)",
            "Magick: Unable to open file (gone.pgm) reported by magick/blob.c (OpenBlob)",
            "Magick: Coder not found (jpg) reported by Magick++/lib/Exception.cpp "
            "(throwExceptionExplicit)",
            "Q16, zlib 1",
        ],
    }
    tab.goto(serve(built(SITES / "shapes")))
    for name, lines in expected.items():
        panel = Panel(tab, name)
        panel.start()
        panel.wait_for(lines[-1])
        panel.expect_state("stopped")
        logs = name not in ("plain", "libraries", "images")
        found = panel.messages() if logs else panel.lines()
        # Lines of sources and versions are those of Debian's libraries.
        assert lines == [re.sub(r"(?<=[pc]):\d+|(?<=zlib \d)[.\d]+", "", line) for line in found]


def test_robot_descriptions_are_read(built: Built, serve: Serve, tab: Page) -> None:
    """By a program that settings in site.yaml add to its package."""
    tab.goto(serve(built(SITES / "shapes")))
    panel = Panel(tab, "models")
    panel.start()
    panel.wait_for("the other way around")
    lines = panel.lines()
    assert [line for line in lines if not re.match(r"Error|Warning| ", line)] == [
        "a joint without a parent: 0",
        "Could not open file [/ros/share/robot_libraries/gone.urdf] for parsing.",
        "no such file: 0",
        "arm has 2 links, root base",
        "shoulder turns to 90 degrees",
        "upper weighs 2.5 kg",
        "the other way around: 1, -5.2832",
    ]
    # console_bridge tells what urdfdom finds.
    assert "loose" in " ".join(line for line in lines if line.startswith("Error"))
