"""Turn a command line into a built site."""

from __future__ import annotations

import argparse
import sys
import traceback
from pathlib import Path

from sitegen import __version__
from sitegen.errors import SiteError

BUILT, WRONG, STOPPED, BUG = 0, 1, 130, 70
# What a command that fails has not done.
DONE = {
    "build": "built",
    "compile": "written",
    "deploy": "published",
    "init": "written",
    "new": "written",
    "serve": "served",
    "theme": "copied",
}


def main(argv: list[str] | None = None) -> int:
    """Run sitegen with `argv` and return its exit code."""
    arguments = _parse(argv)
    try:
        arguments.run(arguments)
    except SiteError as error:
        if arguments.debug:
            traceback.print_exc()
        count = len(error.lines)
        done = DONE.get(arguments.command)
        end = f", nothing was {done}" if done else ""
        lines = [*error.lines, f"{count} problem{'s'[: count != 1]}{end}"]
        print(*lines, sep="\n", file=sys.stderr)
        return WRONG
    except KeyboardInterrupt:
        if arguments.debug:
            traceback.print_exc()
        # Nothing else ends it, so this is no mishap.
        return BUILT if arguments.command == "serve" else STOPPED
    except BrokenPipeError:
        # Whoever read what is printed had enough.
        sys.stderr.close()
        return BUILT
    except Exception:
        traceback.print_exc()
        print("this is a bug in sitegen, please report it", file=sys.stderr)
        return BUG
    return BUILT


def _build(arguments: argparse.Namespace) -> None:
    from sitegen.report import Report

    folder, output, debug = arguments.folder, arguments.output, arguments.debug
    if arguments.single_file:
        from sitegen.commands.single import build_single

        build_single(folder, arguments.single_file, output=output, report=Report())
        return
    from sitegen.cache import unchanged
    from sitegen.cache.folder import cache_folder

    said = unchanged.recall(folder, output, cache_folder(), debug=debug)
    if said is not None:
        print(*said, f"nothing changed since the last build → {output}", sep="\n")
        return
    # Importing the rest takes longer than finding out that nothing has changed.
    from sitegen.commands.build import build

    build(folder, output=output, report=Report(), debug=debug)


def _new(arguments: argparse.Namespace) -> None:
    from sitegen.commands.new import new

    print(*(f"  {file}" for file in new(arguments.name)), sep="\n")
    print(f"wrote {arguments.name}; now: cd {arguments.name} && sitegen serve")


def _init(arguments: argparse.Namespace) -> None:
    from sitegen.commands.init import init
    from sitegen.report import Report

    init(arguments.folder, Report(sys.stdout), github=arguments.github)


def _check(arguments: argparse.Namespace) -> None:
    from sitegen.commands.check import check
    from sitegen.report import Report, count

    site, warnings = check(arguments.folder, Report(sys.stderr), strict=arguments.strict)
    print(*(f"{line}\n" for line in warnings), sep="", end="", file=sys.stderr)
    found = count(len(warnings), "warning") if warnings else "no warnings"
    print(f"checked {count(len(site.pages), 'page')}: {found}")


def _compile(arguments: argparse.Namespace) -> None:
    from sitegen.commands.compile import compile_to
    from sitegen.report import Report

    report = Report(sys.stdout)
    compile_to(arguments.output, arguments.packages, arguments.workspace, report)


def _deploy(arguments: argparse.Namespace) -> None:
    from sitegen.commands.deploy import deploy
    from sitegen.report import Report

    deploy(arguments.folder, Report(sys.stdout), dry_run=arguments.dry_run)


def _serve(arguments: argparse.Namespace) -> None:
    from sitegen.commands.serve import serve
    from sitegen.report import Report

    serve(arguments.folder, port=arguments.port, report=Report(), debug=arguments.debug)


def _schema(arguments: argparse.Namespace) -> None:
    import json

    from sitegen import config

    print(json.dumps(config.json_schema(), indent=2))


def _copy_theme(arguments: argparse.Namespace) -> None:
    from sitegen.commands import theme

    target = arguments.target or Path("themes") / arguments.name
    theme.copy(arguments.name, target)
    print(f"{target}: a copy of '{arguments.name}'; select it in site.yaml: theme: {target.name}")


def _parse(argv: list[str] | None) -> argparse.Namespace:
    debug = argparse.ArgumentParser(add_help=False, argument_default=argparse.SUPPRESS)
    debug.add_argument(
        "--debug",
        action="store_true",
        help="show tracebacks, and build C++ nodes that report source lines",
    )
    parser = argparse.ArgumentParser(
        "sitegen",
        description="Package a ROS 2 workspace into a static web page that runs it.",
        parents=[debug],
    )
    parser.add_argument("--version", action="version", version=f"sitegen {__version__}")
    commands = parser.add_subparsers(dest="command", required=True, metavar="COMMAND")
    folder = argparse.ArgumentParser(add_help=False)
    folder.add_argument(
        "folder",
        nargs="?",
        default=Path(),
        type=Path,
        metavar="FOLDER",
        help="the folder that contains site.yaml (default: the current folder)",
    )
    new = commands.add_parser(
        "new", help="create a small workspace with two nodes and a site", parents=[debug]
    )
    new.add_argument(
        "name",
        type=Path,
        metavar="NAME",
        help="the folder to create; its name must be a valid package name",
    )
    new.set_defaults(run=_new)
    beginning = commands.add_parser(
        "init", help="write a site.yaml for an existing workspace", parents=[debug]
    )
    beginning.add_argument(
        "folder",
        nargs="?",
        default=Path(),
        type=Path,
        metavar="FOLDER",
        help="the workspace folder (default: the current folder)",
    )
    beginning.add_argument(
        "--github", action="store_true", help="write GitHub workflows that publish the site"
    )
    beginning.set_defaults(run=_init)
    build = commands.add_parser(
        "build", help="build the site into a folder", parents=[folder, debug]
    )
    build.add_argument(
        "--output",
        type=Path,
        metavar="DIR",
        help="the folder to write; its contents are replaced (default: FOLDER/dist)",
    )
    build.add_argument(
        "--single-file",
        metavar="PAGE",
        help="write one page as a single HTML file that needs no server (--output names it)",
    )
    build.set_defaults(run=_build)
    check = commands.add_parser(
        "check",
        help="report errors and warnings without compiling anything",
        parents=[folder, debug],
    )
    check.add_argument("--strict", action="store_true", help="treat warnings as errors")
    check.set_defaults(run=_check)
    serve = commands.add_parser(
        "serve", help="serve the site and rebuild it on every change", parents=[folder, debug]
    )
    serve.add_argument(
        "--port", type=int, default=8000, help="the first port to try (default: 8000)"
    )
    serve.set_defaults(run=_serve)
    compiling = commands.add_parser(
        "compile", help="compile nodes into an archive for use in other sites", parents=[debug]
    )
    compiling.add_argument(
        "packages", nargs="+", metavar="PACKAGE", help="a package, or PACKAGE/EXECUTABLE"
    )
    compiling.add_argument(
        *("-o", "--output"),
        type=Path,
        default=Path("nodes.zip"),
        metavar="FILE",
        help="the archive to write (default: nodes.zip)",
    )
    compiling.add_argument(
        "--workspace",
        type=Path,
        default=Path(),
        metavar="FOLDER",
        help="the workspace folder (default: the current folder)",
    )
    compiling.set_defaults(run=_compile)
    deploy = commands.add_parser(
        "deploy", help="build the site and publish it to a Git branch", parents=[folder, debug]
    )
    deploy.add_argument(
        "--dry-run", action="store_true", help="show what would be published without publishing it"
    )
    deploy.set_defaults(run=_deploy)
    schema = commands.add_parser(
        "schema", help="print the JSON Schema of site.yaml for use in editors", parents=[debug]
    )
    schema.set_defaults(run=_schema)
    theme = commands.add_parser("theme", help="start your own theme")
    doings = theme.add_subparsers(dest="doing", required=True, metavar="COMMAND")
    copying = doings.add_parser(
        "copy", help="copy a theme that comes with sitegen", parents=[debug]
    )
    copying.add_argument("name", metavar="NAME", help="the theme to copy: default, slides or plain")
    copying.add_argument(
        "target",
        nargs="?",
        type=Path,
        metavar="DIR",
        help="the folder to create (default: themes/NAME)",
    )
    copying.set_defaults(run=_copy_theme)
    arguments = parser.parse_args(argv)
    arguments.debug = "debug" in arguments
    if arguments.command != "build" or arguments.single_file:
        return arguments
    arguments.output = arguments.output or arguments.folder / "dist"
    if arguments.folder.resolve().is_relative_to(arguments.output.resolve()):
        build.error("argument --output: would replace the folder that contains site.yaml")
    return arguments


if __name__ == "__main__":
    sys.exit(main())
