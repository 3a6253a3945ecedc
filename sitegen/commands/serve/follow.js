// @ts-check
// Beside each page that `sitegen serve` shows: follows the site as its author edits it.
//
// Text, widgets and nodes change in the open page, and style sheets are exchanged; only what is none of these loads
// the page anew, in the state that it has.

import { buildsOf, entryOf, rosMain, served, updateNodes, updateText } from "./update.js";

// A build that takes longer than this (ms) is announced.
const SOON = 400;
const KEPT = "sitegen:kept";
// A file, a line and perhaps a column.
const PLACE = /^[^:\n]+:\d+(:\d+)?(?=:)/gm;
// A link whose nodes start without asking the visitor. As in sharing.js.
const OWN = "sitegen:own";

const folder = decodeURI(location.pathname).replace(/^\//, "").replace(/[^/]*$/, "");
const file = /\/$/.test(location.pathname) ? `${folder}index.html` : decodeURI(location.pathname.slice(1));
const style = document.createElement("link");
style.rel = "stylesheet";
style.href = "/_sitegen/follow.css";
document.head.append(style);

const box = document.createElement("section");
box.className = "sitegen-problems";
box.setAttribute("role", "alert");
box.hidden = true;
const status = document.createElement("p");
status.className = "sitegen-building";
status.setAttribute("role", "status");
status.hidden = true;
document.body.append(box, status);

let entry = await entryOf();
let page = await served();
forgetKept();
// The site was built again while this page was loading.
if (buildsOf(page) !== buildsOf(document)) await reload();

/** Edits are taken one after another. @type {Promise<unknown>} */
let work = Promise.resolve();
/** @type {ReturnType<typeof setTimeout> | undefined} */
let soon;

// A page with nodes names the engine of this browser; only this build of C++ nodes is made.
const asked = { engine: document.documentElement.dataset.engine ?? "", builds: buildsOf(page) };
const news = new EventSource(`/_sitegen/news?${new URLSearchParams(asked)}`);
let lost = false;
news.onerror = () => {
  lost = true;
};
news.onopen = () => {
  // The server was away, and the site may be another now.
  if (lost) reload();
};
news.addEventListener("building", () => {
  clearTimeout(soon);
  soon = setTimeout(() => tell("Building…"), SOON);
});
news.addEventListener("wrong", ({ data }) => {
  tell("");
  show(JSON.parse(data));
});
news.addEventListener("built", ({ data }) => {
  tell("");
  box.hidden = true;
  work = work.then(() => follow(JSON.parse(data))).catch((error) => {
    console.warn("sitegen serve: the page is loaded anew:", error);
    return reload();
  });
});

/** @param {string[]} changed paths of files of the site */
async function follow(changed) {
  const nothing = "nothingYet" in document.documentElement.dataset;
  const modules = changed.some((path) => path.endsWith(".js") && !path.startsWith("nodes/"));
  if (nothing || modules || !(await update(changed.includes(file)))) {
    await reload();
    return;
  }
  if (changed.some((path) => path.endsWith(".css"))) restyle();
}

/** Change the page; false if it has to be loaded anew. @param {boolean} text whether its HTML is another */
async function update(text) {
  const [now, fresh, main] = await Promise.all([entryOf(), text ? served() : page, rosMain()]);
  if (Boolean(now) !== Boolean(entry) || Boolean(now) !== Boolean(main)) return false;
  const finish = now && entry && main && updateNodes(entry, now, main);
  if (main && !finish) return false;
  if (text && !updateText(page, fresh)) return false;
  await finish?.();
  page = fresh;
  entry = now;
  return true;
}

/** Load the page anew, with the nodes that run and what panels show. */
async function reload() {
  const main = await rosMain();
  if (main) {
    sessionStorage.setItem(KEPT, location.hash);
    const link = main.ros.link();
    sessionStorage.setItem(OWN, link);
    history.replaceState(null, "", link);
  }
  location.reload();
}

/** Give the page its own address again: that of a link would go on starting its nodes. */
function forgetKept() {
  const hash = sessionStorage.getItem(KEPT);
  if (hash === null) return;
  sessionStorage.removeItem(KEPT);
  if (location.hash.startsWith("#share=")) history.replaceState(null, "", location.pathname + location.search + hash);
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

/** Say what is going on, or nothing. @param {string} text */
function tell(text) {
  clearTimeout(soon);
  status.textContent = text;
  status.hidden = !text;
}

/** @param {string[]} lines */
function show(lines) {
  const title = document.createElement("h2");
  title.textContent = lines.length === 1 ? "1 problem" : `${lines.length} problems`;
  const close = document.createElement("button");
  close.type = "button";
  close.textContent = "×";
  close.setAttribute("aria-label", "Close");
  close.addEventListener("click", () => {
    box.hidden = true;
  });
  const list = document.createElement("ul");
  list.append(...lines.map(problem));
  box.replaceChildren(title, close, list);
  box.hidden = false;
}

/** A problem, in which each place at the start of a line can be opened in the author's editor. @param {string} text */
function problem(text) {
  const item = document.createElement("li");
  let end = 0;
  for (const found of text.matchAll(PLACE)) {
    item.append(text.slice(end, found.index), place(found[0]));
    end = found.index + found[0].length;
  }
  item.append(text.slice(end));
  return item;
}

/** @param {string} text a file, its line and, from a compiler, the column */
function place(text) {
  const open = document.createElement("button");
  open.type = "button";
  open.className = "place";
  open.title = "Open in the editor";
  open.textContent = text;
  open.addEventListener("click", async () => {
    const answer = await fetch("/_sitegen/open", { method: "POST", body: text });
    if (!answer.ok) open.title = await answer.text();
    open.dataset.done = String(answer.ok);
  });
  return open;
}
