"""The options of a build."""

from __future__ import annotations

from dataclasses import dataclass


@dataclass(frozen=True)
class Options:
    """How to build a site; the defaults are those of a site to publish.

    Without `compile`, everything is checked, and C++ programs are left out. A `live` site is served
    while its author edits it: browsers do not cache it, and the server makes the search index on
    demand. With `debug`, C++ programs report source lines. A `draft` links C++ programs in a fifth
    of the time; they are up to twice as large. `engines` limits the engines that programs are built
    for; when empty, they are built for all engines of the site. `version` names the version to
    build of a site with versions. With `keep_going`, programs that do not compile are left out, and
    their pages say why.
    """

    compile: bool = True
    live: bool = False
    debug: bool = False
    draft: bool = False
    engines: tuple[str, ...] = ()
    version: str = ""
    keep_going: bool = False


PUBLISH = Options()
