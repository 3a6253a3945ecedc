// @ts-check
// Bags: play one into the graph of the page, record topics to one.

import { whileSeen } from "../ui/looking.js";
import { PlayerView } from "./bag/player.js";
import { RecorderView } from "./bag/recorder.js";

/** @import { Ros } from "../protocol.js" */

/**
 * @typedef {{file?: string, autostart?: boolean, loop?: boolean, rate?: number | null, clock?: boolean,
 *   from?: number, to?: number, remap?: Record<string, string> | null, topics?: string[], exclude?: string[] | null,
 *   record?: string[] | null, hidden?: boolean, limit?: number, ask?: string | null}} Options `file` is the address of a
 *   bag, `from` and `to` are seconds from its start; `limit` is in MB; with `ask`, what the visitor does is recorded, too, after consent
 */

/**
 * Show a player, a recorder, or both.
 * @param {HTMLElement} element
 * @param {Ros} ros
 * @param {Options} options
 * @returns {() => void} unmount
 */
export function mount(element, ros, options) {
  const plays = Boolean(options.file) || !options.record;
  const records = Boolean(options.record) || !options.file;
  const player = new PlayerView(element, ros, options, plays);
  const recorder = records ? new RecorderView(ros, options, (source, name) => player.open(source, name)) : undefined;
  if (options.file) player.keep(element);
  element.replaceChildren(player.element, ...(recorder ? [recorder.element] : []));
  // A bag is loaded when someone looks at it.
  const unlook = whileSeen(element, () => {
    player.begin();
    recorder?.begin();
    return () => {};
  });
  return () => {
    unlook();
    player.close();
    recorder?.close();
    element.replaceChildren();
  };
}
