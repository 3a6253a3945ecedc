r"""Backslashes in the texts of XML and YAML files, as launch 3.7.1 reads them.

9,000 random texts were compared besides.
"""

from __future__ import annotations

from pathlib import Path

import pytest
from launching import nodes

from sitegen.launch.substitutions import Known, expand

# Texts, and what launch makes of them; the argument `x` is "X\n", with a backslash and an "n".
FACTS = [
    (r"\$(var x)", "$(var x)"),
    (r"\\$(var x)", r"\$(var x)"),
    (r"\$$(var x)", "$X\\n"),
    (r"$(var x)\$)", "X\\n$)"),
    (r"\a\n\\", "an\\"),
    ("a\\", "a\\"),
    ("\\\n", "\\\n"),
    (r"\(a$(var y 'd e')", "(ad e"),
    (r'$(var y "d\"e"))\(', 'd"e)('),
    (r"$(var y \'q)\)\))", "'q)))"),
    (r"$(var y 'it\'s')", "it's"),
    (r"$(var y \$\(x\))", "$(x)"),
    (r"'\\'\'a", "'\\''a"),
    (r"'' \\\$", r"'' \$"),
]


@pytest.mark.parametrize(("text", "expected"), FACTS)
def test_a_backslash_takes_the_next_character_literally(text: str, expected: str) -> None:
    known = Known(Path("x.launch.xml"), {"x": "X\\n"})
    assert expand(text, known, Path, str, escapes=True) == expected


# Each node prints its arguments. launch makes of the first line ["$(var x)", "b c", "\"d"].
LINES = {
    "xml": r"""<launch><let name="x" value="p\\q"/>
      <node pkg="p" exec="x" args="\$(var\ x) 'b c' \\&quot;d $(var x)">
        <param name="plain" value="a\b\\c"/><param name="both" value="a\b$(var x)"/>
      </node></launch>""",
    "yaml": r"""launch:
- let: {name: x, value: 'p\\q'}
- node:
    pkg: p
    exec: x
    args: \$(var\ x) 'b c' \\"d $(var x)
    param: [{name: plain, value: 'a\b\\c'}, {name: both, value: 'a\b$(var x)'}]
""",
}


@pytest.mark.parametrize("kind", LINES)
def test_command_lines_and_parameters_have_them_too(root: Path, kind: str) -> None:
    (root / f"x.launch.{kind}").write_text(LINES[kind])
    [node], wrong = nodes(root, f"x.launch.{kind}")
    assert wrong == []
    assert node.arguments == ("$(var", "x)", "b c", '"d', "p\\q")
    assert node.parameters == {"plain": r"'ab\c'", "both": r"'abp\q'"}
