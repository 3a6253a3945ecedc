// @ts-check
// Measure the frequency and the bandwidth of a topic over the last seconds.

const WINDOW = 5000;
// The largest number of messages to measure: of a fast topic, fewer seconds are enough.
const MOST = 2000;

export class Rate {
  /** @type {{time: number, size: number}[]} */
  #messages = [];

  /** @param {number} time of sending, ms @param {number} size bytes */
  add(time, size) {
    this.#messages.push({ time, size });
    // Removing the first elements moves all others, so remove many at once.
    if (this.#messages.length > 2 * MOST) this.#messages = this.#messages.slice(-MOST);
  }

  /**
   * Return messages and bytes per second, 0 if there were none in the last seconds.
   * @param {number} now ms
   * @returns {{hertz: number, bytes: number}}
   */
  read(now) {
    const first = this.#messages.findIndex(({ time }) => time > now - WINDOW);
    this.#messages = first < 0 ? [] : this.#messages.slice(first).slice(-MOST);
    const count = this.#messages.length;
    const [oldest, newest] = [this.#messages[0], this.#messages.at(-1)];
    if (!oldest || !newest || count < 2) return { hertz: 0, bytes: 0 };
    const span = newest.time - oldest.time;
    const period = span / (count - 1);
    // The rate of a publisher falls when its next message is overdue, not before.
    const seconds = Math.max(span, now - oldest.time - 1.5 * period) / 1000;
    if (seconds <= 0) return { hertz: 0, bytes: 0 };
    const hertz = (count - 1) / seconds;
    const total = this.#messages.reduce((sum, { size }) => sum + size, 0);
    return { hertz, bytes: (total / count) * hertz };
  }
}
