"""What docs/security.md promises has tests, and the budgets are those of the runtime."""

from __future__ import annotations

import json
import re
import subprocess

import pytest
from paths import ROOT

PROMISED = (ROOT / "docs/security.md").read_text(encoding="utf-8")
BUDGETED = (ROOT / "docs/budgets.md").read_text(encoding="utf-8")
TESTS = sorted(set(re.findall(r"`(test_\w+\.py): (test_\w+)`", PROMISED + BUDGETED)))
VALUES = """
import { BATCH_SIZE, BUDGETS, KEPT, WINDOW } from "./sitegen/runtime/budgets.js";
process.stdout.write(JSON.stringify({ window: WINDOW, kept: KEPT, batch: BATCH_SIZE, ...BUDGETS }));
"""


@pytest.mark.parametrize(("file", "test"), TESTS)
def test_each_named_test_exists(file: str, test: str) -> None:
    texts = [path.read_text(encoding="utf-8") for path in (ROOT / "tests").rglob(file)]
    assert any(re.search(rf"^def {test}\(", text, re.M) for text in texts)


def test_each_promise_names_a_test() -> None:
    tables = PROMISED.partition("## What is promised")[2].partition("## Budgets")[0].splitlines()
    rows = [line for line in tables if line.startswith("| ") and not line.startswith("| promise")]
    assert len(rows) > 15
    assert [row for row in rows if not re.search(r"`test_\w+\.py: test_\w+` \|$", row)] == []


def test_the_budgets_are_those_of_the_runtime() -> None:
    said = {
        key: int(number.replace(",", ""))
        for key, number in re.findall(r"^\| `([\w.]+)`[^|]*\| ([\d,]+) \|", BUDGETED, re.M)
    }
    node = ["node", "--input-type=module", "-e", VALUES]
    ran = subprocess.run(node, cwd=ROOT, capture_output=True, text=True, check=True)
    budgets: dict[str, int] = {}
    for key, value in json.loads(ran.stdout).items():
        parts = value.items() if isinstance(value, dict) else [("", value)]
        budgets |= {f"{key}.{part}" if part else key: number for part, number in parts}
    assert said == budgets


def test_each_budget_names_its_test() -> None:
    rows = re.findall(r"^\| `[\w.]+`.*$", BUDGETED, re.M)
    assert [row for row in rows if not re.search(r"`test_\w+\.py: test_\w+` \|$", row)] == []


def test_the_policy_says_where_to_report() -> None:
    policy = (ROOT / "SECURITY.md").read_text(encoding="utf-8")
    assert "Report a vulnerability" in policy
    assert "docs/security.md" in policy
