"""Run the tests nearest to what changed: `python changed.py [--since REVISION] [--list]`.

For a change in one room, they take a minute or two; `make test` runs all.
"""

from __future__ import annotations

import argparse
import subprocess
import sys
import time
from pathlib import Path

import run
from imports import dependents, imported_names
from paths import ROOT

from sitegen.site import bundles

TESTS = sorted((ROOT / "tests").rglob("test_*.py"))
PROJECT = ROOT / "tests/project"
BROWSER = ROOT / "tests/browser"
DIRECTIONS = PROJECT / "test_imports.py"
# Where the tests of the runtime's rooms are, below BROWSER; the first row that matches counts.
RUNTIME = {
    "bag": "widgets/test_bag*",
    "client": "client/*",
    "gateway": "gateway/*",
    "jupyter": "python/test_jupyter*",
    "messages": "widgets/test_messages*",
    "rosbridge": "rosbridge/*",
    "terminal": "terminal/*",
    "ui": "widgets/test_w*",
    "workers/bag": "widgets/test_bag*",
    "workers/cpp": "graph/test_faults*",
    "workers/gateway": "gateway/*",
    "workers/python": "python/*",
    "": "graph/*",
}
# The same for what is not of a room.
OTHERS = {
    "demos": BROWSER / "pages/test_demos.py",
    "docs": PROJECT / "test_docs.py",
    "sitegen/clients/cpp": BROWSER / "graph/test_faults.py",
    "sitegen/clients/python": BROWSER / "python",
    "sitegen/clients/rowe": ROOT / "tests/rowe",
    "sitegen/packages": BROWSER / "cpp/test_tf.py",
    "themes": ROOT / "tests/site",
}


def changed_files(since: str) -> list[str]:
    """Return the files that were added, edited or removed since the branch left `since`."""

    def ask(*words: str) -> list[str]:
        return subprocess.check_output(["git", *words], cwd=ROOT, text=True).split("\0")[:-1]

    base = subprocess.check_output(["git", "merge-base", since, "HEAD"], cwd=ROOT, text=True)
    edited = ask("diff", "--name-only", "-z", base.strip())
    return sorted({*edited, *ask("ls-files", "--others", "--exclude-standard", "-z")})


def tests_of(file: str) -> set[Path]:
    """Return the files of tests that are nearest to a changed file."""
    path = ROOT / file
    if path in TESTS:
        return {path}
    for folder, tests in OTHERS.items():
        if file.startswith(f"{folder}/"):
            return _below(tests)
    match Path(file).parts:
        case ("tests", "sites", site, *_):
            return _naming(site)
        case ("tests", "support", *_):
            return _importing(path.stem)
        case ("tests", *_):
            near = next(one for one in path.parents if _below(one))
            # What all tests share is left to `make test`.
            return set() if near in (ROOT / "tests", BROWSER) else _below(near)
        case ("sitegen", "runtime", *rest):
            return _of_runtime("/".join(rest)) | {DIRECTIONS}
        case ("sitegen", *rest):
            module = ".".join(("sitegen", *rest)).removesuffix(".py").removesuffix(".__init__")
            room = ROOT / "tests" / rest[0].removesuffix(".py")
            return _below(room) | _importing(module) | {DIRECTIONS}
    return _below(PROJECT)


def _below(path: Path) -> set[Path]:
    return {test for test in TESTS if test.is_relative_to(path)}


def _importing(module: str) -> set[Path]:
    """Tests that import a module themselves: nearly all do through others."""
    return {
        file
        for file in TESTS
        for name in imported_names(file)
        if f"{name}.".startswith(f"{module}.")
    }


def _naming(word: str) -> set[Path]:
    return {file for file in TESTS if f'"{word}"' in file.read_text()}


def _of_runtime(module: str) -> set[Path]:
    """Tests of the widgets that a module is of, or of its room."""
    parts = Path(module).parts
    if parts[0] == "widgets":
        widget = parts[1].removesuffix(".js")
        own = {*BROWSER.rglob(f"test_{widget}*.py")} | _below(BROWSER / widget)
        return own or {file for file in _naming(widget) if file.is_relative_to(BROWSER)}
    pattern = next(tests for room, tests in RUNTIME.items() if f"{module}/".startswith(room))
    users = {Path(name).parts[1] for name in _widgets(module)}
    near = _of_runtime(f"widgets/{users.pop()}") if len(users) == 1 else set()
    return near | ({*BROWSER.glob(pattern)} & {*TESTS})


def _widgets(module: str) -> set[str]:
    """The widgets that a module comes to by imports."""
    return {name for name in dependents(module, bundles.imports()) if name.startswith("widgets/")}


def main() -> int:
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument("--since", default="main", help="compare with this revision")
    parser.add_argument("--list", action="store_true", help="print the files of tests only")
    parser.add_argument("--at-once", type=int, default=2, help="how many tests run at once")
    given = parser.parse_args()
    files = changed_files(given.since)
    chosen = sorted({str(test.relative_to(ROOT)) for file in files for test in tests_of(file)})
    print(f"{len(files)} files changed since {given.since}; nearest tests:", *chosen, sep="\n  ")
    if given.list or not chosen:
        return 0
    return run.run(given.at_once, chosen, run.Stages(time.time()))


if __name__ == "__main__":
    sys.exit(main())
