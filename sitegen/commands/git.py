"""Read and replace the files of a branch of a Git repository."""

from __future__ import annotations

import hashlib
import os
import re
import shutil
import subprocess
import sys
import zipfile
from collections.abc import Mapping
from dataclasses import dataclass
from pathlib import Path

from sitegen.errors import SiteError, nearest

# The local branch for an unfinished commit. No other local branch is changed.
DRAFT = "sitegen-deploy"


@dataclass(frozen=True)
class Repository:
    """The repository that contains `folder`, and the branch of the remote to publish to."""

    folder: Path
    remote: str
    branch: str

    @classmethod
    def of(cls, folder: Path, remote: str, branch: str) -> Repository:
        """Return the repository that contains `folder`.

        Raises: SiteError if the site cannot be published from it.
        """
        if not shutil.which("git"):
            raise SiteError(["git not found; install it (git-scm.com)"])
        repository = cls(folder, remote, branch)
        if repository._run("rev-parse", "--git-dir").returncode:
            message = (
                "is not in a git repository; "
                "run git init, and create a repository on GitHub to push to"
            )
            raise SiteError([f"{folder} {message}"])
        remotes = repository._run("remote").stdout.split()
        if remote not in remotes:
            how = f"add it: git remote add {remote} https://github.com/me/my-robot.git"
            hint = nearest(remote, remotes) if remotes else how
            raise SiteError([f"the repository has no remote '{remote}'; {hint}"])
        if repository._run("symbolic-ref", "--short", "HEAD").stdout.strip() == branch:
            message = f"'{branch}' is the current branch, and publishing would replace its files"
            raise SiteError([f"{message}; choose another one in site.yaml: deploy: {{branch: …}}"])
        for key, variable in (("name", "GIT_COMMITTER_NAME"), ("email", "GIT_COMMITTER_EMAIL")):
            said = repository._run("config", f"user.{key}").stdout.strip()
            if not os.environ.get(variable) and not said:
                raise SiteError([f"git has no user.{key}; set it: git config user.{key} …"])
        return repository

    @property
    def url(self) -> str:
        """The URL of the remote, without a password."""
        url = self._run("remote", "get-url", self.remote).stdout.strip()
        return re.sub(r"(?<=://)[^/@]*@", "", url)

    def published(self) -> str:
        """Return the last commit of the branch at the remote, fetched; empty if there is none."""
        ref = f"refs/heads/{self.branch}"
        done = self._run("ls-remote", self.remote, ref)
        if done.returncode:
            raise SiteError([f"cannot read from {self.remote} ({self.url}): {_reason(done)}"])
        commit = done.stdout.partition("\t")[0]
        # This changes no branch and no file of the author's.
        quiet = ("--quiet", "--no-tags", "--no-write-fetch-head", "--refmap=")
        done = self._run("fetch", *quiet, self.remote, ref) if commit else done
        if done.returncode:
            raise SiteError([f"cannot fetch '{self.branch}' of {self.remote}: {_reason(done)}"])
        return commit

    def files(self, commit: str) -> dict[str, str]:
        """Return the digests of the files of a commit, by path; none for an empty commit."""
        if not commit:
            return {}
        lines = self._git("ls-tree", "-r", "-z", "--full-tree", commit).split("\0")
        entries = (line.partition("\t") for line in lines if line)
        return {path: entry.split()[2] for entry, _, path in entries}

    def extract(self, commit: str, folder: Path) -> None:
        """Write the files of a commit to `folder`; those of no commit are none."""
        folder.mkdir()
        if not commit:
            return
        archive = folder.with_suffix(".zip")
        # As they are, whatever the lines of the author's own files end with.
        self._git("-c", "core.autocrlf=false", "archive", f"--output={archive}", commit)
        with zipfile.ZipFile(archive) as opened:
            opened.extractall(folder)

    def digest(self, data: bytes) -> str:
        """Return the digest that git computes for a file."""
        done = self._run("rev-parse", "--show-object-format")
        known = done.stdout.strip() if done.returncode == 0 else "sha1"
        return hashlib.new(known, b"blob %d\0" % len(data) + data).hexdigest()

    def publish(self, site: Path, files: Mapping[str, str], parent: str, message: str) -> None:
        """Make a commit of the folder `site` after `parent`, and push it to the branch.

        `files` are the expected digests, which are compared with the commit before it is pushed.
        """
        try:
            self._delete_draft()
            if parent:
                self._git("update-ref", f"refs/heads/{DRAFT}", parent)
            words = ("--branch", DRAFT, "--message", message, str(site.resolve()))
            # With -P, Python imports no module from the author's folder.
            command = [sys.executable, "-P", "-m", "ghp_import", *words]
            done = subprocess.run(command, cwd=self.folder, text=True, capture_output=True)
            if done.returncode or self.files(f"refs/heads/{DRAFT}") != files:
                raise SiteError([f"git could not commit the site: {_reason(done)}"])
            pushed = self._run("push", self.remote, f"{DRAFT}:refs/heads/{self.branch}")
            if pushed.returncode:
                where = f"'{self.branch}' of {self.remote} ({self.url})"
                raise SiteError([f"cannot push to {where}: {_reason(pushed)}"])
        finally:
            self._delete_draft()

    def head(self) -> str:
        """Return the abbreviated hash of the author's commit; empty if there is none."""
        return self._run("rev-parse", "--short", "--verify", "--quiet", "HEAD").stdout.strip()

    def _delete_draft(self) -> None:
        self._run("update-ref", "-d", f"refs/heads/{DRAFT}")

    def _git(self, *words: str) -> str:
        done = self._run(*words)
        if done.returncode:
            raise SiteError([f"git {words[0]} failed: {_reason(done)}"])
        return done.stdout

    def _run(self, *words: str) -> subprocess.CompletedProcess[str]:
        # _reason expects the messages of git in English.
        environment = {**os.environ, "LC_ALL": "C.UTF-8"}
        return subprocess.run(
            ["git", *words], cwd=self.folder, env=environment, text=True, capture_output=True
        )


def _reason(done: subprocess.CompletedProcess[str]) -> str:
    """Return the line of git's output, or of the server's, that says why it failed."""
    lines = [line.strip() for line in done.stderr.splitlines() if line.strip()]
    # The last line is often about a consequence of the error.
    for telling in (r"! \[", r"ERROR: ", r"remote: .*(denied|not found)", r"fatal: |error: "):
        told = [line for line in lines if re.match(telling, line)]
        if told:
            return re.sub(r"^(ERROR|remote|fatal|error): ", "", told[0])
    return lines[-1] if lines else f"git exited with status {done.returncode}"
