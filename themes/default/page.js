// What a page offers beside its text: the switch of colours, buttons to copy code, the search.
// Without it the page is complete, so the buttons it serves are hidden until it runs.

import { takesKeys } from "./keys.js";
import { loadSheet } from "./sheet.js";

/** @type {AbortController | undefined} */
let reading;

offerColours();
offerCopies();
offerSearch();
leaveFrame();
followHeadings();
// `sitegen serve` changes the text of an open page.
document.addEventListener("sitegen:edited", () => {
  offerCopies();
  leaveFrame();
  followHeadings();
});

/** Let the button go through: as the device, light, dark; the choice is kept for the site. */
function offerColours() {
  const button = /** @type {HTMLElement | null} */ (document.querySelector(".colours-button"));
  if (!button) return;
  const root = document.documentElement;
  const show = () => {
    const now = root.dataset.colours ?? "auto";
    const text = `${button.dataset.label}: ${button.dataset[now]}`;
    button.setAttribute("aria-label", text);
    button.title = text;
  };
  button.addEventListener("click", () => {
    const next = { auto: "light", light: "dark" }[root.dataset.colours ?? "auto"];
    if (next) root.dataset.colours = next;
    else delete root.dataset.colours;
    try {
      if (next) localStorage.setItem("colours", next);
      else localStorage.removeItem("colours");
    } catch {
      // Kept for this page only.
    }
    show();
  });
  show();
  button.hidden = false;
}

/** Give every block of code a button that copies it. */
function offerCopies() {
  if (!navigator.clipboard) return;
  const { copy = "", copied = "" } = document.body.dataset;
  for (const block of document.querySelectorAll("div.code:not(:has(> .copy))")) {
    const button = document.createElement("button");
    button.type = "button";
    button.className = "copy";
    button.textContent = copy;
    button.addEventListener("click", async () => {
      await navigator.clipboard.writeText(block.querySelector("code")?.textContent ?? "");
      button.textContent = copied;
      setTimeout(() => (button.textContent = copy), 1500);
    });
    block.append(button);
  }
}

/** Load the search when somebody wants it: by the button, Ctrl-K or a slash. */
function offerSearch() {
  const dialog = /** @type {HTMLDialogElement | null} */ (document.querySelector("dialog.search"));
  const button = /** @type {HTMLElement | null} */ (document.querySelector(".search-button"));
  if (!dialog || !button) return;
  const input = /** @type {HTMLInputElement} */ (dialog.querySelector("input"));
  /** @type {Promise<void> | undefined} */
  let loading;
  const load = () => (loading ??= loadSearch(dialog).catch(() => {
    // Without a connection, for example. The next time may succeed; some browsers remember that a module failed.
    loading = undefined;
    const status = dialog.querySelector("[role=status]");
    if (status) status.textContent = dialog.dataset.failed ?? "";
  }));
  const open = () => {
    if (dialog.open) return;
    // At once, so that what is typed while the rest loads is part of the query.
    dialog.showModal();
    input.select();
    load();
  };
  button.addEventListener("click", open);
  // Enter waits for the results of what was typed before it.
  dialog.addEventListener("keydown", async (event) => {
    if (event.key !== "Enter" || event.target !== input || event.isComposing) return;
    event.preventDefault();
    await load();
    if (dialog.open) dialog.querySelector("a")?.click();
  });
  document.addEventListener("keydown", (event) => {
    const slash = event.key === "/" && !takesKeys(event) && !event.ctrlKey && !event.metaKey && !event.altKey;
    const letter = (event.ctrlKey || event.metaKey) && event.key.toLowerCase() === "k";
    if (event.defaultPrevented || (!slash && !letter)) return;
    event.preventDefault();
    open();
  });
  button.hidden = false;
}

/**
 * Fill the dialog of the search. It is not seen without its styles.
 *
 * @param {HTMLDialogElement} dialog
 */
async function loadSearch(dialog) {
  dialog.style.opacity = "0";
  const parts = Promise.all([import("./search.js"), loadSheet("search.css")]);
  const [{ fillSearch }] = await parts.finally(() => (dialog.style.opacity = ""));
  await fillSearch(dialog);
}

/** In a frame of another page, let links to other pages open beside it. */
function leaveFrame() {
  if (!("embed" in document.documentElement.dataset)) return;
  for (const link of /** @type {NodeListOf<HTMLAnchorElement>} */ (document.querySelectorAll("a[href]"))) {
    if (!link.getAttribute("href")?.startsWith("#")) link.target = "_blank";
  }
}

/** Mark in the table of contents what is being read. */
function followHeadings() {
  reading?.abort();
  reading = new AbortController();
  const { signal } = reading;
  const links = new Map();
  for (const link of document.querySelectorAll(".toc a")) {
    const id = decodeURIComponent(link.getAttribute("href")?.slice(1) ?? "");
    const heading = document.getElementById(id);
    if (heading) links.set(heading, link);
  }
  if (!links.size) return;
  const mark = () => {
    let current = null;
    for (const [heading, link] of links) {
      if (heading.getBoundingClientRect().top < innerHeight / 3) current = link;
    }
    for (const link of links.values()) link.toggleAttribute("data-current", link === current);
  };
  addEventListener("scroll", mark, { passive: true, signal });
  mark();
}
