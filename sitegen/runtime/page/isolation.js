// @ts-check
// Isolation: a page whose files come with two more headers may share memory with its workers. Where the server
// cannot send them the site's service worker adds them, so the first visit to a site loads its page twice.

import { create } from "../ui/elements.js";
import { say } from "../ui/words.js";

// In the storage of the tab while a page loads for the second time: before the address of the service worker.
const AGAIN = "sitegen:isolated:";

let wanted = false;
/** Why there is no isolation, for the console of who would need it. */
let reason = "";

/** Why Python cannot stand still here, as the end of a sentence; empty if the site does not ask for isolation. */
export function obstacle() {
  if (!wanted) return "";
  if (globalThis.crossOriginIsolated) return "; it does not support shared memory either";
  return `; shared memory would do instead, but ${reason}`;
}

/**
 * Isolate the page; this does not return when it is loaded once more for that.
 * @param {string} script the service worker of the site
 */
export async function isolate(script) {
  wanted = true;
  if (globalThis.crossOriginIsolated) {
    keep(script, false);
    return;
  }
  reason = hindrance(script);
  if (reason) return;
  const word = create("div", "ros-word", say("This page reloads once to enable shared memory."));
  word.setAttribute("role", "status");
  document.body.append(word);
  try {
    await activated(await navigator.serviceWorker.register(script));
    keep(script, true);
    location.reload();
    await new Promise(() => {});
  } catch (error) {
    word.remove();
    reason = `its service worker could not be installed (${error instanceof Error ? error.message : error})`;
  }
}

/** What stands in the way, empty if nothing does. @param {string} script */
function hindrance(script) {
  if (window !== top) return "this page is embedded in another page; open it in its own tab";
  if (!isSecureContext) return "this page was not loaded over https://; open its https:// address";
  if (!("serviceWorker" in navigator)) return "this browser does not allow service workers here; try a window that is not private";
  try {
    if (sessionStorage.getItem(AGAIN + script)) {
      keep(script, false); // whoever reloads by hand may try again
      return "reloading did not isolate this page; close its other tabs and reload it";
    }
  } catch {
    return "this browser does not let this page store data; allow it to";
  }
  return "";
}

/** @param {string} script @param {boolean} loading whether the page loads for the second time */
function keep(script, loading) {
  try {
    if (loading) sessionStorage.setItem(AGAIN + script, "1");
    else sessionStorage.removeItem(AGAIN + script);
  } catch {
    // Then it was isolated by its server.
  }
}

/** Resolve when a service worker stands between the server and the pages to come. @param {ServiceWorkerRegistration} registration */
function activated({ active, waiting, installing }) {
  const worker = active ?? waiting ?? installing;
  return /** @type {Promise<void>} */ (new Promise((resolve, reject) => {
    const look = () => {
      if (worker?.state === "activated") resolve();
      if (worker?.state === "redundant") reject(new Error("the site is being published or cannot be reached"));
    };
    worker?.addEventListener("statechange", look);
    look();
  }));
}
