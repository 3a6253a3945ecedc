// Inside of a page that is a single file: unpack its modules, workers and programs, and start it.
//
// What a page loads has an address, so each module becomes a blob with one. A module comes after those that
// it imports, as "sitegen:path", and their addresses are put in. A worker makes blobs of its own: Chromium
// lets none of a file's workers load what the page has made.

/**
 * By path in the site; what is no text is bytes, or in workers base64 of them.
 * @typedef {Record<string, {type: string, content: string | Uint8Array<ArrayBuffer>, coded?: boolean}>} Contents
 */

const scope = /** @type {typeof globalThis & {sitegenFiles: Record<string, string>}} */ (globalThis);
const packed = document.getElementById("sitegen-files")?.textContent ?? "";
const zipped = new Blob([Uint8Array.from(atob(packed), (letter) => letter.charCodeAt(0))]);
const stream = zipped.stream().pipeThrough(new DecompressionStream("gzip"));
const bytes = new Uint8Array(await new Response(stream).arrayBuffer());
const begin = 4 + new DataView(bytes.buffer).getUint32(0);
/**
 * @type {{files: {path: string, type: string, size: number}[], entries: string[], workers: Record<string, string[]>}}
 */
const { files, entries, workers } = JSON.parse(new TextDecoder().decode(bytes.subarray(4, begin)));

/** @type {Contents} */
const contents = {};
let at = begin;
for (const { path, type, size } of files) {
  const content = bytes.subarray(at, at + size);
  contents[path] = { type, content: type === "text/javascript" ? new TextDecoder().decode(content) : content };
  at += size;
}

/** Give each file an address, by the name that place.js asks for. @param {Contents} contents */
function unpack(contents) {
  /** @type {Record<string, string>} */
  const addresses = {};
  for (const [path, { type, content, coded }] of Object.entries(contents)) {
    const body = typeof content !== "string"
      ? content
      : coded
        ? Uint8Array.from(atob(content), (letter) => letter.charCodeAt(0))
        : content.replace(/"(sitegen:[^"]+)"/g, (whole, name) => (name in addresses ? `"${addresses[name]}"` : whole));
    addresses[`sitegen:${path}`] = URL.createObjectURL(new Blob([body], { type }));
  }
  return addresses;
}

/**
 * What a worker begins with: its modules, and a place for messages that come before those run.
 * @param {(contents: Contents) => Record<string, string>} unpack
 * @param {Contents} contents @param {string} entry
 */
function boot(unpack, contents, entry) {
  /** @type {MessageEvent[]} */
  const early = [];
  self.onmessage = (event) => early.push(event);
  const files = unpack(contents);
  Object.assign(self, { sitegenFiles: files });
  import(files[`sitegen:${entry}`] ?? "").then(
    () => early.forEach((event) => self.onmessage?.(event)),
    (error) => setTimeout(() => { throw error; }),
  );
}

scope.sitegenFiles = unpack(contents);
/** Write a file as JSON can have it. @param {string} path @returns {Promise<[string, Contents[string] | undefined]>} */
async function written(path) {
  const file = contents[path];
  if (!file || typeof file.content === "string") return [path, file];
  const blob = new Blob([file.content]);
  const address = await new Promise((resolve) => {
    const reader = new FileReader();
    reader.onload = () => resolve(reader.result);
    reader.readAsDataURL(blob);
  });
  return [path, { type: file.type, content: address.slice(address.indexOf(",") + 1), coded: true }];
}

for (const [entry, paths] of Object.entries(workers)) {
  const own = Object.fromEntries(await Promise.all(paths.map(written)));
  const text = `(${boot})(${unpack}, ${JSON.stringify(own)}, ${JSON.stringify(entry)});`;
  scope.sitegenFiles[`sitegen:${entry}`] = URL.createObjectURL(new Blob([text], { type: "text/javascript" }));
}
const page = /** @type {HTMLLinkElement | null} */ (document.getElementById("ros-page"));
if (page) page.href = scope.sitegenFiles["sitegen:page.json"] ?? "";
await Promise.all(entries.map((path) => import(scope.sitegenFiles[`sitegen:${path}`] ?? "")));

export {};
