// @ts-check
// What programs may not use: everything by which they would reach other pages of the site, or outlive their own.

/**
 * Remove from this worker what gives access to the storage of the site, to its other pages and to further workers, which
 * would not be confined. It is called before the first instruction of a program. The text of this function is also
 * part of scripts, so it refers to nothing outside.
 */
export function confine() {
  const remove = (/** @type {any} */ object, /** @type {string} */ name) => {
    for (let owner = object; owner; owner = Object.getPrototypeOf(owner)) delete owner[name];
  };
  for (const name of ["caches", "indexedDB", "cookieStore", "BroadcastChannel", "importScripts", "Worker", "SharedWorker"]) {
    remove(globalThis, name);
  }
  for (const name of ["locks", "serviceWorker", "storage", "storageBuckets"]) remove(navigator, name);
}
