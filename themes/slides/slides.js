// Turn a page into slides: a new one begins at every line `---` and at every heading of the first
// and second level. The number of the slide is in the address, so a link leads to it.

import { takesKeys } from "./keys.js";

const NEXT = ["ArrowRight", "ArrowDown", "PageDown", "Enter", " "];
const BEFORE = ["ArrowLeft", "ArrowUp", "PageUp", "Backspace"];
// What takes these keys itself, and what takes Enter and space.
const OWN_KEYS = "pre, dialog, [tabindex='0']";
const PRESSED = "button, summary, a";

const main = /** @type {HTMLElement} */ (document.querySelector("main"));
const deck = /** @type {HTMLElement} */ (document.querySelector(".deck"));
const slides = divide(main);
let current = 0;

present();

/**
 * Move the content of `main` into slides, and return them. Elements move, they are not made anew:
 * widgets find their places by id.
 *
 * @param {HTMLElement} main
 */
function divide(main) {
  /** @type {HTMLElement[]} */
  const slides = [];
  let ended = true;
  /** @param {Element} element */
  const add = (element) => {
    if (ended || !slides.length) {
      const slide = document.createElement("section");
      slide.className = "slide";
      slides.push(slide);
      ended = false;
    }
    slides.at(-1)?.append(element);
  };
  for (const child of [...main.children]) {
    if (!child.classList.contains("prose")) {
      if (child.localName === "h1") ended = true;
      add(child);
      continue;
    }
    /** @type {HTMLElement | null} */
    let text = null;
    for (const element of [...child.children]) {
      if (element.localName === "hr") {
        ended = true;
        text = null;
        continue;
      }
      if (["h1", "h2"].includes(element.localName)) {
        ended = true;
        text = null;
      }
      if (!text) {
        text = document.createElement("div");
        text.className = "prose";
        add(text);
      }
      text.append(element);
    }
    child.remove();
  }
  main.append(...slides);
  return slides;
}

/** Show one slide at a time, and let keys, buttons and the address choose it. */
function present() {
  const all = deck.querySelector(".all");
  main.classList.add("one");
  deck.hidden = false;
  deck.querySelector(".back")?.addEventListener("click", () => go(current - 1));
  deck.querySelector(".on")?.addEventListener("click", () => go(current + 1));
  all?.addEventListener("click", () => {
    all.setAttribute("aria-pressed", String(!main.classList.toggle("one")));
    slides[current]?.scrollIntoView();
  });
  document.addEventListener("keydown", (event) => {
    if (event.ctrlKey || event.metaKey || event.altKey || event.defaultPrevented) return;
    const own = ["Enter", " "].includes(event.key) ? `${OWN_KEYS}, ${PRESSED}` : OWN_KEYS;
    if (takesKeys(event, own)) return;
    const step = NEXT.includes(event.key) ? 1 : BEFORE.includes(event.key) ? -1 : 0;
    const end = { Home: 0, End: slides.length - 1 }[event.key];
    if (!step && end === undefined) return;
    event.preventDefault();
    go(end ?? current + (event.key === " " && event.shiftKey ? -1 : step));
  });
  addEventListener("hashchange", () => go(addressed()));
  go(addressed());
}

/** Return which slide the address names: by its number, or by the id of something on it. */
function addressed() {
  const name = decodeURIComponent(location.hash.slice(1));
  if (/^\d+$/.test(name)) return Number(name) - 1;
  const target = name ? document.getElementById(name) : null;
  const place = slides.findIndex((slide) => target !== null && slide.contains(target));
  return Math.max(place, 0);
}

/** @param {number} wanted */
function go(wanted) {
  current = Math.min(Math.max(wanted, 0), slides.length - 1);
  for (const [place, slide] of slides.entries()) slide.classList.toggle("current", place === current);
  const number = deck.querySelector(".number");
  if (number) number.textContent = `${current + 1} / ${slides.length}`;
  const [back, on] = [".back", ".on"].map((name) => deck.querySelector(name));
  back?.toggleAttribute("disabled", current === 0);
  on?.toggleAttribute("disabled", current === slides.length - 1);
  if (main.classList.contains("one")) {
    scrollTo(0, 0);
    history.replaceState(null, "", current ? `#${current + 1}` : location.pathname + location.search);
  } else {
    slides[current]?.scrollIntoView();
  }
}
