"""Where tests find what they need."""

from __future__ import annotations

from pathlib import Path

TESTS = Path(__file__).resolve().parents[1]
ROOT = TESTS.parent
DEMOS = ROOT / "demos"
# Workspaces with a site.yaml, made for tests.
SITES = TESTS / "sites"
SUPPORT = TESTS / "support"
