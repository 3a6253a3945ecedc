// @ts-check
// Keep the end of a scrolling log in view, unless the visitor has scrolled up.

// Within this distance of the end, in pixels, the visitor is reading the newest entry.
const NEAR = 24;

export class Tail {
  #log;
  /** Where the log was scrolled to last, in pixels. */
  #top = 0;
  /** Whether the end stays in view as the log grows. */
  following = true;

  /** @param {HTMLElement} log @param {() => void} [scrolled] called when the visitor has scrolled */
  constructor(log, scrolled = () => {}) {
    this.#log = log;
    log.addEventListener("scroll", () => {
      const fromEnd = log.scrollHeight - log.scrollTop - log.clientHeight;
      // The event comes a frame later. If the log became smaller since then, its end is out of view
      // although the visitor has not scrolled up.
      if (fromEnd < NEAR) this.following = true;
      else if (log.scrollTop < this.#top) this.following = false;
      this.#top = log.scrollTop;
      scrolled();
    });
  }

  /** Scroll to the end if it was in view. */
  follow() {
    if (this.following) this.jump();
  }

  /** Scroll to the end. */
  jump() {
    this.#log.scrollTop = this.#log.scrollHeight;
    this.#top = this.#log.scrollTop;
  }
}
