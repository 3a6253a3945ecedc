"""Turn TeX formulas into MathML Core, which browsers draw without a library."""

from __future__ import annotations

import functools
import html
import re

from sitegen.site.prose.tex import TexError, mathml

# The output of ArithmatexExtension in its generic form.
FORMULA = re.compile(
    r'<(?P<tag>span|div) class="arithmatex">\\[(\[](?P<tex>.*?)\\[)\]]</(?P=tag)>', re.DOTALL
)

# The page's policy forbids style attributes; the theme's figures.css has these classes.
STYLES = {
    "text-align: right": "right",
    "text-align: left": "left",
    "width: 100%": "wide",
    "width: 50%": "half",
    "padding-left: 0": "close-left",
    "padding-right: 0": "close-right",
    "padding-left:1em": "apart",
    "border-left": "rule-left",
    "border-right": "rule-right",
    "border-top": "rule-top",
    "border-bottom": "rule-bottom",
}
_STYLE = re.compile(r' style="([^"]*)"')


class FormulaError(ValueError):
    """`formula` is not valid TeX."""

    def __init__(self, formula: str, fault: str) -> None:
        super().__init__(fault)
        self.formula = formula


def formulas(text: str, wrong: list[FormulaError]) -> str:
    """Return `text`, HTML, with formulas as MathML; invalid formulas are added to `wrong`."""

    def draw(found: re.Match[str]) -> str:
        tex, block = html.unescape(found["tex"]).strip(), found["tag"] == "div"
        try:
            drawn = _mathml(tex, block)
        except TexError as error:
            position, _, fault = str(error).partition(": ")
            near = tex[int(position) :][:20] if position.isdigit() else ""
            where = f" at '{near}'" if near else ""
            wrong.append(FormulaError(tex, (fault or position).rstrip(".") + where))
            return ""
        return f'<div class="formula" tabindex="0">{drawn}</div>' if block else drawn

    return FORMULA.sub(draw, text)


@functools.cache
def _mathml(tex: str, block: bool) -> str:
    return _STYLE.sub(_class, mathml(tex, block=block))


def _class(style: re.Match[str]) -> str:
    names = [name for rule, name in STYLES.items() if rule in style[1]]
    return f' class="{" ".join(names)}"' if names else ""
