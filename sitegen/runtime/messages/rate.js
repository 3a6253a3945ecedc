// @ts-check
// Measure how often messages come and how much they are, over the last seconds.

const WINDOW = 5000;
// Of a fast topic fewer seconds tell as much.
const MOST = 2000;

export class Rate {
  /** @type {{time: number, size: number}[]} */
  #messages = [];

  /** @param {number} time when it was sent, ms @param {number} size bytes */
  add(time, size) {
    this.#messages.push({ time, size });
    // Cutting the front moves the rest, so it is not done for each message.
    if (this.#messages.length > 2 * MOST) this.#messages = this.#messages.slice(-MOST);
  }

  /**
   * Messages and bytes a second; 0 when none came lately.
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
    // A publisher that went silent slows down; until its next message is due it keeps its rate.
    const seconds = Math.max(span, now - oldest.time - 1.5 * period) / 1000;
    if (seconds <= 0) return { hertz: 0, bytes: 0 };
    const hertz = (count - 1) / seconds;
    const total = this.#messages.reduce((sum, { size }) => sum + size, 0);
    return { hertz, bytes: (total / count) * hertz };
  }
}
