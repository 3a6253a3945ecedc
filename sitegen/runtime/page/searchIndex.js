// The index of a site, which sitegen wrote in MiniSearch's own form: pages/search.py is its other half.

import { MiniSearch } from "../vendor/minisearch.js";

/** @typedef {{ href: string, title: string, heading?: string, excerpt: string }} Found */

// The same words as pages/search.py finds.
const WORD = /[\p{L}\p{N}]+/gu;

/**
 * Return what was typed as the words of the index.
 *
 * @param {string} text
 */
function words(text) {
  return text.toLowerCase().match(WORD) ?? [];
}

/**
 * Load an index. Its `search` returns the best first: all words have to be there, the last one
 * may be unfinished, and a longer one may have a letter wrong.
 *
 * @param {URL} url
 */
export async function loadIndex(url) {
  const answer = await fetch(url);
  if (!answer.ok) throw new Error(`${url} cannot be loaded: ${answer.status}`);
  const index = MiniSearch.loadJSON(await answer.text(), {
    fields: ["title", "heading", "text"],
    storeFields: ["href", "title", "heading", "excerpt"],
    tokenize: words,
    processTerm: (term) => term,
    searchOptions: {
      boost: { title: 4, heading: 3 },
      combineWith: "AND",
      fuzzy: (term) => (term.length > 4 ? 0.2 : false),
      prefix: true,
    },
  });
  return {
    words,
    /**
     * @param {string} query
     * @returns {Found[]}
     */
    search: (query) => /** @type {any[]} */ (index.search(query)),
  };
}
