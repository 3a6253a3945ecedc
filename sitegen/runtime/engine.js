// @ts-check
// How this browser suspends programs. The build copies the expression into scripts that cannot import it: engine.py.

/** @import { Engine } from "./protocol.js" */

/** @type {Engine} */
export const engine = "Suspending" in WebAssembly && "promising" in WebAssembly ? "jspi" : "asyncify";
