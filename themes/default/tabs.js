// Tabs, for screen readers and keyboards; without it they are radio buttons.

/** @type {Record<string, (at: number, count: number) => number>} */
const KEYS = {
  ArrowRight: (at, count) => (at + 1) % count,
  ArrowLeft: (at, count) => (at + count - 1) % count,
  Home: () => 0,
  End: (_at, count) => count - 1,
};

offerTabs();
// `sitegen serve` changes the text of an open page.
document.addEventListener("sitegen:edited", offerTabs);

function offerTabs() {
  document.querySelectorAll(".tabbed-labels:not([role])").forEach(makeTabs);
}

/** @param {Element} list the labels of the radio buttons */
function makeTabs(list) {
  const set = /** @type {Element} */ (list.parentElement);
  const inputs = /** @type {NodeListOf<HTMLInputElement>} */ (set.querySelectorAll(":scope > input"));
  const tabs = /** @type {HTMLElement[]} */ ([...list.children]);
  const tell = () => tabs.forEach((tab, at) => {
    const chosen = Boolean(inputs[at]?.checked);
    tab.ariaSelected = String(chosen);
    tab.tabIndex = chosen ? 0 : -1;
  });
  list.role = "tablist";
  inputs.forEach((input, at) => {
    const [tab, panel] = [tabs[at], list.nextElementSibling?.children[at]];
    if (!tab || !panel) return;
    input.hidden = true;
    tab.role = "tab";
    panel.role = "tabpanel";
    tab.id = `${input.id}-tab`;
    panel.id = `${input.id}-panel`;
    tab.setAttribute("aria-controls", panel.id);
    panel.setAttribute("aria-labelledby", tab.id);
  });
  tell();
  // Shared links choose tabs, too.
  set.addEventListener("change", tell);
  list.addEventListener("keydown", (event) => {
    const { key, target } = /** @type {KeyboardEvent} */ (event);
    const next = KEYS[key]?.(tabs.indexOf(/** @type {HTMLElement} */ (target)), tabs.length) ?? -1;
    if (next < 0) return;
    event.preventDefault();
    tabs[next]?.click();
    tabs[next]?.focus();
  });
}
