// Inside of a page that is a single file: unpack its modules, workers and programs, and start it.
//
// What a page loads has an address, so each module becomes a blob with one. A module comes after those that
// it imports, as "sitegen:path", and their addresses are put in. A worker makes blobs of its own: Chromium
// lets none of a file's workers load what the page has made.

const packed = document.getElementById("sitegen-files").textContent;
const zipped = new Blob([Uint8Array.from(atob(packed), (letter) => letter.charCodeAt(0))]);
const stream = zipped.stream().pipeThrough(new DecompressionStream("gzip"));
const bytes = new Uint8Array(await new Response(stream).arrayBuffer());
const begin = 4 + new DataView(bytes.buffer).getUint32(0);
const { files, entries, workers } = JSON.parse(new TextDecoder().decode(bytes.subarray(4, begin)));

const contents = {};
let at = begin;
for (const { path, type, size } of files) {
  const content = bytes.subarray(at, at + size);
  contents[path] = { type, content: type === "text/javascript" ? new TextDecoder().decode(content) : content };
  at += size;
}

/** Give each file an address, by the name that place.js asks for. */
function unpack(contents) {
  const addresses = {};
  for (const [path, { type, content }] of Object.entries(contents)) {
    const body = type === "text/javascript"
      ? content.replace(/"(sitegen:[^"]+)"/g, (whole, name) => (name in addresses ? `"${addresses[name]}"` : whole))
      : content;
    addresses[`sitegen:${path}`] = URL.createObjectURL(new Blob([body], { type }));
  }
  return addresses;
}

/** What a worker begins with: its modules, and a place for messages that come before those run. */
function boot(unpack, contents, entry) {
  const early = [];
  self.onmessage = (event) => early.push(event);
  self.sitegenFiles = unpack(contents);
  import(self.sitegenFiles[`sitegen:${entry}`]).then(
    () => early.forEach((event) => self.onmessage(event)),
    (error) => setTimeout(() => { throw error; }),
  );
}

globalThis.sitegenFiles = unpack(contents);
for (const [entry, paths] of Object.entries(workers)) {
  const own = Object.fromEntries(paths.map((path) => [path, contents[path]]));
  const text = `(${boot})(${unpack}, ${JSON.stringify(own)}, ${JSON.stringify(entry)});`;
  globalThis.sitegenFiles[`sitegen:${entry}`] = URL.createObjectURL(new Blob([text], { type: "text/javascript" }));
}
const page = document.getElementById("ros-page");
if (page) page.href = globalThis.sitegenFiles["sitegen:page.json"];
await Promise.all(entries.map((path) => import(globalThis.sitegenFiles[`sitegen:${path}`])));
