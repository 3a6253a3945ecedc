// @ts-check
// Let a part of the page work only while somebody can see it.

/**
 * Call `begin` when `element` becomes visible, and the function it returned when the element is scrolled out of view,
 * its <details> is closed or its tab is hidden.
 * @param {Element} element
 * @param {() => () => void} begin
 * @returns {() => void} stop observing
 */
export function whileSeen(element, begin) {
  return observe(element, begin, {});
}

/**
 * Like whileSeen, but already within a screen of the visible part, so that a panel has its content before one scrolls
 * to it.
 * @param {Element} element
 * @param {() => () => void} begin
 * @returns {() => void} stop observing
 */
export function whileNear(element, begin) {
  return observe(element, begin, { rootMargin: "100% 0px" });
}

/** @param {Element} element @param {() => () => void} begin @param {IntersectionObserverInit} options */
function observe(element, begin, options) {
  let inView = false;
  /** @type {(() => void) | undefined} */
  let end;
  const look = () => {
    const seen = inView && document.visibilityState === "visible";
    if (seen && !end) {
      end = begin();
    } else if (!seen && end) {
      end();
      end = undefined;
    }
  };
  const observer = new IntersectionObserver((entries) => {
    inView = entries.at(-1)?.isIntersecting ?? false;
    look();
  }, options);
  observer.observe(element);
  document.addEventListener("visibilitychange", look);
  return () => {
    observer.disconnect();
    document.removeEventListener("visibilitychange", look);
    inView = false;
    look();
  };
}
