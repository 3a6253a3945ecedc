// @ts-check
// Make the elements that panels consist of. Text is set as text: it may come from a node.

/**
 * @template {keyof HTMLElementTagNameMap} Tag
 * @param {Tag} tag
 * @param {string} className
 * @param {(Node | string)[]} content
 * @returns {HTMLElementTagNameMap[Tag]}
 */
export function create(tag, className, ...content) {
  const element = document.createElement(tag);
  if (className) element.className = className;
  element.append(...content);
  return element;
}

/** @param {string} text @param {string} className @param {() => void} press */
export function button(text, className, press) {
  const element = create("button", className, text);
  element.type = "button";
  element.addEventListener("click", press);
  return element;
}

/** A labelled checkbox. @param {string} text @param {(on: boolean) => void} change */
export function toggle(text, change) {
  const box = create("input", "");
  box.type = "checkbox";
  box.addEventListener("change", () => change(box.checked));
  return create("label", "ros-toggle", box, text);
}

/** Set text only where it is another: what is selected in it, or read out, stays. @param {Element} element @param {string} text */
export function setText(element, text) {
  if (element.textContent !== text) element.textContent = text;
}

/**
 * Let `list` hold these elements in this order; those that stay are not moved, so that one with the
 * keyboard keeps it.
 * @param {Element} list @param {Element[]} wanted
 */
export function arrange(list, wanted) {
  for (const child of [...list.children]) {
    if (!wanted.includes(child)) child.remove();
  }
  wanted.forEach((element, index) => {
    const there = list.children[index] ?? null;
    if (there !== element) list.insertBefore(element, there);
  });
}
