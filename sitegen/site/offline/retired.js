// In place of the service worker of a site that no longer works without a network: it forgets all, and goes.

self.addEventListener("install", () => self.skipWaiting());
self.addEventListener("activate", (event) => event.waitUntil(leave()));

async function leave() {
  const names = (await caches.keys()).filter((name) => name.startsWith(`sitegen:${self.registration.scope}:`));
  await Promise.all(names.map((name) => caches.delete(name)));
  await self.registration.unregister();
  // Pages that it served load anew, from the server.
  for (const page of await self.clients.matchAll({ type: "window" })) {
    await page.navigate(page.url).catch(() => {});
  }
}
