// @ts-check
// The texts of widgets in the language of the page. The code has them in English; words/<language>.js maps these to
// translations.

import { place } from "../place.js";

const LANGUAGES = ["de"];

// Workers have no document and use English.
/** @type {string} */
const tag = /** @type {any} */ (globalThis).document?.documentElement.lang ?? "en";
const language = tag.split("-")[0]?.toLowerCase() ?? "en";
/** @type {Record<string, string>} */
const words = LANGUAGES.includes(language) ? (await import(place(`ui/words/${language}.js`))).words : {};

/** Translate a text, and replace each {} by one of `values`. @param {string} text @param {unknown[]} values */
export function say(text, ...values) {
  let next = 0;
  return (words[text] ?? text).replaceAll("{}", () => String(values[next++]));
}

/** Join names as a sentence does. @param {string[]} names */
export function together(names) {
  return new Intl.ListFormat(language).format(names);
}

/** The states of a node. */
export const states = {
  stopped: say("stopped"),
  starting: say("starting"),
  running: say("running"),
  stopping: say("stopping"),
  failed: say("failed"),
};
