// @ts-check
// How Python is set aside while it waits. Its own run_sync() goes through five callbacks of asyncio and takes ten
// times as long; what the C function poll() waits for goes to the browser directly, and of nothing to look at
// it waits for what is given here.

/** @type {Promise<void> | null} */
let next = null;

/** Let poll() wait for `promise`, once. @param {Promise<void>} promise */
export function suspend(promise) {
  next = promise;
}

/** @param {any} python that was loaded */
export function setAside(python) {
  python._module.SOCKFS.pollAsync = () => {
    const promise = next?.then(() => 0) ?? null;
    next = null;
    return promise;
  };
}
