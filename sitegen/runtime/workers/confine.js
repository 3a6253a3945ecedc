// @ts-check
// What programs may use of the browser. What is not listed here is taken away before their first instruction, so what
// future browsers add is closed, too: storage, other pages, devices, further workers, and all of the network but the
// files of the site.

/**
 * Take away from this worker what no program needs. The text of this function is also part of scripts, so it refers to
 * nothing outside.
 * @param {string} site the address of the site's files, without the file; empty in a page that is a single file
 */
export function confine(site) {
  // Standard ECMAScript; then what a worker is, has and hears; streams, text, events and pictures; and what the runtime
  // itself has added. PERSISTENT and TEMPORARY are numbers that Chromium does not let go of.
  const globals = new Set(`
    AggregateError Array ArrayBuffer AsyncDisposableStack AsyncIterator Atomics BigInt BigInt64Array BigUint64Array Boolean
    DataView Date DisposableStack Error EvalError FinalizationRegistry Float16Array Float32Array Float64Array Function
    Infinity Int16Array Int32Array Int8Array InternalError Intl Iterator JSON Map Math NaN Number Object Promise Proxy
    RangeError ReferenceError Reflect RegExp Set SharedArrayBuffer String SuppressedError Symbol SyntaxError Temporal
    TypeError URIError Uint16Array Uint32Array Uint8Array Uint8ClampedArray WeakMap WeakRef WeakSet WebAssembly decodeURI
    decodeURIComponent encodeURI encodeURIComponent escape eval globalThis isFinite isNaN parseFloat parseInt undefined
    unescape
    DedicatedWorkerGlobalScope WorkerGlobalScope WorkerLocation WorkerNavigator atob btoa clearInterval clearTimeout close
    console constructor crossOriginIsolated crypto fetch isSecureContext location name navigator onerror onmessage
    onmessageerror onrejectionhandled onunhandledrejection origin performance postMessage queueMicrotask reportError self
    setInterval setTimeout structuredClone
    AbortController AbortSignal Blob ByteLengthQueuingStrategy CompressionStream CountQueuingStrategy Crypto CryptoKey
    CustomEvent DOMException DecompressionStream ErrorEvent Event EventTarget File FileList FileReader FileReaderSync
    FormData Headers MessageChannel MessageEvent MessagePort Performance PerformanceEntry PerformanceMark
    PerformanceMeasure ProgressEvent PromiseRejectionEvent ReadableByteStreamController ReadableStream
    ReadableStreamBYOBReader ReadableStreamBYOBRequest ReadableStreamDefaultController ReadableStreamDefaultReader Request
    Response SubtleCrypto TextDecoder TextDecoderStream TextEncoder TextEncoderStream TransformStream
    TransformStreamDefaultController URL URLSearchParams WritableStream WritableStreamDefaultController
    WritableStreamDefaultWriter addEventListener dispatchEvent removeEventListener
    ImageBitmap ImageBitmapRenderingContext ImageData OffscreenCanvas OffscreenCanvasRenderingContext2D Path2D TextMetrics
    CanvasGradient CanvasPattern DOMMatrix DOMMatrixReadOnly DOMPoint DOMPointReadOnly DOMQuad DOMRect DOMRectReadOnly
    PERSISTENT TEMPORARY createImageBitmap cancelAnimationFrame requestAnimationFrame
    sitegenFiles Module`.trim().split(/\s+/));
  const navigators = new Set(`appCodeName appName appVersion constructor hardwareConcurrency language languages onLine
    platform product userAgent`.split(/\s+/));
  const { fetch: free, Request, TypeError, Promise } = globalThis;
  const urlOf = /** @type {any} */ (Object.getOwnPropertyDescriptor(Request.prototype, "url")).get;
  const methodOf = /** @type {any} */ (Object.getOwnPropertyDescriptor(Request.prototype, "method")).get;
  const { apply } = Reflect;
  const { startsWith } = String.prototype;
  // No cookies: a program is not the visitor. A program may replace every function, hence apply().
  const guarded = (/** @type {any} */ input, /** @type {any} */ init) => {
    const request = new Request(input, { ...init, credentials: "omit", keepalive: false });
    const url = apply(urlOf, request, []);
    const own = site !== "" && apply(startsWith, url, [site]);
    const inside = own || apply(startsWith, url, ["blob:"]) || apply(startsWith, url, ["data:"]);
    if (apply(methodOf, request, []) === "GET" && inside) return free(request);
    return Promise.reject(new TypeError(`programs of a page can fetch the files of its site only, and not ${url}`));
  };
  const strip = (/** @type {any} */ object, /** @type {Set<string>} */ kept) => {
    for (let owner = object; owner && owner !== Object.prototype && owner !== EventTarget.prototype;) {
      for (const name of Object.getOwnPropertyNames(owner)) if (!kept.has(name)) Reflect.deleteProperty(owner, name);
      owner = Object.getPrototypeOf(owner);
    }
  };
  strip(navigator, navigators);
  strip(globalThis, globals);
  for (let owner = globalThis; owner !== Object.prototype; owner = Object.getPrototypeOf(owner)) {
    Reflect.deleteProperty(owner, "fetch");
  }
  globalThis.fetch = guarded;
}
