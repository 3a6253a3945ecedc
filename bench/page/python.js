// @ts-check
// The worker of python.html: it loads Python, and that prints.

// @ts-expect-error: as the site serves it, beside its pages
import { loadPyodide } from "../runtime/vendor/pyodide/pyodide.mjs";

const python = await loadPyodide({ indexURL: new URL("../runtime/vendor/pyodide/", import.meta.url).href });
python.setStdout({ batched: (/** @type {string} */ line) => postMessage(line) });
python.runPython('print("Hello, world!")');
