// Every way out of a worker that browsers have: to other servers, to the storage of the site, to its other pages, and
// to workers that are not confined. Part of scripts and of modules.

const OTHER = "<other>";
// The names that confine.js leaves.
const LEFT = new Set("<left>".split(" "));

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
  usb: () => navigator.usb.getDevices(),
  serial: () => navigator.serial.getPorts(),
  hid: () => navigator.hid.getDevices(),
  fonts: () => new FontFace("x", `url(${OTHER}font)`).load(),
  // To the server of the site, in the name of the visitor, or beside the site.
  neighbour: () => fetch(`${self.origin}/neighbour/`),
  change: () => fetch(`${self.origin}/site/change`, { method: "POST" }),
  socket: () => opened(new WebSocket(`${self.origin.replace("http", "ws")}/site/socket`), "open"),
  prototype: () => WorkerGlobalScope.prototype.fetch.call(self, `${OTHER}prototype`),
  constructed: () => fetch(new Request(`${OTHER}request`, { credentials: "include" })),
  // With what the guard of fetch() may believe in.
  replaced: () => {
    const [{ apply }, { startsWith }] = [Reflect, String.prototype];
    const own = Object.getOwnPropertyDescriptors(Request.prototype);
    Object.defineProperty(Request.prototype, "url", { get: () => `${self.origin}/site/`, configurable: true });
    Object.defineProperty(Request.prototype, "method", { get: () => "GET", configurable: true });
    String.prototype.startsWith = () => true;
    Reflect.apply = () => true;
    try {
      return fetch(`${self.origin}/neighbour/replaced`);
    } finally {
      Reflect.apply = apply;
      String.prototype.startsWith = startsWith;
      Object.defineProperties(Request.prototype, { url: own.url, method: own.method });
    }
  },
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

/** What the platform offers beside the names that are left. */
function left() {
  const found = [];
  for (const start of [globalThis, navigator]) {
    for (let owner = start; !Object.hasOwn(owner, "hasOwnProperty"); owner = Object.getPrototypeOf(owner)) {
      if (owner === EventTarget.prototype) continue;
      found.push(...Object.getOwnPropertyNames(owner).filter((name) => !LEFT.has(name)));
    }
  }
  return found;
}

/** Resolve with the names of the ways that are open. */
async function tryAll() {
  const more = left();
  // The files of the site are open, and no cookies go there.
  await fetch(`${self.origin}/site/page.json?guest`, { credentials: "include" });
  const found = await Promise.all(Object.entries(WAYS).map(async ([name, way]) => {
    const late = new Promise((_, reject) => setTimeout(() => reject(new Error("late")), 3000));
    try {
      await Promise.race([way(), late]);
      return [name];
    } catch {
      return [];
    }
  }));
  return ["open:", ...found.flat(), ...more].join(" ");
}
