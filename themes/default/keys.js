// Whether a key belongs to what has the focus, or to the page.

// What is typed into, and what has keys of its own: a robot that is steered, an application.
const TYPED = "input, textarea, select, [contenteditable], [role=application]";

/**
 * Return whether what has the focus takes the key itself. Its widget may have a shadow root, of which the
 * event's target shows only the host.
 *
 * @param {KeyboardEvent} event @param {string} [others] more elements that take it, as a selector
 */
export function takesKeys(event, others) {
  const selector = others ? `${TYPED}, ${others}` : TYPED;
  return event.composedPath().some((target) => target instanceof Element && target.matches(selector));
}
