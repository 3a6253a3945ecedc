// @ts-check
// Keep the end of a scrolling log in view, unless the visitor has scrolled up.

// Within this distance of the end, in pixels, the visitor is reading the newest entry.
const NEAR = 24;

export class Tail {
  #log;
  /** Whether the end stays in view as the log grows. */
  following = true;

  /** @param {HTMLElement} log @param {() => void} [scrolled] called when the visitor has scrolled */
  constructor(log, scrolled = () => {}) {
    this.#log = log;
    log.addEventListener("scroll", () => {
      this.following = log.scrollHeight - log.scrollTop - log.clientHeight < NEAR;
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
  }
}
