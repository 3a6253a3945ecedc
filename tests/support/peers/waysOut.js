// Every way out of a worker that browsers have: to other servers, to the storage of the site, to its other pages, and
// to workers that are not confined. Part of scripts and of modules.

const OTHER = "<other>";

const WAYS = {
  fetch: () => fetch(`${OTHER}fetch`),
  post: () => fetch(`${OTHER}post`, { method: "POST", mode: "no-cors", keepalive: true }),
  import: () => import(`${OTHER}import.js`),
  xhr: () => new Promise((resolve, reject) => {
    const request = new XMLHttpRequest();
    request.onload = resolve;
    request.onerror = reject;
    request.open("GET", `${OTHER}xhr`);
    request.send();
  }),
  importScripts: () => importScripts(`${OTHER}scripts.js`),
  ownScripts: () => importScripts("data:text/javascript,"),
  websocket: () => opened(new WebSocket(OTHER.replace("http", "ws")), "open"),
  events: () => opened(new EventSource(`${OTHER}events`), "open"),
  transport: () => new WebTransport(OTHER.replace("http", "https")).ready,
  worker: () => answered(new Worker(URL.createObjectURL(new Blob(["postMessage(1)"])))),
  dataWorker: () => answered(new Worker("data:text/javascript,postMessage(1)")),
  sharedWorker: () => new SharedWorker("data:text/javascript,"),
  caches: () => caches.open("x"),
  indexedDB: () => indexedDB.open("x"),
  cookieStore: () => cookieStore.getAll(),
  BroadcastChannel: () => new BroadcastChannel("x").close(),
  storage: () => navigator.storage.getDirectory(),
  locks: () => navigator.locks.query(),
  serviceWorker: () => navigator.serviceWorker.getRegistrations(),
};

function opened(source, event) {
  return new Promise((resolve, reject) => {
    source.addEventListener(event, () => resolve(source.close()));
    source.addEventListener("error", reject);
  });
}

function answered(worker) {
  return new Promise((resolve, reject) => {
    worker.onmessage = resolve;
    worker.onerror = reject;
  });
}

/** Resolve with the names of the ways that are open. */
async function tryAll() {
  const found = await Promise.all(Object.entries(WAYS).map(async ([name, way]) => {
    const late = new Promise((_, reject) => setTimeout(() => reject(new Error("late")), 3000));
    try {
      await Promise.race([way(), late]);
      return [name];
    } catch {
      return [];
    }
  }));
  return ["open:", ...found.flat()].join(" ");
}
