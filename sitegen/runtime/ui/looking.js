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
  return observe(element, begin, {}, false);
}

/**
 * Like whileSeen, but already within a screen of the visible part, so that a panel has its content before one scrolls
 * to it; and wherever it is while the page is printed.
 * @param {Element} element
 * @param {() => () => void} begin
 * @returns {() => void} stop observing
 */
export function whileNear(element, begin) {
  return observe(element, begin, { rootMargin: "100% 0px" }, true);
}

/**
 * @param {Element} element @param {() => () => void} begin @param {IntersectionObserverInit} options
 * @param {boolean} onPaper
 */
function observe(element, begin, options, onPaper) {
  let inView = false;
  let printed = false;
  /** @type {(() => void) | undefined} */
  let end;
  const look = () => {
    const seen = (inView || printed) && document.visibilityState === "visible";
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
  const print = (/** @type {Event} */ { type }) => {
    printed = type === "beforeprint";
    look();
  };
  observer.observe(element);
  const stopped = new AbortController();
  const { signal } = stopped;
  document.addEventListener("visibilitychange", look, { signal });
  if (onPaper) for (const type of ["beforeprint", "afterprint"]) addEventListener(type, print, { signal });
  return () => {
    observer.disconnect();
    stopped.abort();
    inView = printed = false;
    look();
  };
}
