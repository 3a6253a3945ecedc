// The service worker of a site that works without a network. Above this stand BUILD, what the site of one
// build consists of, the engine of this browser, and headers.js.
//
// A cache holds files of one build only: each is checked against its hash before it is kept, so old and new
// never meet, and again before it is served or kept for the next build, because any page of this server can write
// to the cache. Nothing else in a cache counts, neither headers nor status: a program of the site that is served as
// HTML would be a page without a policy. A new build waits until no page of the old one is open, or until a visitor
// asks for it.

const SCOPE = self.registration.scope;
const OURS = `sitegen:${SCOPE}:`;
const CACHE = OURS + BUILD.version;
const AT_ONCE = 6;
// Nodes are there twice, and a browser runs one of the two.
const OTHER = engine === "jspi" ? ".asyncify." : ".jspi.";

self.addEventListener("install", (event) => event.waitUntil(install()));
self.addEventListener("activate", (event) => event.waitUntil(forgetOthers()));
self.addEventListener("message", (event) => {
  if (event.data === "take over") self.skipWaiting();
  if (event.data === "keep") event.waitUntil(keepPage(nameOf(/** @type {Client} */ (event.source).url)));
});
self.addEventListener("fetch", (event) => {
  const { request } = event;
  const name = nameOf(request.url);
  if (request.method !== "GET" || name === undefined) return;
  if (name in BUILD.files) {
    event.respondWith(answer(name).then(isolating(request)));
    if (request.mode === "navigate") event.waitUntil(keepPage(name));
  } else if (request.mode === "navigate") {
    event.respondWith(elsewhere(request, name).then(isolating(request)));
  }
});

/** The name of a file in BUILD that an address means; undefined outside of the site. @param {string} address */
function nameOf(address) {
  const url = new URL(address);
  const whole = url.origin + url.pathname;
  if (!whole.startsWith(SCOPE)) return undefined;
  try {
    return decodeURIComponent(whole.slice(SCOPE.length)).replace(/(^|\/)index\.html$/, "$1");
  } catch {
    return undefined;
  }
}

/** @param {string} name of a file in BUILD */
function addressOf(name) {
  return SCOPE + name.split("/").map(encodeURIComponent).join("/");
}

/** A file of the build, from the cache where it is there. @param {string} name */
async function answer(name) {
  const cache = await caches.open(CACHE);
  try {
    return (await kept(cache, name)) ?? (await fetched(cache, name));
  } catch (error) {
    // Not reached, or of another build: then that is the one to have.
    self.registration.update().catch(() => {});
    console.warn(String(error));
    return Response.error();
  }
}

/** A file from the cache, if it is there and unchanged. @param {Cache} cache @param {string} name */
async function kept(cache, name) {
  const response = await cache.match(addressOf(name));
  const content = await response?.arrayBuffer();
  return content && (await isOfBuild(content, name)) ? responseOf(name, content) : undefined;
}

/** @param {ArrayBuffer} content @param {string} name of a file in BUILD */
async function isOfBuild(content, name) {
  const digest = new Uint8Array(await crypto.subtle.digest("SHA-256", content));
  const hash = Array.from(digest.subarray(0, 16), (byte) => byte.toString(16).padStart(2, "0")).join("");
  return hash === BUILD.files[name];
}

/** A file of the build; its media type is that of its name. @param {string} name @param {ArrayBuffer} content */
function responseOf(name, content) {
  const [suffix = ""] = /\.\w+$/.exec(name.endsWith("/") || !name ? ".html" : name) ?? [];
  const type = BUILD.types[suffix] ?? "application/octet-stream";
  return new Response(content, { headers: { "content-type": type, "x-content-type-options": "nosniff" } });
}

/** A page that the build does not have. @param {Request} request @param {string} name */
async function elsewhere(request, name) {
  if (`${name}/` in BUILD.files) return Response.redirect(addressOf(`${name}/`) + new URL(request.url).search);
  try {
    return await fetch(request);
  } catch {
    const page = await answer("404.html");
    return new Response(page.body, { status: 404, headers: page.headers });
  }
}

/** Fetch a file, and keep it if it is that of this build. @param {Cache} cache @param {string} name */
async function fetched(cache, name) {
  // The browser's own cache may hold another one for minutes.
  const response = await fetch(addressOf(name), { cache: "no-cache", credentials: "same-origin" });
  if (!response.ok) throw new Error(`${name}: ${response.status}`);
  const content = await response.arrayBuffer();
  if (!(await isOfBuild(content, name))) throw new Error(`${name} belongs to another build of this site`);
  await cache.put(addressOf(name), responseOf(name, content));
  return responseOf(name, content);
}

/** Fill the cache: what has not changed comes from that of the build before. */
async function install() {
  const cache = await caches.open(CACHE);
  const before = await Promise.all((await others()).map((name) => caches.open(name)));
  const later = new Set(BUILD.later);
  await each(Object.keys(BUILD.files), async (name) => {
    if (await kept(cache, name)) return;
    let wanted = !later.has(name) && !name.includes(OTHER);
    for (const old of before) {
      const known = await kept(old, name);
      if (known) return cache.put(addressOf(name), known);
      // What was kept stays kept, as it is now.
      wanted ||= (await old.match(addressOf(name))) !== undefined;
    }
    if (wanted) await fetched(cache, name);
  });
}

/** Keep what a page needs beside that which is kept anyway. @param {string | undefined} name */
async function keepPage(name) {
  if (name === undefined) return;
  const cache = await caches.open(CACHE);
  const wanted = (BUILD.pages[name] ?? []).filter((path) => !path.includes(OTHER));
  await each(wanted, async (path) => {
    if (!(await kept(cache, path))) await fetched(cache, path);
  }).catch(() => {});
}

async function forgetOthers() {
  await Promise.all((await others()).map((name) => caches.delete(name)));
}

/** The caches of other builds of this site; other sites may live on the same server. */
async function others() {
  return (await caches.keys()).filter((name) => name.startsWith(OURS) && name !== CACHE);
}

/**
 * Do something for each, a few at once.
 * @param {string[]} items @param {(item: string) => Promise<void>} work
 */
async function each(items, work) {
  const waiting = [...items];
  const next = async () => {
    for (let item = waiting.shift(); item !== undefined; item = waiting.shift()) await work(item);
  };
  await Promise.all(Array.from({ length: AT_ONCE }, next));
}
