// @ts-check
// Publish repeatedly at a rate that the visitor enters.

import { button, create, setText } from "../../ui/elements.js";
import { say } from "../../ui/words.js";

// Messages per second.
const SLOWEST = 0.1;
const FASTEST = 100;
const FIRST = "1";

export class Repeat {
  #send;
  #tell;
  #rate = create("input", "ros-rate");
  button = button(say("Repeat"), "ros-start", () => (this.#timer === undefined ? this.#begin() : this.stop()));
  rateLabel = create("label", "ros-every", this.#rate, "Hz");
  /** @type {ReturnType<typeof setInterval> | undefined} */
  #timer;

  /**
   * @param {() => boolean} send publishes once; false if that is not possible
   * @param {(error: string) => void} tell shows what is wrong with the rate
   */
  constructor(send, tell) {
    this.#send = send;
    this.#tell = tell;
    this.rate = "";
    this.#rate.inputMode = "decimal";
    this.#rate.setAttribute("aria-label", say("messages per second (Hz)"));
  }

  /** The rate as it was entered, empty if it is the default. */
  get rate() {
    return this.#rate.value === FIRST ? "" : this.#rate.value;
  }

  set rate(text) {
    this.#rate.value = text || FIRST;
  }

  stop() {
    clearInterval(this.#timer);
    this.#timer = undefined;
    this.#show();
  }

  #begin() {
    const hertz = Number(this.#rate.value.trim().replace(",", "."));
    const wrong = !(hertz >= SLOWEST && hertz <= FASTEST);
    this.#rate.toggleAttribute("aria-invalid", wrong);
    if (wrong) {
      this.#tell(say("The rate must be a number from {} to {} Hz", SLOWEST, FASTEST));
      this.#rate.focus();
      return;
    }
    if (!this.#send()) return;
    this.#timer = setInterval(() => {
      if (!this.#send()) this.stop();
    }, 1000 / hertz);
    this.#show();
  }

  #show() {
    const repeating = this.#timer !== undefined;
    setText(this.button, repeating ? say("Stop") : say("Repeat"));
    this.button.className = repeating ? "ros-stop" : "ros-start";
    this.#rate.disabled = repeating;
  }
}
