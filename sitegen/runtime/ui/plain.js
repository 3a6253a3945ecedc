// @ts-check
// Texts of programs where they are shown without colours; escapes.js shows them.

/** Return a text without the sequences that change colours of terminals. @param {string} text */
export const plain = (text) => text.replace(/\x1b\[[\d;:]*m/g, "");
