// @ts-check
// Compile the WebAssembly of a program while it is downloaded.

/** Fetch and compile a program. @param {string} url */
export async function compile(url) {
  const response = await fetch(url);
  if (!response.ok) throw new Error(`${url} could not be loaded (${response.status})`);
  // Servers that do not know the media type of WebAssembly prevent compiling during the download.
  if (response.headers.get("content-type")?.startsWith("application/wasm")) {
    return WebAssembly.compileStreaming(response);
  }
  return WebAssembly.compile(await response.arrayBuffer());
}
