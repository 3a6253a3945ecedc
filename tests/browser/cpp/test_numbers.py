"""Numbers as text and from text, by <charconv>: what Python says of the same numbers."""

from __future__ import annotations

import re
import struct
from decimal import Decimal

from browser import Built, Serve
from paths import SITES
from playwright.sync_api import BrowserContext

from tests.native.test_rclpy import printed, run

GENERAL, SCIENTIFIC, FIXED, HEX = 3, 1, 2, 4
MANTISSA, EXPONENT = r"(\d+\.?\d*|\.\d+)", r"e[+-]?\d+"
PATTERNS = {
    GENERAL: f"{MANTISSA}({EXPONENT})?",
    SCIENTIFIC: f"{MANTISSA}{EXPONENT}",
    FIXED: MANTISSA,
    HEX: MANTISSA.replace(r"\d", "[0-9a-f]") + r"(p[+-]?\d+)?",
}
SPECIAL = r"inf(inity)?|nan(\(\w*\))?"


def bits(value: float) -> str:
    return struct.pack(">d", value).hex()


def value_of(text: str) -> float:
    return float(struct.unpack(">d", bytes.fromhex(text))[0])


def written(value: float) -> list[str]:
    """Return the texts of a number: without a format, in each one, and with three digits."""
    three = [f"{value:.3g}", f"{value:.3e}", f"{value:.3f}", hexadecimal(value, 3)]
    if value in (float("inf"), -float("inf")):
        return [str(value)] * 5 + three
    sign, digits, last = Decimal(repr(value)).normalize().as_tuple()
    assert isinstance(last, int)
    exponent = len(digits) - 1 + last if value else 0
    mantissa = ".".join(filter(None, [str(digits[0]), "".join(map(str, digits[1:]))]))
    scientific = f"{'-' * sign}{mantissa}e{exponent:+03d}"
    # A whole number has all its digits.
    fixed = f"{value:.0f}" if value == 0 or last >= 0 else format(Decimal(repr(value)), "f")
    fixed = fixed.removesuffix(".0")
    general = fixed if -4 <= exponent < 6 else scientific
    plain = fixed if len(fixed) <= len(scientific) else scientific
    return [plain, general, scientific, fixed, hexadecimal(value), *three]


def hexadecimal(value: float, digits: int = 13) -> str:
    """Return what float.hex() does, without 0x and with fewer digits: half of one goes to even."""
    if value in (float("inf"), -float("inf")):
        return str(value)
    found = re.fullmatch(r"(-?)0x(\d)\.(\w+)p(.*)", (value + 0.0).hex())
    assert found or value == 0
    sign, first, rest, power = found.groups() if found else ("", "0", "0", "+0")
    sign = "-" if bits(value)[0] >= "8" else ""
    all_digits = int(first + rest.ljust(13, "0"), 16)
    unit = 16 ** (13 - digits)
    number = all_digits // unit
    left = 2 * (all_digits % unit)
    number += left > unit or (left == unit and number % 2)
    text = f"{number:0{digits + 1}x}"
    fraction = text[1:] if digits < 13 else text[1:].rstrip("0")
    return f"{sign}{text[0]}{'.' * bool(fraction)}{fraction}p{power}"


def read(text: str, form: int) -> str:
    """Return what a node prints that reads a number at the beginning of `text`."""
    found = re.match(f"-?({SPECIAL}|{PATTERNS[form]})", text, re.IGNORECASE)
    if not found:
        return f"{bits(77)} 0 invalid"
    number = re.sub(r"\(.*", "", found[0])
    sign, digits = ("-", number[1:]) if number[0] == "-" else ("", number)
    special = re.match(SPECIAL, digits, re.IGNORECASE)
    try:
        value = float.fromhex(f"{sign}0x{digits}") if form == HEX and not special else float(number)
    except OverflowError:
        value = float("inf")
    nothing = value == 0 and re.match(
        r"[0.]*[1-9a-f]", re.split("[ep]" if form != HEX else "p", digits.lower())[0]
    )
    if not special and (nothing or value in (float("inf"), -float("inf"))):
        return f"{bits(77)} {found.end()} range"
    return f"{bits(value)} {found.end()}"


def test_numbers_are_written_and_read_as_python_does(
    context: BrowserContext, serve: Serve, built: Built
) -> None:
    page = context.new_page()
    page.goto(f"{serve(built(SITES / 'rclcpp'))}numbers/")
    state, said = run(page, "numbers")
    assert state == "stopped", said[-1]
    lines = printed(said)
    doubles = [line.split(" ")[1:] for line in lines if line.startswith("double ")]
    assert len(doubles) == 730
    wrong = [
        (*row, "≠", *expected)
        for row in doubles
        if (expected := written(value_of(row[0]))) != row[1:]
    ]
    assert wrong == []
    reads = [re.fullmatch(r"read (\d) \[(.*)\] (.*)", line) for line in lines[730:-2]]
    assert len(reads) == 4 * 65 + 9 + 1 and all(reads)
    of_doubles = [found.groups() for found in reads[:-10] if found]
    wrong = [(form, text, got) for form, text, got in of_doubles if read(text, int(form)) != got]
    assert wrong == []
    # To the nearest float, half of one to even.
    near, even = bits(1 + 2**-23), bits(1 + 2**-22)
    assert [found[3] for found in reads[-10:] if found] == [
        f"{bits(13421773 * 2**-27)} 3",
        f"{bits(16777216.0)} 8",
        f"{bits((2**24 - 1) * 2.0**104)} 12",
        f"{bits(77)} 12 range",
        f"{bits(2.0**-149)} 5",
        f"{bits(77)} 5 range",
        f"{near} 28",
        f"{even} 28",
        f"{even} 28",
        f"{bits(0.01)} 4",
    ]
    assert lines[-2:] == [
        "float 0.1 1e+10 1.2a05f2p+33 3.4028235e+38 1.fffffep+127 1e-45 0.000002p-126 "
        "9.313226e-10 1p-30 16777216 0.5",
        "little 1 1 1 42 42",
    ]
