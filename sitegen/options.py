"""The options of a build."""

from __future__ import annotations

from dataclasses import dataclass


@dataclass(frozen=True)
class Options:
    """How a site is built; the default is to publish it.

    Without `compile`, everything is checked and the C++ programs are missing. A `live` site is
    served while its author edits it: no browser keeps it, and the server makes the search index
    when somebody searches. With `debug`, C++ programs report the lines of their sources. A `draft`
    links C++ programs in a fifth of the time, and they are up to twice as large. Programs are built
    for those of the site's engines that are among `engines`, if it names any. `version` names the
    version that is built, where the site has several.
    """

    compile: bool = True
    live: bool = False
    debug: bool = False
    draft: bool = False
    engines: tuple[str, ...] = ()
    version: str = ""


PUBLISH = Options()
