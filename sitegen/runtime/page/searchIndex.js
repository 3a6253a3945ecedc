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

// Words that say nothing about what is wanted, in the languages of the texts.
const STOP_WORDS = new Set(
  ("a an and are as at be by can do does for from how i if in into is it its me my of on or so that the their this to use " +
   "was what when where which who why will with you your " +
   "auf aus bei das dem den der des die ein eine einem einen einer es für geht ich im in ist kann man mit oder sich so " +
   "und von was wie wo zu zum zur").split(" "),
);

/** The words of a query that count, or all if none does. @param {string} query */
function wanted(query) {
  const all = words(query);
  const some = all.filter((word) => !STOP_WORDS.has(word));
  return some.length ? some : all;
}

/**
 * Load an index. Its `search` returns the best results first, `pages` all pages in their order. Most words of a query
 * must occur; the last one may be incomplete, and longer ones may be misspelled by a letter.
 *
 * @param {URL} url
 */
export async function loadIndex(url) {
  const answer = await fetch(url);
  if (!answer.ok) throw new Error(`${url} cannot be loaded: ${answer.status}`);
  const stored = await answer.json();
  const index = MiniSearch.loadJS(stored, {
    fields: ["title", "heading", "text"],
    storeFields: ["href", "title", "heading", "excerpt", "weight"],
    tokenize: words,
    processTerm: (term) => term,
    searchOptions: {
      boost: { title: 8, heading: 6 },
      combineWith: "OR",
      fuzzy: (term) => (term.length > 4 ? 0.2 : false),
      prefix: true,
      // A word of the query that occurs as it is says more than one that begins or is spelled like it.
      weights: { fuzzy: 0.2, prefix: 0.4 },
      boostDocument: (_id, _term, stored) => Number(stored?.weight ?? 1),
    },
  });
  return {
    words: wanted,
    /**
     * @param {string} query
     * @returns {Found[]}
     */
    search: (query) => {
      const terms = new Set(wanted(query));
      const found = /** @type {any[]} */ (index.search([...terms].join(" ")));
      const count = (/** @type {any} */ { queryTerms }) => new Set(queryTerms).size;
      // Of two words both must be there, if that is so anywhere.
      const most = terms.size > 2 ? Math.round(0.6 * terms.size) : terms.size;
      const enough = Math.min(most, Math.max(0, ...found.map(count)));
      /** How much a hit says: less if words are missing. @param {any} hit */
      const worth = (hit) => hit.score * (count(hit) / terms.size) ** 2;
      return found.filter((hit) => count(hit) >= enough).sort((a, b) => worth(b) - worth(a));
    },
    /** @returns {Found[]} */
    pages: () => {
      /** @type {(Found & {weight: number})[]} */
      const passages = Object.values(stored.storedFields);
      const pages = new Map(passages.toReversed().map((passage) => {
        const href = passage.href.replace(/#.*/, "");
        return [href, { ...passage, href, heading: undefined }];
      }));
      return [...pages.values()].sort((a, b) => b.weight - a.weight);
    },
  };
}
