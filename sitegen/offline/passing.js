// The service worker of a site that only wants its pages to be isolated: all comes from the server. Above this
// stand BUILD and headers.js.

self.addEventListener("install", () => self.skipWaiting());
self.addEventListener("activate", (event) => event.waitUntil(forget()));
self.addEventListener("fetch", (event) => {
  const { request } = event;
  if (request.mode !== "navigate" && request.destination !== "worker") return;
  event.respondWith(fetch(request).then(isolating(request)));
});

/** What it kept while it worked without a network. */
async function forget() {
  const ours = (await caches.keys()).filter((name) => name.startsWith(`sitegen:${self.registration.scope}:`));
  await Promise.all(ours.map((name) => caches.delete(name)));
}
