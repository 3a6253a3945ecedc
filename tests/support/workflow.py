"""A computer that runs the jobs of a workflow of GitHub: its commands as they stand, in order."""

from __future__ import annotations

import os
import re
import subprocess
from collections.abc import Callable, Collection, Mapping, Sequence
from dataclasses import dataclass, field
from pathlib import Path
from typing import Any

import yaml

Step = dict[str, Any]

# A computer of a test is no place to install packages: what is asked for has to be there already.
SUDO = '#!/bin/sh\nexec "$@"\n'
APT_GET = """\
#!/bin/sh
[ "$1" = update ] && exit 0
[ "$1" = install ] || exit 2
shift
for package; do
  case $package in -*) ;; *) dpkg-query --show "$package" || exit 1 ;; esac
done
"""


def workflow(file: Path) -> dict[str, Any]:
    """Return a workflow."""
    # YAML 1.1 reads `on` as true; GitHub does not.
    text = re.sub("^on:", '"on":', file.read_text(), flags=re.MULTILINE)
    found: dict[str, Any] = yaml.safe_load(text)
    return found


@dataclass
class Runner:
    """Runs commands in `folder`, with the programs of the folders `path` and the system's.

    `uses` has what stands for an action, by its name; steps of other actions are not run, nor are
    those with a name in `without`.
    """

    folder: Path
    path: Sequence[Path]
    environment: Mapping[str, str] = field(default_factory=dict)
    uses: Mapping[str, Callable[[Step], None]] = field(default_factory=dict)
    without: Collection[str] = ()

    def run(self, workflow: dict[str, Any], job: str, **given: str) -> list[str]:
        """Run a job whose expressions have the values `given`; return the names of its commands."""
        names = []
        for step in workflow["jobs"][job]["steps"]:
            if "uses" in step:
                action = step["uses"].partition("@")[0].removeprefix("actions/")
                if action in self.uses:
                    self.uses[action](step)
            elif step["name"] not in self.without:
                self._command(workflow, step, given)
                names.append(step["name"])
        return names

    def _command(self, workflow: dict[str, Any], step: Step, given: Mapping[str, str]) -> None:
        assert workflow["defaults"]["run"]["shell"] == "bash"
        # No expression stands in a command: what somebody typed would become one, too.
        assert "${{" not in step["run"]
        environment = {
            **self.environment,
            **{name: str(value) for name, value in workflow.get("env", {}).items()},
            **{name: given[value] for name, value in step.get("env", {}).items()},
            "PATH": os.pathsep.join(map(str, self.path)),
            "GITHUB_STEP_SUMMARY": str(self.folder / "summary.md"),
        }
        command = ["bash", "--noprofile", "--norc", "-eo", "pipefail", "-c", step["run"]]
        done = subprocess.run(
            command, cwd=self.folder, env=environment, text=True, capture_output=True
        )
        assert done.returncode == 0, f"{step['name']}:\n{done.stdout}{done.stderr}"


def system(folder: Path, *, without: Collection[str] = ()) -> Path:
    """Make a folder of the system's programs, less those `without`, and with an apt of tests."""
    folder.mkdir()
    for place in ("/usr/local/bin", "/usr/bin", "/bin"):
        for program in Path(place).iterdir():
            link = folder / program.name
            if program.name not in without and not link.is_symlink():
                link.symlink_to(program)
    for name, text in (("sudo", SUDO), ("apt-get", APT_GET)):
        (folder / name).unlink(missing_ok=True)
        (folder / name).write_text(text)
        (folder / name).chmod(0o755)
    return folder
