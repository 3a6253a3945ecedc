"""Native ROS 2 to compare with: an environment of its own with the wheels of PyPI."""

from __future__ import annotations

import fcntl
import hashlib
import os
import shutil
import subprocess
import sys
import venv
from collections.abc import Iterator
from contextlib import AbstractContextManager, contextmanager
from pathlib import Path

from paths import ROOT, SUPPORT

HERE = SUPPORT / "ros2"
REQUIREMENTS = HERE / "requirements.txt"


class Native:
    """An environment with rclpy, made once for one state of the pins and kept between runs."""

    def __init__(self) -> None:
        pins = REQUIREMENTS.read_bytes() + sys.version.encode()
        name = f"ros2-{hashlib.sha256(pins).hexdigest()[:12]}"
        self._folder = test_cache() / name
        self._python = self._folder / "bin" / "python"
        self._folder.parent.mkdir(parents=True, exist_ok=True)
        with Path(f"{self._folder}.lock").open("w") as lock:
            fcntl.flock(lock, fcntl.LOCK_EX)
            if not (self._folder / "complete").exists():
                self._install()

    def _install(self) -> None:
        shutil.rmtree(self._folder, ignore_errors=True)
        venv.create(self._folder, with_pip=True)
        pip: list[str | Path] = [
            self._python,
            "-m",
            "pip",
            "install",
            "-qq",
            "--disable-pip-version-check",
        ]
        subprocess.run([*pip, "--requirement", REQUIREMENTS], check=True)
        (self._folder / "complete").touch()

    def call(self, function: str, prefix: Path) -> subprocess.CompletedProcess[str]:
        """Call "module:function" of a package that is installed in `prefix`, as a script does."""
        module, _, name = function.partition(":")
        env = self._environment()
        env["AMENT_PREFIX_PATH"] = f"{prefix}:{self._folder}"
        env["PYTHONPATH"] = f"{prefix / 'python'}"
        program = f"import sys; from {module} import {name}; sys.exit({name}())"
        command: list[str | Path] = [self._python, "-c", program, "a", "b c"]
        return subprocess.run(command, env=env, text=True, capture_output=True)

    @property
    def share(self) -> Path:
        """Where its packages keep their interface definitions."""
        return self._folder / "share"

    def run(self, program: str | Path, *arguments: str, stdin: str = "") -> list[str]:
        """Run a program, of tests/ros2 if only named, and return the lines that it prints."""
        done = subprocess.run(
            [self._python, HERE / program, *arguments],
            env=self.environment,
            input=stdin,
            text=True,
            capture_output=True,
        )
        assert done.returncode == 0, done.stderr
        return done.stdout.splitlines()

    @property
    def python(self) -> Path:
        """Its interpreter."""
        return self._python

    @property
    def environment(self) -> dict[str, str]:
        """The variables for its processes, which find the sitegen of this checkout."""
        paths = {"AMENT_PREFIX_PATH": str(self._folder), "PYTHONPATH": str(ROOT)}
        return self._environment() | paths

    def _environment(self) -> dict[str, str]:
        # The wheels' start-up hook sets library paths and then this, which a child must not see.
        env = {k: v for k, v in os.environ.items() if k != "_ROS_WHEELS_BOOTSTRAP_COMPLETE"}
        # Other tests, which run at the same time, have graphs of their own.
        return env | {"ROS_DOMAIN_ID": str(domain())}


# The last one is used.
_domains: list[int] = []


def domain() -> int:
    """Return a domain of ROS that no other process has which runs tests; it keeps it to its end."""
    if not _domains:
        _domains.append(free_domain())
    return _domains[-1]


def free_domain() -> int:
    """Return a domain that no process has; this one keeps it to its end."""
    folder = test_cache()
    folder.mkdir(parents=True, exist_ok=True)
    # Those above 101 need ports that may be in use.
    first = os.getpid() % 100
    numbers: list[int] = [*range(first, 100), *range(first)]
    for number in numbers:
        lock = os.open(folder / f"domain-{number + 1}.lock", os.O_RDWR | os.O_CREAT)
        try:
            fcntl.flock(lock, fcntl.LOCK_EX | fcntl.LOCK_NB)
        except BlockingIOError:
            os.close(lock)
        else:
            return number + 1
    raise AssertionError("a hundred processes run tests")


@contextmanager
def in_domain(number: int) -> Iterator[None]:
    """Use another domain meanwhile."""
    _domains.append(number)
    try:
        yield
    finally:
        _domains.pop()


def own_domain() -> AbstractContextManager[None]:
    """Use a free domain meanwhile, without robots that other tests have started or killed."""
    return in_domain(free_domain())


def test_cache() -> Path:
    """Return the folder for what tests keep between runs."""
    own = os.environ.get("SITEGEN_TEST_CACHE")
    return Path(own) if own else Path.home() / ".cache" / "sitegen-tests"


def copy_test_msgs(native: Native, package: Path) -> None:
    """Copy the definitions of the native test_msgs to a package of the workspace."""
    for kind in ("msg", "srv", "action"):
        definitions = [
            file
            for file in (native.share / "test_msgs" / kind).iterdir()
            if file.suffix == f".{kind}" or not file.with_suffix(f".{kind}").exists()
        ]
        (package / kind).mkdir()
        for file in definitions:
            shutil.copy(file, package / kind)


def differences(native: Native, messages: list[str], answers: list[str]) -> list[str]:
    """Return what native ROS 2 finds wrong with our bytes for its own messages."""
    lines = [f"{line} {answer}\n" for line, answer in zip(messages, answers, strict=True)]
    found = native.run("messages.py", "compare", stdin="".join(lines))
    assert len(found) == len(lines)
    return [f"{line}: {what}" for line, what in zip(lines, found, strict=True) if what]
