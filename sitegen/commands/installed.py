"""Find out how to install this copy of sitegen elsewhere."""

from __future__ import annotations

import json
import re
import subprocess
from importlib import metadata
from pathlib import Path
from typing import NamedTuple
from urllib.parse import urlsplit, urlunsplit
from urllib.request import url2pathname

from sitegen import __version__

# The name on PyPI, where 'sitegen' is another project.
DISTRIBUTION = "ros-sitegen"


class Requirement(NamedTuple):
    """A requirement for pip, and a note about it for the author, if there is one."""

    text: str
    note: str = ""


def requirement() -> Requirement:
    """Return how to install this copy: a release, or a repository and its commit.

    PEP 610 records what pip was given; without this record, the copy came from an index.
    """
    try:
        record = metadata.distribution(DISTRIBUTION).read_text("direct_url.json")
    except metadata.PackageNotFoundError:
        return _unknown("it was not installed by pip")
    if not record:
        return _release()
    try:
        return _from_record(json.loads(record))
    except (ValueError, KeyError, TypeError, AttributeError):
        return _unknown("its direct_url.json cannot be read")


def _from_record(record: dict[str, dict[str, object]]) -> Requirement:
    url = str(record["url"])
    if "vcs_info" in record:
        about = record["vcs_info"]
        return _commit(str(about["vcs"]), url, str(about["commit_id"]))
    parts = urlsplit(url)
    if parts.scheme == "file":
        folder = Path(url2pathname(parts.path))
        if folder.is_dir():
            return _checkout(folder)
        return _unknown(f"it was installed from the file {folder}")
    hashes = record["archive_info"].get("hashes")
    digest = hashes.get("sha256", "") if isinstance(hashes, dict) else ""
    return Requirement(f"{DISTRIBUTION} @ {_public(url)}" + (f"#sha256={digest}" if digest else ""))


def _checkout(folder: Path) -> Requirement:
    """Return the requirement for the current commit of a checkout, from its remote."""
    commit = _git(folder, "rev-parse", "--verify", "HEAD")
    if not commit:
        return _unknown(f"{folder} is not a git repository with a commit")
    remote = _git(folder, "remote", "get-url", "origin")
    found = _commit("git", _over_https(remote), commit)
    if not remote or found.note:
        return _unknown(f"{folder} has no remote 'origin' that others can reach")
    if not _git(folder, "branch", "--remotes", "--contains", commit):
        return found._replace(note=f"push commit {commit[:10]} of {folder} first")
    if _git(folder, "status", "--porcelain", "--untracked-files=no"):
        return found._replace(note=f"without the changes in {folder} that are not committed")
    return found


def _commit(vcs: str, url: str, commit: str) -> Requirement:
    if not url.startswith("https://"):
        return _unknown(f"others cannot install from {url}")
    return Requirement(f"{DISTRIBUTION} @ {vcs}+{_public(url)}@{commit}")


def _release() -> Requirement:
    return Requirement(f"{DISTRIBUTION}=={__version__}")


def _unknown(why: str) -> Requirement:
    text = _release().text
    note = f"unknown where this sitegen came from ({why}); '{text}' is a guess"
    return Requirement(text, note)


def _over_https(remote: str) -> str:
    """Return the URL of a remote without SSH keys: git@host:path and ssh:// become https."""
    match = re.fullmatch(r"(?:ssh://)?git@([\w.-]+)(?::\d+/|[:/])(.+)", remote)
    return f"https://{match[1]}/{match[2]}" if match else remote


def _public(url: str) -> str:
    """Return `url` without a password."""
    parts = urlsplit(url)
    return urlunsplit(parts._replace(netloc=parts.netloc.rpartition("@")[2]))


def _git(folder: Path, *words: str) -> str:
    """Return the output of git; nothing if it fails or is not installed."""
    try:
        done = subprocess.run(["git", *words], cwd=folder, text=True, capture_output=True)
    except FileNotFoundError:
        return ""
    return done.stdout.strip() if done.returncode == 0 else ""
