// Compile the Python modules of a ZIP file with the Python of pages, as bytecode that asks for no source.
// Run by hatch_build.py: node bytecode.mjs SOURCES.zip BYTECODE.zip; sitegen/bytecode.py names the members.

import { readFile, writeFile } from "node:fs/promises";
import { loadPyodide } from "pyodide";

const COMPILE = `
import importlib._bootstrap_external as external
import importlib.util
import json
import zipfile

def compile_all():
    with zipfile.ZipFile("/sources.zip") as sources, zipfile.ZipFile("/bytecode.zip", "w", zipfile.ZIP_DEFLATED) as target:
        places = json.loads(sources.read("places.json"))
        for name, place in places.items():
            source = sources.read(name)
            code = compile(source, f"/ros/{place}", "exec", dont_inherit=True)
            # Without a check: what stands beside it in the archive is what it was made of.
            pyc = external._code_to_hash_pyc(code, importlib.util.source_hash(source), False)
            target.writestr(zipfile.ZipInfo(name), pyc, zipfile.ZIP_DEFLATED)

compile_all()
`;

const [sources, target] = process.argv.slice(2);
const python = await loadPyodide();
python.FS.writeFile("/sources.zip", await readFile(sources));
python.runPython(COMPILE);
await writeFile(target, python.FS.readFile("/bytecode.zip"));
