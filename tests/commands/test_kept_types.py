"""The files of `sitegen types` stay current while their site is served."""

from __future__ import annotations

from collections.abc import Callable
from pathlib import Path

import pytest
from packages import Workspace
from served import Serving
from waiting import until

from sitegen.__main__ import main

SITE = """\
site: {title: Mine}
pages:
  - path: /
    title: Mine
    script: scripts/mine.js
    content: [{panel: panels/mine.js}]
"""
CMAKE = """\
find_package(rosidl_default_generators REQUIRED)
rosidl_generate_interfaces(my_interfaces {})
"""
FILES = {
    "site.yaml": SITE,
    "scripts/mine.js": 'import "sitegen";\n',
    "panels/mine.js": "export const mount = () => {};\n",
    "src/my_interfaces/msg/Speed.msg": "float64 forward\n",
}
SPEED, TURN = "src/my_interfaces/msg/Speed.msg", "src/my_interfaces/msg/Turn.msg"


@pytest.fixture
def site(tmp_path: Path) -> Path:
    workspace = Workspace(tmp_path, tmp_path)
    for name, text in FILES.items():
        workspace.write(name, text)
    describe(tmp_path, "msg/Speed.msg")
    return tmp_path


def describe(site: Path, *definitions: str) -> None:
    """Write a package of interfaces that consists of these."""
    body = CMAKE.format(" ".join(definitions))
    Workspace(site, site).package("my_interfaces", body)


def builds(served: Serving) -> list[str]:
    return [line for line in served.said.getvalue().splitlines() if "built in" in line]


def edit(served: Serving, name: str, text: str) -> None:
    """Edit a file and wait until the site was built with it."""
    before = len(builds(served))
    served.write(name, text)
    until(lambda: any(Path(name).name in line for line in builds(served)[before:]))


def test_types_follow_the_interfaces(site: Path, serving: Callable[[Path], Serving]) -> None:
    assert main(["types", str(site)]) == 0
    types = site / "scripts/ros.d.ts"
    assert '"my_interfaces/msg/Speed": { forward: number };' in types.read_text()
    served = serving(site)
    served.write(SPEED, "float32 forward\nbool braking\n")
    until(lambda: "wrote scripts/ros.d.ts: the types have changed" in served.said.getvalue())
    changed = '"my_interfaces/msg/Speed": { forward: number, braking: boolean };'
    assert changed in types.read_text()
    # One that is new.
    (site / TURN).write_text("float64 angle\n")
    describe(site, "msg/Speed.msg", "msg/Turn.msg")
    until(lambda: served.said.getvalue().count("wrote scripts/ros.d.ts") == 2)
    assert '"my_interfaces/msg/Turn": { angle: number };' in types.read_text()
    # What the server wrote is no edit: nothing was built for it, and so no build follows another.
    edit(served, "scripts/mine.js", "// Edited.\n")
    assert not [line for line in builds(served) if ".d.ts" in line]
    assert served.said.getvalue().count("wrote ") == 2


def test_types_from_before_are_renewed_at_the_start(
    site: Path, serving: Callable[[Path], Serving]
) -> None:
    assert main(["types", str(site)]) == 0
    client = site / "scripts/sitegen.d.ts"
    now = client.read_text()
    client.write_text(now.splitlines()[0] + "\nAs an older release wrote it.\n")
    (site / SPEED).write_text("bool forward\n")
    served = serving(site)
    assert "wrote scripts/ros.d.ts, scripts/sitegen.d.ts: the types" in served.said.getvalue()
    assert client.read_text() == now
    # The panel's page has no node that uses it.
    assert "my_interfaces" not in (site / "panels/ros.d.ts").read_text()


def test_only_files_of_sitegen_are_written(site: Path, serving: Callable[[Path], Serving]) -> None:
    (site / "panels/ros.d.ts").write_text("export type Mine = string;\n")
    served = serving(site)
    edit(served, SPEED, "bool forward\n")
    assert "wrote " not in served.said.getvalue()
    assert (site / "panels/ros.d.ts").read_text() == "export type Mine = string;\n"
    assert not list(site.glob("scripts/*.d.ts"))


def test_types_that_cannot_be_written_are_told(
    site: Path, serving: Callable[[Path], Serving], monkeypatch: pytest.MonkeyPatch
) -> None:
    assert main(["types", str(site)]) == 0
    served = serving(site)
    types = site / "scripts/ros.d.ts"
    before = types.read_text()
    writing = Path.write_bytes

    def refuse(file: Path, content: bytes) -> int:
        if file.name == types.name:
            raise PermissionError(13, "Permission denied")
        return writing(file, content)

    monkeypatch.setattr(Path, "write_bytes", refuse)
    edit(served, SPEED, "bool forward\n")
    until(lambda: "scripts/ros.d.ts: cannot be written: Permission" in served.said.getvalue())
    assert types.read_text() == before
    edit(served, "scripts/mine.js", "// Edited.\n")
