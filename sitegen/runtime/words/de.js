// @ts-check
// What widgets say, in German.

/** @type {Record<string, string>} */
export const words = {};
