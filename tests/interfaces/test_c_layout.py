"""C structs and constants of messages are those of the headers that rosidl generates."""

from __future__ import annotations

import json
import re
import subprocess
from pathlib import Path

from sitegen.interfaces import generator, rosidl
from sitegen.shipped import ROS

PACKAGE = "test_msgs"
STRUCT = re.compile(r"typedef struct (\w+)\s*\{(.*?)\}\s*\w+;", re.DOTALL)
MEMBER = re.compile(r"(\w+)(?:\[\d+\])?;")
COMMENT = re.compile(r"//[^\n]*|/\*.*?\*/", re.DOTALL)
FORMAT = '  print("{name}", {value});'
# Prints a value of any type that a constant can have, and its size.
MAIN = """\
#include <stddef.h>
#include <stdio.h>
{includes}
#define print(name, value) do {{ \\
  printf("%s %zu ", name, sizeof(value)); \\
  _Generic((value), \\
    float: print_real, double: print_real, const char *: print_text, char *: print_text, \\
    default: print_integer)(value); \\
}} while (0)
static void print_real(double value) {{printf("%.17g\\n", value);}}
static void print_text(const char * value) {{printf("%s\\n", value);}}
static void print_integer(long long value) {{printf("%lld\\n", value);}}
int main(void)
{{
{lines}
}}
"""


def test_structs_and_constants_are_those_of_rosidl(tmp_path: Path) -> None:
    share = ROS / "share" / PACKAGE
    files = [f.relative_to(share).as_posix() for f in sorted(share.glob("*/*.*[!n]"))]
    upstream, ours = tmp_path / "upstream", tmp_path / "ours"
    arguments = generator.describe(tmp_path / "described", [], PACKAGE, share, files)
    arguments |= {
        "output_dir": str(upstream / PACKAGE),
        "template_dir": str(ROS / "share" / "rosidl_generator_c" / "resource"),
    }
    listed = tmp_path / "arguments.json"
    listed.write_text(json.dumps(arguments))
    make = rosidl.module("rosidl_pycommon").generate_files
    make(str(listed), {"idl__struct.h.em": "detail/%s__struct.h"})
    generator.write_ros(ours)

    headers = sorted(upstream.rglob("*__struct.h"))
    names = [header.relative_to(upstream).as_posix() for header in headers]
    lines = [line for header in headers for line in asked(header.read_text())]
    assert len(lines) > 500
    includes = "\n".join(f'#include "{name}"' for name in names)
    source = tmp_path / "main.c"
    source.write_text(MAIN.format(includes=includes, lines="\n".join(lines)))
    folders = [*sorted((ours / "include").iterdir()), *sorted((ROS / "include").iterdir())]
    assert printed(source, [ours / "include" / PACKAGE, *folders]) == printed(
        source, [upstream, *folders]
    )


def asked(header: str) -> list[str]:
    """Return the statements that print the sizes, places and constants of a header."""
    plain = COMMENT.sub("", header)
    lines = []
    for name, body in STRUCT.findall(plain):
        lines.append(FORMAT.format(name=name, value=f"sizeof({name})"))
        for member in MEMBER.findall(body):
            place = f"{name}.{member}"
            lines.append(FORMAT.format(name=place, value=f"offsetof({name}, {member})"))
            kind = f"sizeof((({name} *)0)->{member})"
            lines.append(FORMAT.format(name=f"size of {place}", value=kind))
    constants = re.findall(rf"({PACKAGE}__\w+)\s*=", plain)
    return lines + [FORMAT.format(name=name, value=name) for name in constants]


def printed(source: Path, folders: list[Path]) -> list[str]:
    program = source.with_suffix("")
    words = [word for folder in folders for word in ("-I", str(folder))]
    subprocess.run(["gcc", "-w", *words, str(source), "-o", str(program)], check=True)
    return subprocess.run([program], check=True, capture_output=True, text=True).stdout.split("\n")
