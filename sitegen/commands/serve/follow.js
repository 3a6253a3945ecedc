// @ts-check
// Beside each page that `sitegen serve` shows: follows the site as its author edits it.
//
// Looks are exchanged, nodes that changed start again, and only what is neither loads the page anew.

const folder = decodeURI(location.pathname).replace(/^\//, "").replace(/[^/]*$/, "");
const style = document.createElement("link");
style.rel = "stylesheet";
style.href = "/_sitegen/follow.css";
document.head.append(style);

const box = document.createElement("section");
box.className = "sitegen-problems";
box.setAttribute("role", "alert");
box.hidden = true;
document.body.append(box);

/** What page.json said the last time. @type {any} */
let entry = await read();

const news = new EventSource("/_sitegen/news");
let lost = false;
news.onerror = () => {
  lost = true;
};
news.onopen = () => {
  // The server was away, and the site may be another now.
  if (lost) location.reload();
};
news.addEventListener("wrong", ({ data }) => show(JSON.parse(data)));
news.addEventListener("built", async ({ data }) => {
  box.hidden = true;
  /** @type {string[]} */
  const changed = JSON.parse(data);
  const nothing = "nothingYet" in document.documentElement.dataset;
  const page = nothing || changed.includes(`${folder}index.html`);
  const modules = changed.some((path) => path.endsWith(".js") && !path.startsWith("nodes/"));
  if (page || modules || !(await exchange())) {
    location.reload();
    return;
  }
  if (changed.some((path) => path.endsWith(".css"))) restyle();
});

/** Start those nodes again that are other programs now; false if more than programs changed. */
async function exchange() {
  const now = await read();
  const [old, fresh] = [entry, now].map((all) => ({ ...all, nodes: Object.keys(all?.nodes ?? {}) }));
  delete old.types;
  delete fresh.types;
  if (JSON.stringify(old) !== JSON.stringify(fresh)) return false;
  const others = Object.keys(now?.nodes ?? {}).filter(
    (name) => JSON.stringify(now.nodes[name]) !== JSON.stringify(entry.nodes[name]));
  entry = now;
  if (others.length === 0) return true;
  const script = /** @type {HTMLScriptElement} */ (document.querySelector('script[src$="rosMain.js"]'));
  const { ros } = await import(script.src);
  for (const name of others) ros.nodes.get(name).replace(now.nodes[name]);
  return true;
}

/** page.json, if the page has one. */
async function read() {
  const link = /** @type {HTMLLinkElement | null} */ (document.getElementById("ros-page"));
  return link && (await fetch(link.href)).json();
}

function restyle() {
  const links = /** @type {NodeListOf<HTMLLinkElement>} */ (
    document.querySelectorAll('link[rel="stylesheet"]'));
  for (const link of links) {
    const fresh = /** @type {HTMLLinkElement} */ (link.cloneNode());
    const url = new URL(link.href);
    url.searchParams.set("at", String(Date.now()));
    fresh.href = url.href;
    // The old one stays until the new one is there: the page never shows without looks.
    fresh.onload = () => link.remove();
    link.after(fresh);
  }
}

/** @param {string[]} lines */
function show(lines) {
  const title = document.createElement("h2");
  title.textContent = lines.length === 1 ? "1 problem" : `${lines.length} problems`;
  const list = document.createElement("pre");
  list.textContent = lines.join("\n");
  box.replaceChildren(title, list);
  box.hidden = false;
}

export {};
