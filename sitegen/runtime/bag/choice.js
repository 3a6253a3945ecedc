// @ts-check
// Which topics are recorded or played.

/**
 * Topics by name, or by a part of their name that a regular expression finds; with neither, all of them. Excluded ones
 * are left out in any case.
 * @typedef {{topics?: string[], regex?: string, exclude?: string[], excludeRegex?: string}} Choice
 */

/** Whether a topic is chosen; throws a SyntaxError for a wrong expression. @param {string} topic @param {Choice} choice */
export function isChosen(topic, { topics, regex, exclude, excludeRegex }) {
  if (exclude?.includes(topic) || (excludeRegex && new RegExp(excludeRegex).test(topic))) return false;
  if (!topics && !regex) return true;
  return Boolean(topics?.includes(topic) || (regex && new RegExp(regex).test(topic)));
}
