"""The engine of a browser, for scripts that cannot import `runtime/engine.js`."""

from __future__ import annotations

import re

from sitegen.shipped import RUNTIME

_FOUND = re.search(
    r"^export const (engine = .+;)$", (RUNTIME / "engine.js").read_text(encoding="utf-8"), re.M
)
assert _FOUND, "runtime/engine.js is one expression"
# A line of JavaScript that declares `engine`.
ENGINE = f"const {_FOUND[1]}"
