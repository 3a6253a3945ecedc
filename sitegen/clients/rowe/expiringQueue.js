// @ts-check
// A queue whose items expire.

/** The largest number of items. */
const CAPACITY = 10_000;
// The size of all messages in a queue. It bounds the memory when messages are large.
const HEAVIEST = 2 ** 26;
// Items that expire in the same tick (ms) are dropped together.
export const TICK = 50;

/**
 * A queue whose items expire. Every operation takes constant time, amortized: the items that expire in the same tick of
 * the clock are in one bucket, which is dropped after it.
 * @template Item
 */
export class ExpiringQueue {
  /** @type {Map<number, {expiry: number, item: Item, weight: number}>} */
  #items = new Map();
  /** @type {Map<number, Set<number>>} */
  #buckets = new Map();
  #tick = tickOf(performance.now());
  #tickets = 0;
  #weight = 0;
  // One iterator for all calls: a new one would pass all places of removed items each time.
  #order = this.#items.entries();
  #dropped;
  #capacity;

  /** @param {(item: Item) => void} [dropped] called with each item that expired @param {number} [capacity] */
  constructor(dropped = () => {}, capacity = CAPACITY) {
    this.#dropped = dropped;
    this.#capacity = capacity;
  }

  get length() {
    this.#dropBuckets();
    return this.#items.size;
  }

  /** Whether an item of this weight has room. @param {number} weight */
  hasRoom(weight) {
    return this.length === 0 || (this.#items.size < this.#capacity && this.#weight + weight <= HEAVIEST);
  }

  /** Throw if an item of this weight has no room. @param {number} weight */
  check(weight) {
    if (!this.hasRoom(weight)) throw new Error(`the queue is full: ${this.#items.size} messages are waiting`);
  }

  /**
   * Append an item that expires in `timeToLive` seconds, and return its ticket.
   * @param {Item} item @param {number} [timeToLive] @param {number} [weight]
   */
  put(item, timeToLive = Infinity, weight = 0) {
    this.check(weight);
    const ticket = ++this.#tickets;
    const expiry = performance.now() + timeToLive * 1000;
    this.#items.set(ticket, { expiry, item, weight });
    this.#weight += weight;
    if (expiry < Infinity) {
      const tick = tickOf(expiry);
      const bucket = this.#buckets.get(tick) ?? new Set();
      this.#buckets.set(tick, bucket.add(ticket));
    }
    return ticket;
  }

  /** Remove the oldest item, and return it with the seconds that it has left. */
  take() {
    this.#dropBuckets();
    while (this.#items.size > 0) {
      const { value, done } = this.#order.next();
      if (done) {
        this.#order = this.#items.entries();
        continue;
      }
      const [ticket, { expiry, item }] = value;
      this.discard(ticket);
      const left = (expiry - performance.now()) / 1000;
      if (left > 0) return { left, item };
      this.#dropped(item);
    }
    return undefined;
  }

  /** Remove the item of a ticket. Return whether it was still in the queue. @param {number} ticket */
  discard(ticket) {
    const entry = this.#items.get(ticket);
    if (!entry) return false;
    this.#items.delete(ticket);
    this.#weight -= entry.weight;
    if (entry.expiry < Infinity) {
      const tick = tickOf(entry.expiry);
      const bucket = this.#buckets.get(tick);
      bucket?.delete(ticket);
      if (bucket?.size === 0) this.#buckets.delete(tick);
    }
    return true;
  }

  clear() {
    for (const { item } of this.#items.values()) this.#dropped(item);
    this.#items.clear();
    this.#weight = 0;
    this.#buckets.clear();
  }

  #dropBuckets() {
    const now = tickOf(performance.now());
    const drop = (/** @type {number} */ tick) => {
      for (const ticket of this.#buckets.get(tick) ?? []) {
        const entry = this.#items.get(ticket);
        this.#items.delete(ticket);
        if (!entry) continue;
        this.#weight -= entry.weight;
        this.#dropped(entry.item);
      }
      this.#buckets.delete(tick);
    };
    if (now - this.#tick < this.#buckets.size) for (let tick = this.#tick; tick < now; tick += 1) drop(tick);
    else for (const tick of this.#buckets.keys()) if (tick < now) drop(tick);
    this.#tick = now;
  }
}

/** @param {number} milliseconds */
function tickOf(milliseconds) {
  return Math.floor(milliseconds / TICK);
}
