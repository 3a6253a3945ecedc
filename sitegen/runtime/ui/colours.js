// @ts-check
// Tell drawings on a canvas, which know no style sheets, when the colours of the page change.

/** Call `changed` when the page becomes light or dark. @param {() => void} changed @returns {() => void} stop */
export function watchColours(changed) {
  const dark = matchMedia("(prefers-color-scheme: dark)");
  dark.addEventListener("change", changed);
  const observer = new MutationObserver(changed);
  observer.observe(document.documentElement, { attributes: true });
  return () => {
    dark.removeEventListener("change", changed);
    observer.disconnect();
  };
}
