// @ts-check
// HTML that a program made, such as a table: only its structure is kept. What could load, run or submit something, or
// change the look of the page, is left out.

const TAGS = new Set([
  "a", "abbr", "b", "blockquote", "br", "caption", "code", "col", "colgroup", "dd", "del", "details", "div", "dl", "dt",
  "em", "figcaption", "figure", "h1", "h2", "h3", "h4", "h5", "h6", "hr", "i", "img", "kbd", "li", "mark", "ol", "p",
  "pre", "q", "s", "samp", "small", "span", "strong", "sub", "summary", "sup", "table", "tbody", "td", "tfoot", "th",
  "thead", "tr", "u", "ul", "var",
]);
// Elements whose content is no text for readers.
const WHOLE = new Set([
  "button", "canvas", "embed", "form", "frame", "head", "iframe", "input", "link", "math", "meta", "noscript", "object",
  "script", "select", "style", "svg", "template", "textarea", "title",
]);
const ATTRIBUTES = new Set(["alt", "colspan", "height", "open", "rowspan", "scope", "start", "title", "width"]);
const LINK = /^(https?:|mailto:)/i;
const IMAGE = /^data:image\/(png|jpeg|gif|webp|svg\+xml)[;,]/i;

// Even in a document that runs nothing, the policy of the page reports these.
const TAG = /<[a-z][^>]*>/gi;
const REPORTED = /(\s|["'/])(on\w+|style)(?=\s*=)/gi;
const STYLE = /<(\/?)style\b/gi;

/** Return the harmless parts of HTML as elements. @param {string} html */
export function cleanHtml(html) {
  const quiet = html.replace(STYLE, "<$1template").replace(TAG, (tag) => tag.replace(REPORTED, "$1data-left-out"));
  // Nothing in this document loads or runs.
  const { body } = new DOMParser().parseFromString(quiet, "text/html");
  const found = document.createDocumentFragment();
  found.append(...kept(body));
  return found;
}

/** @param {Node} parent @returns {Node[]} */
function kept(parent) {
  return [...parent.childNodes].flatMap((node) => {
    if (node instanceof Text) return [document.createTextNode(node.data)];
    const name = node.nodeName.toLowerCase();
    if (!(node instanceof Element) || WHOLE.has(name)) return [];
    return TAGS.has(name) ? [copied(node, name)] : kept(node);
  });
}

/** @param {Element} from @param {string} name */
function copied(from, name) {
  const element = document.createElement(name);
  for (const { name: attribute, value } of from.attributes) {
    if (ATTRIBUTES.has(attribute)) element.setAttribute(attribute, value);
  }
  const href = from.getAttribute("href") ?? "";
  if (element instanceof HTMLAnchorElement && LINK.test(href)) {
    element.href = href;
    element.rel = "noopener noreferrer";
    element.target = "_blank";
  }
  const source = from.getAttribute("src") ?? "";
  if (element instanceof HTMLImageElement && IMAGE.test(source)) element.src = source;
  element.append(...kept(from));
  return element;
}
