"""Publishing to a bare repository: what arrives, what a dry run says, and what is refused."""

from __future__ import annotations

import subprocess
import sys
import textwrap
from pathlib import Path

import pytest

from sitegen.__main__ import main

SITE = """\
site: {title: Fox}
pages:
  - {path: /, file: index.md}
  - {path: more/, file: more.md}
"""


def git(folder: Path, *words: str) -> str:
    done = subprocess.run(["git", *words], cwd=folder, text=True, capture_output=True)
    assert done.returncode == 0, done.stderr
    return done.stdout.strip()


@pytest.fixture(autouse=True)
def _own_configuration(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    """Nothing of whoever runs the tests."""
    monkeypatch.setenv("GIT_CONFIG_GLOBAL", str(tmp_path / "gitconfig"))
    monkeypatch.setenv("GIT_CONFIG_SYSTEM", "/dev/null")
    for name in ("GIT_COMMITTER_NAME", "GIT_COMMITTER_EMAIL", "GIT_DIR"):
        monkeypatch.delenv(name, raising=False)
    git(tmp_path, "config", "--global", "user.name", "Fox")
    git(tmp_path, "config", "--global", "user.email", "fox@example.org")
    git(tmp_path, "config", "--global", "init.defaultBranch", "main")


@pytest.fixture
def remote(tmp_path: Path) -> Path:
    git(tmp_path, "init", "--bare", "remote.git")
    return tmp_path / "remote.git"


@pytest.fixture
def site(tmp_path: Path, remote: Path) -> Path:
    """A site with one commit in a repository whose origin is `remote`."""
    folder = tmp_path / "site"
    folder.mkdir()
    (folder / "site.yaml").write_text(SITE)
    (folder / "index.md").write_text("# Fox\n")
    (folder / "more.md").write_text("# More\n")
    (folder / ".gitignore").write_text("dist/\n")
    git(folder, "init")
    git(folder, "add", ".")
    git(folder, "commit", "-m", "Begin")
    git(folder, "remote", "add", "origin", str(remote))
    return folder


def files(remote: Path, branch: str = "gh-pages") -> dict[str, bytes]:
    names = git(remote, "ls-tree", "-r", "--name-only", branch).splitlines()
    return {
        name: subprocess.check_output(["git", "show", f"{branch}:{name}"], cwd=remote)
        for name in names
    }


def built(site: Path) -> dict[str, bytes]:
    dist = site / "dist"
    return {
        file.relative_to(dist).as_posix(): file.read_bytes()
        for file in dist.rglob("*")
        if file.is_file()
    }


def state(site: Path) -> str:
    """Everything of the author's repository that publishing must leave alone."""
    assert git(site, "status", "--porcelain") == ""
    return git(site, "for-each-ref", "refs/heads")


def test_what_was_built_is_what_goes_out(
    site: Path, remote: Path, capsys: pytest.CaptureFixture[str]
) -> None:
    before = state(site)
    assert main(["deploy", str(site)]) == 0
    assert files(remote) == built(site)
    assert {".nojekyll", "index.html", "more/index.html"} <= files(remote).keys()
    out = capsys.readouterr().out
    assert f"to branch 'gh-pages' of origin ({remote}): {len(built(site))} added, 0 changed" in out
    subject = git(remote, "log", "-1", "--format=%s, %an", "gh-pages")
    assert subject == f"Publish Fox, {git(site, 'rev-parse', '--short', 'HEAD')}, Fox"
    assert state(site) == before

    assert main(["deploy", str(site)]) == 0
    assert "is up to date; nothing to publish" in capsys.readouterr().out
    assert git(remote, "rev-list", "--count", "gh-pages") == "1"

    # The next state comes on top of the one before, wherever that was published from.
    (site / "more.md").unlink()
    (site / "site.yaml").write_text(SITE.rsplit("  - ", 1)[0] + "deploy: {cname: fox.example.org}")
    git(site, "update-ref", "-d", "refs/remotes/origin/gh-pages")
    assert main(["deploy", str(site)]) == 0
    assert files(remote) == built(site)
    assert files(remote)["CNAME"] == b"fox.example.org\n"
    assert git(remote, "rev-list", "--count", "gh-pages") == "2"
    out = capsys.readouterr().out
    assert ": 1 added, " in out
    assert "see https://fox.example.org/ in a minute" in out
    assert git(site, "for-each-ref", "refs/heads") == before


def test_a_dry_run_says_what_would_happen_and_does_nothing(
    site: Path, remote: Path, capsys: pytest.CaptureFixture[str]
) -> None:
    assert main(["deploy", "--dry-run", str(site)]) == 0
    out = capsys.readouterr().out
    assert "  + more/index.html  " in out
    last = out.splitlines()[-1]
    assert last.startswith("would publish ")
    assert f", to branch 'gh-pages' of origin ({remote}): " in last
    assert last.endswith(" added, 0 changed, 0 removed")
    assert not (site / "dist").exists()
    assert git(remote, "for-each-ref") == ""

    assert main(["deploy", str(site)]) == 0
    before = git(site, "for-each-ref"), git(remote, "for-each-ref"), built(site)
    (site / "index.md").write_text("# Vixen\n")
    (site / "site.yaml").write_text(SITE.replace("path: more/", "path: other/"))
    capsys.readouterr()
    assert main(["deploy", "--dry-run", str(site)]) == 0
    lines = capsys.readouterr().out.splitlines()
    assert any(line.startswith("  + other/index.html  ") for line in lines)
    assert any(line.startswith("  ~ index.html  ") for line in lines)
    assert "  - more/index.html" in lines
    assert lines[-1].endswith("1 removed")
    assert (git(site, "for-each-ref"), git(remote, "for-each-ref"), built(site)) == before


def refused(site: Path, capsys: pytest.CaptureFixture[str]) -> str:
    assert main(["deploy", str(site)]) == 1
    first, *_, last = capsys.readouterr().err.splitlines()
    assert last == "1 problem, nothing was published"
    return first


def test_what_is_missing_is_told(
    site: Path,
    remote: Path,
    tmp_path: Path,
    capsys: pytest.CaptureFixture[str],
    monkeypatch: pytest.MonkeyPatch,
) -> None:
    alone = tmp_path / "alone"
    alone.mkdir()
    (alone / "site.yaml").write_text(
        "site: {title: A}\npages: [{path: /, content: [markdown: '# A']}]\n"
    )
    assert f"{alone} is not in a git repository; run git init" in refused(alone, capsys)

    git(site, "remote", "rename", "origin", "orign")
    assert refused(site, capsys) == ("the repository has no remote 'origin'; did you mean 'orign'?")
    git(site, "remote", "remove", "orign")
    assert "no remote 'origin'; add it: git remote add origin https" in refused(site, capsys)

    git(site, "remote", "add", "origin", str(tmp_path / "gone.git"))
    assert "cannot read from origin" in refused(site, capsys)
    git(site, "remote", "set-url", "origin", str(remote))

    git(tmp_path, "config", "--global", "--unset", "user.email")
    assert refused(site, capsys) == "git has no user.email; set it: git config user.email …"
    git(site, "config", "user.name", "")
    assert refused(site, capsys) == "git has no user.name; set it: git config user.name …"
    with monkeypatch.context() as without:
        without.setenv("PATH", "")
        assert refused(site, capsys) == "git not found; install it (git-scm.com)"
    assert git(remote, "for-each-ref") == ""


def test_no_branch_of_sources_is_replaced(
    site: Path, remote: Path, capsys: pytest.CaptureFixture[str]
) -> None:
    (site / "site.yaml").write_text(SITE + "deploy: {branch: main}\n")
    assert "'main' is the current branch" in refused(site, capsys)
    git(site, "push", "origin", "main")
    git(site, "switch", "--create", "work")
    assert "branch 'main' of origin contains no web site (no index.html)" in refused(site, capsys)


def test_versions_stay_on_the_branch(
    site: Path, remote: Path, capsys: pytest.CaptureFixture[str]
) -> None:
    before = state(site)
    assert main(["deploy", str(site), "--version", "1.0", "--alias", "latest"]) == 0
    (site / "index.md").write_text("# Vixen\n")
    assert main(["deploy", "--dry-run", str(site), "--version", "1.1"]) == 0
    assert "1.1/index.html" not in files(remote)
    assert main(["deploy", str(site), "--version", "1.1", "--alias", "latest"]) == 0
    out = capsys.readouterr().out
    assert f"with version 1.1, to branch 'gh-pages' of origin ({remote}): " in out
    assert " 0 removed" in out
    there = files(remote)
    assert {"1.0/index.html", "1.1/more/index.html", "latest/more/index.html"} <= there.keys()
    assert b"Vixen" not in there["1.0/index.html"]
    assert b"Vixen" in there["1.1/index.html"]
    assert git(remote, "rev-list", "--count", "gh-pages") == "2"
    assert git(remote, "log", "-1", "--format=%s", "gh-pages").startswith("Publish Fox 1.1, ")
    # Nothing of it is built into the author's folder, and nothing is left behind.
    assert not (site / "dist").exists()
    assert git(site, "for-each-ref", "refs/heads") == before

    assert main(["deploy", str(site), "--version", "1.1"]) == 0
    assert "is up to date; nothing to publish" in capsys.readouterr().out
    line = "branch 'gh-pages' of origin contains versions of the site"
    assert refused(site, capsys) == f"{line}; publish another one: sitegen deploy --version …"


def test_a_server_says_why(
    site: Path, tmp_path: Path, capsys: pytest.CaptureFixture[str], monkeypatch: pytest.MonkeyPatch
) -> None:
    """As GitHub's does over ssh: git's own last words would be about rights in general."""
    ssh = tmp_path / "ssh"
    ssh.write_text("#!/bin/sh\necho 'ERROR: Permission to a/b denied to c.' >&2\nexit 1\n")
    ssh.chmod(0o755)
    monkeypatch.setenv("GIT_SSH_COMMAND", str(ssh))
    git(site, "remote", "set-url", "origin", "git@example.org:a/b.git")
    where = "cannot read from origin (git@example.org:a/b.git)"
    assert refused(site, capsys) == f"{where}: Permission to a/b denied to c."


def test_a_refused_push_leaves_nothing(
    site: Path, remote: Path, capsys: pytest.CaptureFixture[str]
) -> None:
    hook = remote / "hooks" / "pre-receive"
    hook.write_text("#!/bin/sh\nexit 1\n")
    hook.chmod(0o755)
    before = state(site)
    line = refused(site, capsys)
    assert line.startswith(f"cannot push to 'gh-pages' of origin ({remote}): ! [remote rejected]")
    assert (state(site), git(remote, "for-each-ref")) == (before, "")


def test_a_site_that_is_wrong_is_not_published(
    site: Path, remote: Path, capsys: pytest.CaptureFixture[str]
) -> None:
    (site / "index.md").write_text("# Fox\n[a](gone.md)\n")
    assert refused(site, capsys).startswith("index.md:2: link: no file 'gone.md'")
    (site / "site.yaml").write_text(
        SITE + "deploy: {branch: -f, remote: 'a b', cname: https://a}\n"
    )
    assert main(["deploy", str(site)]) == 1
    assert [line.split(": ")[1] for line in capsys.readouterr().err.splitlines()[:-1]] == [
        "deploy.branch",
        "deploy.remote",
        "deploy.cname",
    ]
    assert git(remote, "for-each-ref") == ""


def test_an_end_in_between_leaves_nothing(site: Path, remote: Path) -> None:
    """Ctrl-C while the server of the remote thinks about the push."""
    hook = remote / "hooks" / "pre-receive"
    hook.write_text("#!/bin/sh\ntouch hooked; sleep 600\n")
    hook.chmod(0o755)
    before = state(site)
    program = textwrap.dedent(
        """
        import os, signal, sys, threading, time
        from pathlib import Path
        from sitegen.__main__ import main

        def interrupt():
            while not Path(sys.argv[2], "hooked").exists():
                time.sleep(0.01)
            os.killpg(0, signal.SIGINT)

        threading.Thread(target=interrupt, daemon=True).start()
        sys.exit(main(["deploy", sys.argv[1]]))
        """
    )
    done = subprocess.run(
        [sys.executable, "-c", program, str(site), str(remote)],
        capture_output=True,
        text=True,
        start_new_session=True,
    )
    assert done.returncode == 130, done.stderr
    assert (state(site), git(remote, "for-each-ref")) == (before, "")
