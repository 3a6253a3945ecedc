// @ts-check
// Style sheets of libraries. The page's policy forbids <style> elements, and allows sheets that a script constructs.

/** Apply a style sheet to the page. @param {string} text @returns {() => void} remove it */
export function adoptStyle(text) {
  const sheet = new CSSStyleSheet();
  sheet.replaceSync(text);
  return adopt(sheet);
}

/**
 * Create an element for a library that would create a <style> element: its text is the style sheet. vendor.mjs lets
 * libraries call this.
 * @returns {HTMLElement}
 */
export function styleElement() {
  const element = document.createElement("template");
  const sheet = new CSSStyleSheet();
  const remove = adopt(sheet);
  Object.defineProperty(element, "textContent", { set: (text) => sheet.replaceSync(text) });
  element.remove = () => {
    remove();
    Element.prototype.remove.call(element);
  };
  return element;
}

/** @param {CSSStyleSheet} sheet */
function adopt(sheet) {
  document.adoptedStyleSheets = [...document.adoptedStyleSheets, sheet];
  return () => {
    document.adoptedStyleSheets = document.adoptedStyleSheets.filter((one) => one !== sheet);
  };
}
