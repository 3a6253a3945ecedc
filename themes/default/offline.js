// A site that works without a network: its service worker, and word of a new version.

const about = /** @type {HTMLLinkElement | null} */ (document.querySelector("link[rel=manifest]"));
// A frame of another site has no place of its own to keep anything.
if (about && "serviceWorker" in navigator && window === top) {
  if (document.readyState === "complete") begin(about);
  else addEventListener("load", () => begin(about));
}

/** @param {HTMLLinkElement} about */
async function begin(about) {
  const { serviceWorker } = navigator;
  const script = new URL(about.dataset.worker ?? "", document.baseURI).href;
  const registration = await serviceWorker.register(script);
  const look = () => {
    // The first one of all has no older one to replace.
    if (registration.waiting && registration.active) offer(registration, about);
  };
  const follow = () => registration.installing?.addEventListener("statechange", look);
  registration.addEventListener("updatefound", follow);
  // The browser may have found a new version before this module ran.
  follow();
  look();
  // Browsers look for a new version when they find the time, which may be after the visit.
  const update = () => registration.update().catch(() => {});
  if (registration.active) update();
  document.addEventListener("visibilitychange", () => {
    if (document.visibilityState === "visible") update();
  });
  // Every page of the old version has to go with it.
  if (serviceWorker.controller) {
    serviceWorker.addEventListener("controllerchange", () => location.reload());
  }
  (await serviceWorker.ready).active?.postMessage("keep");
}

/** @param {ServiceWorkerRegistration} registration @param {HTMLLinkElement} about */
function offer(registration, about) {
  if (document.querySelector(".news")) return;
  const news = document.createElement("div");
  news.className = "news";
  news.setAttribute("role", "status");
  const button = document.createElement("button");
  button.type = "button";
  button.textContent = about.dataset.load ?? "";
  button.addEventListener("click", () => {
    if (!navigator.serviceWorker.controller) {
      navigator.serviceWorker.addEventListener("controllerchange", () => location.reload());
    }
    if (registration.waiting) registration.waiting.postMessage("take over");
    else location.reload();
  });
  news.append(about.dataset.news ?? "", button);
  document.body.append(news);
}
