"""Collect what Python programs need beside ROS: wheels of PyPI, and of the Pyodide distribution."""

from __future__ import annotations

import hashlib
import io
import json
import re
import subprocess
import sys
import tempfile
import zipfile
from collections.abc import Mapping
from dataclasses import dataclass
from pathlib import Path, PurePosixPath
from typing import Any

from sitegen.digest import digest_of
from sitegen.errors import Place, Problems, SiteError
from sitegen.fetch import FetchError, fetch, mismatch
from sitegen.model import Site

# What the Pyodide distribution has, with its hashes: of the release that pages run.
DISTRIBUTION = Path(__file__).parent / "runtime" / "vendor" / "pyodide-packages.json"
PYTHON = "3.14"
PURE = "-none-any.whl"
LARGEST = 100_000_000
# Without a platform, so that what is compiled is refused: it would not be for WebAssembly.
PIP = [
    *(sys.executable, "-m", "pip", "--disable-pip-version-check", "--no-input"),
    *("download", "--quiet", "--no-deps", "--only-binary=:all:", "--require-hashes"),
    *("--platform=any", "--implementation=py", f"--python-version={PYTHON}"),
]
ADVICE = "name its package in a file of 'pyodide: {requirements: requirements.txt}'"
POINT = "say where the Pyodide distribution is, in 'pyodide: {packages: …}'"


# Package and executable.
Program = tuple[str, str]


@dataclass(frozen=True)
class Wheel:
    """Files that are installed together: the modules that can be imported, and the archive."""

    name: str
    modules: frozenset[str]
    data: bytes


def collect(
    site: Site, wanted: Mapping[Program, Mapping[str, Place]], *, cache: Path
) -> dict[Program, list[Wheel]]:
    """Return the wheels that each program needs.

    `wanted` has the modules that each imports from elsewhere, and where. Raises a SiteError with
    all modules that are nowhere, each with its line.
    """
    pinned = _pinned(site, cache / "wheels") if site.pyodide.requirements else []
    lock = json.loads(DISTRIBUTION.read_text())["packages"]
    origins = {module: name for name, each in lock.items() for module in each["imports"]}
    given = {module: wheel for wheel in pinned for module in wheel.modules}
    problems = Problems(site.root)
    found: dict[Program, dict[str, Wheel]] = {program: {} for program in wanted}
    for program, modules in wanted.items():
        for module, place in modules.items():
            pure = module not in origins or lock[origins[module]]["file_name"].endswith(PURE)
            if module in given:
                # What one of them needs is among them, or pip would not have written them down.
                found[program] |= {wheel.name: wheel for wheel in pinned}
            elif module not in origins or (pure and not site.pyodide.packages):
                message = f"no module of this name comes to the page; {ADVICE}, or leave it out"
                problems.add(place, f"import {module}", message)
            elif not site.pyodide.packages:
                message = f"'{origins[module]}' has to be compiled for the page; {POINT}"
                problems.add(place, f"import {module}", message)
            else:
                try:
                    names = _with_needs(origins[module], lock)
                    wheels = [_of_distribution(site, lock[n], cache / "wheels") for n in names]
                    found[program] |= {wheel.name: wheel for wheel in wheels}
                except FetchError as error:
                    problems.add(place, f"import {module}", str(error))
    problems.raise_if_any()
    return {program: list(wheels.values()) for program, wheels in found.items()}


def _with_needs(name: str, lock: Mapping[str, Any]) -> list[str]:
    names: dict[str, None] = {}
    waiting = [name]
    while waiting:
        one = waiting.pop()
        if one not in names:
            names[one] = None
            waiting += lock[one]["depends"]
    return list(names)


def _of_distribution(site: Site, entry: Mapping[str, Any], cache: Path) -> Wheel:
    """Return a package of the Pyodide distribution; raises a FetchError if it cannot be had."""
    name, sha256, origin = entry["file_name"], entry["sha256"], site.pyodide.packages
    kept = cache / sha256
    if not kept.exists():
        kept.parent.mkdir(parents=True, exist_ok=True)
        with tempfile.TemporaryDirectory(dir=kept.parent) as temporary:
            file = Path(temporary) / name
            if isinstance(origin, Path):
                _copy(origin / name, sha256, file)
            else:
                fetch(f"{origin}{name}", sha256, file, largest=LARGEST)
            file.replace(kept)
    return _wheel(name, kept)


def _copy(source: Path, sha256: str, to: Path) -> None:
    try:
        data = source.read_bytes()
    except OSError as error:
        raise FetchError(f"{source}: {error.strerror}; it is of release 314 of Pyodide") from None
    found = hashlib.sha256(data).hexdigest()
    if found != sha256:
        raise FetchError(mismatch(source.name, found))
    to.write_bytes(data)


def _pinned(site: Site, cache: Path) -> list[Wheel]:
    """Return the wheels that the author pinned; raises a SiteError with pip's words."""
    file = site.pyodide.requirements
    if file is None:
        return []
    folder = cache / digest_of([file])
    if not folder.exists():
        cache.mkdir(parents=True, exist_ok=True)
        with tempfile.TemporaryDirectory(dir=cache) as temporary:
            fresh = Path(temporary) / "wheels"
            command = [*PIP, f"--dest={fresh}", f"--requirement={file}"]
            done = subprocess.run(command, text=True, capture_output=True)
            if done.returncode:
                raise SiteError(_said_by_pip(file.relative_to(site.root), done.stderr))
            fresh.rename(folder)
    return [_wheel(wheel.name, wheel) for wheel in sorted(folder.glob("*.whl"))]


def _said_by_pip(file: Path, text: str) -> list[str]:
    errors = [line[7:] for line in text.splitlines() if line.startswith("ERROR: ")]
    advice = "write each as 'name==1.2.3 --hash=sha256:…', with a wheel of pure Python"
    return [f"{file.as_posix()}: pip: {line}; {advice}" for line in errors[-1:] or [text.strip()]]


def _wheel(name: str, file: Path) -> Wheel:
    """Return a wheel with its files where the page has modules."""
    files: dict[str, bytes] = {}
    with zipfile.ZipFile(file) as archive:
        for member in archive.infolist():
            path = PurePosixPath(member.filename)
            if member.is_dir() or ".." in path.parts or path.is_absolute():
                continue
            data = re.fullmatch(r"[^/]+\.data/(purelib|platlib)/(.+)", member.filename)
            if data or ".data/" not in path.parts[0] + "/":
                files[f"python/{data[2] if data else path.as_posix()}"] = archive.read(member)
    tops = (PurePosixPath(place).parts[1] for place in files)
    modules = {top.partition(".")[0] for top in tops if not top.endswith(".dist-info")}
    return Wheel(name, frozenset(modules), archived(files))


def archived(files: Mapping[str, bytes]) -> bytes:
    """Return a ZIP file, the same bytes for the same files."""
    buffer = io.BytesIO()
    with zipfile.ZipFile(buffer, "w", zipfile.ZIP_DEFLATED) as archive:
        for name in sorted(files):
            entry = zipfile.ZipInfo(name, (1980, 1, 1, 0, 0, 0))
            entry.compress_type = zipfile.ZIP_DEFLATED
            archive.writestr(entry, files[name])
    return buffer.getvalue()
