// @ts-check
// A note that changes each second.

import { create, setText } from "../../ui/elements.js";

export class Countdown {
  element = create("p", "ros-connect-note");
  /** @type {ReturnType<typeof setInterval> | undefined} */
  #timer;

  /** Show what `text` returns for the seconds that have passed. @param {(passed: number) => string} text */
  begin(text) {
    this.end();
    const since = performance.now();
    const write = () => setText(this.element, text((performance.now() - since) / 1000));
    write();
    this.#timer = setInterval(write, 1000);
  }

  /** Show nothing. */
  end() {
    clearInterval(this.#timer);
    setText(this.element, "");
  }
}
