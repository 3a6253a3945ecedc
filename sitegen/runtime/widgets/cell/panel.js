// @ts-check
// Show a panel of the page where the module jupyros asks for one: below a cell, or in an output of JupyterLab.

import { place } from "../../place.js";

/** @import { MessageType, Ros } from "../../protocol.js" */

/**
 * What panels need besides the graph: the address of all definitions of interfaces, and what 3D views load, by URL.
 * @typedef {{interfaces?: string, resources?: Record<string, string>}} Around
 * @typedef {{kind: string, options: Record<string, any>}} Described
 */

const KIND = /^[a-z0-9]+$/;

/** By the definitions that a page knows. @type {WeakMap<object, Promise<void>>} */
const complete = new WeakMap();

/**
 * Mount a panel in an element.
 * @param {HTMLElement} element @param {Ros} ros @param {string | Described} described its kind and its options, also as
 *   JSON @param {Around} around
 * @returns {Promise<() => void>} resolves with the function that unmounts it
 */
export async function mountPanel(element, ros, described, { interfaces, resources }) {
  const { kind, options } = typeof described === "string" ? JSON.parse(described) : described;
  if (!KIND.test(kind)) throw new Error(`'${kind}' is not a panel`);
  const [{ mount }] = await Promise.all([import(place(`widgets/${kind}.js`)), withInterfaces(ros, interfaces)]);
  const inside = element.ownerDocument.createElement("div");
  inside.className = `ros-widget ros-${kind}`;
  element.replaceChildren(inside);
  element.classList.add("ros-panel");
  // It is no part of shared links, which do not run cells.
  return mount(inside, { ...ros, keep() {} }, { ...options, ...(kind === "3d" && resources && { resources }) });
}

/** Know all interfaces of the site: a page itself knows those of its nodes. @param {Ros} ros @param {string} [file] */
function withInterfaces({ types }, file) {
  const loading = complete.get(types) ?? (file ? load(types, file) : Promise.resolve());
  complete.set(types, loading);
  return loading;
}

/** @param {Record<string, MessageType>} types @param {string} file as page.json names it, or its whole address */
async function load(types, file) {
  const address = file.startsWith("sitegen:") ? place(file) : new URL(file, document.baseURI);
  for (const [name, one] of Object.entries(await (await fetch(address)).json())) types[name] ??= one;
}
