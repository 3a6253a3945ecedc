// The search index of a site, which pages/search.py writes in the format of MiniSearch.

import { MiniSearch } from "../vendor/minisearch.js";

/** @typedef {{ href: string, title: string, heading?: string, excerpt: string }} Found */

// As in pages/search.py.
const WORD = /[\p{L}\p{N}]+/gu;

/**
 * Split a text into words as they are in the index.
 *
 * @param {string} text
 */
function words(text) {
  return text.toLowerCase().match(WORD) ?? [];
}

/**
 * Load an index. Its `search` returns the best results first. All words must occur; the last one may be incomplete, and
 * longer ones may be misspelled by a letter.
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
