// @ts-check
// The lines that were typed at a prompt, to recall with the arrow keys.

const LENGTH = 200;

export class History {
  /** @type {string[]} */
  #lines = [];
  /** The index of the line that is shown; the index after the last line stands for the draft. */
  #at = 0;
  #draft = "";

  /** Append a line, unless it is blank or repeats the last one. @param {string} text */
  add(text) {
    if (text.trim() && text !== this.#lines.at(-1)) this.#lines.push(text);
    this.#lines.splice(0, this.#lines.length - LENGTH);
    this.#at = this.#lines.length;
  }

  /**
   * Return the line `step` away from the one shown, or undefined at either end.
   * @param {number} step -1 for older, 1 for newer @param {string} draft what the input holds
   */
  recall(step, draft) {
    const to = Math.min(Math.max(this.#at + step, 0), this.#lines.length);
    if (to === this.#at) return undefined;
    if (this.#at === this.#lines.length) this.#draft = draft;
    this.#at = to;
    return this.#lines[to] ?? this.#draft;
  }
}
