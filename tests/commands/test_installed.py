"""What the workflows install is what was running when they were written."""

from __future__ import annotations

import json
import subprocess
from importlib import metadata
from pathlib import Path

import pytest

from sitegen import __version__
from sitegen.commands.installed import requirement

COMMIT = "0123456789abcdef0123456789abcdef01234567"
RELEASE = f"ros-sitegen=={__version__}"


@pytest.fixture
def recorded(monkeypatch: pytest.MonkeyPatch) -> list[str | None]:
    """What stands in direct_url.json, the last item; nothing without one."""
    records: list[str | None] = []

    class Distribution:
        def read_text(self, name: str) -> str | None:
            assert name == "direct_url.json"
            return records[-1] if records else None

    def distribution(name: str) -> Distribution:
        assert name == "ros-sitegen"
        return Distribution()

    monkeypatch.setattr(metadata, "distribution", distribution)
    return records


def test_a_release_of_an_index_is_named_by_its_version(recorded: list[str | None]) -> None:
    assert requirement() == (RELEASE, "")


@pytest.mark.parametrize(
    ("record", "text"),
    [
        (
            {
                "url": "https://me:secret@github.com/me/sitegen.git",
                "vcs_info": {"vcs": "git", "requested_revision": "main", "commit_id": COMMIT},
            },
            f"ros-sitegen @ git+https://github.com/me/sitegen.git@{COMMIT}",
        ),
        (
            {
                "url": "https://example.org/ros_sitegen-0.1.0-py3-none-any.whl",
                "archive_info": {"hashes": {"sha256": "ab" * 32}},
            },
            "ros-sitegen @ https://example.org/ros_sitegen-0.1.0-py3-none-any.whl#sha256="
            + "ab" * 32,
        ),
        (
            {"url": "https://example.org/sitegen.tar.gz", "archive_info": {}},
            "ros-sitegen @ https://example.org/sitegen.tar.gz",
        ),
    ],
)
def test_an_address_is_named_without_its_password(
    record: dict[str, object], text: str, recorded: list[str | None]
) -> None:
    recorded.append(json.dumps(record))
    assert requirement() == (text, "")


@pytest.mark.parametrize(
    ("record", "why"),
    [
        ('{"url": "file:///tmp/a.whl", "archive_info": {}}', "from the file /tmp/a.whl"),
        (
            f'{{"url": "ssh://git@a.b/c", "vcs_info": {{"vcs": "git", "commit_id": "{COMMIT}"}}}}',
            "others cannot install from ssh://git@a.b/c",
        ),
        ("{", "its direct_url.json cannot be read"),
        ("[]", "its direct_url.json cannot be read"),
        ('{"url": "https://a.b/c"}', "its direct_url.json cannot be read"),
    ],
)
def test_what_is_not_known_is_said(record: str, why: str, recorded: list[str | None]) -> None:
    recorded.append(record)
    text, note = requirement()
    assert text == RELEASE
    assert why in note and f"'{RELEASE}' is a guess" in note


def test_without_pip_nothing_is_known(monkeypatch: pytest.MonkeyPatch) -> None:
    def distribution(name: str) -> metadata.Distribution:
        raise metadata.PackageNotFoundError(name)

    monkeypatch.setattr(metadata, "distribution", distribution)
    assert "it was not installed by pip" in requirement().note


def test_a_checkout_is_named_by_its_remote_and_commit(
    tmp_path: Path, recorded: list[str | None]
) -> None:
    checkout = tmp_path / "with space"
    checkout.mkdir()

    def git(*words: str) -> str:
        own = ("-c", "user.name=A", "-c", "user.email=a@example.org")
        command = ["git", *own, *words]
        return subprocess.run(
            command, cwd=checkout, check=True, text=True, capture_output=True
        ).stdout.strip()

    recorded.append(json.dumps({"url": checkout.as_uri(), "dir_info": {"editable": True}}))
    assert "is not a git repository with a commit" in requirement().note
    git("init", "--quiet")
    (checkout / "a").write_text("1")
    git("add", "a")
    git("commit", "--quiet", "--message", "Begin")
    commit = git("rev-parse", "HEAD")
    assert "has no remote 'origin' that others can reach" in requirement().note
    git("remote", "add", "origin", "/srv/sitegen.git")
    assert requirement().text == RELEASE
    assert "has no remote 'origin' that others can reach" in requirement().note

    git("remote", "set-url", "origin", "git@github.com:me/sitegen.git")
    text = f"ros-sitegen @ git+https://github.com/me/sitegen.git@{commit}"
    assert requirement() == (text, f"push commit {commit[:10]} of {checkout} first")
    git("update-ref", "refs/remotes/origin/main", commit)
    assert requirement() == (text, "")
    for url in (
        "ssh://git@github.com:22/me/sitegen.git",
        "https://me:secret@github.com/me/sitegen.git",
    ):
        git("remote", "set-url", "origin", url)
        assert requirement() == (text, "")
    (checkout / "a").write_text("2")
    assert requirement() == (text, f"without the changes in {checkout} that are not committed")
