// @ts-check
// What the visitor does on this page, as messages of a hidden topic: for studies, and only with consent.

/** @import { Publisher, Ros } from "../../protocol.js" */

export const TOPIC = "/_page/actions";
const TYPE = "std_msgs/msg/String";
// Longer texts are cut off, in characters.
const LONGEST = 1000;
const CONTROLS = "button, a[href], input, select, textarea, summary, [role=button], [role=tab], [role=slider]";
// What these fields hold is nobody's business.
const SECRET = "[type=password], [type=file], [autocomplete^=cc-]";

/**
 * Publish each press of a button or a link, each change of a field, and each change of a node's state, until the
 * returned function is called. Each message is JSON: `action` is `press`, `set` or `state`; `panel` and `control` are
 * the names that screen readers say, `value` is what a field holds then.
 * @param {Ros} ros @param {Element} without whose own controls are left out @returns {() => void}
 */
export function follow(ros, without) {
  ros.types[TYPE] ??= { fields: [{ name: "data", type: "string" }], constants: [] };
  // A recorder that comes a moment later gets the first ones, too.
  const publisher = ros.advertise(TOPIC, TYPE, { depth: 1000, transientLocal: true });
  const press = (/** @type {Event} */ event) => note(publisher, without, event, "press");
  const set = (/** @type {Event} */ event) => note(publisher, without, event, "set");
  addEventListener("click", press, true);
  addEventListener("change", set, true);
  const unfollow = [...ros.nodes.values()].map((node) => {
    const tell = () => send(publisher, { action: "state", node: node.name, state: node.state });
    node.addEventListener("state", tell);
    return () => node.removeEventListener("state", tell);
  });
  return () => {
    removeEventListener("click", press, true);
    removeEventListener("change", set, true);
    for (const end of unfollow) end();
    publisher.close();
  };
}

/** @param {Publisher} publisher @param {Element} without @param {Event} event @param {"press" | "set"} action */
function note(publisher, without, { target }, action) {
  const control = target instanceof Element ? target.closest(CONTROLS) : null;
  if (!control || without.contains(control)) return;
  const isField = control.matches("input, select, textarea");
  // A field is set, not pressed; other controls are pressed only.
  if (isField !== (action === "set")) return;
  const panel = nameOf(control.parentElement?.closest("[aria-label], [aria-labelledby]"));
  const value = isField && !control.matches(SECRET) ? { value: valueOf(control) } : {};
  send(publisher, { action, panel, control: nameOf(control), ...value });
}

/** @param {Publisher} publisher @param {object} action */
function send(publisher, action) {
  try {
    publisher.publish({ data: JSON.stringify(action) });
  } catch (error) {
    console.warn(error); // the recorder is behind by a thousand actions
  }
}

/** What screen readers call an element. @param {Element | null | undefined} element */
function nameOf(element) {
  const labels = element && "labels" in element ? /** @type {HTMLInputElement} */ (element).labels : null;
  const by = element?.getAttribute("aria-labelledby");
  const text = element?.getAttribute("aria-label") ?? (by && document.getElementById(by)?.textContent) ??
    labels?.[0]?.textContent ?? (element?.matches("select, textarea, input") ? "" : element?.textContent) ?? "";
  return text.replace(/\s+/g, " ").trim().slice(0, LONGEST);
}

/** @param {Element} field */
function valueOf(field) {
  if (field instanceof HTMLInputElement && (field.type === "checkbox" || field.type === "radio")) return field.checked;
  return /** @type {HTMLInputElement} */ (field).value.slice(0, LONGEST);
}
