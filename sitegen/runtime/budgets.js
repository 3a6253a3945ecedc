// @ts-check
// How much each worker may use of the page and of other workers. docs/budgets.md has the same table, and the tests.

/** How much may be in transit to one endpoint. More would not be faster, and cannot be taken back. */
export const WINDOW = { records: 1024, bytes: 32 * 1024 * 1024 };
/**
 * The largest history of a publisher with keepAll, and the most requests that wait for room at their server. Fast DDS
 * keeps 5000 messages.
 */
export const KEPT = { records: 5000, bytes: 64 * 1024 * 1024 };
/** The largest frame of several records (bytes). */
export const BATCH_SIZE = 64 * 1024;

export const BUDGETS = Object.freeze({
  /** Endpoints of a worker. */
  endpoints: 4096,
  /** Endpoints of a worker that are of one kind, on one topic or service. Each matches all on the other side. */
  alike: 256,
  /** Messages of a worker that arrived before the news of their match. */
  early: Object.freeze({ records: 4096, bytes: 64 * 1024 * 1024 }),
  /** Responses that wait at a client (bytes). */
  responses: 256 * 1024 * 1024,
  /** A frame to the page (bytes). */
  frame: 128 * 1024 * 1024,
  /** Refused records of a worker after which its port is closed. */
  refused: 100_000,
  /** Reports to the page a second, and at once. */
  reports: Object.freeze({ rate: 10_000, burst: 40_000 }),
  /** Reports that an invalid one counts as. */
  invalid: 100,
  /** Lines a second, and at once; each begun `width` of characters counts as a line. */
  lines: Object.freeze({ rate: 20_000, burst: 200_000, width: 1024 }),
  /** Characters of a line. */
  line: 4_194_304,
  /** Lines that are dropped before the worker is stopped. */
  dropped: 1_000_000,
});
