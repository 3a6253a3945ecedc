"""Parse the command line, and suggest a correction for a wrong one."""

from __future__ import annotations

import argparse
import re
import sys
from collections.abc import Callable, Sequence
from functools import partial
from pathlib import Path
from typing import NoReturn

from sitegen import __version__
from sitegen.commands.versions.names import is_name
from sitegen.errors import nearest

DESCRIPTION = "Package a ROS 2 workspace into a static web page that runs it."
BEGIN = """\
Start with:  sitegen new my_robot    (or, in a workspace:  sitegen init)
Then:        sitegen serve
"""
USAGE = 2


class Parser(argparse.ArgumentParser):
    """A parser that suggests the nearest command or option for an unknown one."""

    def error(self, message: str) -> NoReturn:
        """Print the error and how to get help, and exit with 2."""
        # The messages of argparse; one that does not match is printed unchanged.
        unknown = re.match(
            r"argument COMMAND: invalid choice: '([^']*)' \(choose from (.*)\)", message
        )
        if unknown:
            known = re.findall(r"[\w-]+", unknown[2])
            message = f"unknown command '{unknown[1]}'; {nearest(unknown[1], known)}"
            self.exit(USAGE, f"{self.prog}: {message}\n")
        self.print_usage(sys.stderr)
        self.exit(USAGE, f"{self.prog}: {message}\n")

    def refuse(self, words: Sequence[str]) -> NoReturn:
        """Print that this command does not know `words`, and exit with 2."""
        option = next((word for word in words if word.startswith("-")), None)
        if option is None:
            self.error(f"unexpected argument '{words[0]}'")
        name = option.partition("=")[0]
        known = sorted(set(re.findall(r"--[a-z][\w-]*", self.format_help())))
        message = f"unknown option '{name}'; {nearest(name, known)}"
        self.exit(USAGE, f"{self.prog}: {message}\n")


def parse(argv: Sequence[str] | None) -> argparse.Namespace:
    """Return the arguments of `argv`; without a command, print the help and exit with 2."""
    argv = sys.argv[1:] if argv is None else argv
    common = _common()
    parser = Parser(
        "sitegen",
        description=DESCRIPTION,
        epilog=BEGIN,
        formatter_class=argparse.RawDescriptionHelpFormatter,
        parents=[common],
    )
    parser.add_argument("--version", action="version", version=f"sitegen {__version__}")
    commands = parser.add_subparsers(
        dest="command", metavar="COMMAND", title="commands", parser_class=Parser
    )
    add = partial(commands.add_parser, parents=[common])
    _add_beginnings(add)
    build = _add_builds(add)
    _add_others(add)
    arguments, unknown = parser.parse_known_args(argv)
    if unknown:
        command = commands.choices.get(arguments.command, parser)
        command.refuse(unknown)
    if not arguments.command:
        # The exit code of argparse and Click for a wrong command line: a script must not continue.
        parser.print_help(sys.stderr)
        parser.exit(USAGE)
    if arguments.command in ("build", "deploy"):
        _check_version(arguments, commands.choices[arguments.command])
    for name, default in (("debug", False), ("color", "auto")):
        vars(arguments).setdefault(name, default)
    if arguments.command == "build" and arguments.single_file and arguments.version:
        build.error("argument --version: a single file has no versions")
    if arguments.command == "build" and arguments.single_file and arguments.keep_going:
        build.error("argument --keep-going: a single file needs all nodes of its page")
    if arguments.command == "build" and not arguments.single_file:
        if arguments.with_python:
            build.error("argument --with-python: needs --single-file PAGE")
        arguments.output = arguments.output or arguments.folder / "dist"
        if arguments.folder.resolve().is_relative_to(arguments.output.resolve()):
            build.error("argument --output: would replace the folder that contains site.yaml")
    return arguments


def _common() -> Parser:
    """Return the options that can be written before or after every command."""
    common = Parser(add_help=False, argument_default=argparse.SUPPRESS)
    common.add_argument(
        "--debug",
        action="store_true",
        help="show tracebacks, and build C++ nodes that report source lines",
    )
    common.add_argument(
        "--color",
        choices=("auto", "always", "never"),
        help="color the output; auto (the default) does so on a terminal, unless NO_COLOR is set",
    )
    return common


# Creates the parser of a command.
Add = Callable[..., Parser]


def _add_folder(parser: Parser, what: str = "the folder that contains site.yaml") -> None:
    parser.add_argument(
        "folder",
        nargs="?",
        default=Path(),
        type=Path,
        metavar="FOLDER",
        help=f"{what} (default: the current folder)",
    )


def _add_version(parser: Parser) -> None:
    parser.add_argument(
        "--version",
        metavar="NAME",
        help="build this version of the site, such as 1.2, beside the other versions",
    )
    parser.add_argument(
        "--alias",
        action="append",
        default=[],
        metavar="NAME",
        help="with --version: a second name for this version, such as latest",
    )


def _check_version(arguments: argparse.Namespace, parser: Parser) -> None:
    """Refuse names that do not make an address; make the aliases what they are elsewhere."""
    arguments.alias = tuple(arguments.alias)
    if arguments.alias and arguments.version is None:
        parser.error("argument --alias: needs --version NAME")
    named = [("--version", arguments.version)] if arguments.version is not None else []
    for option, name in (*named, *(("--alias", alias) for alias in arguments.alias)):
        if not is_name(name):
            why = "write it like 1.2 or latest, with letters, digits, '.', '-', '_' and '+'"
            parser.error(f"argument {option}: '{name}' is not a valid name; {why}")
    if arguments.version in arguments.alias:
        parser.error(f"argument --alias: '{arguments.version}' is the version itself")


def _add_beginnings(add: Add) -> None:
    new = add("new", help="create a small workspace with two nodes and a site")
    new.add_argument(
        "name",
        type=Path,
        metavar="NAME",
        help="the folder to create; its name must be a valid package name",
    )
    init = add("init", help="write a site.yaml for an existing workspace")
    _add_folder(init, "the workspace folder")
    init.add_argument(
        "--github", action="store_true", help="write GitHub workflows that publish the site"
    )


def _add_builds(add: Add) -> Parser:
    """Add the commands that build a site; return `build`."""
    serve = add("serve", help="serve the site and rebuild it on every change")
    _add_folder(serve)
    serve.add_argument(
        "--port", type=int, default=8000, help="the first port to try (default: 8000)"
    )
    check = add("check", help="report errors and warnings without compiling anything")
    _add_folder(check)
    check.add_argument("--strict", action="store_true", help="treat warnings as errors")
    missing = add("missing", help="list the packages that a workspace lacks, and where they are")
    _add_folder(missing, "the workspace folder")
    missing.add_argument(
        "--vcs", action="store_true", help="print the file that `vcs import` clones them with"
    )
    build = add("build", help="build the site into a folder")
    _add_folder(build)
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
    build.add_argument(
        "--with-python",
        action="store_true",
        help="with --single-file: embed Python, so that Python nodes run in the file",
    )
    build.add_argument(
        "--verbose", action="store_true", help="list all pages and nodes, even of a large site"
    )
    build.add_argument(
        "--keep-going",
        action="store_true",
        help="write the site without the C++ nodes that do not compile; their pages say why",
    )
    _add_version(build)
    deploy = add("deploy", help="build the site and publish it to a Git branch")
    _add_folder(deploy)
    deploy.add_argument(
        "--dry-run", action="store_true", help="show what would be published without publishing it"
    )
    _add_version(deploy)
    return build


def _add_others(add: Add) -> None:
    compiling = add("compile", help="compile nodes into an archive for use in other sites")
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
    _add_gateway(add)
    add("schema", help="print the JSON Schema of site.yaml for use in editors")
    types = add("types", help="write the types for your panels and scripts, for use in editors")
    _add_folder(types)
    theme = add("theme", help="create your own theme")
    doings = theme.add_subparsers(
        dest="doing", required=True, metavar="COMMAND", parser_class=Parser
    )
    copying = doings.add_parser(
        "copy", help="copy a theme that comes with sitegen", parents=[_common()]
    )
    copying.add_argument("name", metavar="NAME", help="the theme to copy: default, slides or plain")
    copying.add_argument(
        "target",
        nargs="?",
        type=Path,
        metavar="DIR",
        help="the folder to create (default: themes/NAME)",
    )


def _add_gateway(add: Add) -> None:
    gateway = add("gateway", help="connect web pages and other programs to ROS 2 on this computer")
    gateway.add_argument(
        "--config",
        type=Path,
        metavar="FILE",
        help="the file that says what clients may do (default: gateway.yaml, if it exists)",
    )
    gateway.add_argument(
        "--site", type=Path, metavar="DIR", help="also serve this built site, such as dist"
    )
    gateway.add_argument(
        "--bind",
        default="127.0.0.1",
        metavar="ADDRESS",
        help="the address to listen on; 0.0.0.0 lets other computers connect (default: 127.0.0.1)",
    )
    gateway.add_argument(
        "--port", type=int, default=9090, help="the port to listen on (default: 9090)"
    )
    gateway.add_argument(
        "--tls",
        nargs="+",
        metavar="FILE",
        help="encrypt with a certificate and its key, or with self-signed",
    )
    gateway.add_argument(
        "--domain", type=int, metavar="ID", help="the ROS domain (default: ROS_DOMAIN_ID)"
    )
    gateway.add_argument(
        "--zenoh",
        nargs="*",
        metavar="ADDRESS",
        help="join the graphs of other gateways, and of rmw_zenoh, at these addresses",
    )
    gateway.add_argument(
        "--zenoh-port",
        type=int,
        metavar="PORT",
        help="the port for others with --zenoh; 0 to listen at none (default: 7447)",
    )
    gateway.add_argument(
        "--zenoh-config",
        type=Path,
        metavar="FILE",
        help="Zenoh's own configuration, for encryption and access control",
    )
    doings = gateway.add_subparsers(dest="doing", metavar="COMMAND", parser_class=Parser)
    keys = doings.add_parser("keys", help="make a key for a person", parents=[_common()])
    keys.add_argument(
        "name", metavar="NAME", help="the person's name or email address, as in the calendar"
    )
    keys.add_argument(
        "--for",
        dest="duration",
        default="2h",
        metavar="TIME",
        help="how long the key is valid: 90s, 20m, 2h, 7d (default: 2h)",
    )
