// @ts-check
// Know whether anybody can see a part of the page, so that it works only then.

/**
 * Call `begin` when `element` comes into sight, and what it returned when it goes: scrolled away, in
 * a <details> that was closed, in a tab that is hidden.
 * @param {Element} element
 * @param {() => () => void} begin
 * @returns {() => void} end it for good
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
