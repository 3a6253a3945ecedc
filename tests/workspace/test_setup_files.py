"""What setup.py, setup.cfg and pyproject.toml install; setuptools itself installed the same."""

from __future__ import annotations

from pathlib import Path

import pytest

from sitegen.workspace import setupfiles

# The files of the package `courier`, which has modules in more than one place.
FILES = (
    *(
        "package.xml",
        "resource/courier",
        "config/route.txt",
        "config/map.yaml",
        "launch/a.launch.py",
    ),
    *("worlds/small/a.txt", "worlds/large/deep/b.txt", "scripts/tool.py"),
    *("courier/__init__.py", "courier/reader.py", "courier/words.txt", "courier/data/one.csv"),
    *("courier/parts/__init__.py", "courier/parts/wheel.py", "src/driver.cpp"),
    *("lib/porter/__init__.py", "lib/porter/bag.py", "lib/porter/bag.json"),
)
MODULES = {"python/courier/__init__.py", "python/courier/reader.py"}
PARTS = {"python/courier/parts/__init__.py", "python/courier/parts/wheel.py"}
PORTER = {"python/porter/__init__.py", "python/porter/bag.py"}
BASIC = {"share/courier/package.xml", "share/courier/config/route.txt"}
WORLDS = {"share/courier/worlds/small/a.txt", "share/courier/worlds/large/deep/b.txt"}
HEAD = """import os
import glob
from glob import glob as find
from pathlib import Path
from setuptools import find_packages, setup
name = "courier"
"""
# By name: the statements before setup(), its arguments, and the files that it installs.
SCRIPTS = {
    "append": (
        """
data_files = []
data_files.append(("share/" + name, ["package.xml"]))
data_files.append((os.path.join("share", name, "config"), find("config/*.txt")))
""",
        "packages=[name], data_files=data_files",
        MODULES | BASIC,
    ),
    "extend, += and insert": (
        """
data_files = [("share/courier", ["package.xml"])]
data_files.extend([("share/courier/config", ["config/route.txt"])])
data_files += [("share/courier/config", ["config/map.yaml"])]
data_files.insert(0, ("share/courier/launch", glob.glob("launch/*.launch.py")))
packages = ["courier"]
packages.append("courier.parts")
""",
        "packages=packages, data_files=data_files",
        MODULES
        | PARTS
        | BASIC
        | {"share/courier/config/map.yaml", "share/courier/launch/a.launch.py"},
    ),
    "os.walk in a loop": (
        """
data_files = []
for folder, _, names in os.walk("worlds"):
    if not names:
        continue
    files = [os.path.join(folder, n) for n in names]
    data_files.append((os.path.join("share", name, folder), files))
""",
        "packages=[name], data_files=data_files",
        MODULES | WORLDS,
    ),
    "a function that walks": (
        """
def package_files(data_files, directories):
    paths = {}
    for directory in directories:
        for (path, folders, names) in os.walk(directory):
            for each in names:
                file_path = os.path.join(path, each)
                install_path = os.path.join("share", name, path)
                if install_path in paths.keys():
                    paths[install_path].append(file_path)
                else:
                    paths[install_path] = [file_path]
    for key in paths.keys():
        data_files.append((key, paths[key]))
    return data_files
""",
        "packages=[name], data_files="
        "package_files([('share/courier', ['package.xml'])], ['worlds/'])",
        MODULES | WORLDS | {"share/courier/package.xml"},
    ),
    "a generator and a comprehension": (
        """
def tree(top):
    for path in Path(top).rglob("*.txt"):
        if path.is_file():
            yield f"share/{name}/{path.parent}", [str(path)]

folders = {"config": "*.txt"}
""",
        "packages=find_packages(exclude=['lib']), data_files=["
        "*tree('worlds'), *[(f'share/{name}/{k}', find(f'{k}/{v}')) for k, v in folders.items()],"
        "(f'share/{name}', ['package.xml'])]",
        MODULES | PARTS | WORLDS | BASIC,
    ),
    "defaultdict, lambda and keywords": (
        """
from collections import defaultdict
grouped = defaultdict(list)
for file in sorted(Path("worlds").glob("**/*.txt"), key=lambda p: p.name):
    grouped[os.path.join("share", name, str(file.parent))].append(file.as_posix())
more = dict(packages=[name], data_files=list(grouped.items()))
""",
        "**more",
        MODULES | WORLDS,
    ),
    "absolute paths": (
        """
here = os.path.abspath(os.path.dirname(__file__))
os.chdir(here)
config = [os.path.relpath(f, here) for f in glob.glob(os.path.join(here, "config", "*.txt"))]
""",
        "packages=[name], data_files=[('share/courier/config', config), "
        "('share/courier', [os.path.join(here, 'package.xml')])]",
        MODULES | BASIC,
    ),
    "conditions and unused unknowns": (
        """
import subprocess
try:
    import catkin_pkg
except ImportError:
    catkin_pkg = None
with open("package.xml") as file:
    text = file.read()
version = subprocess.check_output(["git", "--version"]).decode()
files = ["package.xml"] if os.path.exists("package.xml") else []
while len(files) > 1:
    files.pop()
if __name__ == "__main__" and not os.path.isdir("nothing"):
    setup(name=name, version=version, packages=[name], data_files=[("share/courier", files)])
""",
        "packages=[]",
        MODULES | {"share/courier/package.xml"},
    ),
    "package data": (
        "package_data = {'': ['*.txt']}\npackage_data['courier'] = ['data/*.csv', 'data/**']\n",
        "packages=['courier'], package_data=package_data, exclude_package_data={'': ['w*.txt']}",
        MODULES | {"python/courier/data/one.csv"},
    ),
    "package_dir of one package": (
        "",
        "packages=['courier', 'porter'], package_dir={'porter': 'lib/porter'}",
        MODULES | PORTER,
    ),
    "find_packages in a folder": (
        "",
        "packages=find_packages(where='lib'), package_dir={'': 'lib'}",
        PORTER,
    ),
    "a folder src with other sources": ("", "packages=['courier']", MODULES),
    "modules only": ("", "py_modules=['courier.reader']", MODULES),
}


@pytest.fixture
def folder(tmp_path: Path) -> Path:
    top = tmp_path / "courier"
    for name in FILES:
        (top / name).parent.mkdir(parents=True, exist_ok=True)
        (top / name).write_text("")
    return top


def installed(folder: Path) -> set[str]:
    listing = setupfiles.read(folder)
    assert listing.fault is None
    return set(listing.files)


@pytest.mark.parametrize("name", SCRIPTS)
def test_what_a_setup_py_installs(folder: Path, name: str) -> None:
    before, arguments, expected = SCRIPTS[name]
    (folder / "setup.py").write_text(f"{HEAD}{before}setup(name=name, {arguments})\n")
    assert installed(folder) == expected


MANIFEST_IN = """# Comment
include courier/words.txt
recursive-include courier *.csv *.json
graft worlds
global-exclude *.pyc
prune courier/nothing
"""
# By name: setup.cfg, pyproject.toml, MANIFEST.in and the files that are installed.
CONFIGURED = {
    "find with where": (
        "[options]\npackages = find:\n[options.packages.find]\nwhere = lib\n",
        "",
        "",
        PORTER,
    ),
    "find with exclude": (
        "[options]\npackages = find:\n"
        "[options.packages.find]\nexclude =\n    courier.parts*\n    lib*\n",
        "",
        "",
        MODULES,
    ),
    "package_dir and lists with commas": (
        "[options]\npackages = courier, porter\npackage_dir =\n    porter = lib/porter\n"
        "[options.package_data]\n* = *.txt, *.json\n",
        "",
        "",
        MODULES | PORTER | {"python/courier/words.txt", "python/porter/bag.json"},
    ),
    "data_files with patterns": (
        "[options]\npackages = courier\n"
        "[options.data_files]\nshare/courier = package.xml\nshare/courier/config = config/*.txt\n",
        "",
        "",
        MODULES | BASIC,
    ),
    "include_package_data": (
        "[options]\npackages = courier\ninclude_package_data = True\n",
        "",
        MANIFEST_IN,
        MODULES | {"python/courier/words.txt", "python/courier/data/one.csv"},
    ),
    "MANIFEST.in without include_package_data": (
        "[options]\npackages = courier\n",
        "",
        MANIFEST_IN,
        MODULES,
    ),
    "pyproject.toml finds packages": (
        "",
        "[project]\nname = 'courier'\nversion = '1'\n"
        "[tool.setuptools.packages.find]\nwhere = ['lib']\n"
        "[tool.setuptools.data-files]\n'share/courier' = ['package.xml']\n",
        "",
        PORTER | {"share/courier/package.xml"},
    ),
    "pyproject.toml includes the data of MANIFEST.in": (
        "",
        "[project]\nname = 'courier'\nversion = '1'\n[tool.setuptools]\npackages = ['courier']\n",
        "graft courier\nexclude courier/words.txt\n",
        MODULES | {"python/courier/data/one.csv"} | PARTS,
    ),
}


@pytest.mark.parametrize("name", CONFIGURED)
def test_what_setup_cfg_and_pyproject_toml_install(folder: Path, name: str) -> None:
    cfg, pyproject, manifest, expected = CONFIGURED[name]
    (folder / "setup.py").write_text("from setuptools import setup\nsetup(name='courier')\n")
    for file, text in (
        ("setup.cfg", cfg),
        ("pyproject.toml", pyproject),
        ("MANIFEST.in", manifest),
    ):
        if text:
            (folder / file).write_text(text)
    assert installed(folder) == expected


# By statements before setup(): the arguments of setup(), and the message.
REFUSED = {
    "data_files = []\nfor each in read_list():\n    data_files.append(each)\n": (
        "packages=[name], data_files=data_files",
        "8: data_files: sitegen does not evaluate 'read_list()'",
    ),
    "data_files = []\nadd_all(data_files)\n": (
        "packages=[name], data_files=data_files",
        "8: data_files: sitegen does not evaluate 'add_all(data_files)'",
    ),
    "data_files = []\nalias = data_files\nif secret:\n    alias += [1]\n": (
        "packages=[name], data_files=data_files",
        "9: data_files: sitegen does not evaluate 'secret'",
    ),
    "def more(into):\n    into.append(unknown())\n\nall_of = []\nmore(all_of)\n": (
        "packages=[name], data_files=[('share/courier', all_of)]",
        "8: data_files: sitegen does not evaluate 'unknown()'",
    ),
    "files = []\nfor each in ['a']:\n    if secret:\n        continue\n    files.append(each)\n": (
        "packages=[name], data_files=[('share', files)]",
        "9: data_files: sitegen does not evaluate 'secret'",
    ),
    "def more(into):\n    if secret:\n        return\n    into.append('x')\n\nx = []\nmore(x)\n": (
        "packages=[name], data_files=[('share', x)]",
        "8: data_files: sitegen does not evaluate 'secret'",
    ),
    "import helper\nsettings = helper.settings()\n": (
        "**settings",
        "8: **: sitegen does not evaluate 'helper.settings()'",
    ),
    "while True:\n    name = name\n": ("", "1: setup.py takes too long to evaluate"),
    "x = ['a']\nfor i in range(60):\n    x = [x, x]\n": (
        "packages=x",
        "1: setup.py takes too long to evaluate",
    ),
    "x = 'a' * 99999\nfor i in range(60):\n    x = x.replace('a', x)\n": (
        "packages=[x]",
        "9: packages: sitegen does not evaluate 'x.replace(",
    ),
    "x = glob.glob('/**', recursive=True)\n": ("packages=x", "7: packages: sitegen does not"),
    "x = glob.glob('*/../../../**', recursive=True)\n": ("packages=x", "7: packages: sitegen does"),
    "x = open('/etc/passwd').read()\n": ("packages=[x]", "7: packages: sitegen does not evaluate"),
    "x = ().__class__.__base__\n": ("packages=[x]", "7: packages: sitegen does not evaluate"),
    "x = f'{name:>999999999}'\n": ("packages=[x]", "7: packages: sitegen does not evaluate"),
    "x = '%999999999s' % name\n": ("packages=[x]", "7: packages: sitegen does not evaluate"),
    "x = 2 ** 10 ** 10\n": ("packages=[x]", "7: packages: sitegen does not evaluate"),
    "def f():\n    return f()\n\nx = f()\n": ("packages=[x]", "8: packages: sitegen does not"),
    "": ("packages=['nobody']", "7: packages: no folder 'nobody' of 'nobody'"),
    "\n": (
        "packages=[], data_files=[('share', ['config/none.txt'])]",
        "8: data_files: no file 'config/none.txt' in the package",
    ),
    "\n\n": ("data_files=[('share', ['config'])]", "9: data_files: 'config' is a folder"),
    "\n\n\n": (
        "data_files=[('share', ['../../../etc/passwd'])]",
        "10: data_files: no file '../../../etc/passwd' in the package",
    ),
    "raise SystemExit(1)\n": ("", "7: sitegen does not evaluate 'raise SystemExit(1)'"),
}


@pytest.mark.parametrize("before", REFUSED)
def test_what_is_not_evaluated_is_said(folder: Path, before: str) -> None:
    arguments, expected = REFUSED[before]
    (folder / "setup.py").write_text(f"{HEAD}{before}setup(name=name, {arguments})\n")
    listing = setupfiles.read(folder)
    assert listing.fault is not None
    file, line, message = listing.fault
    assert file == folder / "setup.py"
    assert f"{line}: {message}".startswith(expected)


def test_files_beside_the_package_are_installed(folder: Path) -> None:
    (folder.parent / "shared.yaml").write_text("")
    (folder / "config/link.yaml").symlink_to("../../shared.yaml")
    setup = "data_files=[('share/courier', ['../shared.yaml', 'config/link.yaml'])]"
    (folder / "setup.py").write_text(f"{HEAD}setup(name=name, packages=[name], {setup})\n")
    listing = setupfiles.read(folder, folder.parent)
    assert listing.fault is None
    shared = {"share/courier/shared.yaml", "share/courier/link.yaml"}
    assert set(listing.files) == MODULES | shared
    # Without the folder around it, this file is no part of the site.
    fault = setupfiles.read(folder).fault
    assert fault
    assert fault[1:] == (7, "data_files: '../shared.yaml' leads outside the folder of site.yaml")
