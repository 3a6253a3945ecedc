// @ts-check
// Whether a program can still do something by itself: what it waits for.

export class Pending {
  #tell;
  /** @type {Set<unknown>} */
  #things = new Set();
  #evaluated = false;
  #busy = true;
  #looking = false;

  /** @param {(busy: boolean) => void} tell called after each change, the first time when it has nothing more to do */
  constructor(tell) {
    this.#tell = tell;
  }

  /** @param {unknown} thing for which it waits */
  add(thing) {
    this.#things.add(thing);
    this.#look();
  }

  /** @param {unknown} thing */
  delete(thing) {
    this.#things.delete(thing);
    this.#look();
  }

  /** The module has run to its end. */
  evaluated() {
    this.#evaluated = true;
    this.#look();
  }

  /** Note timers and requests from now on. */
  watch() {
    const { setTimeout, setInterval, requestAnimationFrame, fetch } = globalThis;
    const once = (/** @type {(run: (...values: any[]) => void, ...rest: any[]) => any} */ start, /** @type {string} */ kind) =>
      (/** @type {any} */ callback, /** @type {any[]} */ ...rest) => {
        const id = start((...values) => {
          this.delete(kind + id);
          callback(...values);
        }, ...rest);
        this.add(kind + id);
        return id;
      };
    const ending = (/** @type {(id: any) => void} */ end, /** @type {string} */ kind) => (/** @type {any} */ id) => {
      this.delete(kind + id);
      end(id);
    };
    const clear = ending(clearTimeout, "timer");
    Object.assign(globalThis, {
      setTimeout: once(setTimeout, "timer"),
      setInterval: (/** @type {Parameters<typeof setInterval>} */ ...given) => {
        const id = setInterval(...given);
        this.add(`timer${id}`);
        return id;
      },
      // Either ends both kinds, as in browsers.
      clearTimeout: clear,
      clearInterval: clear,
      fetch: (/** @type {Parameters<typeof fetch>} */ ...given) => {
        const response = fetch(...given);
        this.add(response);
        return response.finally(() => this.delete(response));
      },
    });
    if (requestAnimationFrame) {
      Object.assign(globalThis, {
        requestAnimationFrame: once(requestAnimationFrame, "frame"),
        cancelAnimationFrame: ending(cancelAnimationFrame, "frame"),
      });
    }
  }

  /** After the present callback, which may begin something else. */
  #look() {
    if (this.#looking) return;
    this.#looking = true;
    queueMicrotask(() => {
      this.#looking = false;
      const busy = !this.#evaluated || this.#things.size > 0;
      if (busy === this.#busy) return;
      this.#busy = busy;
      this.#tell(busy);
    });
  }
}
