// The service worker of a site that only wants its pages to be isolated: all comes from the server. Above this
// stand BUILD and headers.js.

self.addEventListener("install", () => self.skipWaiting());
self.addEventListener("activate", (event) => event.waitUntil(forget()));
self.addEventListener("fetch", (event) => {
  const { request } = event;
  if (request.mode !== "navigate" && request.destination !== "worker") return;
  event.respondWith(whole(request).then(isolating(request)));
});

/**
 * The answer to a request, never that nothing has changed: WebKit asks for that, and has no use for it from here.
 * @param {Request} request
 */
async function whole(request) {
  const response = await fetch(request);
  return response.status === 304 ? fetch(request.url, { credentials: "same-origin" }) : response;
}

/** What it kept while it worked without a network. */
async function forget() {
  const ours = (await caches.keys()).filter((name) => name.startsWith(`sitegen:${self.registration.scope}:`));
  await Promise.all(ours.map((name) => caches.delete(name)));
}
