"""Turn JupyterLite into files of a site: its pages, our extension, and the author's notebooks."""

from __future__ import annotations

import json
import re
import subprocess
import sys
import tempfile
from collections.abc import Iterator
from importlib import metadata
from pathlib import Path
from typing import Any

from filelock import FileLock

from sitegen.errors import SiteError
from sitegen.model import Artifact, Page, Site, Widget
from sitegen.nodes.python.ipython import MISSING
from sitegen.report import Report
from sitegen.site.jupyter import contents

KIND = "jupyter"
FOLDER = "jupyter"
CORE = "jupyterlite-core"
APPS = ("lab", "notebooks")
ENTRY = Path(__file__).with_name("remoteEntry.js")
EXTENSION = "sitegen-ros"
# Files of JupyterLite that no page loads.
UNUSED = re.compile(
    r"(doc|files|api/contents)/.*|rspack\..*|.*package\.json|.*\.map|bootstrap\.js|service-worker\.js"
)
# JupyterLab compiles the schemas of its settings, and writes styles into its pages. All it loads
# comes from the site.
POLICY = (
    "default-src 'none'; script-src 'self' 'unsafe-inline' 'unsafe-eval' 'wasm-unsafe-eval'; "
    "style-src 'self' 'unsafe-inline'; img-src 'self' data: blob:; font-src 'self' data:; "
    "media-src 'self' data: blob:; connect-src 'self' data: blob:; worker-src 'self' blob:; "
    "frame-src 'self' blob: data:; manifest-src 'self'; base-uri 'none'; form-action 'none'"
)
HEAD = "<head>"
# The document of a panel in an output: its script adds the styles of the page around.
PANEL = """\
<!doctype html>
<html lang="en">
<head>
<meta charset="utf-8">
<meta http-equiv="Content-Security-Policy" content="{policy}">
<title>Panel</title>
<script type="module" src="../runtime/jupyter/panel.js"></script>
</head>
<body></body>
</html>
"""
# What the policy of a page allows its panels.
PANEL_POLICY = (
    "default-src 'none'; script-src 'self' 'wasm-unsafe-eval'; style-src 'self'; "
    "img-src 'self' data: blob:; font-src 'self'; connect-src 'self' data: blob:; "
    "worker-src 'self' blob:; base-uri 'none'; form-action 'none'"
)
# The service worker of JupyterLite is for kernels that share its files.
DISABLED = ("@jupyterlite/application-extension:service-worker-manager",)
SETTINGS: dict[str, dict[str, Any]] = {
    "@jupyterlab/apputils-extension:themes": {"adaptive-theme": True},
    # A notebook that is closed leaves the graph; without this, its kernel would go on.
    "@jupyterlab/notebook-extension:tracker": {"kernelShutdown": True},
    # The files have the dates of the build.
    "@jupyterlab/filebrowser-extension:browser": {"showLastModifiedColumn": False},
    # Nothing is requested from elsewhere.
    "@jupyterlab/apputils-extension:notification": {
        "checkForUpdates": False,
        "fetchNews": "false",
    },
}


def artifacts(site: Site, cache: Path, report: Report) -> list[Artifact]:
    """Return the files of JupyterLite and of the notebooks; none if no page shows them.

    Raises: SiteError if JupyterLite is not installed or cannot be built, or if two notebooks have
        the same name.
    """
    shown = [(page, widget) for page in site.pages for widget in _widgets(page)]
    if not shown:
        return []
    lab = _lab(cache, report)
    found = [
        Artifact(f"{FOLDER}/{name}", _with_policy(file) if file.suffix == ".html" else file)
        for file in sorted(lab.rglob("*"))
        if file.is_file() and not UNUSED.fullmatch(name := file.relative_to(lab).as_posix())
        if name != "jupyter-lite.json"
    ]
    page, widget = shown[0]
    config = json.loads((lab / "jupyter-lite.json").read_text(encoding="utf-8"))
    _configure(config["jupyter-config-data"], page, widget)
    found.append(Artifact(f"{FOLDER}/jupyter-lite.json", json.dumps(config).encode()))
    entry = f"{FOLDER}/extensions/{EXTENSION}/static/{ENTRY.name}"
    found.append(Artifact(entry, ENTRY.read_bytes()))
    panel = PANEL.format(policy=PANEL_POLICY)
    found.append(Artifact(f"{FOLDER}/panel.html", panel.encode()))
    folders = {str(widget.options.get("notebooks") or "") for _, widget in shown} - {""}
    found += contents.artifacts([site.root / name for name in sorted(folders)], FOLDER)
    return found


def _widgets(page: Page) -> Iterator[Widget]:
    return (part for part in page.leaves if isinstance(part, Widget) and part.kind == KIND)


def _configure(config: dict[str, Any], page: Page, widget: Widget) -> None:
    config["federated_extensions"] = [
        {"name": EXTENSION, "load": f"static/{ENTRY.name}", "extension": "./extension"}
    ]
    config["disabledExtensions"] = [*config.get("disabledExtensions", ()), *DISABLED]
    config["defaultKernelName"] = "python3"
    config["contentsAllJsonFile"] = contents.LISTING
    config["settingsOverrides"] = {**config.get("settingsOverrides", {}), **SETTINGS}
    config["litePluginSettings"] = {
        **config.get("litePluginSettings", {}),
        # For notebooks that are opened without a page around them.
        f"{EXTENSION}:kernel": {"page": f"../{page.path}page.json", "node": widget.options["node"]},
    }


def _lab(cache: Path, report: Report) -> Path:
    """Return a folder with JupyterLite, built once for each of its versions.

    Raises: SiteError if it is not installed or cannot be built.
    """
    try:
        version = metadata.version(CORE)
    except metadata.PackageNotFoundError:
        raise SiteError([MISSING]) from None
    target = cache / "jupyter" / version
    target.parent.mkdir(parents=True, exist_ok=True)
    with FileLock(target.with_name(f"{version}.lock")):
        if not target.is_dir():
            report.doing("JupyterLite", f"building version {version} (once for all sites)")
            with tempfile.TemporaryDirectory(dir=target.parent) as temporary:
                try:
                    _build(Path(temporary) / "lab")
                finally:
                    report.done("JupyterLite")
                (Path(temporary) / "lab").rename(target)
    return target


def _build(output: Path) -> None:
    words = ["build", "--output-dir", str(output), "--lite-dir", str(output.parent)]
    words += [word for app in APPS for word in ("--apps", app)]
    words += ["--no-sourcemaps", "--ignore-sys-prefix", "federated_extensions", "--no-libarchive"]
    words += ["--source-date-epoch", "315532800"]
    done = subprocess.run(
        [sys.executable, "-m", "jupyterlite_core", *words],
        cwd=output.parent,
        text=True,
        capture_output=True,
    )
    if done.returncode:
        said = (done.stderr or done.stdout).rstrip()
        raise SiteError([f"JupyterLite could not be built:\n{said}"])


def _with_policy(page: Path) -> bytes:
    text = page.read_text(encoding="utf-8")
    meta = f'<meta http-equiv="Content-Security-Policy" content="{POLICY}">'
    return text.replace(HEAD, f"{HEAD}{meta}", 1).encode()
