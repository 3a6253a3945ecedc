"""Print what a package.xml says as commands of CMake, for ament_package_xml()."""

from __future__ import annotations

import sys
from pathlib import Path

from sitegen.errors import Problems
from sitegen.workspace.manifest import Manifest, read_manifest

# By the name of a variable, the tags whose packages it has.
VARIABLES = {
    "BUILD_DEPENDS": ("depend", "build_depend"),
    "BUILDTOOL_DEPENDS": ("buildtool_depend",),
    "BUILD_EXPORT_DEPENDS": ("depend", "build_export_depend", "run_depend"),
    "BUILDTOOL_EXPORT_DEPENDS": ("buildtool_export_depend",),
    "EXEC_DEPENDS": ("depend", "exec_depend", "run_depend"),
    "TEST_DEPENDS": ("test_depend",),
}


def commands(manifest: Manifest) -> list[str]:
    """Return commands that set a variable for the version and for each kind of dependency."""
    lines = [
        f'set(_AMENT_PACKAGE_NAME "{manifest.name}")',
        f'set({manifest.name}_VERSION "{_quoted(manifest.version)}")',
    ]
    for variable, tags in VARIABLES.items():
        names = (_quoted(name) for tag, name in manifest.tags if tag in tags)
        words = "".join(f' "{name}"' for name in dict.fromkeys(names))
        lines.append(f"set({manifest.name}_{variable}{words})")
    return lines


def _quoted(text: str) -> str:
    return "".join(f"\\{char}" if char in '\\"$;' else char for char in text)


def main() -> int:
    """Print the commands for the file that the command line names."""
    file = Path(sys.argv[1])
    # A package.xml that cannot be read was reported before CMake runs.
    manifest = read_manifest(file, Problems(file.parent))
    if manifest is None:
        return 1
    print(*commands(manifest), sep="\n")
    return 0


if __name__ == "__main__":
    sys.exit(main())
