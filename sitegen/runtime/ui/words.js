// @ts-check
// What widgets say, in the language of the page. English stands in the code; words/<language>.js has
// the others, by the English.

import { place } from "../place.js";

const LANGUAGES = ["de"];

// Workers have no document, and speak English.
/** @type {string} */
const tag = /** @type {any} */ (globalThis).document?.documentElement.lang ?? "en";
const language = tag.split("-")[0]?.toLowerCase() ?? "en";
/** @type {Record<string, string>} */
const words = LANGUAGES.includes(language) ? (await import(place(`ui/words/${language}.js`))).words : {};

/** A text in the language of the page, with `values` where it has {}. @param {string} text @param {unknown[]} values */
export function say(text, ...values) {
  let next = 0;
  return (words[text] ?? text).replaceAll("{}", () => String(values[next++]));
}

/** How a node is, in words. */
export const states = {
  stopped: say("stopped"),
  starting: say("starting"),
  running: say("running"),
  stopping: say("stopping"),
  failed: say("failed"),
};
