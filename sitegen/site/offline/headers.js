// What isolates pages: two headers of theirs and of their workers, for hosts that cannot send them.

const ISOLATION = {
  "cross-origin-opener-policy": "same-origin",
  "cross-origin-embedder-policy": "require-corp",
};

/**
 * Return a function that adds these headers to the response to `request` where it needs them.
 * @param {Request} request @returns {(response: Response) => Response}
 */
function isolating({ mode, destination }) {
  if (!BUILD.isolate || !(mode === "navigate" || destination === "worker")) return (response) => response;
  return (response) => {
    // Redirects and failures are the browser's.
    if (response.status === 0 || response.redirected) return response;
    const headers = new Headers(response.headers);
    for (const [name, value] of Object.entries(ISOLATION)) headers.set(name, value);
    const { status, statusText } = response;
    return new Response(response.body, { status, statusText, headers });
  };
}
