// @ts-check
// Cross-origin isolation, which shared memory requires. It depends on two HTTP headers. If the server does not send
// them, the site's service worker adds them, and the page is loaded a second time on the first visit.

import { create } from "../ui/elements.js";
import { say } from "../ui/words.js";

// The key in sessionStorage, followed by the address of the service worker, while a page is loaded a second time.
const AGAIN = "sitegen:isolated:";

/**
 * Isolate the page, and return why that is not possible, or "". If the page is reloaded, this function does not return.
 * @param {string} script the service worker of the site
 */
export async function isolate(script) {
  if (globalThis.crossOriginIsolated) {
    keep(script, false);
    return "";
  }
  const reason = hindrance(script);
  if (reason) return reason;
  const word = create("div", "ros-word", say("This page reloads once to enable shared memory."));
  word.setAttribute("role", "status");
  document.body.append(word);
  try {
    await activated(await navigator.serviceWorker.register(script));
    keep(script, true);
    location.reload();
    return await new Promise(() => {});
  } catch (error) {
    word.remove();
    return `its service worker could not be installed (${error instanceof Error ? error.message : error})`;
  }
}

/** Return why the page cannot be isolated, or "". @param {string} script */
function hindrance(script) {
  if (window !== top) return "this page is embedded in another page; open it in its own tab";
  if (!isSecureContext) return "this page was not loaded over https://; open its https:// address";
  if (!("serviceWorker" in navigator)) return "this browser does not allow service workers here; try a window that is not private";
  try {
    if (sessionStorage.getItem(AGAIN + script)) {
      keep(script, false); // so that a manual reload tries again
      return "reloading did not isolate this page; close its other tabs and reload it";
    }
  } catch {
    return "this browser does not let this page store data; allow it to";
  }
  return "";
}

/** @param {string} script @param {boolean} loading whether the page is about to be loaded a second time */
function keep(script, loading) {
  try {
    if (loading) sessionStorage.setItem(AGAIN + script, "1");
    else sessionStorage.removeItem(AGAIN + script);
  } catch {
    // Without storage, only the server can have isolated the page.
  }
}

/** Resolve when the service worker is active. @param {ServiceWorkerRegistration} registration */
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
