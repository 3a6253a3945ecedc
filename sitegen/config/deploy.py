"""Read `deploy` of site.yaml."""

from __future__ import annotations

import re

from sitegen.config.document import Value
from sitegen.config.schema import DEPLOY
from sitegen.config.section import check
from sitegen.errors import Problems
from sitegen.model import Deploy

DOMAIN = re.compile(r"([a-z0-9]([a-z0-9-]*[a-z0-9])?\.)+[a-z][a-z0-9-]*[a-z0-9]")
# Stricter than git, and nothing that git could take for an option.
REF = re.compile(r"[A-Za-z0-9_](?:[\w.-]*[\w-])?(?:/[A-Za-z0-9_](?:[\w.-]*[\w-])?)*", re.ASCII)


def deploy(given: Value | None, problems: Problems) -> Deploy:
    """Return where the site is published, and report values that git or the web would refuse."""
    if given is None:
        return Deploy()
    section = check(given, DEPLOY, problems)
    for name in ("branch", "remote"):
        text = section.text(name)
        if not REF.fullmatch(text) or ".." in text:
            message = (
                f"'{text}' is not a valid git name; use letters, digits, '-', '_', '.' and '/'"
            )
            problems.add(section.location(name), section.label(name), message)
    cname = section.text("cname").lower()
    if cname and not DOMAIN.fullmatch(cname):
        message = (
            f"'{cname}' is not a valid domain; write it like 'robot.example.org', without https://"
        )
        problems.add(section.location("cname"), section.label("cname"), message)
    return Deploy(section.text("branch"), section.text("remote"), cname)
