// JavaScript Promise Integration, which TypeScript's libraries do not know yet.
declare namespace WebAssembly {
  function promising(exported: Function): (...args: unknown[]) => Promise<unknown>;
  class Suspending {
    constructor(imported: Function);
  }
}
