"""Run xacro with the packages of a workspace.

This runs as a separate program. It reads the folders of packages from the standard input as JSON,
and writes the URDF to the standard output, or the error and its file to the standard error.
"""

from __future__ import annotations

import json
import sys
import types
from pathlib import Path
from typing import Any


def described(file: str, **options: Any) -> Any:
    """Return the document that a xacro file describes, as `xacro.process_file` does.

    Upstream's function writes the full path of the file into the document, which must not be
    published.
    """
    import xacro

    xacro.init_stacks(file)
    document = xacro.parse(None, file)
    xacro.process_doc(document, **options)
    return document


def main() -> int:
    """Write the URDF of the file given as argument."""
    folders = json.load(sys.stdin)
    packages = types.ModuleType("ament_index_python.packages")
    lacking: list[str] = []

    def share(package: str) -> str:
        if package not in folders:
            lacking.append(f"no package '{package}' in the workspace")
            raise LookupError(lacking[0])
        return str(folders[package])

    vars(packages).update(get_package_share_directory=share, PackageNotFoundError=LookupError)
    sys.modules |= {"ament_index_python": packages, packages.__name__: packages}

    import xacro
    from xacro.cli import process_args

    options, file = process_args(sys.argv[1:])
    try:
        document = described(file, **vars(options))
    except Exception as error:
        where = Path((xacro.filestack or [file])[-1] or file).name
        # xacro adds the types of exceptions, and their texts once more.
        text = " ".join((*lacking, str(error))[0].split()) or type(error).__name__
        print(f"xacro: {where}: {text}", file=sys.stderr)
        return 1
    sys.stdout.write(document.toprettyxml(indent="  "))
    return 0


if __name__ == "__main__":
    sys.exit(main())
