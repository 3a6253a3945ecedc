// @ts-check
// A panel that the author of the site wrote: an ES module that exports `mount`.

import { create } from "../ui/elements.js";
import { fullScreenButton } from "../ui/fullScreen.js";
import { place } from "../place.js";
import { say } from "../ui/words.js";
import { Faults } from "./own/faults.js";
import { OwnRos } from "./own/ownRos.js";

/** @import { Ros } from "../protocol.js" */

// Nodes that start with the page wait for a module for this long (ms), so that the panel misses no message.
const PATIENCE = 3000;

/**
 * Load the panel `module`, an address relative to page.json, which was written in `file`.
 * @param {HTMLElement} element
 * @param {Ros} ros
 * @param {{file: string, title: string, module: string, options: Record<string, any>}} panel
 * @returns {(() => void) & {ready: Promise<unknown>}} unmount; `ready` resolves when the panel is mounted
 */
export function mount(element, ros, { file, title, module, options }) {
  const content = create("div", "ros-own-content");
  const address = module.startsWith("sitegen:") ? place(module) : new URL(module, pageAddress()).href;
  const faults = new Faults(file, address);
  const bar = create("div", "ros-bar", create("span", "ros-title", title),
    create("div", "ros-controls", fullScreenButton(element)));
  element.replaceChildren(bar, content, faults.element);

  const own = new OwnRos(element, ros, faults);
  /** @type {unknown} */
  let unmount;
  let gone = false;
  const end = () => {
    if (typeof unmount === "function") faults.guard(/** @type {() => void} */ (unmount))();
    unmount = undefined;
  };
  const begin = async () => {
    const { mount: mountOwn } = await import(address);
    if (typeof mountOwn !== "function") throw new Error(say("it exports no function 'mount'"));
    if (gone) return;
    unmount = await mountOwn(content, own.api, options);
    if (gone) end();
  };
  const begun = begin().catch((error) => faults.show(error));
  const ready = Promise.race([begun, new Promise((resolve) => setTimeout(resolve, PATIENCE))]);

  return Object.assign(() => {
    gone = true;
    end();
    own.close();
    faults.close();
    element.replaceChildren();
  }, { ready });
}

/** The address that those in page.json are relative to. */
function pageAddress() {
  return /** @type {HTMLLinkElement | null} */ (document.getElementById("ros-page"))?.href ?? location.href;
}
