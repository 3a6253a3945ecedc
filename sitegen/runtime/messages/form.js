// @ts-check
// Turn a message type into a form, and the values typed there into a message.

import { create, button } from "../ui/elements.js";
import { isFloat, isInteger, isMessage, parseFieldType, range, readList, readScalar } from "./fieldType.js";
import { say } from "../ui/words.js";

/** @import { MessageType } from "../protocol.js" */
/** @import { FieldType } from "./fieldType.js" */

/**
 * @typedef {Record<string, MessageType>} Types
 * @typedef {{name: string, type: string, default?: any}} Field
 * @typedef {{name: string, value: any}} Choice a constant that is a value of the field
 * @typedef {{text: string, control: HTMLElement}} Fault an error, and the control that has it
 * @typedef {{element: HTMLElement, read(faults: Fault[]): any, typed(): any, fill(typed: any): boolean}} Part
 *   `typed` returns the values that the visitor has changed, undefined if there are none; `fill` restores them
 */

// The largest number of list items that a link may add.
const MOST = 100;

let lastId = 0;

/**
 * Create a form for messages of a type. `read` returns the message; if a value is invalid, it returns null, shows the
 * errors at their fields and focuses the first. `typed` returns the values that the visitor has changed, valid or not,
 * as JSON; `fill` restores them and returns whether all have a field. Throws an Error if the page does not know a type.
 * @param {string} type
 * @param {Types} types
 * @returns {{element: HTMLElement, read(): any, typed(): any, fill(typed: any): boolean}}
 */
export function createForm(type, types) {
  const { element, read, typed, fill } = messagePart(type, types);
  element.classList.add("ros-form");
  return {
    element,
    typed,
    fill,
    read() {
      /** @type {Fault[]} */
      const faults = [];
      const message = read(faults);
      faults[0]?.control.focus();
      return faults.length ? null : message;
    },
  };
}

/** @param {string} name @param {Types} types @returns {Part} */
function messagePart(name, types) {
  const type = types[name];
  if (!type) {
    throw new Error(say("this page has no definition of {}; start a node that uses it", name));
  }
  /** @type {[string, Part][]} */
  const parts = type.fields.map((field) => [field.name, fieldPart(field, type, types)]);
  const element = create("div", "ros-fields", ...parts.map(([, part]) => part.element));
  if (!parts.length) element.append(create("p", "ros-none", say("This type has no fields.")));
  const read = (/** @type {Fault[]} */ faults) =>
    Object.fromEntries(parts.map(([field, part]) => [field, part.read(faults)]));
  const typed = () => {
    const said = parts.map(([field, part]) => [field, part.typed()]).filter(([, value]) => value !== undefined);
    return said.length ? Object.fromEntries(said) : undefined;
  };
  const fill = (/** @type {any} */ values) => {
    if (typeof values !== "object" || values === null) return false;
    const known = new Map(parts);
    return Object.entries(values).map(([field, value]) => known.get(field)?.fill(value) ?? false).every(Boolean);
  };
  return { element, read, typed, fill };
}

/** @param {Field} field @param {MessageType} owner @param {Types} types @returns {Part} */
function fieldPart(field, owner, types) {
  const type = parseFieldType(field.type);
  if (isMessage(type.base)) {
    return type.array ? listPart(field, type, types) : nestedPart(field.name, field.type, type.base, types);
  }
  if (type.array) return inputPart(field, listText(field, type), (text) => readList(text, type));
  if (type.base === "bool") return flagPart(field);
  const text = String(field.default ?? (isInteger(type.base) || isFloat(type.base) ? 0 : ""));
  const choices = choicesFor(field, owner);
  const read = (/** @type {string} */ typed) => readScalar(typed, type);
  return choices.length ? choicePart(field, text, choices, read) : inputPart(field, text, read);
}

/**
 * Return the constants that are values of a field: those of the same type and, if the names of some begin with the name
 * of the field, only these.
 * @param {Field} field @param {MessageType} owner @returns {Choice[]}
 */
function choicesFor(field, owner) {
  const same = owner.constants.filter((constant) => plainType(constant.type) === plainType(field.type));
  const named = same.filter(({ name }) => name.startsWith(`${field.name.toUpperCase()}_`));
  return named.length ? named : same;
}

/** Return a type without bounds; byte and char are uint8. @param {string} type */
function plainType(type) {
  return type === "byte" || type === "char" ? "uint8" : type.replace(/<=\d+/, "");
}

/** Return the default value of an array, as text. @param {Field} field @param {FieldType} type */
function listText(field, { base, array, size }) {
  const none = base === "bool" ? false : isInteger(base) || isFloat(base) ? 0 : "";
  /** @type {unknown[]} */
  const values = field.default ?? (array === "fixed" ? Array(size).fill(none) : []);
  return `[${values.map((value) => (isInteger(base) ? value : JSON.stringify(value))).join(", ")}]`;
}

/** @param {Field} field @param {string} text @param {(typed: string) => any} read @returns {Part} */
function inputPart(field, text, read) {
  const { array, base } = parseFieldType(field.type);
  const input = array ? create("textarea", "") : create("input", "");
  input.value = text;
  input.spellcheck = false;
  input.autocomplete = "off";
  if (input instanceof HTMLTextAreaElement) input.rows = 1;
  else if (isFloat(base)) input.inputMode = "decimal";
  else if (isInteger(base)) input.inputMode = range(base).least < 0n ? "text" : "numeric";
  const put = (/** @type {string} */ value) => {
    input.value = value;
  };
  return labelled(field, input, () => read(input.value), () => (input.value === text ? undefined : input.value), put);
}

/**
 * A list of constants, and a field for other values.
 * @param {Field} field @param {string} text @param {Choice[]} choices
 * @param {(typed: string) => any} read @returns {Part}
 */
function choicePart(field, text, choices, read) {
  const options = choices.map(({ name, value }) => new Option(`${name} (${value})`, String(value)));
  const select = create("select", "", ...options, new Option(say("another value…"), ""));
  const other = create("input", "");
  other.setAttribute("aria-label", say("{}, another value", field.name));
  other.value = text;
  select.value = text;
  if (select.selectedIndex < 0) select.selectedIndex = options.length;
  const show = () => {
    other.hidden = select.selectedIndex < options.length;
  };
  select.addEventListener("change", show);
  show();
  const value = () => (other.hidden ? select.value : other.value);
  const put = (/** @type {string} */ now) => {
    other.value = now;
    select.value = now;
    if (select.selectedIndex < 0) select.selectedIndex = options.length;
    show();
  };
  const part = labelled(field, select, () => read(value()), () => (value() === text ? undefined : value()), put);
  select.after(other);
  return part;
}

/** @param {Field} field @returns {Part} */
function flagPart(field) {
  const box = create("input", "");
  box.type = "checkbox";
  box.defaultChecked = Boolean(field.default);
  const typed = () => (box.checked === box.defaultChecked ? undefined : String(box.checked));
  const part = labelled(field, box, () => box.checked, typed, (value) => {
    box.checked = value === "true";
  });
  part.element.classList.add("ros-flag");
  return part;
}

/**
 * A control with its label and its error.
 * @param {Field} field @param {HTMLElement} control @param {() => any} read
 * @param {() => string | undefined} typed @param {(text: string) => void} put @returns {Part}
 */
function labelled(field, control, read, typed, put) {
  control.id = `ros-field-${++lastId}`;
  const label = create("label", "", field.name, " ", create("small", "", field.type));
  label.htmlFor = control.id;
  const fault = create("p", "ros-fault");
  fault.id = `${control.id}-fault`;
  const element = create("div", "ros-field", label, control, fault);
  const tell = (/** @type {string} */ text) => {
    fault.textContent = text;
    if (text) {
      control.setAttribute("aria-invalid", "true");
      control.setAttribute("aria-describedby", fault.id);
    } else {
      control.removeAttribute("aria-invalid");
      control.removeAttribute("aria-describedby");
    }
  };
  element.addEventListener("input", () => tell(""));
  return {
    element,
    read(faults) {
      tell("");
      try {
        return read();
      } catch (error) {
        const text = error instanceof Error ? error.message : String(error);
        tell(text);
        faults.push({ text, control });
      }
    },
    typed,
    fill(value) {
      if (typeof value !== "string") return false;
      put(value);
      return true;
    },
  };
}

/** @param {string} title @param {string} type @param {string} base @param {Types} types @returns {Part} */
function nestedPart(title, type, base, types) {
  const { element: inner, ...part } = messagePart(base, types);
  const legend = create("legend", "", title, " ", create("small", "", type));
  return { element: create("fieldset", "ros-nested", legend, inner), ...part };
}

/**
 * An array of messages, with buttons to add and remove them.
 * @param {Field} field @param {FieldType} type @param {Types} types @returns {Part}
 */
function listPart(field, type, types) {
  /** @type {Part[]} */
  const parts = [];
  const list = create("div", "ros-items");
  const add = button(say("Add to {}", field.name), "", () => {
    append();
    const control = parts.at(-1)?.element.querySelector("input, select, textarea");
    if (control instanceof HTMLElement) control.focus();
  });
  const changed = () => {
    add.hidden = type.array === "fixed";
    add.disabled = parts.length >= type.size;
    parts.forEach(({ element }, index) => {
      const name = element.querySelector("legend span");
      if (name) name.textContent = `${field.name}[${index}]`;
    });
  };
  const append = () => {
    const part = nestedPart("", "", type.base, types);
    part.element.querySelector("legend")?.replaceChildren(create("span", ""));
    parts.push(part);
    if (type.array !== "fixed") {
      const remove = button(say("Remove"), "ros-remove", () => {
        parts.splice(parts.indexOf(part), 1);
        part.element.remove();
        changed();
        add.focus();
      });
      part.element.append(remove);
    }
    list.append(part.element);
    changed();
  };
  const first = type.array === "fixed" ? type.size : 0;
  const grow = (/** @type {number} */ count) => {
    while (parts.length < count) append();
  };
  grow(first);
  changed();
  const label = create("p", "ros-label", field.name, " ", create("small", "", field.type));
  const element = create("div", "ros-field", label, list, add);
  return {
    element,
    read: (faults) => parts.map((part) => part.read(faults)),
    typed() {
      const items = parts.map((part) => part.typed());
      const edited = parts.length !== first || items.some((item) => item !== undefined);
      return edited ? items.map((item) => item ?? {}) : undefined;
    },
    fill(values) {
      if (!Array.isArray(values) || values.length > Math.min(type.size, MOST)) return false;
      grow(values.length);
      return values.map((value, index) => parts[index]?.fill(value) ?? false).every(Boolean);
    },
  };
}
