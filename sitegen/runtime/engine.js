// @ts-check
// How this browser suspends programs. The build copies the expression into scripts that cannot import it: engine.py.

/** @type {"jspi" | "asyncify"} */
export const engine = "Suspending" in WebAssembly && "promising" in WebAssembly ? "jspi" : "asyncify";
