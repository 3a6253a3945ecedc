// Compile Python modules with the Python of pages, as bytecode that asks for no source. Run by hatch_build.py:
//
//   node bytecode.mjs SOURCES.zip BYTECODE.zip LIBRARY.zip
//
// BYTECODE.zip gets the modules of SOURCES.zip; sitegen/nodes/python/bytecode.py names its members. LIBRARY.zip gets
// the library of Python, with the bytecode of what Python itself and these modules import: to compile it took two
// thirds of the time that Python needs to start.

import { readFile, writeFile } from "node:fs/promises";
import { loadPyodide } from "pyodide";

const COMPILE = `
import ast
import importlib
import importlib._bootstrap_external as external
import importlib.util
import json
import sys
import zipfile

LIBRARY = next(path for path in sys.path if path.endswith(".zip"))

def compiled(source, place):
    # Without a check: what stands beside it in the archive is what it was made of.
    code = compile(source, place, "exec", dont_inherit=True)
    return external._code_to_hash_pyc(code, importlib.util.source_hash(source), False)

def add(archive, name, content):
    archive.writestr(zipfile.ZipInfo(name), content, zipfile.ZIP_DEFLATED, 9)

def compile_all(sources):
    with zipfile.ZipFile("/bytecode.zip", "w") as target:
        for name, place in json.loads(sources.read("places.json")).items():
            add(target, name, compiled(sources.read(name), f"/ros/{place}"))

def import_library(sources):
    """Import what the modules import of Python's library, as far as pages have it."""
    names = set()
    for name in json.loads(sources.read("places.json")):
        for node in ast.walk(ast.parse(sources.read(name))):
            if isinstance(node, ast.Import):
                names |= {one.name for one in node.names}
            elif isinstance(node, ast.ImportFrom) and node.module and not node.level:
                names |= {node.module, *(f"{node.module}.{one.name}" for one in node.names)}
    for name in sorted(names):
        if name.partition(".")[0] in sys.stdlib_module_names:
            try:
                importlib.import_module(name)
            except ImportError:
                pass

def complete_library():
    """Copy the library, with bytecode beside the modules that have been imported."""
    origins = (getattr(module.__spec__, "origin", None) for module in list(sys.modules.values()))
    wanted = {origin.removeprefix(f"{LIBRARY}/") for origin in origins if origin and origin.startswith(LIBRARY)}
    with zipfile.ZipFile(LIBRARY) as source, zipfile.ZipFile("/library.zip", "w") as target:
        for name in source.namelist():
            content = source.read(name)
            add(target, name, content)
            if name in wanted:
                add(target, f"{name}c", compiled(content, f"{LIBRARY}/{name}"))

with zipfile.ZipFile("/sources.zip") as sources:
    compile_all(sources)
    import_library(sources)
complete_library()
`;

const [sources, bytecode, library] = process.argv.slice(2);
const python = await loadPyodide();
python.FS.writeFile("/sources.zip", await readFile(sources));
python.runPython(COMPILE);
await writeFile(bytecode, python.FS.readFile("/bytecode.zip"));
await writeFile(library, python.FS.readFile("/library.zip"));
