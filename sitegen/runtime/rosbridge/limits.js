// @ts-check
// How much one client may ask for.

/** Characters of a message that comes as text, and bytes of one that comes as an object. */
export const MOST_TEXT = 32_000_000;
/** Topics, services, actions, goals or calls of one client, each. */
export const MOST_NAMES = 1000;
export const MOST_QUEUE = 10_000;
/** Fragments of one message, and messages of which only a part has come. */
export const MOST_FRAGMENTS = 10_000;
export const MOST_PARTIAL = 16;
/** Clients of a page. */
export const MOST_CLIENTS = 32;
/** Characters of an id, a name and of a status that quotes them. */
export const LONGEST_ID = 1000;
export const LONGEST_NAME = 255;
