// @ts-check
// Files of the site, for programs that wait for them.

/** Return the content of a file. @param {string} address */
export async function contentOf(address) {
  const response = await fetch(address);
  if (!response.ok) throw new Error(`the server answered ${response.status}`);
  return new Uint8Array(await response.arrayBuffer());
}

/** Begin to read a file, and return what is known of it: the program looks again after a wait. @param {string} address */
export function beginReading(address) {
  /** @type {{done: boolean, content?: Uint8Array, error: string}} */
  const file = { done: false, error: "" };
  contentOf(address).then((content) => {
    file.content = content;
  }, (error) => {
    file.error = error.message;
  }).finally(() => {
    file.done = true;
  });
  return file;
}
