// The dialog of the search: what is typed, what is found, and the keys to go through it.

/** @typedef {{ href: string, title: string, heading?: string, excerpt: string }} Found */
/** @typedef {{ search: (query: string) => Found[], pages: () => Found[], words: (query: string) => string[] }} Index */

const SHOWN = 20;

/**
 * Load the index that the dialog names, and show what is found in it.
 *
 * @param {HTMLDialogElement} dialog
 */
export async function fillSearch(dialog) {
  listen(dialog, await load(dialog));
}

/**
 * @param {HTMLDialogElement} dialog
 * @returns {Promise<Index>}
 */
async function load(dialog) {
  const { engine = "", index = "" } = dialog.dataset;
  const { loadIndex } = await import(new URL(engine, location.href).href);
  return loadIndex(new URL(index, location.href));
}

/**
 * @param {HTMLDialogElement} dialog
 * @param {Index} index
 */
function listen(dialog, index) {
  const input = /** @type {HTMLInputElement} */ (dialog.querySelector("input"));
  const list = /** @type {HTMLElement} */ (dialog.querySelector("ul"));
  const status = /** @type {HTMLElement} */ (dialog.querySelector("[role=status]"));

  function show() {
    const query = input.value;
    const found = query.trim() ? index.search(query).slice(0, SHOWN) : index.pages();
    const words = index.words(query);
    list.replaceChildren(...found.map((each) => line(each, words, dialog.dataset.home ?? "")));
    status.textContent = query.trim() ? counted(found.length, dialog.dataset) : "";
  }

  input.addEventListener("input", show);
  dialog.addEventListener("keydown", (event) => {
    const links = [...list.querySelectorAll("a")];
    const step = { ArrowDown: 1, ArrowUp: -1 }[event.key];
    if (step) {
      event.preventDefault();
      // Above the first line is the input.
      const now = links.findIndex((link) => link === document.activeElement);
      (links[now + step] ?? (now + step < 0 ? input : links[now]))?.focus();
    }
  });
  list.addEventListener("click", () => dialog.close());
  dialog.addEventListener("click", (event) => {
    if (event.target === dialog) dialog.close(); // beside it
  });
  show();
}

/**
 * @param {Found} found
 * @param {string[]} words
 * @param {string} home
 */
function line(found, words, home) {
  const item = document.createElement("li");
  const link = document.createElement("a");
  link.href = home + found.href;
  const title = document.createElement("b");
  title.append(...marked(found.heading ?? found.title, words));
  link.append(title);
  if (found.heading) {
    const page = document.createElement("small");
    page.textContent = found.title;
    link.append(page);
  }
  const text = document.createElement("span");
  text.append(...marked(found.excerpt, words));
  link.append(text);
  item.append(link);
  return item;
}

/**
 * Return `text` with what begins like one of `words` marked.
 *
 * @param {string} text
 * @param {string[]} words
 */
function marked(text, words) {
  return text.split(/([^\p{L}\p{N}]+)/u).map((piece) => {
    const word = words.find((each) => piece.toLowerCase().startsWith(each));
    if (!word) return piece;
    const mark = document.createElement("mark");
    mark.textContent = piece;
    return mark;
  });
}

/**
 * @param {number} count
 * @param {DOMStringMap} texts
 */
function counted(count, texts) {
  const text = count === 0 ? texts.none : count === 1 ? texts.one : texts.many;
  return (text ?? "").replace("{}", String(count));
}
