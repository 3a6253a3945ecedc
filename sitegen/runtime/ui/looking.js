// @ts-check
// Let a part of the page work only while it is visible.

/**
 * Call `begin` when `element` becomes visible, and the function it returned when the element is scrolled out of view,
 * its <details> is closed or its tab is hidden.
 * @param {Element} element
 * @param {() => () => void} begin
 * @returns {() => void} stop observing
 */
export function whileSeen(element, begin) {
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
  });
  observer.observe(element);
  document.addEventListener("visibilitychange", look);
  return () => {
    observer.disconnect();
    document.removeEventListener("visibilitychange", look);
    inView = false;
    look();
  };
}
