"""Make keys for the gateway."""

from __future__ import annotations

import argparse
import re
from pathlib import Path

from sitegen.errors import SiteError
from sitegen.report import Report

SECRET = "gateway.secret"
UNITS = {"s": 1, "m": 60, "h": 3600, "d": 86400}


def make_key(arguments: argparse.Namespace, report: Report) -> None:
    """Print a signed key; the secret that signs it is made if there is none."""
    from sitegen.gateway.config import load
    from sitegen.gateway.keys import NAME, make_secret, read_secret, signed

    if not NAME.fullmatch(arguments.name):
        raise SiteError(
            [f"'{arguments.name}' is not a valid name; write letters, digits and @.-+'"]
        )
    seconds = duration(arguments.duration)
    rules = load(arguments.config)
    file = (rules.keys and rules.keys.secret) or Path(SECRET)
    if file.exists():
        secret = read_secret(file)
    else:
        secret = make_secret(file)
        report.say(f"made {file}; keep it to yourself")
    if not rules.keys:
        text = f"add to gateway.yaml, or no keys are asked for: keys: {{secret: {file.name}}}"
        report.say(text, "warning")
    print(signed(arguments.name, seconds, secret))


def duration(text: str) -> int:
    """Return a time like "90s", "20m", "2h" or "7d" (s). Raises: SiteError for any other text."""
    match = re.fullmatch(r"([1-9]\d{0,6})([smhd])", text)
    if not match:
        raise SiteError([f"--for: '{text}' is not a time; write it like 90s, 20m, 2h or 7d"])
    return int(match[1]) * UNITS[match[2]]
