"""The wheel, installed where nothing of the checkout is in reach."""

from __future__ import annotations

import os
import subprocess
import sys
import venv
from pathlib import Path

from paths import ROOT


def run(*command: str | Path, cwd: Path) -> str:
    # Nothing of this run may help the installed command: no PYTHONPATH, no virtual environment, no
    # program that was compiled before.
    env = {k: v for k, v in os.environ.items() if not k.startswith(("PYTHON", "VIRTUAL_ENV"))}
    env["SITEGEN_CACHE"] = str(cwd / "cache")
    done = subprocess.run(
        [str(word) for word in command], cwd=cwd, env=env, text=True, capture_output=True
    )
    assert done.returncode == 0, done.stdout + done.stderr
    return done.stdout


def test_the_installed_command_builds_a_site(tmp_path: Path) -> None:
    pip: list[str | Path] = [sys.executable, "-m", "pip", "wheel", "--quiet", "--no-deps"]
    run(*pip, "--wheel-dir", tmp_path, ROOT, cwd=tmp_path)
    [wheel] = tmp_path.glob("sitegen-*.whl")
    venv.create(tmp_path / "venv", with_pip=True)
    python = tmp_path / "venv" / "bin" / "python"
    constraints = ROOT / "constraints.txt"
    run(python, "-m", "pip", "install", "--quiet", "-c", constraints, wheel, cwd=tmp_path)

    site = tmp_path / "hello"
    (site / "src").mkdir(parents=True)
    demo = ROOT / "demos" / "demo01"
    run("cp", "-r", demo / "src", demo / "page.md", site, cwd=tmp_path)
    (site / "site.yaml").write_text(
        "site: {title: Hello, asyncify: false}\nworkspace: .\npages: [{path: /, file: page.md}]\n"
    )
    said = run(tmp_path / "venv" / "bin" / "sitegen", "build", cwd=site)
    assert "built 1 page, 1 node" in said
    written = {path.relative_to(site / "dist").as_posix() for path in site.rglob("dist/**/*")}
    assert written >= {
        "index.html",
        "page.json",
        "nodes/cpp_hello/talker.jspi.wasm",
        "runtime/rosMain.js",
        "runtime/workers/cpp/cppNode.js",
        "theme/all-live.css",
    }

    run(tmp_path / "venv" / "bin" / "sitegen", "new", "my_fox", cwd=tmp_path)
    fox = tmp_path / "my_fox"
    made = {path.relative_to(fox).as_posix() for path in fox.rglob("*")}
    assert made >= {".gitignore", "site.yaml", "src/my_fox_py/resource/my_fox_py"}
    run(tmp_path / "venv" / "bin" / "sitegen", "init", "--github", fox, cwd=tmp_path)
    workflows = sorted(path.name for path in (fox / ".github" / "workflows").iterdir())
    assert workflows == ["nodes.yml", "pages.yml"]
