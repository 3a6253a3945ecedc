// @ts-check
// The host function that sets content filters.

import { place } from "../../place.js";
import { readText, readTexts, writeText } from "./layout.js";

/** @import { Participant } from "../../participant/participant.js" */

/** @param {Participant} participant */
export function filterHost(participant) {
  /** @type {typeof import("../../messages/filter/contentFilter.js") | undefined} */
  let filters;
  /** Why the module could not be loaded. @type {unknown} */
  let failure;

  /** Load what makes filters, which few programs need. */
  const load = () => {
    import(place("messages/filter/contentFilter.js")).then(
      (module) => { filters = module; },
      (error) => { failure = error; },
    ).finally(() => participant.wake());
  };
  return {
    /**
     * @param {Uint8Array} heap @param {number} id @param {number} definition @param {number} expression
     * @param {number} parameters @param {number} count @param {number} problem @param {number} capacity
     */
    filter(heap, id, definition, expression, parameters, count, problem, capacity) {
      try {
        const rule = readText(heap, expression);
        if (rule && failure) throw failure;
        if (rule && !filters) {
          load();
          return -1;
        }
        const given = readTexts(heap, parameters, count);
        participant.filter(id, rule ? filters?.contentFilter(readText(heap, definition), rule, given) : undefined);
        return 0;
      } catch (error) {
        return writeText(heap, problem, /** @type {Error} */ (error).message, capacity);
      }
    },
  };
}
