"""The locations of the files that come with sitegen."""

from __future__ import annotations

from pathlib import Path

PACKAGE = Path(__file__).resolve().parent
# The client libraries that nodes are compiled with or run on, one folder for each language.
CLIENTS = PACKAGE / "clients"
# Interface packages that every ROS installation has and no wheel on PyPI contains.
INTERFACES = PACKAGE / "interfaces" / "share"
# ROS packages that sitegen reimplements; a workspace may bring its own instead.
PACKAGES = PACKAGE / "packages"
# Parts of the ROS 2 wheels on PyPI, unpacked when sitegen is built (hatch_build.py).
ROS = PACKAGE / "ros"
# The modules that run in the browser, and the libraries they use.
RUNTIME = PACKAGE / "runtime"
VENDOR = RUNTIME / "vendor"
# What pages load of them, and what imports what, made when sitegen is built (bundle.mjs).
BUNDLES = PACKAGE / "bundles"
# In an editable install the themes are still where the repository has them.
THEMES = PACKAGE / "themes" if (PACKAGE / "themes").is_dir() else PACKAGE.parent / "themes"
DEFAULT_THEME = THEMES / "default"
