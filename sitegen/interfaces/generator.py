"""Turn ROS interface definitions into CMake packages of C++ headers.

The message classes come from the real rosidl generator; sitegen adds its own type support.
"""

from __future__ import annotations

import json
import shutil
import subprocess
import sys
import tempfile
from collections.abc import Iterable, Iterator, Sequence
from pathlib import Path
from typing import Any

from sitegen.errors import SiteError
from sitegen.interfaces import cheaders, definitions, rosidl, typesupport, values
from sitegen.shipped import INTERFACES, ROS

KINDS = ("msg", "srv", "action")
RUNTIME = ("rcutils", "rosidl_runtime_c", "rosidl_runtime_cpp", "rosidl_typesupport_interface")

# The prefix of lines that report an error to the author of a package.
PROBLEM = "sitegen: "


def write_package(prefix: Path, package: str, descriptions: Iterable[Path]) -> None:
    """Add `package` to the CMake prefix: type supports, C headers and its CMake configuration.

    The C++ headers that rosidl generated for it must be in `prefix/include/<package>` or in ROS.
    """
    depends: set[str] = set()
    for file in sorted(descriptions):
        interface = f"{package}/{file.parent.name}/{file.stem}"
        messages = list(typesupport.read_description(file))
        stem = typesupport.header_name(interface)
        header = prefix / "include" / package / f"{stem}__type_support.hpp"
        header.parent.mkdir(parents=True, exist_ok=True)
        header.write_text(typesupport.type_support(interface, messages))
        hashes = typesupport.read_hashes(file)
        include = prefix / "include" / package
        cheaders.write_headers(include, file.parents[1], interface, messages, hashes)
        depends |= {field.nested.split("/")[0] for m in messages for field in m.fields}
        if file.parent.name == "action":
            depends.add("action_msgs")  # rosidl's header of an action includes its services
    config = prefix / "share" / package / "cmake" / f"{package}Config.cmake"
    config.parent.mkdir(parents=True, exist_ok=True)
    config.write_text(_cmake_config(package, sorted(depends - {package, ""})))


def _cmake_config(package: str, depends: Sequence[str]) -> str:
    # The prefix of the package comes first: its type supports replace those of rosidl.
    folders = [ROS / "include" / name for name in (package, *RUNTIME)]
    include = ";".join(
        [
            f"${{include}}/{package}",
            "${SITEGEN_CPP}/include",
            *(folder.as_posix() for folder in folders if folder.exists()),
        ]
    )
    target = f"{package}::{package}"
    parts = ("generator_c", "generator_cpp", "typesupport_c", "typesupport_cpp")
    return "\n".join(
        [
            "include_guard(GLOBAL)",
            "include(CMakeFindDependencyMacro)",
            *(f"find_dependency({depend})" for depend in depends),
            'get_filename_component(include "${CMAKE_CURRENT_LIST_DIR}/../../../include" ABSOLUTE)',
            f'set({package}_INCLUDE_DIRS "{include}")',
            f"add_library({target} INTERFACE IMPORTED GLOBAL)",
            f"set_target_properties({target} PROPERTIES",
            "  INTERFACE_COMPILE_FEATURES cxx_std_17",
            f'  INTERFACE_INCLUDE_DIRECTORIES "${{{package}_INCLUDE_DIRS}}"',
            f'  INTERFACE_LINK_LIBRARIES "{";".join(f"{d}::{d}" for d in depends)}")',
            *(f"add_library({target}__rosidl_{part} ALIAS {target})" for part in parts),
            f"set({package}_TARGETS {target})",
            f"set({package}_LIBRARIES {target})",
            # Written by ament_package() instead if the package has libraries, too.
            f'if(NOT PROJECT_NAME STREQUAL "{package}")',
            f'  include("${{CMAKE_CURRENT_LIST_DIR}}/{package}Libraries.cmake" OPTIONAL)',
            "endif()",
            "",
        ]
    )


def write_ros(prefix: Path) -> None:
    """Add the interface packages that come with sitegen to the CMake prefix."""
    for share in sorted((ROS / "share").iterdir()):
        descriptions = [file for kind in KINDS for file in share.glob(f"{kind}/*.json")]
        if descriptions:
            write_package(prefix, share.name, descriptions)


def write_shipped(prefix: Path) -> None:
    """Generate the packages of INTERFACES into the CMake prefix, each in its own process."""
    for folder in sorted(INTERFACES.iterdir()):
        files = sorted(f.relative_to(folder).as_posix() for f in folder.glob("*/*.*"))
        command = [
            sys.executable,
            "-m",
            "sitegen.interfaces.generator",
            str(prefix),
            "",
            folder.name,
        ]
        done = subprocess.run([*command, str(folder), *files], capture_output=True, text=True)
        if done.returncode:
            raise RuntimeError(f"{folder.name} could not be generated:\n{done.stderr}")


def generate(
    prefix: Path, others: Sequence[Path], package: str, folder: Path, files: Sequence[str]
) -> None:
    """Generate the C++ headers of a workspace package and add it to the CMake prefix.

    `files` are its `.msg`, `.srv`, `.action` and `.idl` files, relative to `folder`; `others` are
    the prefixes of packages that they may use.

    Raises: SiteError if definitions are wrong.
    """
    with tempfile.TemporaryDirectory() as folder_of_new:
        fresh = Path(folder_of_new)
        arguments = describe(fresh, others, package, folder, files)
        cpp = rosidl.module("rosidl_generator_cpp")
        output = fresh / "include" / package / package
        _run(cpp.generate_cpp, arguments | {"output_dir": str(output)})
        # Besides the types of the interfaces there is one for each part of a service or an action.
        idls = [name.rpartition(":")[2] for name in arguments["idl_tuples"]]
        share = fresh / "share" / package
        write_package(fresh, package, ((share / idl).with_suffix(".json") for idl in idls))
        for part in ("include", "share"):
            _update(fresh / part / package, prefix / part / package)


def describe(
    prefix: Path, others: Sequence[Path], package: str, folder: Path, files: Sequence[str]
) -> dict[str, Any]:
    """Write the type descriptions of a workspace package to the prefix.

    The parameters and exceptions are those of `generate`. Returns the input of rosidl's generators.
    """
    adapter = rosidl.module("rosidl_adapter")
    description = rosidl.module("rosidl_generator_type_description")
    packages = {path.name: path for path in shares([ROS, *others]) if path.name != package}
    problems = definitions.check(package, folder, files, packages)
    if problems:
        raise SiteError(problems)
    share = prefix / "share" / package
    share.mkdir(parents=True)
    idls = []
    for name in files:
        if name.endswith(".idl"):
            idls.append(f"{folder}:{name}")
            values.write_idl_values(folder / name, share / Path(name).parent)
        else:
            idl = adapter.convert_to_idl(folder, package, Path(name), share)
            shutil.copyfile(folder / name, Path(idl).with_suffix(Path(name).suffix))
            idls.append(f"{share}:{Path(idl).relative_to(share).as_posix()}")
    arguments = {
        "package_name": package,
        "idl_tuples": idls,
        "include_paths": [f"{name}:{path}" for name, path in packages.items()],
        "output_dir": str(share),
        "template_dir": str(ROS / "share" / "rosidl_generator_cpp" / "resource"),
        "target_dependencies": [],
    }
    _run(description.generate_type_hash, arguments)
    return arguments


def write_classes(prefix: Path, arguments: dict[str, Any]) -> None:
    """Generate the Python classes of a package to `prefix/python`.

    The parameter is what `describe` returns. The generated C sources, which connect the classes to
    a middleware, are left out.
    """
    generator = rosidl.module("rosidl_generator_py")
    package = arguments["package_name"]
    with tempfile.TemporaryDirectory() as folder:
        fresh = Path(folder) / package
        templates = ROS / "share" / "rosidl_generator_py" / "resource"
        own = {"output_dir": str(fresh), "template_dir": str(templates)}
        _run(lambda file: generator.generate_py(file, []), arguments | own)
        (fresh / "__init__.py").touch()
        for file in sorted(fresh.rglob("*.py")):
            target = prefix / "python" / package / file.relative_to(fresh)
            target.parent.mkdir(parents=True, exist_ok=True)
            shutil.copyfile(file, target)


def _update(fresh: Path, folder: Path) -> None:
    """Make the contents of `folder` equal to those of `fresh`.

    Unchanged files keep their modification times, so that what includes them is not compiled again.
    """
    names = {file.relative_to(fresh) for file in fresh.rglob("*") if file.is_file()}
    for name in names:
        file, content = folder / name, (fresh / name).read_bytes()
        if not file.exists() or file.read_bytes() != content:
            file.parent.mkdir(parents=True, exist_ok=True)
            file.write_bytes(content)
    for file in {*folder.rglob("*.*")} - {*folder.rglob("*.cmake")}:
        if file.relative_to(folder) not in names:
            file.unlink()  # of an interface that the package no longer has


def shares(prefixes: Iterable[Path]) -> Iterator[Path]:
    """Yield the folders of packages that have type descriptions."""
    for prefix in prefixes:
        for share in sorted((prefix / "share").glob("*")):
            if any((share / kind).is_dir() for kind in KINDS):
                yield share


def _run(generator: Any, arguments: dict[str, Any]) -> Any:
    with tempfile.TemporaryDirectory() as folder:
        file = Path(folder) / "arguments.json"
        file.write_text(json.dumps(arguments))
        return generator(str(file))


def main() -> int:
    """Do the work of rosidl_generate_interfaces() while CMake configures a package."""
    prefix, others, package, folder, *files = sys.argv[1:]
    try:
        generate(
            Path(prefix),
            [Path(other) for other in others.split(";") if other],
            package,
            Path(folder),
            files,
        )
    except SiteError as error:
        print(*(f"{PROBLEM}{line}" for line in error.lines), sep="\n", file=sys.stderr)
        return 1
    return 0


if __name__ == "__main__":
    sys.exit(main())
