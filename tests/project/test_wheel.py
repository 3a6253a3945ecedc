"""The wheel in a clean environment: no checkout, no Node.js on the path, nothing compiled before.

There, the steps of the workflows that `init --github` writes are run as they stand, in order.
"""

from __future__ import annotations

import json
import os
import shutil
import subprocess
import venv
from dataclasses import dataclass
from pathlib import Path

import pytest
from distribution import commit, environment
from paths import ROOT
from workflow import Runner, Step, system, workflow

from sitegen import __version__
from sitegen.__main__ import main
from sitegen.cache.digest import digest_of
from sitegen.cache.folder import cache_folder
from sitegen.commands import installed
from sitegen.nodes.cpp import compiler, digests
from sitegen.nodes.cpp.locks import locked
from sitegen.nodes.cpp.toolchain import Toolchain
from sitegen.report import Report

RELEASE = f"ros-sitegen=={__version__}"
# Where the installed copy compiles, and what it compiles with.
ASK = """
import json
from sitegen.cache.digest import digest_of
from sitegen.cache.folder import cache_folder
from sitegen.nodes.cpp import compiler, digests
from sitegen.nodes.cpp.toolchain import Toolchain
work = compiler.work_folder(Toolchain.find(), cache_folder())
print(json.dumps([digest_of(digests.sources()), str(work)]))
"""


@dataclass
class Computer:
    """A computer of GitHub with a clone of an author's repository, and Python without packages."""

    folder: Path
    repository: Path
    env: dict[str, str]
    path: list[Path]

    def call(self, *words: str, cwd: Path | None = None) -> str:
        """Run a command and return what it prints."""
        env = {**self.env, "PATH": os.pathsep.join(map(str, self.path))}
        program = shutil.which(words[0], path=env["PATH"])
        assert program, words[0]
        done = subprocess.run(
            [program, *words[1:]], cwd=cwd or self.folder, env=env, text=True, capture_output=True
        )
        assert done.returncode == 0, done.stdout + done.stderr
        return done.stdout

    def runner(self) -> Runner:
        """Return what runs the jobs of workflows here, and does what their actions do."""
        actions = {
            "checkout": self._clone,
            "setup-python": self._make_python,
            "cache": self._restore,
        }
        return Runner(self.folder / "clone", self.path, self.env, actions)

    def _clone(self, step: Step) -> None:
        clone = self.folder / "clone"
        if not clone.exists():
            self.call("git", "clone", "-q", self.repository.as_uri(), str(clone))

    def _make_python(self, step: Step) -> None:
        if not self.path[0].exists():
            venv.create(self.path[0].parent, with_pip=True)

    def _restore(self, step: Step) -> None:
        """Take the compiled library over, which is the same where all that it is made of is."""
        assert step["with"]["path"] == "~/.cache/sitegen"
        sources, work = json.loads(self.call("python", "-I", "-c", ASK))
        assert sources == digest_of(digests.sources()), "the wheel has other sources"
        assert Path(work).is_relative_to(self.folder / "home" / ".cache" / "sitegen")
        own = compiler.work_folder(Toolchain.find(), cache_folder())
        for library in own.glob("*/rclcpp/librclcpp.a"):
            with locked([library.parent], Report()):
                copy = Path(work) / library.relative_to(own)
                copy.parent.mkdir(parents=True, exist_ok=True)
                shutil.copyfile(library, copy)


@pytest.fixture(scope="module")
def computer(dist: Path, tmp_path_factory: pytest.TempPathFactory) -> Computer:
    """A computer without sitegen; the repository has workflows that install a release."""
    folder = tmp_path_factory.mktemp("computer")
    repository = folder / "repository"
    shutil.copytree(ROOT / "demos" / "demo01" / "src", repository / "src")
    (repository / "page.md").write_bytes((ROOT / "demos" / "demo01" / "page.md").read_bytes())
    (repository / "site.yaml").write_text(
        "site: {title: Hello, asyncify: false}\npages: [{path: /, file: page.md}]\n"
    )
    with pytest.MonkeyPatch.context() as patch:
        patch.setattr(installed, "requirement", lambda: installed.Requirement(RELEASE))
        commit(repository)
        assert main(["init", "--github", str(repository)]) == 0
    subprocess.run(["git", "add", "-A"], cwd=repository, check=True)
    who = ("-c", "user.name=A", "-c", "user.email=a@example.org")
    subprocess.run(["git", *who, "commit", "-qm", "Publish"], cwd=repository, check=True)
    # The release is found beside what an index has.
    found = f"{os.environ.get('PIP_FIND_LINKS', '')} {dist}".strip()
    env = environment(
        folder / "home", PIP_FIND_LINKS=found, PIP_CONSTRAINT=str(ROOT / "constraints.txt")
    )
    (folder / "home").mkdir()
    programs = system(folder / "bin", without=("node", "npm", "sitegen", "python3", "pip", "pip3"))
    return Computer(folder, repository, env, [folder / "venv" / "bin", programs])


@pytest.mark.exhaustive
def test_the_workflow_for_pages_runs_from_its_first_step_to_its_last(computer: Computer) -> None:
    pages = workflow(computer.repository / ".github" / "workflows" / "pages.yml")
    assert computer.runner().run(pages, "build") == [
        "Install Emscripten",
        "Install sitegen",
        "Check the site",
        "Build the site",
    ]
    [upload] = [step for step in pages["jobs"]["build"]["steps"] if "upload" in str(step)]
    made = computer.folder / "clone" / upload["with"]["path"].replace("${{ env.SITE }}", ".")
    written = {path.relative_to(made).as_posix() for path in made.rglob("*")}
    assert written >= {
        "index.html",
        "page.json",
        "nodes/cpp_hello/talker.jspi.wasm",
        "runtime/rosMain.js",
        "runtime/workers/cpp/cppNode.js",
        "theme/all-live.css",
    }


@pytest.mark.exhaustive
def test_the_workflow_for_nodes_runs_from_its_first_step_to_its_last(computer: Computer) -> None:
    nodes = workflow(computer.repository / ".github" / "workflows" / "nodes.yml")
    assert computer.runner().run(nodes, "compile", **{"${{ inputs.package }}": "cpp_hello"}) == [
        "Install Emscripten",
        "Install sitegen",
        "Compile",
        "Unpack the archive",
        "Explain how to use the archive",
    ]
    [upload] = [step for step in nodes["jobs"]["compile"]["steps"] if "upload" in str(step)]
    assert any((computer.folder / "clone" / upload["with"]["path"]).iterdir())


def test_the_installed_command_begins_a_site(computer: Computer, tmp_path: Path) -> None:
    steps = workflow(computer.repository / ".github" / "workflows" / "pages.yml")["jobs"]["build"]
    prepared = {"jobs": {"build": {"steps": steps["steps"][:4]}}, "env": {"SITEGEN": RELEASE}}
    computer.runner().run({**prepared, "defaults": {"run": {"shell": "bash"}}}, "build")
    assert not shutil.which("node", path=os.pathsep.join(map(str, computer.path)))
    computer.call("sitegen", "new", "my_fox", cwd=tmp_path)
    fox = tmp_path / "my_fox"
    made = {path.relative_to(fox).as_posix() for path in fox.rglob("*")}
    assert made >= {".gitignore", "site.yaml", "site.schema.json", "src/my_fox_py/setup.py"}
    said = computer.call("ros-sitegen", "check", str(fox), cwd=tmp_path)
    assert said == "checked 1 page: no warnings\n"
    # What it writes there names the release, as pip recorded no other source.
    said = computer.call("python", "-m", "sitegen", "init", "--github", str(fox), cwd=tmp_path)
    assert f"the workflows install {RELEASE}\n" in said
    file = Path(".github/workflows/pages.yml")
    assert (fox / file).read_text() == (computer.repository / file).read_text()
