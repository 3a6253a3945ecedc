"""The JSON Schema of site.yaml takes what sitegen takes, and refuses what it refuses."""

from __future__ import annotations

import json
from pathlib import Path
from typing import Any

import pytest
import yaml
from jsonschema import Draft202012Validator
from paths import ROOT

from sitegen.__main__ import main

SITES = [
    ROOT / "site.yaml",
    *sorted(ROOT.glob("demos/*/site.yaml")),
    *sorted(ROOT.glob("tests/sites/*/site.yaml")),
    ROOT / "bench/site/site.yaml",
]


@pytest.fixture
def schema(capsys: pytest.CaptureFixture[str]) -> Draft202012Validator:
    assert main(["schema"]) == 0
    found = json.loads(capsys.readouterr().out)
    Draft202012Validator.check_schema(found)
    return Draft202012Validator(found)


@pytest.mark.parametrize("file", SITES, ids=lambda file: str(file.relative_to(ROOT)))
def test_every_site_of_ours_conforms(schema: Draft202012Validator, file: Path) -> None:
    problems = schema.iter_errors(yaml.safe_load(file.read_text()))
    assert [problem.message for problem in problems] == []


def test_scripts_are_one_path_or_several(schema: Draft202012Validator) -> None:
    both = [("script", "a.js"), ("scripts", ["a.js", "b.js"])]
    wrong = [("script", ["a.js"]), ("scripts", "a.js"), ("scripts", [1])]
    for key, value, sound in [*((*one, True) for one in both), *((*one, False) for one in wrong)]:
        page: dict[str, object] = {"path": "/", key: value, "content": []}
        assert schema.is_valid({"site": {"title": "A"}, "pages": [page]}) is sound


@pytest.mark.parametrize(
    "wrong",
    [
        "site: {title: A, colour: red}",
        "site: {titel: A}",
        "site: {title: A}\npages: []",
        "site: {title: A}\npages: [{path: /, content: [{consol: talker}]}]",
        "site: {title: A}\npages: [{path: /, content: [{console: talker, buttons: talker}]}]",
        "site: {title: A}\npages: [{path: /, content: [{console: {node: a, lines: 0}}]}]",
        "site: {title: A}\npages: [{path: /, content: [{topics: /chatter}]}]",
        "site: {title: A}\npages: [{path: /, content: [{robot: {kind: dalek}}]}]",
        "site: {title: A}\nnodes: {a: {package: p}}\npages: [{path: /}]",
        "site: {title: A, accent: red}\npages: [{path: /}]",
    ],
)
def test_what_is_wrong_does_not(schema: Draft202012Validator, wrong: str) -> None:
    content: Any = yaml.safe_load(wrong)
    if "pages" not in content:
        content["pages"] = [{"path": "/"}]
    assert not schema.is_valid(content)
