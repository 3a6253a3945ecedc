// @ts-check
// Suspend Python while it waits. Pyodide's run_sync() takes ten times as long, because it goes through five callbacks
// of asyncio. Instead, Python calls poll() without files, whose JavaScript half waits for the promise given here.

/** @type {Promise<void> | null} */
let next = null;

/** Let the next poll() wait for `promise`. @param {Promise<void>} promise */
export function suspend(promise) {
  next = promise;
}

/** @param {any} python the loaded Pyodide */
export function setAside(python) {
  python._module.SOCKFS.pollAsync = () => {
    const promise = next?.then(() => 0) ?? null;
    next = null;
    return promise;
  };
}
