"""Turn a command line into a built site."""

from __future__ import annotations

import argparse
import sys
import traceback
from pathlib import Path
from typing import TextIO

from sitegen.commands.arguments import parse
from sitegen.errors import SiteError
from sitegen.options import Options
from sitegen.report import Report, count, paint, painted_problem, wants_colour

BUILT, WRONG, STOPPED, BUG = 0, 1, 130, 70
# What a failed command did not do.
DONE = {
    "build": "built",
    "compile": "written",
    "deploy": "published",
    "init": "written",
    "new": "written",
    "serve": "served",
    "theme": "copied",
    "types": "written",
}


def main(argv: list[str] | None = None) -> int:
    """Run sitegen with `argv` and return its exit code."""
    arguments = parse(argv)
    try:
        RUN[arguments.command](arguments)
    except SiteError as error:
        if arguments.debug:
            traceback.print_exc()
        colour = wants_colour(arguments.color, sys.stderr)
        done = DONE.get(arguments.command)
        end = count(len(error.lines), "problem") + (f", nothing was {done}" if done else "")
        lines = [painted_problem(line, "bad", colour=colour) for line in error.lines]
        print(*lines, paint(end, "bad", colour=colour), sep="\n", file=sys.stderr)
        return WRONG
    except KeyboardInterrupt:
        if arguments.debug:
            traceback.print_exc()
        # Ctrl-C is the normal way to end it.
        return BUILT if arguments.command == "serve" else STOPPED
    except BrokenPipeError:
        # The reader of the output closed the pipe, such as `head`.
        sys.stderr.close()
        return BUILT
    except Exception:
        traceback.print_exc()
        print("this is a bug in sitegen, please report it", file=sys.stderr)
        return BUG
    return BUILT


def _report(arguments: argparse.Namespace, out: TextIO | None = None) -> Report:
    out = out or sys.stdout
    return Report(out, colour=wants_colour(arguments.color, out))


def _build(arguments: argparse.Namespace) -> None:
    folder, output, debug = arguments.folder, arguments.output, arguments.debug
    report = _report(arguments)
    if arguments.single_file:
        from sitegen.commands.single import build_single

        page, with_python = arguments.single_file, arguments.with_python
        build_single(folder, page, output=output, report=report, with_python=with_python)
        return
    options = Options(debug=debug, keep_going=arguments.keep_going)
    if arguments.version:
        from sitegen.commands.versions.build import build_version
        from sitegen.commands.versions.names import Version

        version, verbose = Version(arguments.version, arguments.alias), arguments.verbose
        build_version(
            folder, version, output=output, report=report, options=options, verbose=verbose
        )
        return
    from sitegen.cache import unchanged
    from sitegen.cache.folder import cache_folder

    said = unchanged.recall(folder, output, cache_folder(), debug=debug, verbose=arguments.verbose)
    if said is not None:
        for line in said:
            report.say(line)
        report.say(f"nothing changed since the last build → {output}", "good")
        return
    # Importing the rest takes longer than detecting that nothing has changed.
    from sitegen.commands.build import build

    build(folder, output=output, report=report, options=options, verbose=arguments.verbose)


def _new(arguments: argparse.Namespace) -> None:
    from sitegen.commands.new import new

    report = _report(arguments)
    for file in new(arguments.name):
        report.say(f"  {file}")
    report.say(f"wrote {arguments.name}; now: cd {arguments.name} && sitegen serve", "good")


def _init(arguments: argparse.Namespace) -> None:
    from sitegen.commands.init import init

    init(arguments.folder, _report(arguments), github=arguments.github)


def _check(arguments: argparse.Namespace) -> None:
    from sitegen.commands.check import check

    colour = wants_colour(arguments.color, sys.stderr)
    report = _report(arguments, sys.stderr)
    site, warnings = check(arguments.folder, report, strict=arguments.strict)
    for line in warnings:
        print(painted_problem(line, "warning", colour=colour), file=sys.stderr)
    found = count(len(warnings), "warning") if warnings else "no warnings"
    said = f"checked {count(len(site.pages), 'page')}: {found}"
    _report(arguments).say(said, "warning" if warnings else "good")


def _missing(arguments: argparse.Namespace) -> None:
    from sitegen.commands.missing import missing, tell, vcs

    found = missing(arguments.folder)
    if arguments.vcs:
        print(vcs(found))
    else:
        tell(found, _report(arguments))


def _compile(arguments: argparse.Namespace) -> None:
    from sitegen.commands.compile import compile_to

    compile_to(arguments.output, arguments.packages, arguments.workspace, _report(arguments))


def _deploy(arguments: argparse.Namespace) -> None:
    from sitegen.commands.deploy import deploy
    from sitegen.commands.versions.names import Version

    version = Version(arguments.version, arguments.alias) if arguments.version else None
    deploy(arguments.folder, _report(arguments), dry_run=arguments.dry_run, version=version)


def _serve(arguments: argparse.Namespace) -> None:
    from sitegen.commands.serve import serve

    serve(arguments.folder, port=arguments.port, report=_report(arguments), debug=arguments.debug)


def _gateway(arguments: argparse.Namespace) -> None:
    if arguments.doing == "keys":
        from sitegen.commands.gatewaykeys import make_key

        make_key(arguments, _report(arguments, sys.stderr))
        return
    from sitegen.commands.gateway import gateway

    gateway(arguments, _report(arguments))


def _schema(arguments: argparse.Namespace) -> None:
    from sitegen.commands import schema

    print(schema.text(), end="")


def _copy_theme(arguments: argparse.Namespace) -> None:
    from sitegen.commands import theme

    target = arguments.target or Path("themes") / arguments.name
    theme.copy(arguments.name, target)
    print(f"{target}: a copy of '{arguments.name}'; select it in site.yaml: theme: {target.name}")


def _types(arguments: argparse.Namespace) -> None:
    from sitegen.commands.types import write_types

    report = _report(arguments)
    for name in write_types(arguments.folder, report):
        report.say(f"wrote {name}", "good")


# Each command imports its modules when it runs, which keeps the start short.
RUN = {
    "build": _build,
    "check": _check,
    "compile": _compile,
    "deploy": _deploy,
    "gateway": _gateway,
    "init": _init,
    "missing": _missing,
    "new": _new,
    "schema": _schema,
    "serve": _serve,
    "theme": _copy_theme,
    "types": _types,
}


if __name__ == "__main__":
    sys.exit(main())
